#include "drt/scene/scene_path.h"

namespace drt {

std::string ScenePath::str() const {
    std::string out;
    append_to(out);
    return out;
}

void ScenePath::append_to(std::string& out) const {
    if (!parent_) return;
    parent_->append_to(out);
    if (name_.empty()) {
        out += '[' + std::to_string(index_) + ']';
    } else {
        if (!out.empty()) out += '.';
        out += name_;
    }
}

}  // namespace drt
