#pragma once
// What a ray needs, for one frame: flat arrays and ids, no strings. Coordinates are relative to `origin`, the eye at
// shutter open, so that float keeps its digits where the camera looks.

#include <memory>
#include <vector>

#include "drt/accel/accel.h"
#include "drt/camera/camera_model.h"
#include "drt/geometry/body_table.h"
#include "drt/light/light_table.h"
#include "drt/material/material_table.h"
#include "drt/plan/features.h"
#include "drt/sampling/filter.h"
#include "drt/sampling/sampler.h"
#include "drt/texture/texture_map.h"

namespace drt {

/// How a body's surface is laid out for textures. Directions are unit vectors in the body's described orientation.
enum class MappingKind : std::uint8_t { planar, spherical, box, cylindrical };

template <class Real>
struct Mapping {
    MappingKind kind = MappingKind::planar;
    Vec3<Real> ax, ay,
        az;             ///< planar: u, v directions; spherical: meridian, its perpendicular, pole; box, cylinder: axes
    Vec3<Real> origin;  ///< planar: where (u, v) = (0, 0), relative to the body's centre; box: half extents;
                        ///< cylinder: (radius, half height, -)
};

/// Where a body's shape is: BodyTable's array of its kind.
struct ShapeRef {
    ShapeKind kind = ShapeKind::sphere;
    int body = 0, shape = 0;
};

/// A body that shines: a visible light.
struct Emitter {
    Color radiance;
    bool two_sided = true;
    LightId light = no_light;  ///< none if it is black
};

inline constexpr int most_media = 64;  ///< bodies that refract that a path can be inside of at once

struct SamplePlan {
    std::uint32_t seed = 0, frame = 0;
    SamplerKind kind = SamplerKind::sobol;
    int max_depth = 0;
    int media_capacity = 0;  ///< entries of the media stack a path carries; 0 when nothing refracts
    int roulette_depth = 0;  ///< bounces before Russian roulette starts
    float roulette_threshold = 0;
};

/// What the picture shows where a camera ray meets nothing. A background is part of the picture; without one, it being
/// black, and where it is asked to be transparent, there is nothing to cover what the picture is laid over.
struct CameraBackground {
    Color color{0.0f};
    float alpha = 0;
};

/// Textures by number. Other worlds may share them.
struct SharedTextures {
    std::vector<std::shared_ptr<const TextureMap>> maps;
    const TextureMap& operator[](std::size_t i) const { return *maps[i]; }
};

template <class Real>
struct World {
    using RealType = Real;
    Features features;
    Vec3d origin;
    BodyTable<Real> bodies;
    std::unique_ptr<Accel<Real>> accel;
    std::vector<int> body_material;  ///< per body; emitters have none (-1)
    std::vector<int> body_emitter;   ///< per body, index in `emitters` or -1; empty without visible lights
    std::vector<int> body_mapping;   ///< per body, index in `mappings` or -1; empty without textures
    std::vector<Mapping<Real>> mappings;
    std::vector<Emitter> emitters;
    std::vector<ShapeRef> eye_media;  ///< bodies that refract and that the eye may be inside of
    MaterialTable materials;
    SharedTextures textures;
    LightTable<Real> lights;
    CameraModel<Real> camera;
    View<Real> view;  ///< of a camera that stands still
    FilterTable filter;
    Color background;           ///< what a ray sees that meets nothing
    CameraBackground backdrop;  ///< what a camera ray sees then
    SamplePlan sampling;
};

}  // namespace drt
