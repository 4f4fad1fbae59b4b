#include "drt/scene/scene_desc.h"

namespace drt {

Location SourceMap::find(std::string path) const {
    while (!path.empty()) {
        if (const auto it = places.find(path); it != places.end()) return it->second;
        const size_t cut = path.find_last_of(".[");
        path.resize(cut == std::string::npos ? 0 : cut);
    }
    const auto root = places.find("");
    return root == places.end() ? Location{} : root->second;
}

}  // namespace drt
