#include "drt/geometry/contact.h"
#include "drt/stages/media.h"
#include "drt/stages/stages.h"

namespace drt {

namespace {

// Which of the points are inside the body at their rays' times.
template <class Real>
MaskOf<typename Pack<Real>::R> is_inside(const BodyTable<Real>& bodies, const ShapeRef& ref,
                                         const Vec3<typename Pack<Real>::R>& p, const typename Pack<Real>::R& time) {
    using R = typename Pack<Real>::R;
    Vec3<R> q = p - Vec3<R>(bodies.centers[size_t(ref.body)]);
    if (const auto path = bodies.path(ref.body); !path.empty()) {
        const Pose<R> pose = pose_at(path, time);
        q = rotate_back(pose.orientation, p - pose.center);
    }
    const size_t i = size_t(ref.shape);
    switch (ref.kind) {
        case ShapeKind::sphere:
            return drt::is_inside<R>(bodies.spheres[i], q);
        case ShapeKind::box:
            return drt::is_inside<R>(bodies.boxes[i], q);
        case ShapeKind::cylinder:
            return drt::is_inside<R>(bodies.cylinders[i], q);
        case ShapeKind::plane:
            return drt::is_inside<R>(bodies.planes[i], q);
        case ShapeKind::flat:
            break;
    }
    return MaskOf<R>(false);
}

}  // namespace

template <class Real>
void eye_media_stage(StageContext<Real>& c) {
    using P = Pack<Real>;
    using R = typename P::R;
    using F = typename P::F;
    RayBatch<Real>& b = *c.batch;
    const World<Real>& w = *c.world;
    for (int i = 0; i < b.count; i += P::width) {
        const Vec3<R> o = load3<R>(b.o, i);
        const R time = num_cast<R>(load<F>(b.time.at(i)));
        for (const ShapeRef& body : w.eye_media) {
            const auto inside = is_inside(w.bodies, body, o, time);
            for (int l = 0; l < P::width; ++l) {
                if (!inside[l] || b.slot[i + l] < 0) continue;
                MediaStack<Real> stack(b, b.slot[i + l]);
                if (!stack.enter(body.body, w.bodies.roles)) ++c.counters->media_overflows;
            }
        }
    }
}

template void eye_media_stage(StageContext<float>&);
template void eye_media_stage(StageContext<double>&);

}  // namespace drt
