#include <algorithm>
#include <charconv>

#include "drt/scene/check_fields.h"
#include "drt/scene/mass.h"

namespace drt {
namespace {

using Kind = PhysicsDesc::Kind;

template <class... S>
bool is_one_of(const Shape& shape) {
    return (std::holds_alternative<S>(shape) || ...);
}

// ---- which shape can be what, and who moves it ---------------------------------------------------------------------

// True when the shape can be of that kind.
bool check_kind(Report& report, const ScenePath& at, const Body& body) {
    const Kind kind = body.physics->kind;
    const std::string word(enum_name(kind));
    if (is_one_of<SphereSet>(body.shape))
        report.error(at, "a sphere_set cannot take part in the simulation", {}, "single spheres");
    else if (is_one_of<Plane>(body.shape) && kind != Kind::fixed)
        report.error(at / "kind", "an infinite plane cannot move", word, "static");
    else if (kind == Kind::dynamic && !is_one_of<Sphere, Box, Cylinder>(body.shape))
        report.error(at / "kind", "a " + shape_name(body.shape) + " cannot be dynamic, for it has no volume", word,
                     "static or kinematic; or a shape that has one: sphere, box, cylinder");
    else
        return true;
    return false;
}

void check_motion_of(Report& report, const ScenePath& body, const ScenePath& at, Kind kind, bool has_motion) {
    if (kind == Kind::dynamic && has_motion)
        report.error(body / "motion", "a dynamic body cannot have a motion: its motion is what is simulated", {},
                     "no motion, or kind: kinematic");
    else if (kind == Kind::fixed && has_motion)
        report.error(body / "motion", "a static body cannot have a motion", {}, "no motion, or kind: kinematic");
    else if (kind == Kind::kinematic && !has_motion)
        report.warning(at / "kind", "a kinematic body without motion stands still", "kinematic",
                       "motion, or kind: static");
}

// What only a dynamic body can make use of.
void warn_of_what_has_no_effect(Report& report, const ScenePath& at, const PhysicsDesc& physics) {
    const auto warn = [&](const char* key, bool set) {
        if (set)
            report.warning(at / key,
                           std::string(key) + " without effect on a " + std::string(enum_name(physics.kind)) + " body");
    };
    warn("mass", physics.mass.has_value());
    warn("density", physics.density.has_value());
    warn("velocity", physics.velocity != Vec3d{});
    warn("angular_velocity_degrees", physics.angular_velocity_degrees != Vec3d{});
    warn("impulses", !physics.impulses.empty());
    warn("forces", !physics.forces.empty());
}

// ---- events --------------------------------------------------------------------------------------------------------

std::string simulated_time(const SimulationSettings& s) {
    return "the simulation, which starts at " + to_text(s.start) + (s.end ? " and ends at " + to_text(*s.end) : "");
}

void check_events(Report& report, const ScenePath& at, const PhysicsDesc& physics, const SimulationSettings& simulation,
                  const FineFields& fine) {
    const auto has_ended = [&](double time) { return simulation.end && time >= *simulation.end; };
    const ScenePath impulses = at / "impulses", forces = at / "forces";
    for (std::size_t i = 0; i < physics.impulses.size(); ++i) {
        const double time = physics.impulses[i].time;
        if (fine(impulses[i] / "time") && (time < simulation.start || has_ended(time)))
            report.warning(impulses[i] / "time", "the impulse has no effect", to_text(time),
                           "a time within " + simulated_time(simulation));
    }
    for (std::size_t i = 0; i < physics.forces.size(); ++i) {
        const auto& [from, until, force] = physics.forces[i];
        if (!fine(forces[i] / "from", forces[i] / "until")) continue;
        if (!(until > from))
            report.error(forces[i] / "until", "the force ends before it begins", to_text(until),
                         "more than from " + to_text(from));
        else if (until <= simulation.start || has_ended(from))
            report.warning(forces[i], "the force has no effect", to_text(from) + " to " + to_text(until),
                           "a time within " + simulated_time(simulation));
    }
}

// ---- mass ----------------------------------------------------------------------------------------------------------

// Four digits: nobody wrote these numbers, so nobody looks for all of their digits.
std::string rounded(double v) {
    char buffer[32];
    return {buffer, std::to_chars(buffer, buffer + sizeof buffer, v, std::chars_format::general, 4).ptr};
}

bool size_is_fine(const ScenePath& body, const FineFields& fine, const Shape& shape) {
    if (is_one_of<Sphere>(shape)) return fine(body / "radius");
    if (is_one_of<Box>(shape)) return fine(body / "size");
    return fine(body / "from", body / "to", body / "radius");
}

void check_mass(Report& report, const ScenePath& body, const ScenePath& at, const Shape& shape,
                const PhysicsDesc& physics, const FineFields& fine) {
    if (physics.mass && physics.density)
        return report.error(at / "density", "density beside mass", to_text(*physics.density), "one of the two");
    if (!fine(at / "mass", at / "density") || !size_is_fine(body, fine, shape)) return;
    const MassProperties m = *mass_properties(shape, physics);
    const auto [least, largest] = std::minmax({m.inertia.x, m.inertia.y, m.inertia.z});
    const ScenePath key = at / (physics.mass ? "mass" : "density");
    if (!(m.mass >= least_mass && m.mass <= largest_mass))
        report.error(key, "the body's mass cannot be reckoned with", rounded(m.mass),
                     "a size and density that make a mass from 1e-30 to 1e30");
    else if (!(least >= least_inertia && largest <= largest_inertia))
        report.error(key, "the body's inertia, mass * size^2, cannot be reckoned with",
                     rounded(least < least_inertia ? least : largest), "a size and mass that make it 1e-60 to 1e60");
}

// A stack of ten bodies stands under one that is so many times as heavy; more was not tried
// (tests/dynamics/hold_test.cpp).
constexpr double largest_ratio = 1e5;

std::string body_text(const SceneDesc& scene, std::size_t i) {
    return scene.bodies[i].name.empty() ? "body " + std::to_string(i + 1) : '\'' + scene.bodies[i].name + '\'';
}

}  // namespace

void check_simulation(Report& report, const SceneDesc& scene) {
    const ScenePath root, at = root / "simulation";
    const SimulationSettings& s = scene.simulation;
    const FineFields fine = check_fields(report, at, s);
    if (s.end && fine(at / "start", at / "end") && !(*s.end > s.start))
        report.error(at / "end", "the simulation ends before it starts", to_text(*s.end),
                     "more than start " + to_text(s.start));
}

void check_physics(Report& report, const ScenePath& at, const SceneDesc& scene, const Body& body,
                   const FineFields& fine) {
    const ScenePath here = at / "physics";
    const PhysicsDesc& physics = *body.physics;
    if (!check_kind(report, here, body)) return;
    check_motion_of(report, at, here, physics.kind, body.motion.has_value());
    if (physics.kind != Kind::dynamic) return warn_of_what_has_no_effect(report, here, physics);
    check_events(report, here, physics, scene.simulation, fine);
    check_mass(report, at, here, body.shape, physics, fine);
}

void check_masses(Report& report, const SceneDesc& scene) {
    struct Extreme {
        double mass;
        std::size_t body;
    };
    std::optional<Extreme> lightest, heaviest;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const Body& body = scene.bodies[i];
        if (!body.physics || body.physics->kind != Kind::dynamic) continue;
        const auto properties = mass_properties(body.shape, *body.physics);
        if (!properties || !(properties->mass >= least_mass && properties->mass <= largest_mass)) continue;
        if (!lightest || properties->mass < lightest->mass) lightest = {properties->mass, i};
        if (!heaviest || properties->mass > heaviest->mass) heaviest = {properties->mass, i};
    }
    if (!lightest || heaviest->mass <= largest_ratio * lightest->mass) return;
    const ScenePath root, list = root / "bodies";
    report.warning(list[heaviest->body] / "physics",
                   body_text(scene, heaviest->body) + " has very much more mass than " +
                       body_text(scene, lightest->body) + ", the lightest dynamic body",
                   rounded(heaviest->mass) + " to " + rounded(lightest->mass),
                   "at most 100000 to 1, which is what contacts were measured to hold");
}

}  // namespace drt
