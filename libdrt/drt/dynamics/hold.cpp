#include "drt/dynamics/hold.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "drt/dynamics/rows.h"

namespace drt {

namespace {

double size_of_roll(const Collider& c) {
    if (const auto* s = std::get_if<SphereCollider>(&c)) return s->radius;
    if (const auto* s = std::get_if<CylinderCollider>(&c)) return s->radius;
    return 0;
}

// Friction acts against the slip; across it, and where nothing slips, along any two directions.
std::pair<Vec3d, Vec3d> friction_directions(const Vec3d& normal, const Vec3d& slip) {
    const Vec3d across = cross(normal, slip);
    if (const double size = length(across); size > 1e-9) return {cross(across, normal) / size, across / size};
    const Vec3d x = normalize(cross(std::abs(normal.x) < 0.7 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0}, normal));
    return {x, cross(normal, x)};
}

struct ContactRows {
    std::vector<Row> rows;
    std::vector<ContactPoint*> points;  // whose force a row is part of; none for rolling friction

    int add(const Row& row, ContactPoint* point) {
        rows.push_back(row);
        points.push_back(point);
        return int(rows.size()) - 1;
    }
};

void add_rows(ContactRows& out, const RigidScene& scene, const std::vector<RigidState>& states, Contact& c,
              const std::vector<bool>& acts, double seconds, double way) {
    const RigidBody &body_a = scene.bodies[size_t(c.a)], &body_b = scene.bodies[size_t(c.b)];
    const RigidState &a = states[size_t(c.a)], &b = states[size_t(c.b)];
    const double friction = combined_friction(body_a, body_b);
    const double rolling = combined_rolling_friction(body_a, body_b) *
                           std::max(size_of_roll(body_a.collider), size_of_roll(body_b.collider));
    for (int k = 0; k < c.count; ++k) {
        if (!acts[size_t(k)]) continue;
        ContactPoint& point = c.all[size_t(k)];
        const Vec3d from_a = point.on_a - a.position, from_b = point.on_b - b.position;
        const auto push = [&](const Vec3d& direction) {
            Row r = push_along(c.a, c.b, direction, from_a, from_b);
            r.impulse = dot(point.force, direction) * seconds;
            return r;
        };
        Row press = push(point.normal);
        if (way > 0) press.offset = std::max(point.gap, 0.0) / way;
        const int normal = out.add(press, &point);
        const Vec3d slip = a.velocity + cross(a.spin, from_a) - b.velocity - cross(b.spin, from_b);
        const auto limited = [&](Row row, double limit) {
            row.normal = normal;
            row.limit = limit;
            return row;
        };
        const auto [along, across] = friction_directions(point.normal, slip);
        if (friction > 0)
            for (const Vec3d& d : {along, across}) out.add(limited(push(d), friction), &point);
        const auto [roll, tilt] = friction_directions(point.normal, a.spin - b.spin);
        if (rolling > 0)
            for (const Vec3d& d : {roll, tilt}) {
                Row r;
                r.a = c.a;
                r.b = c.b;
                r.turn_a = d;
                r.turn_b = -d;
                out.add(limited(r, rolling), nullptr);
            }
    }
}

// Of the many points of a contact a few hold it: those that did so a moment ago and some that are far apart. Whatever
// else turns out to come closer is added. Unknowns cost their cube.
constexpr int points_at_first = 3;
constexpr int most_additions = 8;
constexpr double close_by = 1e-4;  // length
constexpr double closer = 1e-9;    // than it may

std::vector<std::vector<bool>> first_guess(std::span<const Contact> contacts, const std::vector<RigidState>& states,
                                           double way) {
    std::vector<std::vector<bool>> acts;
    for (const Contact& c : contacts) {
        acts.emplace_back(c.count);
        for (int k = 0; k < c.count; ++k) {
            const ContactPoint& p = c.all[size_t(k)];
            const bool pressed = length_squared(p.force) > 0;
            const bool near = p.gap <= approach_at(c, p, states) * way + close_by;
            acts.back()[size_t(k)] = pressed || (near && k < points_at_first);
        }
    }
    return acts;
}

bool add_what_comes_closer(std::vector<std::vector<bool>>& acts, std::span<const Contact> contacts,
                           const std::vector<RigidState>& states, double way) {
    double fastest = 0;
    for (const RigidState& s : states) fastest = std::max(fastest, length(s.velocity));
    bool any = false;
    for (size_t i = 0; i < contacts.size(); ++i)
        for (int k = 0; k < contacts[i].count; ++k) {
            const ContactPoint& p = contacts[i].all[size_t(k)];
            const double approach = approach_at(contacts[i], p, states);
            const bool comes_closer =
                way > 0 ? approach * way > std::max(p.gap, 0.0) + closer : approach > closer * fastest;
            if (acts[i][size_t(k)] || !comes_closer) continue;
            acts[i][size_t(k)] = any = true;
        }
    return any;
}

}  // namespace

double hold(const RigidScene& scene, std::vector<RigidState>& states, std::span<Contact> contacts, double seconds,
            double way) {
    const std::vector<RigidState> before = states;
    std::vector<std::vector<bool>> acts = first_guess(contacts, before, way);
    for (int k = 0;; ++k) {
        ContactRows all;
        for (size_t i = 0; i < contacts.size(); ++i) add_rows(all, scene, before, contacts[i], acts[i], seconds, way);
        states = before;
        const double error = solve_rows(scene, all.rows, states);
        for (Contact& c : contacts)
            for (ContactPoint& point : c.points()) point.force = {};
        if (seconds > 0)
            for (size_t i = 0; i < all.rows.size(); ++i)
                if (all.points[i]) all.points[i]->force += all.rows[i].linear * (all.rows[i].impulse / seconds);
        if (k == most_additions || !add_what_comes_closer(acts, contacts, states, way)) return error;
    }
}

}  // namespace drt
