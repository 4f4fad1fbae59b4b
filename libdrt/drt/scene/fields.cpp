#include "drt/scene/fields.h"

#include <cmath>

#include "drt/scene/value_text.h"

namespace drt {

std::string to_string(const Range& r) {
    std::string out;
    if (std::isfinite(r.low)) out += (r.low_open ? "> " : ">= ") + to_text(r.low);
    if (std::isfinite(r.high)) {
        if (!out.empty()) out += " and ";
        out += (r.high_open ? "< " : "<= ") + to_text(r.high);
    }
    return out;
}

}  // namespace drt
