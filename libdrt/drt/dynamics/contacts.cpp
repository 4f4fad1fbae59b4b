#include "drt/dynamics/contacts.h"

#include <algorithm>
#include <utility>

#include "drt/dynamics/clip.h"
#include "drt/dynamics/polytope.h"

namespace drt {

namespace {

constexpr double touching_points = 1e-9;  // more than touch_distance by rounding

void set_points(Contact& c, const std::vector<SurfacePoint>& points, const Vec3d& normal) {
    c.count = 0;
    for (const SurfacePoint& p : points) c.all[size_t(c.count++)] = {p.gap, 0, normal, p.on_a, p.on_b, {}};
}

// Exact points instead of Bullet's, for the pairs of shapes that have them.
void refine(Contact& c, const ContactWorld& world, const RigidScene& scene, const std::vector<RigidState>& states,
            double reach) {
    const Collider &ca = scene.bodies[size_t(c.a)].collider, &cb = scene.bodies[size_t(c.b)].collider;
    const RigidState &sa = states[size_t(c.a)], &sb = states[size_t(c.b)];
    const auto *plane_a = std::get_if<PlaneCollider>(&ca), *plane_b = std::get_if<PlaneCollider>(&cb);
    if (std::holds_alternative<SphereCollider>(ca) || std::holds_alternative<SphereCollider>(cb)) {
        const Nearest n = *nearest_in_closed_form(ca, sa, cb, sb);
        c.count = 0;
        if (n.distance <= reach) set_points(c, {{n.distance, n.point + n.normal * n.distance, n.point}}, n.normal);
    } else if (has_flat_faces(ca) && has_flat_faces(cb)) {
        const Polytope pa = make_polytope(ca, sa), pb = make_polytope(cb, sb);
        const Separation s = prefer_faces(pa, pb, separate(pa, pb));
        set_points(c, contact_points(pa, pb, s, reach), s.normal);
        if (c.count > 0 || s.distance > reach) return;
        // Nearest at a corner, where no face or edge is opposite.
        const Nearest n = world.nearest(c.a, sa, c.b, sb);
        if (n.distance <= reach) set_points(c, {{n.distance, n.point + n.normal * n.distance, n.point}}, n.normal);
    } else if (plane_b) {
        set_points(c, contact_points(ca, sa, *plane_b, sb, reach), rotate(sb.orientation, normalize(plane_b->normal)));
    } else if (plane_a) {
        std::vector<SurfacePoint> points = contact_points(cb, sb, *plane_a, sa, reach);
        for (SurfacePoint& p : points) std::swap(p.on_a, p.on_b);
        set_points(c, points, -rotate(sa.orientation, normalize(plane_a->normal)));
    } else {
        const Nearest n = world.nearest(c.a, sa, c.b, sb);
        c.count = 0;
        if (n.distance > reach) return;
        std::vector<SurfacePoint> points = contact_points_of_round(ca, sa, cb, sb, n.normal, reach);
        // Between the corners that a rim counts as may be one that is nearer.
        if (std::none_of(points.begin(), points.end(), [&](const auto& p) { return p.gap <= n.distance + n.error; }))
            points.push_back({n.distance, n.point + n.normal * n.distance, n.point});
        set_points(c, spread(std::move(points)), n.normal);
    }
}

}  // namespace

Nearest nearest_bodies(const ContactWorld& world, const RigidScene& scene, int a, const RigidState& sa, int b,
                       const RigidState& sb) {
    const Collider &ca = scene.bodies[size_t(a)].collider, &cb = scene.bodies[size_t(b)].collider;
    if (const auto near = nearest_in_closed_form(ca, sa, cb, sb)) return *near;
    if (!has_flat_faces(ca) || !has_flat_faces(cb)) return world.nearest(a, sa, b, sb);
    const Polytope pa = make_polytope(ca, sa), pb = make_polytope(cb, sb);
    Separation s = separate(pa, pb);
    Nearest out{s.distance, s.normal, (sa.position + sb.position) * 0.5, touch_distance};
    if (s.distance > touch_distance) return out;
    s = prefer_faces(pa, pb, s);
    out.normal = s.normal;
    const std::vector<SurfacePoint> points = contact_points(pa, pb, s, touching_points);
    if (points.empty()) return world.nearest(a, sa, b, sb);  // no face or edge is opposite: a corner
    for (double least = never; const SurfacePoint& p : points)
        if (p.gap < least) least = p.gap, out.point = p.on_b;
    return out;
}

std::vector<Contact> find_contacts(ContactWorld& world, const RigidScene& scene, const std::vector<RigidState>& states,
                                   double reach) {
    std::vector<Contact> out = world.contacts(states, reach);
    for (Contact& c : out) refine(c, world, scene, states, reach);
    std::erase_if(out, [](const Contact& c) { return c.count == 0; });
    update_approach(out, states);
    return out;
}

void update_approach(std::vector<Contact>& contacts, const std::vector<RigidState>& states) {
    for (Contact& c : contacts)
        for (ContactPoint& p : c.points()) p.approach = approach_at(c, p, states);
}

}  // namespace drt
