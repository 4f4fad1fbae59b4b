#pragma once
// The lights of a frame, one array per kind. A light's data is templated over the number type: scalars in the table,
// lanes where every lane of a packet looks at a light of its own.

#include <vector>

#include "drt/base/color.h"
#include "drt/base/constants.h"
#include "drt/base/vec.h"
#include "drt/light/light_tree.h"
#include "drt/sampling/distribution.h"

namespace drt {

/// What all kinds share. F is float or lanes of float.
template <class F>
struct LightCommon {
    Color3<F> color;             ///< I_l, radiance or radiant intensity: see light_sample.h
    MaskOf<F> inverse_square{};  ///< physical falloff; else none
    Rebind<F, int> body{-1};     ///< the body that shows this light, or -1 for an invisible light
};

template <class T>
struct PointLightData : LightCommon<Rebind<T, float>> {
    Vec3<T> position;
};

template <class T>
struct RectLightData : LightCommon<Rebind<T, float>> {
    Vec3<T> corner, edge_x, edge_y;
    Vec3<T> normal;  ///< unit, along cross(edge_x, edge_y)
    T area{};
    MaskOf<T> two_sided{};
    Vec3<T> center;
    T near2{};  ///< squared longer diagonal: how far from the centre it may be sampled by solid angle
};

template <class T>
struct SphereLightData : LightCommon<Rebind<T, float>> {
    Vec3<T> center;
    T radius{};
    MaskOf<T> radial{};  ///< the legacy bulb; else uniform over the visible cone
};

/// Near is what the longer diagonal spans. From farther off the distance and the cosine at the light vary so little
/// over the light that its area does as well, at a third of the price.
inline RectLightData<double> make_rect_light(const LightCommon<float>& common, const Vec3d& corner, const Vec3d& x,
                                             const Vec3d& y, bool two_sided) {
    const Vec3d n = cross(x, y);
    const double diagonal2 = std::max(length_squared(x + y), length_squared(x - y));
    return {common,
            corner,
            x,
            y,
            normalize(n),
            length(n),
            two_sided,
            corner + (x + y) * 0.5,
            common.inverse_square ? diagonal2 : 0};
}

/// Lights without falloff that are too many to be asked one by one.
struct PowerChoice {
    std::vector<LightId> lights;
    Distribution by_power;
};

/// Each light is asked in one of three ways, which plan_light_choice decides.
template <class Real>
struct LightTable {
    std::vector<PointLightData<Real>> points;
    std::vector<RectLightData<Real>> rects;
    std::vector<SphereLightData<Real>> spheres;
    std::vector<LightId> asked;  ///< by every hit
    LightTree tree;              ///< those with falloff, if they are many
    PowerChoice plain;           ///< those without, if they are many
    int count() const { return int(points.size() + rects.size() + spheres.size()); }
};

/// `visit(light)` with the one that the id names.
template <class Real, class Visit>
auto visit_light(const LightTable<Real>& t, LightId id, Visit visit) {
    const auto i = size_t(light_id::index(id));
    switch (light_id::kind(id)) {
        case LightKind::point:
            return visit(t.points[i]);
        case LightKind::rect:
            return visit(t.rects[i]);
        case LightKind::sphere:
            break;
    }
    return visit(t.spheres[i]);
}

/// The strength in the direction of the greatest, at a distance: W / sr for a light with falloff; else the colour.
template <class Real>
double strength(const PointLightData<Real>& l) {
    return luminance(Color3<double>(l.color));
}
template <class Real>
double strength(const RectLightData<Real>& l) {
    return luminance(Color3<double>(l.color)) * (l.inverse_square ? double(l.area) : 1);
}
template <class Real>
double strength(const SphereLightData<Real>& l) {
    return luminance(Color3<double>(l.color)) * (l.inverse_square ? pi<double> * double(l.radius * l.radius) : 1);
}

/// `get(light)` of every lane's light.
template <class L, class Data, class I, class Get>
L gather_field(const std::vector<Data>& lights, const I& index, Get get) {
    return L([&](auto i) { return ScalarOf<L>(get(lights[size_t(int(index[i]))])); });
}

namespace light_detail {

template <class V, class Data, class I, class Get>
Vec3<V> gather_vec(const std::vector<Data>& lights, const I& index, Get get) {
    return {gather_field<V>(lights, index, [&](const Data& l) { return get(l).x; }),
            gather_field<V>(lights, index, [&](const Data& l) { return get(l).y; }),
            gather_field<V>(lights, index, [&](const Data& l) { return get(l).z; })};
}

template <class M, class Data, class I, class Get>
M gather_mask(const std::vector<Data>& lights, const I& index, Get get) {
    M m(false);
    for (int i = 0; i < width_of<I>; ++i) m[i] = get(lights[size_t(lane(index, i))]);
    return m;
}

template <class F, class Data, class I>
void gather_common(LightCommon<F>& out, const std::vector<Data>& lights, const I& index) {
    out.color = {gather_field<F>(lights, index, [](const Data& l) { return l.color.r; }),
                 gather_field<F>(lights, index, [](const Data& l) { return l.color.g; }),
                 gather_field<F>(lights, index, [](const Data& l) { return l.color.b; })};
    out.inverse_square = gather_mask<MaskOf<F>>(lights, index, [](const Data& l) { return l.inverse_square; });
    out.body = gather_field<Rebind<F, int>>(lights, index, [](const Data& l) { return l.body; });
}

}  // namespace light_detail

/// A light of its own for every lane. T is lanes of Real.
template <class T, class I>
PointLightData<T> pick(const std::vector<PointLightData<ScalarOf<T>>>& lights, const I& index) {
    using D = PointLightData<ScalarOf<T>>;
    PointLightData<T> out;
    light_detail::gather_common<Rebind<T, float>>(out, lights, index);
    out.position = light_detail::gather_vec<T>(lights, index, [](const D& l) { return l.position; });
    return out;
}

template <class T, class I>
RectLightData<T> pick(const std::vector<RectLightData<ScalarOf<T>>>& lights, const I& index) {
    using D = RectLightData<ScalarOf<T>>;
    using namespace light_detail;
    RectLightData<T> out;
    gather_common<Rebind<T, float>>(out, lights, index);
    out.corner = gather_vec<T>(lights, index, [](const D& l) { return l.corner; });
    out.edge_x = gather_vec<T>(lights, index, [](const D& l) { return l.edge_x; });
    out.edge_y = gather_vec<T>(lights, index, [](const D& l) { return l.edge_y; });
    out.normal = gather_vec<T>(lights, index, [](const D& l) { return l.normal; });
    out.area = gather_field<T>(lights, index, [](const D& l) { return l.area; });
    out.two_sided = gather_mask<MaskOf<T>>(lights, index, [](const D& l) { return l.two_sided; });
    out.center = gather_vec<T>(lights, index, [](const D& l) { return l.center; });
    out.near2 = gather_field<T>(lights, index, [](const D& l) { return l.near2; });
    return out;
}

template <class T, class I>
SphereLightData<T> pick(const std::vector<SphereLightData<ScalarOf<T>>>& lights, const I& index) {
    using D = SphereLightData<ScalarOf<T>>;
    using namespace light_detail;
    SphereLightData<T> out;
    gather_common<Rebind<T, float>>(out, lights, index);
    out.center = gather_vec<T>(lights, index, [](const D& l) { return l.center; });
    out.radius = gather_field<T>(lights, index, [](const D& l) { return l.radius; });
    out.radial = gather_mask<MaskOf<T>>(lights, index, [](const D& l) { return l.radial; });
    return out;
}

template <class F>
LightCommon<F> cast_common(const LightCommon<float>& c) {
    return {Color3<F>(c.color), MaskOf<F>(c.inverse_square), Rebind<F, int>(c.body)};
}

/// To another number type: double to float, or one light for all lanes.
template <class To, class From>
PointLightData<To> cast(const PointLightData<From>& l) {
    return {cast_common<Rebind<To, float>>(l), Vec3<To>(l.position)};
}
template <class To, class From>
RectLightData<To> cast(const RectLightData<From>& l) {
    return {cast_common<Rebind<To, float>>(l),
            Vec3<To>(l.corner),
            Vec3<To>(l.edge_x),
            Vec3<To>(l.edge_y),
            Vec3<To>(l.normal),
            To(ScalarOf<To>(l.area)),
            MaskOf<To>(l.two_sided),
            Vec3<To>(l.center),
            To(ScalarOf<To>(l.near2))};
}
template <class To, class From>
SphereLightData<To> cast(const SphereLightData<From>& l) {
    return {cast_common<Rebind<To, float>>(l), Vec3<To>(l.center), To(ScalarOf<To>(l.radius)), MaskOf<To>(l.radial)};
}

template <class To, class From>
LightTable<To> cast(LightTable<From>&& t) {
    LightTable<To> out;
    for (const auto& l : t.points) out.points.push_back(cast<To>(l));
    for (const auto& l : t.rects) out.rects.push_back(cast<To>(l));
    for (const auto& l : t.spheres) out.spheres.push_back(cast<To>(l));
    out.asked = std::move(t.asked);
    out.tree = std::move(t.tree);
    out.plain = std::move(t.plain);
    return out;
}

}  // namespace drt
