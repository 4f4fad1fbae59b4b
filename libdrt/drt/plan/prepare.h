#pragma once
// The first half of compiling: everything resolved and in double, before a precision is chosen.

#include "drt/plan/body_build.h"
#include "drt/plan/plan.h"

namespace drt {

struct PreparedScene {
    Exposure exposure;
    Vec3d origin;  ///< eye at shutter open; already subtracted everywhere below
    std::vector<BodyInput> bodies;
    std::vector<int> body_material;  ///< index in SceneDesc::materials, -1 for emitters
    std::vector<int> body_emitter;   ///< index in emitters or -1
    std::vector<int> body_source;    ///< index in SceneDesc::bodies, -1 for emitters
    std::vector<int> body_mapping;   ///< index in mappings or -1
    std::vector<Mapping<double>> mappings;
    std::vector<Emitter> emitters;
    LightTable<double> lights;
    CameraModel<double> camera;
    std::vector<int> eye_media;  ///< bodies that refract and that the eye may be inside of, by index in `bodies`
};

PreparedScene prepare(const SceneDesc&, const PlanOptions&);

/// The part of prepare() that knows what a camera does over its video.
CameraModel<double> build_camera(const RenderSettings&, const Camera&, const Exposure&);

/// Float is enough while the hit point's error stays small against the shape it lies on and against a pixel. Returns
/// the reason for double, or "" when float will do. The bound is in docs/geometry.md.
std::string needs_double(const PreparedScene&);

}  // namespace drt
