#include "drt/dynamics/simulate.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "drt/dynamics/contacts.h"
#include "drt/dynamics/hold.h"
#include "drt/dynamics/impact_time.h"
#include "drt/dynamics/overlap.h"
#include "drt/dynamics/rest.h"

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
constexpr double touching = 1e-6;    // nearer than this, bodies collide
constexpr double resting = 2e-4;     // nearer than this and slower than a bounce, they hold each other
constexpr double hold_reach = 0.02;  // corners of bodies that hold each other are watched from here on
constexpr double rim_way = 0.01;     // that a corner of a turning body in contact may go in a step

// Approaches slower than this do not bounce: a share of sqrt(g L), and of the fastest speed there ever was.
constexpr double slow_falling = 0.02, slow_flying = 1e-6;

constexpr int most_collisions = 10000;  // of one instant: then the rest is inelastic
constexpr int most_stalls = 20;         // events in a row that take no time: then a step is taken all the same

constexpr int most_events = 500000;  // impacts, or steps in contact: a bake must end

// A tumbling body's path is integrated from its begin: one that turns farther than this begins anew.
constexpr double longest_tumble = 4;  // radians

class Simulator {
public:
    Simulator(const RigidScene& scene, double begin, double end, double step)
        : scene_(scene), world_(load_contact_world(scene)), rest_(scene), end_(end), step_(step), time_(begin) {
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
        make_timeline();
    }

    Simulation run() {
        apply_events();
        separate_overlaps();
        resolve_impacts();
        while (time_ < end_) {
            if (out_.contact_steps > most_events || out_.impacts.size() > size_t(most_events)) {
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
        out_.given_up_at = time_;
        for (size_t i = 0; i < states_.size(); ++i) {
            RigidState still = states_[i];
            still.velocity = still.spin = {};
            out_.tracks[i].push_back({time_, still, {}, false});
        }
    }

    const RigidBody& body(int i) const { return scene_.bodies[size_t(i)]; }
    bool moves(int i) const { return body(i).kind == RigidBody::Kind::dynamic; }
    bool is_kinematic(int i) const { return body(i).kind == RigidBody::Kind::kinematic; }
    bool stands(int i) const { return rest_.asleep(i) || body(i).kind == RigidBody::Kind::fixed; }
    int count() const { return int(scene_.bodies.size()); }

    // ---- what the scene asks for at given times ---------------------------------------------------------------------

    struct Event {
        double time = 0;
        int body = 0;
    };

    void make_timeline() {
        for (int i = 0; i < count(); ++i) {
            const auto add = [&](double t) {
                if (t > time_ && t < end_) timeline_.push_back({t, i});
            };
            if (moves(i)) {
                for (const Blow& b : body(i).blows) add(b.time);
                for (const Push& p : body(i).pushes) add(p.from), add(p.until);
            }
            if (is_kinematic(i))
                for (const Path& p : body(i).course) add(p.begin);
        }
        std::stable_sort(timeline_.begin(), timeline_.end(),
                         [](const Event& a, const Event& b) { return a.time < b.time; });
        for (int i = 0; i < count(); ++i) begin_event(i);
    }

    void begin_event(int i) {
        const RigidBody& b = body(i);
        if (is_kinematic(i)) states_[size_t(i)] = state_at(b, b.course, time_);
        if (!moves(i)) return;
        acceleration_[size_t(i)] = scene_.gravity;
        for (const Push& p : b.pushes)
            if (p.from <= time_ && time_ < p.until) acceleration_[size_t(i)] += p.force / b.mass;
        for (const Blow& blow : b.blows)
            if (blow.time == time_) strike(b, states_[size_t(i)], blow.impulse, blow.at);
    }

    void wake(int i) {
        for (const int k : rest_.wake(i)) changed_[size_t(k)] = true;
    }

    // Those of this very time.
    void apply_events() {
        for (int last = -1; next_event() <= time_; ++next_event_) {
            const int i = timeline_[next_event_].body;
            if (i != last) begin_event(i);  // those of one body stand together
            wake(i);
            last = i;
        }
    }
    double next_event() const { return next_event_ < timeline_.size() ? timeline_[next_event_].time : never; }
    double next_kink(int i) const {
        for (size_t k = next_event_; k < timeline_.size(); ++k)
            if (timeline_[k].body == i) return timeline_[k].time;
        return end_;
    }

    // ---- bodies that hold each other --------------------------------------------------------------------------------

    double slow() const { return slow_; }
    void learn_speeds() {
        for (int i = 0; i < count(); ++i) fastest_ = std::max(fastest_, length(states_[size_t(i)].velocity));
        slow_ = std::max(slow_falling * std::sqrt(length(scene_.gravity)), slow_flying * fastest_);
    }

    // Pairs that are near without approaching fast hold each other in the step to come.
    void find_holds() {
        std::fill(holds_.begin(), holds_.end(), false);
        std::vector<bool> was_held(held_.size(), false);
        was_held.swap(held_);
        const std::vector<Contact> last = std::exchange(holding_, {});
        landing_ = never;
        if (in_touch_) {
            std::vector<Contact> contacts = find_contacts(*world_, scene_, states_, hold_reach);
            if (has_landed(contacts)) {  // a corner of a body that stands on others
                resolve_impacts();
                update_approach(contacts, states_);
            }
            for (const Contact& c : contacts) add_hold(c);
            in_touch_ = !holding_.empty();
            recall_forces(last);
        }
        for (const int i : rest_.update(states_, held_, holding_, time_)) changed_[size_t(i)] = true;
        for (int i = 0; i < count(); ++i)
            if (rest_.asleep(i)) held_[size_t(i)] = false;
        for (size_t i = 0; i < held_.size(); ++i)
            if (was_held[i] && !held_[i]) changed_[i] = true;
    }

    // What held a pair in the last step is the best guess for the next.
    void recall_forces(const std::vector<Contact>& last) {
        auto from = last.begin();
        for (Contact& c : holding_) {  // both in the order of their bodies
            while (from != last.end() && std::pair(from->a, from->b) < std::pair(c.a, c.b)) ++from;
            if (from == last.end()) return;
            if (from->a != c.a || from->b != c.b || from->count != c.count) continue;
            for (int k = 0; k < c.count; ++k) c.all[size_t(k)].force = from->all[size_t(k)].force;
        }
    }

    // Pairs without restitution need no instant of impact once they touch: what holds them also stops them.
    bool bounces(const Contact& c) const { return combined_restitution(body(c.a), body(c.b)) > 0; }

    bool has_landed(const std::vector<Contact>& contacts) const {
        for (const Contact& c : contacts)
            for (const ContactPoint& p : c.points())
                if (p.gap <= touching && p.approach > slow() && bounces(c)) return true;
        return false;
    }

    void add_hold(const Contact& c) {
        const bool bouncy = bounces(c);
        const auto rests = [&](const ContactPoint& p) { return p.gap <= resting && (p.approach <= slow() || !bouncy); };
        if (!std::any_of(c.points().begin(), c.points().end(), rests)) return;
        holding_.push_back(c);
        for (const ContactPoint& p : c.points()) {
            if (p.approach > slow() && bouncy) landing_ = std::min(landing_, p.gap / p.approach);
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

    double step_length() const {
        double h = step_;
        for (int i = 0; i < count(); ++i)
            if (held_[size_t(i)])
                h = std::min(
                    h, rim_way / std::max(1e-30, length(states_[size_t(i)].spin) * corner_reach(body(i).collider)));
        return std::max(h, step_ / 64);
    }

    // Bodies in contact move at the mean of their velocities before and after the step: second order in the step.
    void hold_paths(double until) {
        const double h = until - time_;
        after_ = states_;
        for (int i = 0; i < count(); ++i)
            if (!rest_.asleep(i)) after_[size_t(i)].velocity += acceleration_[size_t(i)] * h;
        const std::vector<RigidState> alone = after_;
        hold(scene_, after_, holding_, h);
        const std::vector<double> share = shares(alone, h);
        for (size_t i = 0; i < states_.size(); ++i) {
            if (!moves(int(i))) continue;
            if (after_[i].velocity != alone[i].velocity || after_[i].spin != alone[i].spin) held_[i] = true;
            if (!held_[i]) continue;
            RigidState mean = states_[i];
            mean.velocity = states_[i].velocity * (1 - share[i]) + after_[i].velocity * share[i];
            mean.spin = states_[i].spin * (1 - share[i]) + after_[i].spin * share[i];
            step_path_[i] = {time_, mean, Vec3d{}, false};
            changed_[i] = true;
        }
        ++out_.contact_steps;
    }

    // The share of the velocity after a step in that of its path. Where a contact sets in within the step, the mean
    // would carry bodies into each other or apart; and bodies that touch must move alike.
    std::vector<double> shares(const std::vector<RigidState>& alone, double h) const {
        std::vector<double> share(states_.size(), 0.5);
        for (const Contact& c : holding_)
            for (const ContactPoint& p : c.points()) {
                const bool apart = p.gap > 1e-9 || p.approach < -1e-9;
                if (apart && approach_at(c, p, alone) * h > p.gap) share[size_t(c.a)] = share[size_t(c.b)] = 1;
            }
        for (bool spreads = true; spreads;) {
            spreads = false;
            for (const Contact& c : holding_) {
                double &a = share[size_t(c.a)], &b = share[size_t(c.b)];
                if (a == b || !moves(c.a) || !moves(c.b)) continue;
                a = b = 1;
                spreads = true;
            }
        }
        return share;
    }

    void separate_overlaps() {
        const PushedApart pushed = push_apart(scene_, find_contacts(*world_, scene_, states_, 0), states_);
        out_.deepest_overlap = std::max(out_.deepest_overlap, pushed.deepest);
        for (const int i : pushed.moved) changed_[size_t(i)] = true;
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
        double until = std::min({end_, next_event(), next_renewal()});
        step_path_.resize(states_.size());
        if (anything_held()) {
            until = std::min({until, time_ + step_length(), time_ + std::max(landing_, step_ / 64)});
            hold_paths(until);
        }
        start_paths();
        find_impacts(until);
        const double impact =
            next_impact_.empty() ? never : *std::min_element(next_impact_.begin(), next_impact_.end());
        if (impact < until) {
            until = impact;
            stalls_ = impact > time_ ? 0 : stalls_ + 1;
            if (stalls_ > most_stalls) until = std::min(end_, time_ + 1e-6 * step_);
            if (anything_held() && until > time_) {  // a shorter step has other velocities
                hold_paths(until);
                start_paths();
            }
        }
        move_to(until);
        if (anything_held()) separate_overlaps();
        apply_events();
        if (until >= impact || in_event_) resolve_impacts();
    }

    void move_to(double until) {
        changed_.assign(states_.size(), false);
        for (size_t i = 0; i < states_.size(); ++i) {
            const Track& track = is_kinematic(int(i)) ? body(int(i)).course : out_.tracks[i];
            states_[i] = is_kinematic(int(i)) ? state_at(body(int(i)), track, until)
                                              : state_at(body(int(i)), track.back(), until);
            if (!held_[i]) continue;
            states_[i].velocity = after_[i].velocity;
            states_[i].spin = after_[i].spin;
            changed_[i] = true;
        }
        for (int i = 0; i < count(); ++i)
            if (renewal(i) <= until) changed_[size_t(i)] = true;
        time_ = until;
        in_event_ = next_event() <= time_;
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
                return held_[size_t(i)] ? until : is_kinematic(i) ? next_kink(i) : end_;
            };
            next_impact_[k] =
                impact_time(*world_, scene_, a, out_.tracks[size_t(a)].back(), b, out_.tracks[size_t(b)].back(), time_,
                            std::min(holds_until(a), holds_until(b)))
                    .value_or(never);
        }
    }

    // One pair after the other, the fastest first: what Newton's cradle does, and energy never rises.
    void resolve_impacts() {
        learn_speeds();
        const double before = kinetic_energy(scene_, states_);
        const std::vector<RigidState> old = states_;
        std::vector<Contact> contacts = find_contacts(*world_, scene_, states_, touching);
        for (int k = 0; k < most_collisions; ++k) {
            const auto speed = [&](const Contact& c) { return bounces(c) ? c.approach() : -never; };
            const auto fastest = std::max_element(contacts.begin(), contacts.end(),
                                                  [&](const auto& a, const auto& b) { return speed(a) < speed(b); });
            if (fastest == contacts.end() || speed(*fastest) <= slow()) break;
            world_->collide(states_, *fastest);
            update_approach(contacts, states_);
        }
        hold(scene_, states_, contacts, 0);
        out_.impacts.push_back({time_, before, kinetic_energy(scene_, states_)});
        for (size_t i = 0; i < states_.size(); ++i)
            if (states_[i].velocity != old[i].velocity || states_[i].spin != old[i].spin) wake(int(i));
        in_touch_ = true;
        learn_speeds();
    }

    const RigidScene& scene_;
    std::unique_ptr<ContactWorld> world_;
    Rest rest_;
    double end_, step_, time_;
    double fastest_ = 0, slow_ = 0;
    std::vector<std::pair<int, int>> pairs_;
    std::vector<double> next_impact_;  // by pair, absolute
    std::vector<Event> timeline_;
    size_t next_event_ = 0;
    bool in_event_ = false;
    int stalls_ = 0;
    // By body
    std::vector<RigidState> states_, after_;  // now; at the end of the step
    std::vector<Vec3d> acceleration_;
    std::vector<bool> held_, changed_;
    std::vector<Path> step_path_;
    // Lasting contacts
    bool in_touch_ = true;          // there may be some
    std::vector<bool> holds_;       // by pair: count() * a + b, a < b
    std::vector<Contact> holding_;  // of the step to come
    double landing_ = never;        // seconds until a corner of a body in contact lands
    Simulation out_;
};

}  // namespace

Simulation simulate(const RigidScene& scene, double begin, double end, double step) {
    return Simulator(scene, begin, end, step).run();
}

}  // namespace drt
