#include "drt/plan/rank.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "drt/geometry/contact.h"

namespace drt {

namespace {

enum class Extent : std::uint8_t { solid, flat, plane };

struct Standing {
    int priority = 0;
    Extent extent = Extent::solid;
    std::int64_t size = 0;  // logarithm of the volume or area
    int body = 0;
};

bool outranks(const Standing& a, const Standing& b) {
    if (a.priority != b.priority) return a.priority > b.priority;
    if (a.extent != b.extent) return a.extent < b.extent;
    if (a.size != b.size) return a.size < b.size;
    return a.body > b.body;
}

double area(const FlatShape<double>& s) {
    const double parallelogram = 1 / length(cross(s.da, s.db));
    switch (s.outline) {
        case Outline::parallelogram:
            return parallelogram;
        case Outline::triangle:
            return parallelogram / 2;
        case Outline::disc:
            break;
    }
    return pi<double> * parallelogram;
}

struct Size {
    Extent extent;
    double measure;
};

Size size_of(const SphereShape<double>& s) { return {Extent::solid, 4 * pi<double> / 3 * std::pow(s.radius, 3)}; }
Size size_of(const BoxShape<double>& s) { return {Extent::solid, 8 * s.half.x * s.half.y * s.half.z}; }
Size size_of(const FlatShape<double>& s) { return {Extent::flat, area(s)}; }
Size size_of(const PlaneShape<double>&) { return {Extent::plane, 1}; }
Size size_of(const CylinderShape<double>& s) {
    if (s.capped) return {Extent::solid, pi<double> * s.radius * s.radius * 2 * s.half_height};
    return {Extent::flat, 2 * pi<double> * s.radius * 2 * s.half_height};
}

// In steps of a millionth, so that two bodies of one size, computed in two ways, are of one size.
std::int64_t rounded_log(double measure) { return std::llround(1e6 * std::log(std::max(measure, 1e-300))); }

Standing standing_of(const PreparedScene& p, const SceneDesc& scene, int body) {
    const Size size = std::visit([](const auto& s) { return size_of(s); }, p.bodies[size_t(body)].shape);
    const int source = p.body_source[size_t(body)];
    const int priority = source < 0 ? 0 : scene.bodies[size_t(source)].priority;
    return {priority, size.extent, rounded_log(size.measure), body};
}

}  // namespace

void assign_roles(PreparedScene& p, const SceneDesc& scene) {
    std::vector<Standing> order;
    order.reserve(p.bodies.size());
    for (int i = 0; i < int(p.bodies.size()); ++i) order.push_back(standing_of(p, scene, i));
    std::sort(order.begin(), order.end(), outranks);
    for (size_t rank = 0; rank < order.size(); ++rank) {
        const size_t body = size_t(order[rank].body);
        const int material = p.body_material[body];
        p.bodies[body].role.rank = std::int32_t(rank);
        p.bodies[body].role.refracts = material >= 0 && scene.materials[size_t(material)].refraction > 0;
    }
}

namespace {

Vec3d center_of(const BodyInput& b) { return b.path.empty() ? b.center : center_at<double>(b.path, 0.0); }

// At shutter open.
bool contains(const BodyInput& b, const Vec3d& p) {
    const Pose<double> pose = b.path.empty() ? Pose<double>{b.center, {}} : pose_at<double>(b.path, 0.0);
    const Vec3d q = rotate_back(pose.orientation, p - pose.center);
    return std::visit(
        [&](const auto& s) {
            using S = std::decay_t<decltype(s)>;
            if constexpr (std::is_same_v<S, FlatShape<double>>)
                return false;
            else if constexpr (std::is_same_v<S, CylinderShape<double>>)
                return s.capped && is_inside(s, q);
            else
                return is_inside(s, q);
        },
        b.shape);
}

[[noreturn]] void throw_too_deep(const PreparedScene& p, const SceneDesc& scene, size_t body) {
    const int source = p.body_source[body];
    const Location place = scene.sources.find(fmt::format("bodies[{}]", source));
    throw Error(ErrorKind::scene, {{Severity::error,
                                    place,
                                    fmt::format("body \"{}\" is inside {} or more other bodies that refract",
                                                scene.bodies[size_t(source)].name, most_media),
                                    {},
                                    fmt::format("at most {} refracting bodies inside each other", most_media),
                                    {}}});
}

}  // namespace

void check_nesting(const PreparedScene& p, const SceneDesc& scene) {
    std::vector<size_t> media;
    for (size_t i = 0; i < p.bodies.size(); ++i)
        if (p.bodies[i].role.refracts) media.push_back(i);
    constexpr size_t worth_checking = 4096;  // by pairs; what is beyond is counted while rendering
    if (media.size() <= most_media || media.size() > worth_checking) return;
    for (auto it = media.rbegin(); it != media.rend(); ++it) {  // a scene's last bodies are its innermost, mostly
        const size_t inner = *it;
        const Vec3d middle = center_of(p.bodies[inner]);
        const auto holds_it = [&](size_t other) { return contains(p.bodies[other], middle); };
        if (std::count_if(media.begin(), media.end(), holds_it) > most_media) throw_too_deep(p, scene, inner);
    }
}

}  // namespace drt
