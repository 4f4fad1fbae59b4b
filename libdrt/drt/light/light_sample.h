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

/// Uniform over the rectangle.
template <class T>
[[gnu::always_inline]] inline LightSample<T> sample_light(const RectLightData<T>& l, const Vec3<T>& p,
                                                          const Vec2<T>& u) {
    using F = Rebind<T, float>;
    using std::abs;
    LightSample<T> s = light_detail::towards(p, l.corner + l.edge_x * u.x + l.edge_y * u.y);
    const T cosine = -dot(s.wi, l.normal);
    const T facing = select(l.two_sided, abs(cosine), max(cosine, T(0)));
    light_detail::set_radiance(s, l, s.distance * (s.distance / (facing * l.area)), mask_cast<F>(facing > T(0)));
    return s;
}

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

/// Uniform over the cone of directions to the sphere.
template <class T>
[[gnu::always_inline]] inline LightSample<T> sample_cone(const SphereLightData<T>& l, const Frame<T>& frame, const T& d,
                                                         const Vec2<T>& u) {
    using F = Rebind<T, float>;
    using std::sqrt;
    const T sin_max = l.radius / d;
    const LocalDirection<T> cone = uniform_cone(u, sin_max);
    const T sin2 = cone.one_minus_cos * (T(2) - cone.one_minus_cos);
    LightSample<T> s;
    s.wi = frame.to_world(cone.direction);
    s.distance = d * (T(1) - cone.one_minus_cos) - sqrt(max(l.radius * l.radius - d * d * sin2, T(0)));
    s.is_delta = MaskOf<F>(false);
    s.lit = MaskOf<F>(true);
    const T solid_angle = cone_solid_angle(sin_max);
    set_radiance(s, l, T(1) / solid_angle, mask_cast<F>(solid_angle > T(0)));
    return s;
}

}  // namespace light_detail

template <class T>
[[gnu::always_inline]] inline LightSample<T> sample_light(const SphereLightData<T>& l, const Vec3<T>& p,
                                                          const Vec2<T>& u) {
    using F = Rebind<T, float>;
    const LightSample<T> axis = light_detail::towards(p, l.center);
    const Frame<T> frame = frame_around(axis.wi);
    LightSample<T> s;
    if (!any(l.radial))
        s = light_detail::sample_cone(l, frame, axis.distance, u);
    else if (all(l.radial))
        s = light_detail::sample_radial(l, p, frame, axis.distance, u);
    else
        s = select(mask_cast<F>(l.radial), light_detail::sample_radial(l, p, frame, axis.distance, u),
                   light_detail::sample_cone(l, frame, axis.distance, u));
    s.lit = s.lit && mask_cast<F>(axis.distance > l.radius);  // inside the bulb its surface shines away from us
    return s;
}

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
