#pragma once
// The Phong model of light arriving from one direction (model.md section 2): k_d max(0, L.N) + k_s max(0, R.V)^alpha,
// R the mirror image of L about N, V towards the viewer. Not normalised, by design: it is the thesis' picture.

#include "drt/base/color.h"
#include "drt/base/math.h"
#include "drt/base/vec.h"

namespace drt {

template <class F>
struct PhongParameters {
    Color3<F> diffuse, specular;
    F shininess;
};

/// `n` faces the viewer; wi, wo are unit vectors away from the surface; 0 where wi is below the surface.
template <class F>
[[gnu::always_inline]] inline Color3<F> phong_diffuse(const PhongParameters<F>& p, const F& cos_i) {
    return p.diffuse * max(cos_i, F(0));
}

template <class F>
[[gnu::always_inline]] inline Color3<F> phong_specular(const PhongParameters<F>& p, const Vec3<F>& n, const Vec3<F>& wi,
                                                       const Vec3<F>& wo, const F& cos_i) {
    const Vec3<F> r = n * (F(2) * cos_i) - wi;
    const Vec3<F> gap = r - wo;
    const F highlight = pow_cos(dot(r, wo), dot(gap, gap) * F(0.5f), p.shininess);
    return p.specular * select(cos_i > F(0), highlight, F(0));
}

}  // namespace drt
