#include "drt/dynamics/polytope.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "drt/dynamics/clip.h"

namespace drt {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();
// An edge pair must separate by so much more than the best face: faces give more points.
constexpr double faces_preferred_by = 1e-9;
constexpr double parallel = 1e-8;  // sine of the angle
constexpr double almost_parallel = 0.02;

Polytope make(const BoxCollider& c, const RigidState& s) {
    Polytope out;
    const Vec3d x = rotate(s.orientation, Vec3d{1, 0, 0}), y = rotate(s.orientation, Vec3d{0, 1, 0}),
                z = rotate(s.orientation, Vec3d{0, 0, 1});
    for (int k = 0; k < 8; ++k)
        out.vertices.push_back(s.position + x * (k & 1 ? c.half.x : -c.half.x) + y * (k & 2 ? c.half.y : -c.half.y) +
                               z * (k & 4 ? c.half.z : -c.half.z));
    out.faces = {{-x, {0, 4, 6, 2}}, {x, {1, 3, 7, 5}},  {-y, {0, 1, 5, 4}},
                 {y, {2, 6, 7, 3}},  {-z, {0, 2, 3, 1}}, {z, {4, 5, 7, 6}}};
    out.edges = {x, y, z};
    return out;
}

Polytope make(const PolygonCollider& c, const RigidState& s) {
    Polytope out;
    const int n = int(c.vertices.size());
    for (const Vec3d& v : c.vertices) out.vertices.push_back(s.position + rotate(s.orientation, v));
    Polytope::Face front, back;
    front.normal = normalize(cross(out.vertices[1] - out.vertices[0], out.vertices[2] - out.vertices[0]));
    back.normal = -front.normal;
    for (int k = 0; k < n; ++k) {
        front.loop.push_back(k);
        back.loop.push_back(n - 1 - k);
        out.edges.push_back(normalize(out.vertices[size_t((k + 1) % n)] - out.vertices[size_t(k)]));
    }
    out.faces = {front, back};
    return out;
}

struct Extent {
    double least = never, most = -never;
};

Extent extent(const Polytope& p, const Vec3d& axis) {
    Extent e;
    for (const Vec3d& v : p.vertices) {
        const double d = dot(v, axis);
        e.least = std::min(e.least, d);
        e.most = std::max(e.most, d);
    }
    return e;
}

std::vector<Vec3d> corners(const Polytope& p, const Polytope::Face& f) {
    std::vector<Vec3d> out;
    for (const int k : f.loop) out.push_back(p.vertices[size_t(k)]);
    return out;
}

// The face of `other` that looks most against n, cut to the outline of `face`.
std::vector<Vec3d> overlap_of_faces(const Polytope& p, const Polytope::Face& face, const Polytope& other) {
    const auto against = std::min_element(other.faces.begin(), other.faces.end(), [&](const auto& f, const auto& g) {
        return dot(f.normal, face.normal) < dot(g.normal, face.normal);
    });
    std::vector<Vec3d> polygon = corners(other, *against);
    const std::vector<Vec3d> outline = corners(p, face);
    for (size_t i = 0; i < outline.size(); ++i) {
        const Vec3d edge = outline[(i + 1) % outline.size()] - outline[i];
        polygon = clip(polygon, outline[i], cross(edge, face.normal));
    }
    return polygon;
}

// Of the edges of a polytope along `direction`, the one that is farthest along n: a point of it.
Vec3d outermost_edge(const Polytope& p, const Vec3d& direction, const Vec3d& n) {
    Vec3d best;
    double farthest = -never;
    for (const Polytope::Face& f : p.faces)
        for (size_t i = 0; i < f.loop.size(); ++i) {
            const Vec3d &a = p.vertices[size_t(f.loop[i])], &b = p.vertices[size_t(f.loop[(i + 1) % f.loop.size()])];
            if (length(cross(normalize(b - a), direction)) > parallel) continue;
            const double d = dot(a + b, n);
            if (d > farthest) farthest = d, best = a;
        }
    return best;
}

SurfacePoint crossing(const Vec3d& pa, const Vec3d& da, const Vec3d& pb, const Vec3d& db, const Vec3d& n) {
    const Vec3d w = pb - pa;
    const double c = dot(da, db), s = 1 - c * c;
    const double ta = (dot(w, da) - c * dot(w, db)) / s, tb = (c * dot(w, da) - dot(w, db)) / s;
    const Vec3d on_a = pa + da * ta, on_b = pb + db * tb;
    return {dot(on_a - on_b, n), on_a, on_b};
}

// Where a cylinder may stand on its rims: where they are lowest, opposite, and between.
std::vector<Vec3d> rim_points(const CylinderCollider& c, const RigidState& s, const Vec3d& up) {
    const Vec3d axis = rotate(s.orientation, Vec3d{0, 0, 1});
    Vec3d down = axis * dot(up, axis) - up;
    if (length(down) < parallel) down = rotate(s.orientation, Vec3d{1, 0, 0});
    down = normalize(down) * c.radius;
    const Vec3d across = cross(axis, down);
    std::vector<Vec3d> out;
    for (const double end : {-c.half_height, c.half_height})
        for (const Vec3d& rim : {down, across, -across, -down}) out.push_back(s.position + axis * end + rim);
    return out;
}

}  // namespace

std::vector<SurfacePoint> contact_points(const Collider& body, const RigidState& s, const PlaneCollider& plane,
                                         const RigidState& at, double reach) {
    const Vec3d up = rotate(at.orientation, normalize(plane.normal));
    const auto* cylinder = std::get_if<CylinderCollider>(&body);
    std::vector<SurfacePoint> out;
    for (const Vec3d& p : cylinder ? rim_points(*cylinder, s, up) : make_polytope(body, s).vertices) {
        const double gap = dot(p - at.position, up);
        if (gap <= reach) out.push_back({gap, p, p - up * gap});
    }
    return spread(std::move(out));
}

bool has_flat_faces(const Collider& c) {
    return std::holds_alternative<BoxCollider>(c) || std::holds_alternative<PolygonCollider>(c);
}

Polytope make_polytope(const Collider& c, const RigidState& s) {
    if (const auto* box = std::get_if<BoxCollider>(&c)) return make(*box, s);
    return make(std::get<PolygonCollider>(c), s);
}

Separation separate(const Polytope& a, const Polytope& b) {
    Separation best;
    best.distance = -never;
    for (size_t k = 0; k < a.faces.size(); ++k) {
        const Vec3d n = -a.faces[k].normal;
        const double d = extent(a, n).least - extent(b, n).most;
        if (d > best.distance) best = {d, n, int(k), -1};
    }
    for (size_t k = 0; k < b.faces.size(); ++k) {
        const Vec3d& n = b.faces[k].normal;
        const double d = extent(a, n).least - extent(b, n).most;
        if (d > best.distance) best = {d, n, -1, int(k)};
    }
    for (const Vec3d& ea : a.edges)
        for (const Vec3d& eb : b.edges) {
            Vec3d n = cross(ea, eb);
            if (length(n) < parallel) continue;
            n = normalize(n);
            const Extent xa = extent(a, n), xb = extent(b, n);
            const double forward = xa.least - xb.most, backward = xb.least - xa.most;
            const double d = std::max(forward, backward);
            if (d > best.distance + faces_preferred_by) best = {d, forward >= backward ? n : -n, -1, -1};
        }
    return best;
}

Separation prefer_faces(const Polytope& a, const Polytope& b, const Separation& s) {
    if (s.face_of_a >= 0 || s.face_of_b >= 0) return s;
    Separation best = s;
    double nearest = almost_parallel * almost_parallel;
    for (size_t k = 0; k < a.faces.size(); ++k)
        if (const double d = length_squared(a.faces[k].normal + s.normal); d < nearest)
            nearest = d, best = {s.distance, -a.faces[k].normal, int(k), -1};
    for (size_t k = 0; k < b.faces.size(); ++k)
        if (const double d = length_squared(b.faces[k].normal - s.normal); d < nearest)
            nearest = d, best = {s.distance, b.faces[k].normal, -1, int(k)};
    return best;
}

std::vector<SurfacePoint> contact_points(const Polytope& a, const Polytope& b, const Separation& s, double reach) {
    std::vector<SurfacePoint> out;
    if (s.distance > reach) return out;
    if (s.face_of_a < 0 && s.face_of_b < 0) {
        // Which two edges: those that cross at the smallest distance.
        SurfacePoint best;
        double smallest = never;
        for (const Vec3d& ea : a.edges)
            for (const Vec3d& eb : b.edges) {
                const Vec3d n = cross(ea, eb);
                if (length(n) < parallel || length(cross(normalize(n), s.normal)) > parallel) continue;
                const SurfacePoint p =
                    crossing(outermost_edge(a, ea, -s.normal), ea, outermost_edge(b, eb, s.normal), eb, s.normal);
                if (std::abs(p.gap - s.distance) < smallest) smallest = std::abs(p.gap - s.distance), best = p;
            }
        if (smallest < never) out.push_back(best);
        return out;
    }
    const bool on_a = s.face_of_a >= 0;
    const Polytope &holder = on_a ? a : b, &other = on_a ? b : a;
    const Polytope::Face& face = holder.faces[size_t(on_a ? s.face_of_a : s.face_of_b)];
    const Vec3d& at = holder.vertices[size_t(face.loop[0])];
    for (const Vec3d& p : overlap_of_faces(holder, face, other)) {
        const double gap = dot(p - at, face.normal);
        if (gap > reach) continue;
        const Vec3d foot = p - face.normal * gap;
        out.push_back(on_a ? SurfacePoint{gap, foot, p} : SurfacePoint{gap, p, foot});
    }
    return spread(std::move(out));
}

}  // namespace drt
