#include "drt/dynamics/overlap.h"

#include <algorithm>

#include "drt/dynamics/rows.h"

namespace drt {

PushedApart push_apart(const RigidScene& scene, const std::vector<Contact>& contacts, std::vector<RigidState>& states,
                       bool turning) {
    PushedApart out;
    std::vector<Row> rows;
    for (const Contact& c : contacts)
        for (const ContactPoint& p : c.points()) {
            if (-p.gap > out.deepest) {
                out.deepest = -p.gap;
                out.deepest_body = scene.bodies[size_t(c.a)].kind == RigidBody::Kind::dynamic ? c.a : c.b;
            }
            const Vec3d from_a = p.on_a - states[size_t(c.a)].position, from_b = p.on_b - states[size_t(c.b)].position;
            rows.push_back(push_along(c.a, c.b, p.normal, turning ? from_a : Vec3d{}, turning ? from_b : Vec3d{}));
            rows.back().offset = p.gap;
        }
    // The way that is left to go in a unit of time is a speed.
    std::vector<RigidState> way = states;
    for (RigidState& s : way) s.velocity = s.spin = {};
    solve_rows(scene, rows, way);
    for (size_t i = 0; i < states.size(); ++i) {
        if (way[i].velocity == Vec3d{} && way[i].spin == Vec3d{}) continue;
        states[i].position += way[i].velocity;
        if (const double angle = length(way[i].spin); angle > 0)
            states[i].orientation = normalize(quat_from_axis_angle(way[i].spin / angle, angle) * states[i].orientation);
        out.moved.push_back(int(i));
    }
    return out;
}

}  // namespace drt
