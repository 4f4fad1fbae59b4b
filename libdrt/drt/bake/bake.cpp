#include "drt/bake/bake.h"

#include <fmt/format.h>

#include <algorithm>

#include "drt/bake/pixel_tolerance.h"
#include "drt/bake/rigid_scene.h"
#include "drt/dynamics/control.h"
#include "drt/dynamics/keys.h"
#include "drt/dynamics/nearest.h"

namespace drt {

namespace {

// Of the smallest dynamic body's size: finer asks for more than doubles have left after a few contacts, coarser would
// not show it as what it is.
constexpr double finest_tolerance = 1e-6, coarsest_tolerance = 0.1;

constexpr double worth_telling = 0.01;  // of overlaps: share of the smallest body's size

class Baker {
public:
    explicit Baker(const BakeInput& in) : in_(in), model_(build_rigid_scene(in)), views_(eye_views(in)) {}

    BakedMotion run() {
        BakedMotion out;
        out.report.begin = out.report.trusted_until = in_.begin;
        out.report.end = std::max(in_.begin, in_.end);
        for (size_t i = 0; i < bodies().size(); ++i)
            if (is_dynamic(i)) dynamic_.push_back(i);
        out.report.dynamic_bodies = int(dynamic_.size());
        if (dynamic_.empty() || in_.end <= in_.begin) return standing(std::move(out));
        simulate();
        for (const size_t i : dynamic_) {
            out.motions.push_back(motion_of(i));
            out.report.keys += int(out.motions.back().keys.size());
        }
        describe(out.report);
        return out;
    }

private:
    const std::vector<RigidBody>& bodies() const { return model_.scene.bodies; }
    bool is_dynamic(size_t i) const { return bodies()[i].kind == RigidBody::Kind::dynamic; }

    // Nothing is ever shown of the simulated time.
    BakedMotion standing(BakedMotion out) const {
        for (const size_t i : dynamic_)
            out.motions.push_back({{}, {MotionKey{in_.begin, described_center(i), {}, {}}}});
        out.report.keys = int(dynamic_.size());
        out.report.trusted_until = out.report.end;
        return out;
    }

    Vec3d described_center(size_t i) const { return center_of(in_.scene.bodies[i].shape); }

    // In units of the rigid scene; bodies that have not been simulated yet stand at their places.
    double tolerance_of(size_t i) const {
        const SimulationSettings& s = in_.scene.simulation;
        const double unit = model_.units.length, radius = unit * bounding_radius(bodies()[i].collider);
        const auto center = [&](double time) {
            const RigidState at = tracks_.empty()
                                      ? bodies()[i].start
                                      : state_at(bodies()[i], tracks_[i], std::clamp(time, in_.begin, in_.end));
            return model_.units.to_scene(at.position);
        };
        const double scene_units =
            s.tolerance ? *s.tolerance : s.tolerance_pixels * smallest_pixel(views_, center, radius);
        return std::clamp(scene_units / unit, finest_tolerance, coarsest_tolerance);
    }

    double smallest_tolerance() const {
        double smallest = coarsest_tolerance;
        for (const size_t i : dynamic_) smallest = std::min(smallest, tolerance_of(i));
        return smallest;
    }

    // Where bodies are seen from is known once they have moved: one that comes nearer to an eye than it was at the
    // start needs a second simulation.
    void simulate() {
        tolerance_ = smallest_tolerance();
        run_simulation();
        const double needed = smallest_tolerance();
        if (needed >= 0.5 * tolerance_) return;
        tolerance_ = needed;
        run_simulation();
    }

    void run_simulation() {
        const int runs = controlled_.runs;
        controlled_ = simulate_controlled(model_.scene, in_.begin, in_.end, tolerance_);
        controlled_.runs += runs;
        tracks_ = std::move(controlled_.simulation.tracks);
    }

    Motion motion_of(size_t i) const {
        const RigidBody& body = bodies()[i];
        KeyTolerance t;
        t.position = tolerance_of(i);
        t.angle = std::min(0.1, t.position / bounding_radius(body.collider));
        Motion m;
        m.keys = keys_of(body, tracks_[i], in_.begin, in_.end, t);
        for (MotionKey& k : m.keys) {
            // A body that has not moved is where the scene says, to the last bit.
            k.position = k.position == body.start.position ? described_center(i) : model_.units.to_scene(k.position);
            if (!k.orientation) continue;
            k.orientation = *k.orientation * conjugate(model_.frames[i]);
            if (*k.orientation == Quatd{}) k.orientation.reset();  // as described
        }
        return m;
    }

    void describe(BakeReport& r) const {
        r.tolerance = tolerance_ * model_.units.length;
        r.error = controlled_.error * model_.units.length;
        r.step = controlled_.step;
        r.runs = controlled_.runs;
        r.trusted_until = controlled_.trusted_until;
        r.is_chaotic = controlled_.is_chaotic;
        r.impacts = int(controlled_.simulation.impacts.size());
        r.contact_steps = controlled_.simulation.contact_steps;
        describe_audit(r);
        describe_troubles(r);
    }

    void describe_audit(BakeReport& r) const {
        const Audit& a = controlled_.audit;
        if (!(a.energy_rise <= Audit::most_energy_rise))
            r.notes.push_back({Severity::warning, -1,
                               fmt::format("the simulation gains energy near t = {:.6g} s: {:.2g} of the largest "
                                           "kinetic energy",
                                           a.worst_time, a.energy_rise)});
        if (!(a.restitution_error <= Audit::most_restitution_error))
            r.notes.push_back({Severity::warning, -1,
                               fmt::format("a bounce near t = {:.6g} s keeps {:.2g} more or less of its speed than its "
                                           "restitution says",
                                           a.worst_time, a.restitution_error)});
    }

    void describe_troubles(BakeReport& r) const {
        const Simulation& s = controlled_.simulation;
        const auto say = [&](const Trouble& t, const std::string& what) {
            r.notes.push_back(
                {Severity::warning, t.body,
                 fmt::format("{} at t = {:.6g} s, at a speed of {:.4g}", what, t.time, t.speed * model_.units.length)});
        };
        if (s.given_up.time < in_.end)
            say(s.given_up,
                "the simulation ends, for too much happens to this body: it is crushed, or turns or bounces "
                "without end; everything stands still from then on,");
        if (s.deepest_start > worth_telling)  // as the legacy manual's ball does
            r.notes.push_back({Severity::note, s.started_in_another.body,
                               fmt::format("this body starts {:.3g} deep in another and is pushed out",
                                           s.deepest_start * model_.units.length)});
        if (s.deepest_overlap > worth_telling)
            say(s.overlapped, fmt::format("this body gets {:.3g} deep into another and is pushed out",
                                          s.deepest_overlap * model_.units.length));
    }

    const BakeInput& in_;
    RigidModel model_;
    std::vector<EyeView> views_;
    std::vector<size_t> dynamic_;
    double tolerance_ = 0;
    Controlled controlled_;
    std::vector<Track> tracks_;
};

}  // namespace

std::string to_text(const BakeReport& r) {
    std::string out = fmt::format("{} dynamic {} from t = {:.6g} s to {:.6g} s: {} keys, {} impacts", r.dynamic_bodies,
                                  r.dynamic_bodies == 1 ? "body" : "bodies", r.begin, r.end, r.keys, r.impacts);
    if (r.runs == 0) return out;
    out += fmt::format(
        "\ntolerance {:.3g}, estimated error {:.3g} scene units; {} runs, the last with {} steps in contact of at most "
        "{:.3g} s\n",
        r.tolerance, r.error, r.runs, r.contact_steps, r.step);
    return out + (r.trusted_until < r.end ? fmt::format("trusted until t = {:.6g} s", r.trusted_until)
                                          : "trusted to the end");
}

BakedMotion compute_motion(const BakeInput& in) { return Baker(in).run(); }

Baked with_motion(const SceneDesc& scene, const BakeInput& in, BakedMotion baked) {
    Baked out{scene, std::move(baked.report), {}};
    auto motion = baked.motions.begin();
    for (const int i : in.bodies) {
        Body& body = out.scene.bodies[size_t(i)];
        if (body.physics->kind == PhysicsDesc::Kind::dynamic) body.motion = std::move(*motion++);
        body.physics.reset();
    }
    out.scene.simulation = {};
    out.scene.gravity.reset();
    for (const BakeNote& n : out.report.notes) {
        const std::string path =
            n.body < 0 ? "simulation" : fmt::format("bodies[{}].physics", in.bodies[size_t(n.body)]);
        out.notes.push_back({n.severity, scene.sources.find(path), n.message, {}, {}, {}});
    }
    return out;
}

Baked bake(const SceneDesc& scene, double until) {
    const BakeInput in = bake_input(scene, until);
    return with_motion(scene, in, compute_motion(in));
}

}  // namespace drt
