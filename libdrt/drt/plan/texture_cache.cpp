#include "drt/plan/texture_cache.h"

#include "drt/base/diagnostic.h"

namespace drt {
namespace {

TextureCache::Entry read_texture(const std::string& file, ReadOptions::Transfer transfer) {
    ReadOptions options;
    options.transfer = transfer;
    try {
        return {std::make_shared<const TextureMap>(make_texture_map(read_image(file, options))), {}};
    } catch (const Error& e) {
        if (e.kind() != ErrorKind::asset) throw;
        return {std::make_shared<const TextureMap>(make_missing_texture()), e.diagnostics().front().message};
    }
}

}  // namespace

const TextureCache::Entry& TextureCache::get(const std::string& file, ReadOptions::Transfer transfer) {
    const std::pair key(file, transfer);
    auto place = entries_.find(key);
    if (place == entries_.end()) place = entries_.emplace(key, read_texture(file, transfer)).first;
    return place->second;
}

}  // namespace drt
