#pragma once
// Textures that have been decoded, to be shared by the frames of a run.

#include <map>
#include <memory>
#include <string>
#include <utility>

#include "drt/image/image.h"
#include "drt/texture/texture_map.h"

namespace drt {

/// Each file is read once, when it is first asked for, whatever happens to it afterwards: all frames show the same.
/// What it gave out lives on without it. Not to be used by several threads at a time.
class TextureCache {
public:
    struct Entry {
        std::shared_ptr<const TextureMap> map;
        std::string problem;  ///< why the file could not be read (map is make_missing_texture()), else ""
    };

    /// Valid until the cache is gone. Throws Error (memory).
    const Entry& get(const std::string& file, ReadOptions::Transfer);

private:
    std::map<std::pair<std::string, ReadOptions::Transfer>, Entry> entries_;
};

}  // namespace drt
