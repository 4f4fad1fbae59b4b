#include "drt/stages/stages.h"
#include "drt/stages/texture_mapping.h"

namespace drt {

template <class Real>
void surface_stage(StageContext<Real>& c) {
    using P = Pack<Real>;
    using R = typename P::R;
    using F = typename P::F;
    using I = typename P::I;
    const World<Real>& w = *c.world;
    RayBatch<Real>& b = *c.batch;
    for (int i = 0; i < b.count; i += P::width) {
        const I body = load<I>(b.body.at(i));
        const auto hit = body >= I(0);
        if (!any(hit)) {  // before the tables are read: a scene without bodies has none
            store(I(-1), b.material.at(i));
            continue;
        }
        const I material = select(hit, gather_coherent<I>(w.body_material.data(), max(body, I(0))), I(-1));
        store(material, b.material.at(i));
        const Vec3<R> d = load3<R>(b.d, i);
        const R t = load<R>(b.t.at(i));
        const Vec3<R> ng = normalize(load3<R>(b.ng, i));
        const auto outward = dot(d, ng) < R(0);
        store3(load3<R>(b.o, i) + d * t, b.p, i);
        store3(select(outward, ng, -ng), b.n, i);
        store(select(mask_cast<I>(outward), I(1), I(0)), b.outward.at(i));
        Color3<F> albedo = gather_color<F>(w.materials.diffuse, max(material, I(0)));
        if (w.features.textures) {
            store(load<F>(b.footprint.at(i)) + load<F>(b.spread.at(i)) * num_cast<F>(t), b.footprint.at(i));
            albedo = texture_color(w, b, i, material, albedo);
        }
        store_color(albedo, b.albedo, i);
    }
}

template void surface_stage(StageContext<float>&);
template void surface_stage(StageContext<double>&);

}  // namespace drt
