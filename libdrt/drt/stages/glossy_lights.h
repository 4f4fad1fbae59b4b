#pragma once
// Glossy reflections of visible lights: light samples and the lobe's own rays both find them, and each is weighed by
// how well it does: the power heuristic of Veach, "Robust Monte Carlo Methods for Light Transport Simulation", 1997. A
// dull reflection of a small light is left to light samples, a sharp one of a large light to the lobe.

#include "drt/plan/world.h"
#include "drt/stages/ray_batch.h"

namespace drt {

/// The weight of a sample of density a > 0 that another method takes with density b >= 0: a^2 / (a^2 + b^2).
template <class F>
[[gnu::always_inline]] inline F power_heuristic(const F& a, const F& b) {
    const F ratio = min(F(b / a), F(1e18f));  // its square is finite
    return F(1) / (F(1) + ratio * ratio);
}

/// The glossy reflection at the surface points of packet i.
template <class Real>
struct ReflectionLobe {
    using P = Pack<Real>;
    Vec3<typename P::R> axis, n;
    typename P::I lobe;
    typename P::F reflectance;
    typename P::F choice;  ///< probability that scatter takes it
    typename P::Mask glossy;
};

template <class Real>
[[gnu::always_inline]] inline ReflectionLobe<Real> reflection_lobe(const World<Real>& w, const RayBatch<Real>& b, int i,
                                                                   const typename Pack<Real>::I& material) {
    using R = typename Pack<Real>::R;
    using F = typename Pack<Real>::F;
    using I = typename Pack<Real>::I;
    const Vec3<R> d = load3<R>(b.d, i), n = load3<R>(b.n, i);
    const F kr = gather_coherent<F>(w.materials.reflectance.data(), material);
    const I lobe = gather_coherent<I>(w.materials.reflection_lobe.data(), material);
    ReflectionLobe<Real> out{
        d - n * (R(2) * dot(d, n)), n, lobe, kr, F(1), kr > F(0) && mask_cast<F>(lobe != I(sharp))};
    if (w.features.refraction) {
        const F kt = gather_coherent<F>(w.materials.refraction.data(), material);
        out.choice = kr / max(kr + kt, F(1e-30f));
    }
    return out;
}

/// The density per steradian, given that the lobe was chosen, of its rays that leave along wi: the lobe itself and its
/// tail, which is mirrored back about the tangent plane. 0 for sharp reflections.
template <class Real>
[[gnu::always_inline]] inline typename Pack<Real>::F density_along(const World<Real>& w, const ReflectionLobe<Real>& l,
                                                                   const Vec3<typename Pack<Real>::R>& wi) {
    using R = typename Pack<Real>::R;
    using F = typename Pack<Real>::F;
    using I = typename Pack<Real>::I;
    if (!any(l.glossy)) return F(0);
    const I lobe = max(l.lobe, I(0));
    const auto of = [&](const Vec3<R>& direction) {
        return lobe_density(w.materials.lobes, lobe, num_cast<F>(length_squared(direction - l.axis)));
    };
    return select(l.glossy, of(wi) + of(wi - l.n * (R(2) * dot(wi, l.n))), F(0));
}

}  // namespace drt
