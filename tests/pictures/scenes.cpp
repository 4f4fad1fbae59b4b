#include "pictures/scenes.h"

#include <stdexcept>

namespace drt {

std::vector<PictureCase> all_pictures(const std::string& folder) {
    std::vector<PictureCase> all;
    for (const auto& group : {surface_pictures(), light_pictures(), texture_pictures(folder), camera_pictures(folder)})
        all.insert(all.end(), group.begin(), group.end());
    return all;
}

PictureCase find_picture(const std::string& name, const std::string& folder) {
    for (PictureCase& picture : all_pictures(folder))
        if (picture.name == name) return std::move(picture);
    throw std::invalid_argument("no picture is called \"" + name + "\"");
}

}  // namespace drt
