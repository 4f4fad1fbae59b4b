#include "drt/bake/bake_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "drt/base/version.h"
#include "drt/formats/formats.h"
#include "drt/scene/camera_time.h"
#include "drt/scene/scene_fields.h"

namespace drt {

namespace {

// Raise it whenever the same scene may get another motion.
constexpr int method_version = 3;

// What only the eye sees of a shape.
void forget_looks(Shape& shape) {
    if (auto* s = std::get_if<Sphere>(&shape)) *s = {.center = s->center, .radius = s->radius};
    if (auto* c = std::get_if<Cylinder>(&shape)) c->capped = true;  // an open one collides as if it were closed
}

// A camera as far as it decides how large a pixel is where a body moves.
Camera eye_of(const Camera& c) {
    Camera eye;
    eye.positions = c.positions;
    eye.targets = {c.positions.front() + Vec3d{0, 0, -1}};  // anywhere that makes a view
    eye.fov_degrees_start = c.fov_degrees_start;
    eye.fov_degrees_end = c.fov_degrees_end;
    eye.zoom = c.zoom;
    eye.video_start = c.video_start;
    eye.video_end = c.video_end;
    eye.time_start = c.time_start;
    eye.time_end = c.time_end;
    eye.motion = c.motion;
    return eye;
}

// Of an endless video every frame has its own latest time; frames of the same second or two share a simulation.
double rounded_up(double seconds) { return std::exp2(std::max(0.0, std::ceil(std::log2(seconds)))); }

double simulated_end(const SceneDesc& scene, double until) {
    const SimulationSettings& s = scene.simulation;
    if (s.end) return *s.end;
    const double shown = latest_shown(scene);
    return std::min(until > shown ? s.start + rounded_up(until - s.start) : shown, latest_simulated);
}

}  // namespace

bool has_physics(const SceneDesc& scene) {
    return std::any_of(scene.bodies.begin(), scene.bodies.end(), [](const Body& b) { return b.physics.has_value(); });
}

double latest_shown(const SceneDesc& scene) {
    double latest = scene.simulation.start;
    for (const Camera& c : scene.cameras) {
        if (!c.video_end) continue;
        const double fps = scene.render.fps;
        const FrameRange frames = recorded_frames(c, fps);
        if (frames.empty()) continue;
        const double close = (frames.end - 1) / fps + exposure_duration(c, fps);  // may be past the video's end
        latest = std::max({latest, scene_time(c, frames.first / fps), scene_time(c, close)});
    }
    return latest;
}

BakeInput bake_input(const SceneDesc& scene, double until) {
    BakeInput in;
    in.begin = scene.simulation.start;
    in.end = simulated_end(scene, until);
    in.scene.gravity = gravity_of(scene);
    in.scene.simulation.start = in.begin;
    in.scene.simulation.end = in.end;
    for (size_t i = 0; i < scene.bodies.size(); ++i) {
        const Body& b = scene.bodies[i];
        if (!b.physics) continue;
        Body plain{"", b.shape, "", b.motion, b.physics};
        forget_looks(plain.shape);
        in.scene.bodies.push_back(std::move(plain));
        in.bodies.push_back(int(i));
    }
    if (scene.simulation.tolerance) {
        in.scene.simulation.tolerance = scene.simulation.tolerance;
        return in;
    }
    in.scene.simulation.tolerance_pixels = scene.simulation.tolerance_pixels;
    in.scene.render.width = scene.render.width;
    for (const Camera& c : scene.cameras) in.scene.cameras.push_back(eye_of(c));
    return in;
}

std::string input_text(const BakeInput& in) {
    return fmt::format("drt {} {}, bake {}\n", version(), build_isa(), method_version) +
           write_yaml_scene(in.scene, "/");
}

}  // namespace drt
