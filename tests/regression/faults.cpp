#include "regression/faults.h"

#include <stdexcept>

#include "regression/regression.h"
#include "support/plant_faults.h"

namespace drt {
namespace {

template <class T>
T& by_name(std::vector<T>& things, const std::string& name) {
    for (T& thing : things)
        if (thing.name == name) return thing;
    throw std::invalid_argument("nothing is called " + name);
}

void brighter_lights(SceneDesc& scene) { brighten_lights(scene, 1.02f); }
void wider_lobes(SceneDesc& scene) { widen_lobes(scene, 1.05); }
void shifted_filter(SceneDesc& scene) { shift_filter(scene, 0.1); }

// ---- light

void missing_light(SceneDesc& scene) { scene.lights.pop_back(); }
void brighter_ambient_light(SceneDesc& scene) { scene.ambient_light *= 1.02f; }

void uniform_bulb(SceneDesc& scene) {
    std::get<SphereLight>(by_name(scene.lights, "Lamp").shape).distribution = SphereLight::Distribution::uniform;
}

/// By 5 %, with the same power.
void larger_lamps(SceneDesc& scene) {
    for (Light& light : scene.lights) {
        std::get<SphereLight>(light.shape).radius *= 1.05;
        light.color *= float(1 / (1.05 * 1.05));
    }
}

// ---- surfaces

void wider_reflected_lobe(SceneDesc& scene) { by_name(scene.materials, "brushed").reflection_spread_degrees *= 1.05; }
void wider_refracted_lobe(SceneDesc& scene) { by_name(scene.materials, "frosted").refraction_spread_degrees *= 1.05; }
void higher_index(SceneDesc& scene) { by_name(scene.materials, "clear").refraction_index *= 1.01; }
void larger_ball(SceneDesc& scene) { std::get<Sphere>(by_name(scene.bodies, "cue ball").shape).radius *= 1.01; }

void narrower_highlights(SceneDesc& scene) {
    for (Material& m : scene.materials) m.shininess *= 1.05;
}

void linear_textures(SceneDesc& scene) {
    for (Texture& t : scene.textures) t.color_space = Texture::ColorSpace::linear;
}

void larger_textures(SceneDesc& scene) {
    for (Material& m : scene.materials) m.scale_u *= 1.01, m.scale_v *= 1.01;
}

// ---- camera and motion

void wider_filter(SceneDesc& scene) { scene.render.filter.radius *= 1.05; }
void wider_lens(SceneDesc& scene) { scene.cameras[0].lens.aperture_radius *= 1.05; }
void abrupt_shutter(SceneDesc& scene) { scene.cameras[0].shutter.switch_ratio = 0; }

void longer_shutter(SceneDesc& scene) {
    Shutter& shutter = scene.cameras[0].shutter;
    shutter.duration = *shutter.duration * 1.05;
}

/// By a tenth of a frame's scene time.
void later_time(SceneDesc& scene) {
    Camera& camera = scene.cameras[0];
    const double speed = (*camera.time_end - *camera.time_start) / (*camera.video_end - camera.video_start);
    const double delay = 0.1 * speed / scene.render.fps;
    *camera.time_start += delay;
    *camera.time_end += delay;
}

void shorter_turn(SceneDesc& scene) { by_name(scene.bodies, "crate").motion->keys[1].turn->degrees *= 0.99; }

}  // namespace

std::vector<PlantedFault> plain_faults() {
    return {
        {"lights_2_percent_brighter", "glossy-distributed", 1, brighter_lights},
        {"lights_2_percent_brighter", "shadows-classic", 1, brighter_lights},
        {"lights_2_percent_brighter", "shadows-distributed", 1, brighter_lights},
        {"lights_2_percent_brighter", "legacy-still-life", 1, brighter_lights},
        {"ambient_light_2_percent_brighter", "legacy-manual-example", 1, brighter_ambient_light},
        {"one_light_missing", "combined-distributed", 1, missing_light},
        {"bulb_sampled_uniformly", "legacy-still-life", 1, uniform_bulb},
        {"reflected_lobe_5_percent_wider", "lobes", 1, wider_reflected_lobe},
        {"refracted_lobe_5_percent_wider", "lobes", 1, wider_refracted_lobe},
        {"refraction_index_1_percent_higher", "translucency-classic", 1, higher_index},
        {"textures_without_srgb_curve", "textures", 1, linear_textures},
        {"textures_1_percent_larger", "textures", 1, larger_textures},
        {"a_ball_1_percent_larger", "billiard", 1, larger_ball},
        {"filter_shifted_by_a_tenth_of_a_pixel", "textures", 1, shifted_filter},
        {"filter_shifted_by_a_tenth_of_a_pixel", "focus-distributed", 1, shifted_filter},
        {"shutter_5_percent_longer", "motion-distributed", 1, longer_shutter},
        {"a_turn_1_percent_shorter", "turn", 1, shorter_turn},
    };
}

std::vector<PlantedFault> subtle_faults() {
    std::vector<PlantedFault> faults{
        {"lobes_5_percent_wider", "glossy-distributed", 64, wider_lobes},
        {"lobes_5_percent_wider", "translucency-distributed", 8, wider_lobes},
        {"lobes_5_percent_wider", "legacy-still-life", 16, wider_lobes},
        {"lamps_5_percent_larger_and_as_strong", "shadows-distributed", 8, larger_lamps},
        {"highlights_5_percent_narrower", "legacy-still-life", 8, narrower_highlights},
        {"filter_5_percent_wider", "shadows-classic", 8, wider_filter},
        {"lens_5_percent_wider", "focus-distributed", 8, wider_lens},
        {"shutter_opens_at_once", "motion-distributed", 8, abrupt_shutter},
        {"a_tenth_of_a_frame_late", "camera-move", 8, later_time},
    };
    for (const Shot& shot : shots())
        if (shot.name != "lobes" && shot.name != "legacy-manual-example")  // have none
            faults.push_back({"lights_2_percent_brighter", shot.name, 1, brighter_lights});
    return faults;
}

}  // namespace drt
