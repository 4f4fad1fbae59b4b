#include "drt/geometry/body_table.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>

namespace drt {

namespace {

ShapeKind kind_of(const AnyShape& s) { return ShapeKind(s.index()); }

// The variant's order is ShapeKind's: checked here so that neither can be reordered alone.
static_assert(std::is_same_v<std::variant_alternative_t<size_t(ShapeKind::cylinder), AnyShape>, CylinderShape<double>>);
static_assert(std::is_same_v<std::variant_alternative_t<size_t(ShapeKind::plane), AnyShape>, PlaneShape<double>>);

SphereShape<float> to_float(const SphereShape<double>& s) { return {float(s.radius)}; }
FlatShape<float> to_float(const FlatShape<double>& s) {
    return {Vec3f(s.origin), Vec3f(s.normal), Vec3f(s.da), Vec3f(s.db), s.outline, float(s.da_size), float(s.db_size)};
}
BoxShape<float> to_float(const BoxShape<double>& s) { return {Vec3f(s.ax), Vec3f(s.ay), Vec3f(s.az), Vec3f(s.half)}; }
CylinderShape<float> to_float(const CylinderShape<double>& s) {
    return {Vec3f(s.ax), Vec3f(s.ay), Vec3f(s.az), float(s.radius), float(s.half_height), s.capped};
}
PlaneShape<float> to_float(const PlaneShape<double>& s) { return {Vec3f(s.normal)}; }

// The sum of its absolute coordinates is at least a vector's length.
template <class Real>
Real size_of(const Vec3<Real>& v) {
    return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

template <class Real, class S>
auto as_real(const S& s) {
    if constexpr (std::is_same_v<Real, double>)
        return s;
    else
        return to_float(s);
}

// Half extents about the centre in every orientation along the path: those of the circumsphere if the body turns.
template <class Shape>
Vec3d swept_extent(const Shape& shape, std::span<const MotionPiece<double>> path) {
    const Vec3d half = half_extent(shape);
    constexpr bool round = std::is_same_v<Shape, SphereShape<float>> || std::is_same_v<Shape, SphereShape<double>>;
    if (round || path.empty() || !turns(path)) return half;
    const double r = length(half);
    return {r, r, r};
}

int time_steps(const BodyInput& in) {
    if (in.path.empty()) return 1;
    return std::visit(
        [&](const auto& shape) {
            if constexpr (std::is_same_v<std::decay_t<decltype(shape)>, PlaneShape<double>>) {
                return 1;
            } else {
                return time_steps_for(in.path, swept_extent(shape, in.path));
            }
        },
        in.shape);
}

template <class Real>
void append_shape(BodyTable<Real>& t, const AnyShape& shape) {
    std::visit(
        [&](const auto& s) {
            using S = std::decay_t<decltype(s)>;
            if constexpr (std::is_same_v<S, SphereShape<double>>) t.spheres.push_back(as_real<Real>(s));
            if constexpr (std::is_same_v<S, FlatShape<double>>) {
                t.flats.push_back(as_real<Real>(s));
                t.flats.back().da_size = size_of(t.flats.back().da);
                t.flats.back().db_size = size_of(t.flats.back().db);
            }
            if constexpr (std::is_same_v<S, BoxShape<double>>) t.boxes.push_back(as_real<Real>(s));
            if constexpr (std::is_same_v<S, CylinderShape<double>>) t.cylinders.push_back(as_real<Real>(s));
            if constexpr (std::is_same_v<S, PlaneShape<double>>) t.planes.push_back(as_real<Real>(s));
        },
        shape);
}

bool fills_a_volume(const BodyInput& in) {
    switch (kind_of(in.shape)) {
        case ShapeKind::sphere:
        case ShapeKind::box:
            return true;
        case ShapeKind::cylinder:
            return std::get<CylinderShape<double>>(in.shape).capped;
        case ShapeKind::plane:
            return in.role.refracts;
        case ShapeKind::flat:
            break;
    }
    return false;
}

// The centre and the extent about it are rounded once each, and once more when a ray is taken relative to the centre.
template <class Real>
Real surface_error(const BodyInput& in) {
    double reach = length(in.center);
    for (const MotionPiece<double>& p : in.path)
        reach = std::max(reach, length(p.c0) + length(p.c1) + length(p.c2) + length(p.c3));
    reach += std::visit(
        [](const auto& s) {
            if constexpr (std::is_same_v<std::decay_t<decltype(s)>, PlaneShape<double>>)
                return 0.0;
            else
                return length(half_extent(s));
        },
        in.shape);
    return Real(2 * double(std::numeric_limits<Real>::epsilon()) * reach);
}

template <class Real>
int shape_count(const BodyTable<Real>& t, ShapeKind kind) {
    switch (kind) {
        case ShapeKind::sphere:
            return int(t.spheres.size());
        case ShapeKind::flat:
            return int(t.flats.size());
        case ShapeKind::box:
            return int(t.boxes.size());
        case ShapeKind::cylinder:
            return int(t.cylinders.size());
        case ShapeKind::plane:
            return int(t.planes.size());
    }
    return 0;
}

}  // namespace

template <class Real>
BuiltTable<Real> build_body_table(const std::vector<BodyInput>& inputs) {
    BuiltTable<Real> out;
    BodyTable<Real>& t = out.table;
    std::vector<int> steps(inputs.size());
    std::transform(inputs.begin(), inputs.end(), steps.begin(), time_steps);
    const auto key = [&](int i) {
        const BodyInput& in = inputs[size_t(i)];
        return std::tuple(kind_of(in.shape), !in.path.empty(), steps[size_t(i)]);
    };
    out.order.resize(inputs.size());
    std::iota(out.order.begin(), out.order.end(), 0);
    std::stable_sort(out.order.begin(), out.order.end(), [&](int a, int b) { return key(a) < key(b); });

    const bool any_motion =
        std::any_of(inputs.begin(), inputs.end(), [](const BodyInput& in) { return !in.path.empty(); });
    t.centers.reserve(inputs.size());
    for (size_t id = 0; id < out.order.size(); ++id) {
        const int source = out.order[id];
        const BodyInput& in = inputs[size_t(source)];
        const ShapeKind kind = kind_of(in.shape);
        if (id == 0 || key(out.order[id - 1]) != key(source))
            t.groups.push_back({kind, !in.path.empty(), steps[size_t(source)], int(id), 0, shape_count(t, kind)});
        ++t.groups.back().count;
        append_shape(t, in.shape);
        t.centers.emplace_back(in.path.empty() ? in.center : center_at<double>(in.path, 0.0));
        t.roles.push_back({in.role.rank, in.role.refracts, fills_a_volume(in)});
        t.surface_error.push_back(surface_error<Real>(in));
        if (any_motion) {
            t.motions.push_back({int(t.pieces.size()), int(in.path.size())});
            for (const MotionPiece<double>& p : in.path) t.pieces.push_back(cast<Real>(p));
        }
    }
    // Infinite planes have no bounds: they stay outside the accelerator. Moving and static ones share one group.
    t.plane_group.first = t.body_count();
    while (!t.groups.empty() && t.groups.back().kind == ShapeKind::plane) {
        const BodyGroup g = t.groups.back();
        t.groups.pop_back();
        t.plane_group.first = g.first;
        t.plane_group.count += g.count;
        t.plane_group.moving = t.plane_group.moving || g.moving;
    }
    return out;
}

template <class Real>
std::vector<Bounds> body_bounds(const BodyTable<Real>& t, const BodyGroup& g, int body) {
    const size_t shape = size_t(g.first_shape + body - g.first);
    std::vector<MotionPiece<double>> path;
    for (const MotionPiece<Real>& p : t.path(body)) path.push_back(cast<double>(p));
    const auto bound = [&](const auto& s) -> std::vector<Bounds> {
        if (path.empty()) return {around(Vec3d(t.centers[size_t(body)]), half_extent(s))};
        return bounds_over_time(path, swept_extent(s, path), g.time_steps);
    };
    switch (g.kind) {
        case ShapeKind::sphere:
            return bound(t.spheres[shape]);
        case ShapeKind::flat:
            return bound(t.flats[shape]);
        case ShapeKind::box:
            return bound(t.boxes[shape]);
        case ShapeKind::cylinder:
            return bound(t.cylinders[shape]);
        case ShapeKind::plane:
            break;
    }
    return {};
}

template BuiltTable<float> build_body_table<float>(const std::vector<BodyInput>&);
template BuiltTable<double> build_body_table<double>(const std::vector<BodyInput>&);
template std::vector<Bounds> body_bounds(const BodyTable<float>&, const BodyGroup&, int);
template std::vector<Bounds> body_bounds(const BodyTable<double>&, const BodyGroup&, int);

}  // namespace drt
