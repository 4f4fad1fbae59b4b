#include "drt/dynamics/rows.h"

#include <algorithm>
#include <numeric>

#include "drt/dynamics/complementarity.h"

namespace drt {

namespace {

struct Body {
    double inverse_mass = 0;  // 0: nothing moves it
    Vec3d inverse_inertia;
    Quatd orientation;
};

std::vector<Body> bodies_of(const RigidScene& scene, const std::vector<RigidState>& states) {
    std::vector<Body> out;
    for (size_t i = 0; i < states.size(); ++i) {
        const RigidBody& b = scene.bodies[i];
        if (b.kind == RigidBody::Kind::dynamic)
            out.push_back({1 / b.mass, {1 / b.inertia.x, 1 / b.inertia.y, 1 / b.inertia.z}, states[i].orientation});
        else
            out.push_back({});
    }
    return out;
}

Vec3d times_inverse_inertia(const Body& b, const Vec3d& v) {
    const Vec3d l = rotate_back(b.orientation, v);
    return rotate(b.orientation,
                  Vec3d{l.x * b.inverse_inertia.x, l.y * b.inverse_inertia.y, l.z * b.inverse_inertia.z});
}

struct Problem {
    std::vector<Body> bodies;
    const std::vector<Row>& rows;
    std::vector<Vec3d> spin_a, spin_b;  // by row: that a unit impulse gives

    const Body& a(int row) const { return bodies[size_t(rows[size_t(row)].a)]; }
    const Body& b(int row) const { return bodies[size_t(rows[size_t(row)].b)]; }
};

Problem make_problem(const RigidScene& scene, const std::vector<Row>& rows, const std::vector<RigidState>& states) {
    Problem p{bodies_of(scene, states), rows, {}, {}};
    for (int k = 0; k < int(rows.size()); ++k) {
        p.spin_a.push_back(times_inverse_inertia(p.a(k), rows[size_t(k)].turn_a));
        p.spin_b.push_back(times_inverse_inertia(p.b(k), rows[size_t(k)].turn_b));
    }
    return p;
}

// What a unit impulse of row j does to the speed along row i.
double coupling(const Problem& p, int i, int j) {
    const Row &r = p.rows[size_t(i)], &s = p.rows[size_t(j)];
    const Vec3d &spin_a = p.spin_a[size_t(j)], &spin_b = p.spin_b[size_t(j)];
    const double along = dot(r.linear, s.linear);
    double sum = 0;
    if (r.a == s.a) sum += p.a(i).inverse_mass * along + dot(r.turn_a, spin_a);
    if (r.b == s.b) sum += p.b(i).inverse_mass * along + dot(r.turn_b, spin_b);
    if (r.a == s.b) sum += -p.a(i).inverse_mass * along + dot(r.turn_a, spin_b);
    if (r.b == s.a) sum += -p.b(i).inverse_mass * along + dot(r.turn_b, spin_a);
    return sum;
}

Complementarity make_complementarity(const Problem& p, const std::vector<int>& group,
                                     const std::vector<RigidState>& states) {
    const size_t n = group.size();
    Complementarity c;
    c.n = int(n);
    c.A.resize(n * n);
    std::vector<int> place(p.rows.size(), -1);
    for (size_t i = 0; i < n; ++i) {
        place[size_t(group[i])] = int(i);
        for (size_t j = 0; j <= i; ++j) c.A[i * n + j] = c.A[j * n + i] = coupling(p, group[i], group[j]);
        const Row& r = p.rows[size_t(group[i])];
        const RigidState &a = states[size_t(r.a)], &b = states[size_t(r.b)];
        c.b.push_back(dot(r.linear, a.velocity - b.velocity) + dot(r.turn_a, a.spin) + dot(r.turn_b, b.spin) +
                      r.offset);
        c.x.push_back(r.impulse);
        c.normal.push_back(r.normal < 0 ? -1 : place[size_t(r.normal)]);
        c.limit.push_back(r.limit);
    }
    return c;
}

// Rows that share moving bodies, directly or through others.
std::vector<std::vector<int>> groups_of(const Problem& p) {
    std::vector<int> parent(p.bodies.size());
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&](int i) {
        while (parent[size_t(i)] != i) i = parent[size_t(i)] = parent[size_t(parent[size_t(i)])];
        return i;
    };
    const auto moves = [&](int i) { return p.bodies[size_t(i)].inverse_mass > 0; };
    for (const Row& r : p.rows)
        if (moves(r.a) && moves(r.b)) parent[size_t(root(r.a))] = root(r.b);
    std::vector<std::vector<int>> out;
    std::vector<int> place(p.bodies.size(), -1);
    for (size_t k = 0; k < p.rows.size(); ++k) {
        const int body = moves(p.rows[k].a) ? p.rows[k].a : p.rows[k].b;
        int& group = place[size_t(root(body))];
        if (group < 0) {
            group = int(out.size());
            out.emplace_back();
        }
        out[size_t(group)].push_back(int(k));
    }
    return out;
}

void apply(const Problem& p, int row, double impulse, std::vector<RigidState>& states) {
    const Row& r = p.rows[size_t(row)];
    RigidState &a = states[size_t(r.a)], &b = states[size_t(r.b)];
    a.velocity += r.linear * (p.a(row).inverse_mass * impulse);
    b.velocity -= r.linear * (p.b(row).inverse_mass * impulse);
    a.spin += p.spin_a[size_t(row)] * impulse;
    b.spin += p.spin_b[size_t(row)] * impulse;
}

}  // namespace

Row push_along(int a, int b, const Vec3d& direction, const Vec3d& from_a, const Vec3d& from_b) {
    Row r;
    r.a = a;
    r.b = b;
    r.linear = direction;
    r.turn_a = cross(from_a, direction);
    r.turn_b = -cross(from_b, direction);
    return r;
}

double solve_rows(const RigidScene& scene, std::vector<Row>& rows, std::vector<RigidState>& states) {
    const Problem p = make_problem(scene, rows, states);
    double worst = 0;
    for (const std::vector<int>& group : groups_of(p)) {
        Complementarity c = make_complementarity(p, group, states);
        worst = std::max(worst, solve(c));
        for (size_t i = 0; i < group.size(); ++i) {
            rows[size_t(group[i])].impulse = c.x[i];
            apply(p, group[i], c.x[i], states);
        }
    }
    return worst;
}

}  // namespace drt
