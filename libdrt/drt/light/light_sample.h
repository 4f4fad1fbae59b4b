#pragma once
// How each kind of light is sampled from a shaded point.
//
// A sample gives I_l of the Phong formula for one point of the light: for falloff `none` the light's colour, for
// `inverse_square` E / pi, with E the irradiance that a small piece of the light's measure lays on a plane facing it,
// divided by the sample's density. The expectation over the sample is the integral over the light.

#include "drt/base/constants.h"
#include "drt/base/frame.h"
#include "drt/light/light_table.h"
#include "drt/sampling/warps.h"

namespace drt {

template <class T>
struct LightSample {
    Vec3<T> wi;                          ///< unit, towards the sampled point of the light
    T distance;                          ///< to that point
    Color3<Rebind<T, float>> intensity;  ///< I_l, including 1 / pdf
    MaskOf<Rebind<T, float>> lit;        ///< false: the light sends nothing here
};

namespace light_detail {

/// Without the intensity.
template <class T>
[[gnu::always_inline]] inline LightSample<T> towards(const Vec3<T>& from, const Vec3<T>& to) {
    using F = Rebind<T, float>;
    const Vec3<T> v = to - from;
    const T d2 = dot(v, v);
    const T inverse = inverse_sqrt(d2);
    return {v * inverse, d2 * inverse, Color3<F>(F(0)), mask_cast<F>(d2 > T(0))};
}

/// E / pi is unbounded as a light is approached; this keeps it finite, far beyond the film's own clamp.
template <class T>
[[gnu::always_inline]] inline void set_intensity(LightSample<T>& s, const LightCommon<Rebind<T, float>>& light,
                                                 const T& physical_factor) {
    using F = Rebind<T, float>;
    const F factor = min(num_cast<F>(physical_factor), F(1e30f));
    s.intensity = light.color * select(light.inverse_square, factor, F(1));
    s.lit = s.lit && (factor > F(0) || !light.inverse_square);
}

}  // namespace light_detail

template <class T>
[[gnu::always_inline]] inline LightSample<T> sample_light(const PointLightData<T>& l, const Vec3<T>& p,
                                                          const Vec2<T>&) {
    using Real = ScalarOf<T>;
    LightSample<T> s = light_detail::towards(p, l.position);
    const T inverse = reciprocal(s.distance);
    light_detail::set_intensity(s, l, T(1 / pi<Real>) * (inverse * inverse));
    return s;
}

/// Uniform over the rectangle.
template <class T>
[[gnu::always_inline]] inline LightSample<T> sample_light(const RectLightData<T>& l, const Vec3<T>& p,
                                                          const Vec2<T>& u) {
    using Real = ScalarOf<T>;
    using std::abs;
    LightSample<T> s = light_detail::towards(p, l.corner + l.edge_x * u.x + l.edge_y * u.y);
    const T cosine = -dot(s.wi, l.normal);
    const T facing = select(l.two_sided, abs(cosine), max(cosine, T(0)));
    const T inverse = reciprocal(s.distance);
    light_detail::set_intensity(s, l, (facing * inverse) * (l.area * T(1 / pi<Real>) * inverse));
    return s;
}

namespace light_detail {

/// The legacy bulb: a point on the disc that faces p, its radius uniform. With inverse_square the disc has the bulb's
/// power: E / pi = colour (pi r^2 / d^2) / pi.
template <class T>
[[gnu::always_inline]] inline LightSample<T> sample_radial(const SphereLightData<T>& l, const Vec3<T>& p,
                                                           const Frame<T>& frame, const T& d, const Vec2<T>& u) {
    const Vec2<T> disc = radial_disc(u);
    LightSample<T> s = towards(p, l.center + (frame.x * disc.x + frame.y * disc.y) * l.radius);
    set_intensity(s, l, l.radius * l.radius / (d * d));
    return s;
}

/// Uniform over the cone of directions to the sphere.
template <class T>
[[gnu::always_inline]] inline LightSample<T> sample_cone(const SphereLightData<T>& l, const Frame<T>& frame, const T& d,
                                                         const Vec2<T>& u) {
    using F = Rebind<T, float>;
    using Real = ScalarOf<T>;
    using std::sqrt;
    const T sin_max = l.radius / d;
    const LocalDirection<T> cone = uniform_cone(u, sin_max);
    const T sin2 = cone.one_minus_cos * (T(2) - cone.one_minus_cos);
    LightSample<T> s;
    s.wi = frame.to_world(cone.direction);
    s.distance = d * (T(1) - cone.one_minus_cos) - sqrt(max(l.radius * l.radius - d * d * sin2, T(0)));
    s.lit = mask_cast<F>(T(0) < d);
    set_intensity(s, l, cone_solid_angle(sin_max) * T(1 / pi<Real>));
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
    else {
        const LightSample<T> a = light_detail::sample_cone(l, frame, axis.distance, u);
        const LightSample<T> b = light_detail::sample_radial(l, p, frame, axis.distance, u);
        const auto radial = mask_cast<F>(l.radial);
        s = {select(l.radial, b.wi, a.wi), select(l.radial, b.distance, a.distance),
             select(radial, b.intensity, a.intensity), (radial && b.lit) || (!radial && a.lit)};
    }
    s.lit = s.lit && mask_cast<F>(axis.distance > l.radius);  // inside the bulb its surface shines away from us
    return s;
}

}  // namespace drt
