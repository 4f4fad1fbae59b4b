#include "drt/scene/value_text.h"

#include <charconv>
#include <initializer_list>

namespace drt {
namespace {

template <class T>
std::string shortest(T value) {
    char buffer[32];
    return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr};
}

template <class T>
std::string bracketed(std::initializer_list<T> values) {
    std::string out;
    for (const T v : values) out += (out.empty() ? "[" : ", ") + shortest(v);
    return out + ']';
}

}  // namespace

std::string to_text(double v) { return shortest(v); }
std::string to_text(float v) { return shortest(v); }
std::string to_text(int v) { return shortest(v); }
std::string to_text(std::uint32_t v) { return shortest(v); }
std::string to_text(bool v) { return v ? "true" : "false"; }
std::string to_text(const Vec3d& v) { return bracketed({v.x, v.y, v.z}); }
std::string to_text(const Color& c) { return c.r == c.g && c.g == c.b ? shortest(c.r) : bracketed({c.r, c.g, c.b}); }
std::string to_text(const Quatd& q) { return bracketed({q.w, q.x, q.y, q.z}); }

}  // namespace drt
