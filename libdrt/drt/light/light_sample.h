#pragma once
// How each kind of light is sampled from a shaded point, and the density of that.
//
// A sample stands for I_l of the Phong formula, the intensity that a point of the light lays on a surface: radiance /
// (pi pdf). For falloff `inverse_square`, radiance is what arrives from direction wi and pdf is in solid angle; the
// mean over the samples is E / pi, with E the irradiance of the whole light on a plane facing wi. Points have no solid
// angle: their pdf is 1 and the radiance stands for the irradiance. For falloff `none` pdf is 1 / pi: I_l is the
// colour.

#include "drt/base/constants.h"
#include "drt/base/frame.h"
#include "drt/light/light_table.h"
#include "drt/sampling/spherical_triangle.h"
#include "drt/sampling/warps.h"

namespace drt {

template <class T>
struct LightSample {
    using F = Rebind<T, float>;
    Vec3<T> wi;          ///< unit, towards the sampled point of the light
    T distance;          ///< to that point
    Color3<F> radiance;  ///< along wi
    F pdf;               ///< per steradian
    MaskOf<F> is_delta;  ///< pdf is no density over solid angle that a ray could be weighed by
    MaskOf<F> lit;       ///< false: the light sends nothing here
};

/// I_l, for one of `samples` samples that are taken of the light in the mean.
template <class T>
[[gnu::always_inline]] inline Color3<Rebind<T, float>> intensity(const LightSample<T>& s,
                                                                 const Rebind<T, float>& samples = 1.0f) {
    using F = Rebind<T, float>;
    return s.radiance * reciprocal(F(s.pdf * (samples * F(pi<float>))));
}

template <class T>
[[gnu::always_inline]] inline LightSample<T> select(const MaskOf<Rebind<T, float>>& m, const LightSample<T>& a,
                                                    const LightSample<T>& b) {
    const auto real = mask_cast<T>(m);
    return {select(real, a.wi, b.wi), select(real, a.distance, b.distance),    select(m, a.radiance, b.radiance),
            select(m, a.pdf, b.pdf),  (m && a.is_delta) || (!m && b.is_delta), (m && a.lit) || (!m && b.lit)};
}

namespace light_detail {

/// Without radiance and density.
template <class T>
[[gnu::always_inline]] inline LightSample<T> towards(const Vec3<T>& from, const Vec3<T>& to) {
    using F = Rebind<T, float>;
    const Vec3<T> v = to - from;
    const T d2 = dot(v, v);
    const T inverse = inverse_sqrt(d2);
    return {v * inverse, d2 * inverse, Color3<F>(F(0)), F(0), MaskOf<F>(false), mask_cast<F>(d2 > T(0))};
}

/// Of a light that sends its colour along wi. Without falloff it is lit whatever the density.
template <class T>
[[gnu::always_inline]] inline void set_radiance(LightSample<T>& s, const LightCommon<Rebind<T, float>>& light,
                                                const T& pdf, const MaskOf<Rebind<T, float>>& sends) {
    using F = Rebind<T, float>;
    s.radiance = light.color;
    s.pdf = select(light.inverse_square, num_cast<F>(pdf), F(1 / pi<float>));
    s.is_delta = s.is_delta || !light.inverse_square;
    s.lit = s.lit && (sends || !light.inverse_square);
}

}  // namespace light_detail

// light_pdf is the density of sample_light at p for the direction wi that meets the light at a distance, per steradian;
// 0 where the samples have none.

/// The irradiance is unbounded as the light is approached; 1e30 of the intensity keeps it finite.
template <class T>
[[gnu::always_inline]] inline LightSample<T> sample_light(const PointLightData<T>& l, const Vec3<T>& p,
                                                          const Vec2<T>&) {
    using F = Rebind<T, float>;
    LightSample<T> s = light_detail::towards(p, l.position);
    const T inverse = reciprocal(s.distance);
    const F factor = min(num_cast<F>(T(inverse * inverse)), F(1e30f));
    s.radiance = l.color * select(l.inverse_square, factor, F(1));
    s.pdf = select(l.inverse_square, F(1), F(1 / pi<float>));
    s.is_delta = MaskOf<F>(true);
    s.lit = s.lit && (factor > F(0) || !l.inverse_square);
    return s;
}

template <class T>
[[gnu::always_inline]] inline Rebind<T, float> light_pdf(const PointLightData<T>&, const Vec3<T>&, const Vec3<T>&,
                                                         const T&) {
    return 0;
}

// ---- rectangles ----------------------------------------------------------------------------------------------------

/// Whether p is so near that the light is sampled over its solid angle: within the longer diagonal of its centre, and
/// within 0.4 of that of its plane, as higher up the area does as well for less (docs/lights.md). Of what is seen
/// edge-on only over the area: hardly anything comes from there, and directions lose their digits.
template <class T>
[[gnu::always_inline]] inline MaskOf<T> is_near(const RectLightData<T>& l, const Vec3<T>& p) {
    const Vec3<T> v = l.center - p;
    const auto within = length_squared(v) < l.near2;
    if (!any(within)) return within;
    const T height = dot(v, l.normal);
    return within && height * height < l.near2 * T(0.16f);
}

namespace light_detail {

/// A parallelogram as two spherical triangles in a fan about its corner, (x, corner, xy) and (xy, corner, y): what is
/// uniform in both is continuous from the one to the other.
template <class T>
struct RectView {
    SphericalTriangle<T> first, second;
    T height;  ///< of p above the light's plane, on the side of its normal
    T solid_angle() const { return first.area + second.area; }
};

/// In double, whatever T: under a ceiling a thousand times as wide as it is high, two corners are so nearly opposite
/// that directions in float would be off by a percent of the light. Only near lights pay for it.
template <class T>
[[gnu::always_inline]] inline RectView<Rebind<T, double>> view_rect(const RectLightData<T>& l, const Vec3<T>& p) {
    using D = Rebind<T, double>;
    using std::abs;
    const Vec3<D> o = Vec3<D>(l.corner) - Vec3<D>(p), edge_y(l.edge_y);
    const Vec3<D> x = o + Vec3<D>(l.edge_x), y = o + edge_y, xy = x + edge_y;
    const D inverse_o = inverse_sqrt(dot(o, o)), inverse_x = inverse_sqrt(dot(x, x));
    const D inverse_y = inverse_sqrt(dot(y, y)), inverse_xy = inverse_sqrt(dot(xy, xy));
    const D height = -dot(o, Vec3<D>(l.normal));
    // The determinant of three corners is the same for both: the volume of the prism over the parallelogram.
    const D det = abs(height) * num_cast<D>(l.area) * inverse_o * inverse_xy;
    const Vec3<D> to_o = o * inverse_o, to_xy = xy * inverse_xy;
    return {spherical_triangle(x * inverse_x, to_o, to_xy, D(det * inverse_x)),
            spherical_triangle(to_xy, to_o, y * inverse_y, D(det * inverse_y)), height};
}

template <class T>
[[gnu::always_inline]] inline MaskOf<T> wide_enough(const RectView<T>& v) {
    return v.solid_angle() > T(1e-3f);
}

/// Uniform over the solid angle.
template <class T>
[[gnu::always_inline]] inline LightSample<T> sample_view(const RectLightData<T>& l,
                                                         const RectView<Rebind<T, double>>& v, const Vec2<T>& u) {
    using F = Rebind<T, float>;
    using D = Rebind<T, double>;
    using std::abs;
    const D solid_angle = v.solid_angle(), at = num_cast<D>(u.x) * solid_angle;
    const auto in_first = at < v.first.area;
    const Vec3<D> wi = normalize(uniform_spherical_triangle(
        select(in_first, v.first, v.second), D(at - select(in_first, D(0), v.first.area)), num_cast<D>(u.y)));
    LightSample<T> s;
    s.wi = Vec3<T>(wi);
    s.distance = num_cast<T>(D(abs(v.height / dot(wi, Vec3<D>(l.normal)))));
    s.radiance = l.color;
    s.pdf = num_cast<F>(D(D(1) / solid_angle));
    s.is_delta = MaskOf<F>(false);
    const auto above = mask_cast<F>(v.height > D(0)), below = mask_cast<F>(v.height < D(0));
    s.lit = above || (mask_cast<F>(l.two_sided) && below);
    return s;
}

}  // namespace light_detail

/// Uniform over the area.
template <class T>
[[gnu::always_inline]] inline LightSample<T> sample_area(const RectLightData<T>& l, const Vec3<T>& p,
                                                         const Vec2<T>& u) {
    using F = Rebind<T, float>;
    using std::abs;
    LightSample<T> s = light_detail::towards(p, l.corner + l.edge_x * u.x + l.edge_y * u.y);
    const T cosine = -dot(s.wi, l.normal);
    const T facing = select(l.two_sided, abs(cosine), max(cosine, T(0)));
    light_detail::set_radiance(s, l, s.distance * (s.distance / (facing * l.area)), mask_cast<F>(facing > T(0)));
    return s;
}

/// Uniform over the area; near the light over the solid angle, as the area would send nearly all samples to where they
/// count little. Without falloff always over the area.
template <class T>
[[gnu::always_inline]] inline LightSample<T> sample_light(const RectLightData<T>& l, const Vec3<T>& p,
                                                          const Vec2<T>& u) {
    using F = Rebind<T, float>;
    using namespace light_detail;
    const LightSample<T> s = sample_area(l, p, u);
    const auto near = is_near(l, p);
    if (!any(near)) return s;
    const auto view = view_rect(l, p);
    return select(mask_cast<F>(near) && mask_cast<F>(wide_enough(view)), sample_view(l, view, u), s);
}

/// Where wi meets the light at the distance.
template <class T>
[[gnu::always_inline]] inline Rebind<T, float> light_pdf(const RectLightData<T>& l, const Vec3<T>& p, const Vec3<T>& wi,
                                                         const T& distance) {
    using F = Rebind<T, float>;
    using namespace light_detail;
    using std::abs;
    const T over_area = distance * (distance / (abs(dot(wi, l.normal)) * l.area));
    const auto near = is_near(l, p);
    if (!any(near)) return num_cast<F>(over_area);
    const auto view = view_rect(l, p);
    const F over_solid_angle = F(1) / num_cast<F>(view.solid_angle());
    return select(mask_cast<F>(near) && mask_cast<F>(wide_enough(view)), over_solid_angle, num_cast<F>(over_area));
}

// ---- spheres -------------------------------------------------------------------------------------------------------

namespace light_detail {

/// The legacy bulb: a point on the disc that faces p, its radius uniform. With inverse_square the disc has the bulb's
/// power: E / pi = colour (pi r^2 / d^2) / pi for every point of it, which is no density of directions.
template <class T>
[[gnu::always_inline]] inline LightSample<T> sample_radial(const SphereLightData<T>& l, const Vec3<T>& p,
                                                           const Frame<T>& frame, const T& d, const Vec2<T>& u) {
    using F = Rebind<T, float>;
    const Vec2<T> disc = radial_disc(u);
    LightSample<T> s = towards(p, l.center + (frame.x * disc.x + frame.y * disc.y) * l.radius);
    s.is_delta = MaskOf<F>(true);
    set_radiance(s, l, T((d / l.radius) * (d / l.radius) * T(1 / pi<ScalarOf<T>>)), MaskOf<F>(true));
    return s;
}

/// 1 - cos of the cone of directions in which the sphere is seen from the distance d: all directions from inside.
template <class T>
[[gnu::always_inline]] inline T visible_cap(const SphereLightData<T>& l, const T& d) {
    return select(d > l.radius, one_minus_cos_from_sin(T(l.radius / d)), T(2));
}

/// Uniform over the directions in which the sphere is seen. From outside they meet its near side.
template <class T>
[[gnu::always_inline]] inline LightSample<T> sample_visible(const SphereLightData<T>& l, const Frame<T>& frame,
                                                            const T& d, const Vec2<T>& u) {
    using F = Rebind<T, float>;
    using std::sqrt;
    const T cap = visible_cap(l, d);
    const LocalDirection<T> cone = uniform_cap(u, cap);
    const T sin2 = cone.one_minus_cos * (T(2) - cone.one_minus_cos);
    const T half_chord = sqrt(max(l.radius * l.radius - d * d * sin2, T(0)));
    LightSample<T> s;
    s.wi = frame.to_world(cone.direction);
    s.distance = d * (T(1) - cone.one_minus_cos) + select(d > l.radius, -half_chord, half_chord);
    s.is_delta = MaskOf<F>(false);
    s.lit = MaskOf<F>(true);
    set_radiance(s, l, T(T(1 / (2 * pi<ScalarOf<T>>)) / cap), mask_cast<F>(cap > T(0)));
    return s;
}

}  // namespace light_detail

/// Inside, a visible sphere is seen to shine, and so it lights; an invisible one shines outwards only.
template <class T>
[[gnu::always_inline]] inline LightSample<T> sample_light(const SphereLightData<T>& l, const Vec3<T>& p,
                                                          const Vec2<T>& u) {
    using F = Rebind<T, float>;
    using I = Rebind<T, std::int32_t>;
    using namespace light_detail;
    const LightSample<T> axis = towards(p, l.center);
    const auto off_center = mask_cast<T>(axis.lit);
    const T d = select(off_center, axis.distance, T(0));
    const Frame<T> frame = frame_around(select(off_center, axis.wi, Vec3<T>{T(0), T(0), T(1)}));
    const auto outside = d > l.radius;
    const auto radial = l.radial && outside;
    LightSample<T> s;
    if (!any(radial))
        s = sample_visible(l, frame, d, u);
    else if (all(radial))
        s = sample_radial(l, p, frame, d, u);
    else
        s = select(mask_cast<F>(radial), sample_radial(l, p, frame, d, u), sample_visible(l, frame, d, u));
    s.lit = s.lit && (mask_cast<F>(outside) || mask_cast<F>(l.body >= I(0)));
    return s;
}

template <class T>
[[gnu::always_inline]] inline Rebind<T, float> light_pdf(const SphereLightData<T>& l, const Vec3<T>& p, const Vec3<T>&,
                                                         const T&) {
    using F = Rebind<T, float>;
    const T d = length(l.center - p);
    const T pdf = T(1 / (2 * pi<ScalarOf<T>>)) / light_detail::visible_cap(l, d);
    return num_cast<F>(select(l.radial && d > l.radius, T(0), pdf));
}

// ---- any kind ------------------------------------------------------------------------------------------------------

/// A light of its own for every lane.
template <class T>
struct PickedSample {
    LightSample<T> sample;
    Rebind<T, std::int32_t> body;  ///< that shows the light, or -1
};

/// Of the light that each lane's id names; not lit where there is none. T is lanes of Real.
template <class T, class I>
[[gnu::always_inline]] inline PickedSample<T> sample_picked(const LightTable<ScalarOf<T>>& t, const I& id,
                                                            const Vec3<T>& p, const Vec2<T>& u) {
    using F = Rebind<T, float>;
    PickedSample<T> out{{}, I(-1)};
    out.sample.lit = MaskOf<F>(false);
    const I kind = select(id < I(0), I(-1), I(id & I(3)));
    const auto of_kind = [&](LightKind k, const auto& lights) {
        const auto mine = kind == I(int(k));
        if (!any(mine)) return;
        const auto light = pick<T>(lights, select(mine, light_id::index(id), I(0)));
        out.sample = select(mask_cast<F>(mine), sample_light(light, p, u), out.sample);
        out.body = select(mine, light.body, out.body);
    };
    of_kind(LightKind::point, t.points);
    of_kind(LightKind::rect, t.rects);
    of_kind(LightKind::sphere, t.spheres);
    return out;
}

}  // namespace drt
