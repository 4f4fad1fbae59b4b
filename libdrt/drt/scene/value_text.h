#pragma once
// Values of a scene as text: the shortest digits that read back to the very same number, in any locale.

#include <cstdint>
#include <string>

#include "drt/base/color.h"
#include "drt/base/quat.h"
#include "drt/base/vec.h"

namespace drt {

std::string to_text(double);
std::string to_text(float);
std::string to_text(int);
std::string to_text(std::uint32_t);
std::string to_text(bool);          ///< "true", "false"
std::string to_text(const Vec3d&);  ///< "[x, y, z]"
std::string to_text(const Color&);  ///< "[r, g, b]", or one number for a grey
std::string to_text(const Quatd&);  ///< "[w, x, y, z]"

}  // namespace drt
