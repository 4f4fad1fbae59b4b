#pragma once
// The ball scene in bare Embree, for yardsticks: no drt code between the rays and the library. Two builds of it: SIMD
// user geometry (what packet queries can do at best) and Embree's own SPHERE_POINT and quads.

#include <memory>
#include <vector>

#include "drt/base/simd.h"
#include "drt/scene/scene_desc.h"
#include "embree.h"

namespace drt {

inline constexpr int packet_width = Pack<float>::width;

/// Bodies as the callbacks read them: spheres that move linearly over the exposure, axis-aligned boxes.
struct BareBodies {
    struct Sphere {
        Vec3f center, velocity;  ///< centre = center + time * velocity
        float radius;
    };
    struct BoxBody {
        Vec3f center, half;
    };
    std::vector<Sphere> still, moving;
    std::vector<BoxBody> boxes;
    Vec3d origin;  ///< subtracted from all coordinates
};

/// `origin` as the plan chose it, so that recorded rays fit.
BareBodies bare_bodies(const SceneDesc&, const Vec3d& origin);

struct BareScene {
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    std::vector<std::shared_ptr<void>> data;  ///< what the callbacks read
    BareScene() = default;
    BareScene(const BareScene&) = delete;
    BareScene& operator=(const BareScene&) = delete;
    ~BareScene();
};

/// Spheres and boxes as user geometry with SIMD callbacks for whole packets, ROBUST as the renderer's.
std::unique_ptr<BareScene> build_packet_scene(const BareBodies&);
/// SPHERE_POINT and quads, Embree's own intersectors.
std::unique_ptr<BareScene> build_point_scene(const BareBodies&);

}  // namespace drt
