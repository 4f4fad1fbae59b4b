#pragma once
// compile(SceneDesc, options) -> RenderPlan: what is needed, the world that rays see, and the reasons. The only room
// that knows both what the user wrote and what a ray needs.

#include <memory>
#include <string>
#include <variant>

#include "drt/plan/exposure.h"
#include "drt/plan/features.h"
#include "drt/plan/sights.h"
#include "drt/plan/world.h"
#include "drt/scene/scene_desc.h"

namespace drt {

struct PlanOptions {
    int frame = 0;
    std::string camera;    ///< "" = the one that records the frame
    bool general = false;  ///< keep everything in: --plan=general
    enum class Precision { automatic, single, double_ } precision = Precision::automatic;
    SamplerKind sampler = SamplerKind::sobol;
    bool checker_for_missing_textures = false;
};

struct RenderPlan {
    int width = 0, height = 0;
    Features features;
    Explanation explanation;
    Exposure exposure;
    std::variant<std::unique_ptr<World<float>>, std::unique_ptr<World<double>>> world;
    Sights sights;
    bool random = true;      ///< false: all samples of a pixel are the same path
    Diagnostics notes;       ///< warnings met while compiling, such as textures replaced by a checker
    std::size_t memory = 0;  ///< bytes held by the world, Embree's included
};

class TextureCache;

/// The scene must have passed validate(). Throws Error (usage: no camera records the frame; asset: a texture or a
/// sphere set cannot be read; memory). With a cache (texture_cache.h), textures are decoded for the first of several
/// frames only.
RenderPlan compile(const SceneDesc&, const PlanOptions&, TextureCache&);
RenderPlan compile(const SceneDesc&, const PlanOptions&);

}  // namespace drt
