#include "drt/dynamics/simulate.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "drt/dynamics/contacts.h"
#include "drt/dynamics/hold.h"
#include "drt/dynamics/impact_time.h"
#include "drt/dynamics/overlap.h"
#include "drt/dynamics/patience.h"
#include "drt/dynamics/rest.h"
#include "drt/dynamics/step.h"
#include "drt/dynamics/timeline.h"

namespace drt {

double kinetic_energy(const RigidScene& scene, const std::vector<RigidState>& states) {
    double sum = 0;
    for (size_t i = 0; i < states.size(); ++i) {
        const RigidBody& b = scene.bodies[i];
        if (b.kind != RigidBody::Kind::dynamic) continue;
        const Vec3d w = rotate_back(states[i].orientation, states[i].spin);
        sum += 0.5 * b.mass * length_squared(states[i].velocity) +
               0.5 * (b.inertia.x * w.x * w.x + b.inertia.y * w.y * w.y + b.inertia.z * w.z * w.z);
    }
    return sum;
}

void strike(const RigidBody& body, RigidState& s, const Vec3d& impulse, const Vec3d& at) {
    s.velocity += impulse / body.mass;
    const Vec3d torque = rotate_back(s.orientation, cross(at, impulse));
    s.spin +=
        rotate(s.orientation, Vec3d{torque.x / body.inertia.x, torque.y / body.inertia.y, torque.z / body.inertia.z});
}

namespace {

// Lengths, in sizes of the smallest moving body.
constexpr double touching = 1e-6;                // nearer than this, bodies collide
constexpr double resting = 2e-4;                 // nearer than this and slower than a bounce, they hold each other
constexpr double hold_reach = farthest_contact;  // corners of bodies that hold each other are watched from here on

// Approaches slower than this do not bounce: a share of sqrt(g L), and of the fastest speed there ever was.
constexpr double slow_falling = 0.02, slow_flying = 1e-6;

constexpr int most_collisions = 2000;  // of one instant: then the rest is inelastic
constexpr int most_stalls = 20;        // events in a row that take no time: then a step is taken all the same

constexpr double small_overlap = 1e-11;  // is left as it is
constexpr int most_separations = 3;      // bodies that turn come apart only in the limit
constexpr double jammed = 0.02;          // deeper than this after that, bodies have no room

bool is_finite(const RigidState& s) {
    return std::isfinite(length_squared(s.velocity)) && std::isfinite(length_squared(s.spin));
}

// A tumbling body's path is integrated from its begin: one that turns farther than this begins anew.
constexpr double longest_tumble = 0.5;  // radians

class Simulator {
public:
    Simulator(const RigidScene& scene, double begin, double end, double step)
        : scene_(scene),
          world_(load_contact_world(scene)),
          rest_(scene),
          end_(end),
          step_(step),
          limits_(step_limits(scene, step)),
          time_(begin),
          timeline_(scene, begin, end) {
        const size_t n = scene.bodies.size();
        for (const RigidBody& b : scene.bodies) states_.push_back(b.start);
        for (int a = 0; a < int(n); ++a)
            for (int b = a + 1; b < int(n); ++b)
                if (moves(a) || moves(b)) pairs_.push_back({a, b});
        next_impact_.assign(pairs_.size(), never);
        holds_.assign(n * n, false);
        acceleration_.assign(n, {});
        held_.assign(n, false);
        changed_.assign(n, true);
        out_.tracks.resize(n);
        for (int i = 0; i < count(); ++i) begin_event(i);
    }

    Simulation run() {
        apply_events();
        separate_overlaps(false);
        resolve_impacts();
        while (time_ < end_) {
            if (patience_.is_at_its_end()) {
                give_up();
                break;
            }
            find_holds();
            advance();
        }
        return std::move(out_);
    }

private:
    void give_up() {
        out_.given_up = trouble_of(patience_.jammed_steps > Patience::most_jammed_steps ? jammed_body_ : last_body_);
        for (size_t i = 0; i < states_.size(); ++i) {
            RigidState still = states_[i];
            still.velocity = still.spin = {};
            out_.tracks[i].push_back({time_, still, {}, false});
        }
    }

    Trouble trouble_of(int i) const { return {time_, i, i < 0 ? 0 : length(states_[size_t(i)].velocity)}; }

    const RigidBody& body(int i) const { return scene_.bodies[size_t(i)]; }
    bool moves(int i) const { return body(i).kind == RigidBody::Kind::dynamic; }
    bool is_kinematic(int i) const { return body(i).kind == RigidBody::Kind::kinematic; }
    bool stands(int i) const { return rest_.asleep(i) || body(i).kind == RigidBody::Kind::fixed; }
    int count() const { return int(scene_.bodies.size()); }

    // ---- what the scene asks for at given times ---------------------------------------------------------------------

    void begin_event(int i) {
        const RigidBody& b = body(i);
        if (is_kinematic(i)) states_[size_t(i)] = state_at(b, b.course, time_);
        if (!moves(i)) return;
        acceleration_[size_t(i)] = acceleration_from(scene_, i, time_);
        for (const Blow& blow : b.blows)
            if (blow.time == time_) strike(b, states_[size_t(i)], blow.impulse, blow.at);
    }

    void wake(int i) {
        for (const int k : rest_.wake(i)) changed_[size_t(k)] = true;
    }

    void apply_events() {
        for (const int i : timeline_.take_until(time_)) {
            begin_event(i);
            wake(i);
        }
    }

    // ---- bodies that hold each other --------------------------------------------------------------------------------

    double slow() const { return slow_; }
    void learn_speeds() {
        for (int i = 0; i < count(); ++i)
            if (moves(i)) fastest_ = std::max(fastest_, length(states_[size_t(i)].velocity));
        slow_ = std::max(slow_falling * std::sqrt(length(scene_.gravity)), slow_flying * fastest_);
    }

    // Pairs that are near without approaching fast hold each other in the step to come.
    void find_holds() {
        std::fill(holds_.begin(), holds_.end(), false);
        std::vector<bool> was_held(held_.size(), false);
        was_held.swap(held_);
        holding_.clear();
        landing_ = never;
        if (in_touch_) {
            std::vector<Contact> contacts = find_contacts(*world_, scene_, states_, hold_reach);
            if (has_landed(contacts)) {  // a corner of a body that stands on others
                resolve_impacts();
                update_approach(contacts, states_);
            }
            for (const Contact& c : contacts) add_hold(c);
            in_touch_ = !holding_.empty();
        }
        for (const int i : rest_.update(states_, held_, holding_, time_)) changed_[size_t(i)] = true;
        for (int i = 0; i < count(); ++i)
            if (rest_.asleep(i)) held_[size_t(i)] = false;
        for (size_t i = 0; i < held_.size(); ++i)
            if (was_held[i] && !held_[i]) changed_[i] = true;
    }

    // What held a pair in the last step is the best guess for the next.
    static void recall_forces(std::vector<Contact>& contacts, const std::vector<Contact>& last) {
        auto from = last.begin();
        for (Contact& c : contacts) {  // both in the order of their bodies
            while (from != last.end() && std::pair(from->a, from->b) < std::pair(c.a, c.b)) ++from;
            if (from == last.end()) return;
            if (from->a != c.a || from->b != c.b || from->count != c.count) continue;
            for (int k = 0; k < c.count; ++k) c.all[size_t(k)].force = from->all[size_t(k)].force;
        }
    }

    bool bounces(const Contact& c) const { return combined_restitution(body(c.a), body(c.b)) > 0; }

    // With those of their points that approach.
    std::vector<Contact> that_bounce_now(const std::vector<Contact>& contacts) const {
        std::vector<Contact> out;
        for (const Contact& c : contacts) {
            if (!bounces(c)) continue;
            Contact fast = c;
            fast.count = 0;
            for (const ContactPoint& p : c.points())
                if (p.approach > slow()) fast.all[size_t(fast.count++)] = p;
            if (fast.count > 0) out.push_back(fast);
        }
        return out;
    }

    bool has_landed(const std::vector<Contact>& contacts) const {
        for (const Contact& c : contacts)
            for (const ContactPoint& p : c.points())
                if (p.gap <= touching && p.approach > slow()) return true;
        return false;
    }

    void add_hold(const Contact& c) {
        const auto rests = [&](const ContactPoint& p) { return p.gap <= resting && p.approach <= slow(); };
        if (!std::any_of(c.points().begin(), c.points().end(), rests)) return;
        holding_.push_back(c);
        for (const ContactPoint& p : c.points()) {
            if (p.approach > slow()) landing_ = std::min(landing_, p.gap / p.approach);
            if (rests(p) && p.approach >= -slow()) {  // what parts fast is free, but may be pushed back
                holds(c.a, c.b) = true;
                held_[size_t(c.a)] = held_[size_t(c.a)] || moves(c.a);
                held_[size_t(c.b)] = held_[size_t(c.b)] || moves(c.b);
            }
        }
    }
    std::vector<bool>::reference holds(int a, int b) {
        return holds_[size_t(std::min(a, b) * count() + std::max(a, b))];
    }

    bool anything_held() const { return std::find(held_.begin(), held_.end(), true) != held_.end(); }

    double shortest_step() const { return step_ / 64; }
    double step_length() const {
        double h = std::min(step_, allowed_step_);
        for (int i = 0; i < count(); ++i)
            if (held_[size_t(i)]) h = std::min(h, longest_contact_step(body(i), states_[size_t(i)], limits_));
        return std::max(h, shortest_step());
    }

    // As if nothing changed the velocities.
    std::vector<RigidState> states_of_the_middle(double h) const {
        std::vector<RigidState> out;
        for (int i = 0; i < count(); ++i) {
            const double t = time_ + 0.5 * h;
            out.push_back(is_kinematic(i)   ? state_at(body(i), body(i).course, t)
                          : rest_.asleep(i) ? states_[size_t(i)]
                                            : state_at(body(i), Path{time_, states_[size_t(i)], {}, false}, t));
        }
        return out;
    }

    std::vector<Contact> held_contacts(const std::vector<RigidState>& states) {
        std::vector<Contact> out = find_contacts(*world_, scene_, states, hold_reach);
        std::erase_if(out, [&](const Contact& c) { return !is_holding(c); });
        recall_forces(out, last_held_);
        return out;
    }
    bool is_holding(const Contact& c) const {
        return std::any_of(holding_.begin(), holding_.end(),
                           [&](const Contact& h) { return h.a == c.a && h.b == c.b; });
    }

    // Of bodies that fly it is in their paths.
    std::vector<Vec3d> accelerations_of(const std::vector<bool>& held) const {
        std::vector<Vec3d> out(states_.size());
        for (size_t i = 0; i < out.size(); ++i)
            if (held[i]) out[i] = acceleration_[i];
        return out;
    }
    std::vector<bool> all_awake() const {
        std::vector<bool> out;
        for (int i = 0; i < count(); ++i) out.push_back(!rest_.asleep(i));
        return out;
    }

    // Paths of bodies in contact, to this time or one before it where they are thrown about. Returns the time.
    double hold_paths(double until) {
        for (;;) {
            const double h = until - time_;
            std::vector<RigidState> states = states_of_the_middle(h);
            std::vector<Contact> contacts = held_contacts(states);
            set_gaps_of_begin(contacts, states, h);
            const std::vector<Vec3d> accelerations = accelerations_of(all_awake());
            ++patience_.steps;
            const bool short_enough = begin_step(scene_, states, accelerations, contacts, h, limits_);
            if (!short_enough && h > 1.5 * shortest_step()) {
                allowed_step_ = std::max(0.5 * h, shortest_step());
                until = time_ + allowed_step_;
                continue;
            }
            for (int k = 0; k < count(); ++k) {
                const auto i = size_t(k);
                if (!moves(k)) continue;
                keep_finite(k, states[i], states_[i]);
                const Vec3d free = states_[i].velocity + accelerations[i] * (0.5 * h);
                if (states[i].velocity != free || states[i].spin != states_[i].spin) held_[i] = true;
                if (!held_[i]) continue;
                step_path_[i] = {time_, states_[i], Vec3d{}, false};
                step_path_[i].from.velocity = states[i].velocity;
                step_path_[i].from.spin = states[i].spin;
                last_body_ = k;
                changed_[i] = true;
            }
            ++out_.contact_steps;
            for (const Contact& c : contacts) out_.contact_points += c.count;
            last_held_ = std::move(contacts);
            allowed_step_ = std::min(step_, 2 * allowed_step_);
            return until;
        }
    }

    void end_paths(double h) {
        std::vector<Contact> contacts = held_contacts(states_);
        const std::vector<RigidState> old = states_;
        end_step(scene_, states_, accelerations_of(held_), contacts, h);
        for (size_t i = 0; i < states_.size(); ++i) {
            keep_finite(int(i), states_[i], old[i]);
            if (states_[i].velocity != old[i].velocity || states_[i].spin != old[i].spin) changed_[i] = true;
        }
        last_held_ = std::move(contacts);
    }

    void note_overlap(const PushedApart& pushed, bool at_start) {
        double& deepest = at_start ? out_.deepest_start : out_.deepest_overlap;
        if (pushed.deepest <= deepest) return;
        deepest = pushed.deepest;
        (at_start ? out_.started_in_another : out_.overlapped) = trouble_of(pushed.deepest_body);
    }

    // At the start bodies stay as they are turned.
    void separate_overlaps(bool turning) {
        const int jammed_before = std::exchange(patience_.jammed_steps, 0);
        for (int round = 0; round <= most_separations; ++round) {
            const std::vector<Contact> contacts = find_contacts(*world_, scene_, states_, resting);
            double deepest = 0;
            for (const Contact& c : contacts)
                for (const ContactPoint& p : c.points()) deepest = std::max(deepest, -p.gap);
            if (round == most_separations) patience_.jammed_steps = deepest > jammed ? jammed_before + 1 : 0;
            if (deepest <= small_overlap || round == most_separations) return;
            const PushedApart pushed = push_apart(scene_, contacts, states_, turning);
            jammed_body_ = pushed.deepest_body;
            if (round == 0) note_overlap(pushed, !turning);
            for (const int i : pushed.moved) changed_[size_t(i)] = true;
        }
    }

    // ---- from event to event ----------------------------------------------------------------------------------------

    // A new path for every body whose motion changed.
    void start_paths() {
        for (int i = 0; i < count(); ++i) {
            if (!changed_[size_t(i)]) continue;
            const Path path = held_[size_t(i)]  ? step_path_[size_t(i)]
                              : rest_.asleep(i) ? Path{time_, states_[size_t(i)], {}, false}
                                                : Path{time_, states_[size_t(i)], acceleration_[size_t(i)], moves(i)};
            Track& track = out_.tracks[size_t(i)];
            if (!track.empty() && track.back().begin == time_)
                track.back() = path;
            else
                track.push_back(path);
        }
    }

    // When the path of a tumbling body has become long.
    double renewal(int i) const {
        const Vec3d& inertia = body(i).inertia;
        if (!moves(i) || held_[size_t(i)] || rest_.asleep(i) || (inertia.x == inertia.y && inertia.y == inertia.z))
            return never;
        const Track& track = out_.tracks[size_t(i)];
        const double begin = track.empty() || changed_[size_t(i)] ? time_ : track.back().begin;
        return begin + longest_tumble / std::max(1e-30, length(states_[size_t(i)].spin));
    }
    double next_renewal() const {
        double first = never;
        for (int i = 0; i < count(); ++i) first = std::min(first, renewal(i));
        return first;
    }

    void advance() {
        double until = std::min({end_, timeline_.next(), next_renewal()});
        step_path_.resize(states_.size());
        if (anything_held()) {
            until = std::min({until, time_ + step_length(), time_ + std::max(landing_, shortest_step())});
            until = hold_paths(until);
        }
        start_paths();
        double impact = first_impact(until);
        const double escape = stalls_ > most_stalls ? time_ + 1e-5 * (stalls_ - most_stalls) * step_ : time_;
        if (impact < until) {
            stalls_ = impact > time_ ? 0 : stalls_ + 1;
            until = std::min(until, std::max(impact, escape));
            if (anything_held() && until > time_) {  // a shorter step has other velocities
                until = hold_paths(until);
                start_paths();
                impact = first_impact(until);
                until = std::min(until, std::max(impact, escape));
            }
        } else {
            stalls_ = 0;
        }
        const double h = until - time_;
        move_to(until);
        if (anything_held() && h > 0) {
            separate_overlaps(true);
            end_paths(h);
        }
        apply_events();
        if (until >= impact || in_event_) resolve_impacts();
    }

    void move_to(double until) {
        changed_.assign(states_.size(), false);
        for (size_t i = 0; i < states_.size(); ++i) {
            // At a kink of a course the step that ends sees the speed before it; the event sets the one after.
            states_[i] = is_kinematic(int(i))
                             ? state_at(body(int(i)), body(int(i)).course, std::nextafter(until, time_))
                             : state_at(body(int(i)), out_.tracks[i].back(), until);
            if (held_[i]) changed_[i] = true;
        }
        for (int i = 0; i < count(); ++i)
            if (renewal(i) <= until) {
                changed_[size_t(i)] = true;
                last_body_ = i;
                ++patience_.renewals;
            }
        time_ = until;
        if (time_ > at_once_until_) {
            at_once_until_ = time_ + shortest_step();
            patience_.at_once = 0;
        }
        in_event_ = timeline_.next() <= time_;
    }

    double first_impact(double until) {
        find_impacts(until);
        return next_impact_.empty() ? never : *std::min_element(next_impact_.begin(), next_impact_.end());
    }

    void find_impacts(double until) {
        for (size_t k = 0; k < pairs_.size(); ++k) {
            const auto [a, b] = pairs_[k];
            if (holds(a, b)) {
                next_impact_[k] = never;
                continue;
            }
            if (!changed_[size_t(a)] && !changed_[size_t(b)]) continue;
            if (stands(a) && stands(b)) {
                next_impact_[k] = never;
                continue;
            }
            // Paths hold until something happens to them.
            const auto holds_until = [&](int i) {
                return held_[size_t(i)] ? until : is_kinematic(i) ? timeline_.next_of(i, end_) : end_;
            };
            next_impact_[k] =
                impact_time(*world_, scene_, a, out_.tracks[size_t(a)].back(), b, out_.tracks[size_t(b)].back(), time_,
                            std::min(holds_until(a), holds_until(b)))
                    .value_or(never);
        }
    }

    void keep_finite(int i, RigidState& s, const RigidState& before) {
        if (is_finite(s)) return;
        last_body_ = i;
        patience_.is_lost = true;
        s.velocity = before.velocity;
        s.spin = before.spin;
    }

    void count_collision() {
        ++patience_.collisions;
        ++patience_.at_once;
    }

    // All that approach at once, then those that approach because of that, and so on (generalized reflections, Smith et
    // al. 2012): Newton's cradle behaves as it does, a rack of balls breaks evenly, and without friction energy never
    // rises.
    void resolve_impacts() {
        learn_speeds();
        count_collision();
        const double before = kinetic_energy(scene_, states_);
        const std::vector<RigidState> old = states_;
        std::vector<Contact> contacts = find_contacts(*world_, scene_, states_, touching);
        for (int k = 0; k < most_collisions; ++k) {
            const std::vector<Contact> approaching = that_bounce_now(contacts);
            if (approaching.empty()) break;
            world_->collide(states_, approaching);
            update_approach(contacts, states_);
            if (k > 0) count_collision();
            last_body_ = moves(approaching[0].a) ? approaching[0].a : approaching[0].b;
        }
        hold(scene_, states_, contacts, 0, 0);
        bool any = false;
        for (size_t i = 0; i < states_.size(); ++i) {
            keep_finite(int(i), states_[i], old[i]);
            if (states_[i].velocity == old[i].velocity && states_[i].spin == old[i].spin) continue;
            wake(int(i));
            any = true;
        }
        if (any) out_.impacts.push_back({time_, before, kinetic_energy(scene_, states_)});
        in_touch_ = true;
        learn_speeds();
    }

    const RigidScene& scene_;
    std::unique_ptr<ContactWorld> world_;
    Rest rest_;
    double end_, step_;
    StepLimits limits_;
    double time_;
    double fastest_ = 0, slow_ = 0;
    std::vector<std::pair<int, int>> pairs_;
    std::vector<double> next_impact_;  // by pair, absolute
    Timeline timeline_;
    bool in_event_ = false;
    int stalls_ = 0;
    Patience patience_;
    double at_once_until_ = -never;
    int jammed_body_ = -1;
    int last_body_ = -1;  // that anything happened to
    // By body
    std::vector<RigidState> states_;
    std::vector<Vec3d> acceleration_;
    std::vector<bool> held_, changed_;
    std::vector<Path> step_path_;
    // Lasting contacts
    bool in_touch_ = true;            // there may be some
    std::vector<bool> holds_;         // by pair: count() * a + b, a < b
    std::vector<Contact> holding_;    // of the step to come, at its begin
    std::vector<Contact> last_held_;  // the last step's, with their forces
    double allowed_step_ = never;     // seconds; short for a while after bodies have been thrown about
    double landing_ = never;          // seconds until a corner of a body in contact lands
    Simulation out_;
};

}  // namespace

Simulation simulate(const RigidScene& scene, double begin, double end, double step) {
    return Simulator(scene, begin, end, step).run();
}

}  // namespace drt
