#pragma once
// The scene with its references resolved, and the one question asked of it: what does a ray hit first?

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "drt/image/image.h"
#include "drt/scene/scene_desc.h"
#include "reference/motion.h"
#include "reference/shapes.h"
#include "support/estimate.h"

namespace drt::reference {

struct WorldBody {
    Shape shape;
    const Motion* motion = nullptr;
    Material material;
    int priority = 0;
    std::shared_ptr<const Image> texture;  ///< null: none
    const Light* light = nullptr;          ///< set: this is a visible light's own body; it has no material
};

struct World {
    explicit World(const SceneDesc&);
    const SceneDesc& scene;
    std::vector<WorldBody> bodies;
};

/// The world at a scene time: where its moving bodies are.
struct Instant {
    Instant(const World&, double time);
    const World& world;
    std::vector<Pose> poses;  ///< of each body; meaningful for those that move
};

struct Hit {
    const WorldBody* body = nullptr;
    double distance = 0;
    Vec3d point, normal;                      ///< world; the unit geometric normal
    Vec3d described_point, described_normal;  ///< the same in the pose that the scene describes
};

std::optional<Hit> hit_body(const WorldBody&, const Pose&, const Ray&);

/// The nearest hit.
std::optional<Hit> first_hit(const Instant&, const Ray&);

/// Whether anything but the body of `light` is between `from` and `to`, of bodies that count.
bool occluded(const Instant&, const Vec3d& from, const Vec3d& to, const Light* light,
              const std::function<bool(const WorldBody&)>& counts);

/// Colour of the body's texture at the hit: bilinear, repeated; texel centres are at half coordinates.
Rgb texture_color(const Hit&);

}  // namespace drt::reference
