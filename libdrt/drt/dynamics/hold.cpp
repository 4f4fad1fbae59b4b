#include "drt/dynamics/hold.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace drt {

namespace {

constexpr int sweeps_between = 4;  // before which contacts hold is believed
constexpr int bold_rounds = 12, careful_rounds = 5;
constexpr int most_direct_rows = 400;  // beyond it sweeps alone are cheaper
constexpr double dependent = 1e-11;    // of the diagonal: what is left of it
constexpr int most_newton_steps = 8;
constexpr double exact = 1e-8;  // of the largest speed

// One unknown impulse: along `direction` from b to a at points, or about it.
struct Row {
    int a = 0, b = 0;
    Vec3d linear;          // on a; the opposite on b
    Vec3d turn_a, turn_b;  // torque on a, and on b, of a unit impulse
    double offset = 0;     // speed beyond which it acts
    int normal = -1;       // friction: the row of the normal impulse that limits it ...
    double limit = 0;      // ... times this
    double guess = 0;
    ContactPoint* point = nullptr;  // whose force it is part of; none for rolling friction
    Vec3d spin_a, spin_b;           // that a unit impulse gives a, and b
};

struct Body {
    double inverse_mass = 0;
    Vec3d inverse_inertia;
    Quatd orientation;
};

Vec3d times_inverse_inertia(const Body& b, const Vec3d& v) {
    const Vec3d l = rotate_back(b.orientation, v);
    return rotate(b.orientation,
                  Vec3d{l.x * b.inverse_inertia.x, l.y * b.inverse_inertia.y, l.z * b.inverse_inertia.z});
}

struct Problem {
    const RigidScene& scene;
    std::vector<Body> bodies;
    std::vector<Row> rows;
};

Problem make_problem(const RigidScene& scene, const std::vector<RigidState>& states) {
    Problem p{scene, {}, {}};
    for (size_t i = 0; i < states.size(); ++i) {
        const RigidBody& b = scene.bodies[i];
        if (b.kind == RigidBody::Kind::dynamic)
            p.bodies.push_back(
                {1 / b.mass, {1 / b.inertia.x, 1 / b.inertia.y, 1 / b.inertia.z}, states[i].orientation});
        else
            p.bodies.push_back({});
    }
    return p;
}

Row push_along(int a, int b, const Vec3d& direction, const Vec3d& from_a, const Vec3d& from_b) {
    Row r;
    r.a = a;
    r.b = b;
    r.linear = direction;
    r.turn_a = cross(from_a, direction);
    r.turn_b = -cross(from_b, direction);
    return r;
}

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

void add_rows(Problem& p, const std::vector<RigidState>& states, Contact& c, double seconds) {
    const RigidBody &body_a = p.scene.bodies[size_t(c.a)], &body_b = p.scene.bodies[size_t(c.b)];
    const RigidState &a = states[size_t(c.a)], &b = states[size_t(c.b)];
    const double friction = combined_friction(body_a, body_b);
    const double rolling = combined_rolling_friction(body_a, body_b) *
                           std::max(size_of_roll(body_a.collider), size_of_roll(body_b.collider));
    for (ContactPoint& point : c.points()) {
        const Vec3d from_a = point.on_a - a.position, from_b = point.on_b - b.position;
        const int normal = int(p.rows.size());
        const auto push = [&](const Vec3d& direction) {
            Row r = push_along(c.a, c.b, direction, from_a, from_b);
            r.guess = dot(point.force, direction) * seconds;
            r.point = &point;
            return r;
        };
        p.rows.push_back(push(point.normal));
        if (seconds > 0) p.rows.back().offset = std::max(point.gap, 0.0) / seconds;
        const Vec3d relative = a.velocity + cross(a.spin, from_a) - b.velocity - cross(b.spin, from_b);
        const auto add_limited = [&](const Row& row, double limit) {
            p.rows.push_back(row);
            p.rows.back().normal = normal;
            p.rows.back().limit = limit;
        };
        const auto [along, across] = friction_directions(point.normal, relative);
        if (friction > 0)
            for (const Vec3d& d : {along, across}) add_limited(push(d), friction);
        if (rolling > 0) {
            const auto [roll, tilt] = friction_directions(point.normal, a.spin - b.spin);
            for (const Vec3d& d : {roll, tilt}) {
                Row r;
                r.a = c.a;
                r.b = c.b;
                r.turn_a = d;
                r.turn_b = -d;
                add_limited(r, rolling);
            }
        }
    }
}

// ---- the complementarity problem: w = A x + b -----------------------------------------------------------------------

struct Lcp {
    int n = 0;
    std::vector<double> A;  // n x n, symmetric
    std::vector<double> b, x;
    std::vector<int> normal;  // by row: -1, or the row whose x limits it
    std::vector<double> limit;
    std::vector<double> scratch;  // of the direct solutions

    double at(int i, int j) const { return A[size_t(i) * size_t(n) + size_t(j)]; }
    double low(int i) const { return normal[size_t(i)] < 0 ? 0 : -high(i); }
    double high(int i) const { return normal[size_t(i)] < 0 ? never : limit[size_t(i)] * x[size_t(normal[size_t(i)])]; }
    double w(int i) const {
        const double* row = &A[size_t(i) * size_t(n)];
        return std::inner_product(row, row + n, x.begin(), b[size_t(i)]);
    }
};

double coupling(const Problem& p, const Row& r, const Row& s) {
    double sum = 0;
    const double along = dot(r.linear, s.linear);
    if (r.a == s.a) sum += p.bodies[size_t(r.a)].inverse_mass * along + dot(r.turn_a, s.spin_a);
    if (r.b == s.b) sum += p.bodies[size_t(r.b)].inverse_mass * along + dot(r.turn_b, s.spin_b);
    if (r.a == s.b) sum += -p.bodies[size_t(r.a)].inverse_mass * along + dot(r.turn_a, s.spin_b);
    if (r.b == s.a) sum += -p.bodies[size_t(r.b)].inverse_mass * along + dot(r.turn_b, s.spin_a);
    return sum;
}

Lcp make_lcp(const Problem& p, const std::vector<int>& which, const std::vector<RigidState>& states) {
    Lcp l;
    l.n = int(which.size());
    l.A.resize(which.size() * which.size());
    std::vector<int> place(p.rows.size(), -1);
    for (size_t i = 0; i < which.size(); ++i) place[size_t(which[i])] = int(i);
    for (size_t i = 0; i < which.size(); ++i) {
        const Row& r = p.rows[size_t(which[i])];
        for (size_t j = 0; j <= i; ++j)
            l.A[i * which.size() + j] = l.A[j * which.size() + i] = coupling(p, r, p.rows[size_t(which[j])]);
        const RigidState &a = states[size_t(r.a)], &b = states[size_t(r.b)];
        l.b.push_back(dot(r.linear, a.velocity - b.velocity) + dot(r.turn_a, a.spin) + dot(r.turn_b, b.spin) +
                      r.offset);
        l.x.push_back(r.guess);
        l.normal.push_back(r.normal < 0 ? -1 : place[size_t(r.normal)]);
        l.limit.push_back(r.limit);
    }
    return l;
}

// Returns the largest change of a speed.
double sweep(Lcp& l) {
    double largest = 0;
    for (int i = 0; i < l.n; ++i) {
        const double diagonal = l.at(i, i);
        if (diagonal <= 0) continue;
        const double old = l.x[size_t(i)];
        l.x[size_t(i)] = std::clamp(old - l.w(i) / diagonal, l.low(i), l.high(i));
        largest = std::max(largest, std::abs(l.x[size_t(i)] - old) * diagonal);
    }
    return largest;
}

// How far x is from a solution, as a speed.
double residual(const Lcp& l) {
    double largest = 0;
    for (int i = 0; i < l.n; ++i) {
        const double diagonal = l.at(i, i);
        if (diagonal <= 0) continue;
        const double better = std::clamp(l.x[size_t(i)] - l.w(i) / diagonal, l.low(i), l.high(i));
        largest = std::max(largest, std::abs(better - l.x[size_t(i)]) * diagonal);
    }
    return largest;
}

// Cholesky in place, lower triangle; the right side becomes a solution. Unknowns that hang on those before them stay 0:
// four points hold a box where three would do.
void solve_semidefinite(std::vector<double>& m, std::vector<double>& y) {
    const size_t n = y.size();
    const auto row = [&](size_t i) { return &m[i * n]; };
    for (size_t i = 0; i < n; ++i) {
        for (size_t j = 0; j < i; ++j)
            row(i)[j] = (row(i)[j] - std::inner_product(row(i), row(i) + j, row(j), 0.0)) / row(j)[j];
        const double rest = row(i)[i] - std::inner_product(row(i), row(i) + i, row(i), 0.0);
        row(i)[i] = rest > dependent * row(i)[i] ? std::sqrt(rest) : never;
    }
    for (size_t i = 0; i < n; ++i) y[i] = (y[i] - std::inner_product(row(i), row(i) + i, y.begin(), 0.0)) / row(i)[i];
    for (size_t i = n; i-- > 0;) {
        for (size_t k = i + 1; k < n; ++k) y[i] -= row(k)[i] * y[k];
        y[i] /= row(i)[i];
    }
}

// The normal impulses given the friction, or the friction given the normal impulses: a convex quadratic program with
// bounds, by projected Newton steps (Bertsekas 1982).
void solve_part(Lcp& l, const std::vector<int>& part, double enough) {
    for (int round = 0; round < most_newton_steps; ++round) {
        std::vector<int> free;
        std::vector<double> y;
        double largest = 0;
        for (const int i : part) {
            const double w = l.w(i), x = l.x[size_t(i)];
            if (l.at(i, i) <= 0 || (x <= l.low(i) && w > 0) || (x >= l.high(i) && w < 0)) continue;
            free.push_back(i);
            y.push_back(-w);
            largest = std::max(largest, std::abs(w));
        }
        if (largest <= enough) return;
        const size_t n = free.size();
        const std::vector<double> downhill = y;
        std::vector<double>& m = l.scratch;
        m.resize(n * n);
        for (size_t i = 0; i < n; ++i)
            for (size_t j = 0; j <= i; ++j) m[i * n + j] = l.at(free[i], free[j]);
        solve_semidefinite(m, y);
        // As far along the step as the energy falls. Its change is d.(w + A d / 2) for the change d within the bounds.
        std::vector<double> old(n), d(n);
        for (size_t i = 0; i < n; ++i) old[i] = l.x[size_t(free[i])];
        for (double share = 1; share > 1e-6; share /= 2) {
            double slope = 0, bend = 0;
            for (size_t i = 0; i < n; ++i) {
                const int k = free[i];
                d[i] = std::clamp(old[i] + share * y[i], l.low(k), l.high(k)) - old[i];
                slope -= downhill[i] * d[i];
            }
            for (size_t i = 0; i < n; ++i)
                for (size_t j = 0; j < n; ++j) bend += d[i] * l.at(free[i], free[j]) * d[j];
            if (slope + 0.5 * bend <= 1e-4 * slope) break;
        }
        for (size_t i = 0; i < n; ++i) l.x[size_t(free[i])] = old[i] + d[i];
    }
}

// All impulses between their limits at once, as if the others stayed as they are.
void solve_those_that_hold(Lcp& l) {
    std::vector<int> free;
    std::vector<double> y;
    for (int i = 0; i < l.n; ++i)
        if (l.at(i, i) > 0 && l.x[size_t(i)] > l.low(i) && l.x[size_t(i)] < l.high(i)) {
            free.push_back(i);
            y.push_back(-l.w(i));
        }
    const size_t n = free.size();
    std::vector<double>& m = l.scratch;
    m.resize(n * n);
    for (size_t i = 0; i < n; ++i)
        for (size_t j = 0; j <= i; ++j) m[i * n + j] = l.at(free[i], free[j]);
    solve_semidefinite(m, y);
    for (const bool normals : {true, false})  // friction is limited by the new normals
        for (size_t i = 0; i < n; ++i)
            if (const int k = free[i]; (l.normal[size_t(k)] < 0) == normals)
                l.x[size_t(k)] = std::clamp(l.x[size_t(k)] + y[i], l.low(k), l.high(k));
}

// Normal impulses and friction in turn (staggered projections: Kaufman et al. 2008).
double solve(Lcp& l) {
    double scale = 0;
    for (const double v : l.b) scale = std::max(scale, std::abs(v));
    const double enough = exact * scale;
    std::vector<int> normals, frictions;
    for (int i = 0; i < l.n; ++i) (l.normal[size_t(i)] < 0 ? normals : frictions).push_back(i);
    std::vector<double> best = l.x;
    double least = never;
    const auto improves = [&] {
        const double error = residual(l);
        if (!(error < least)) return false;
        least = error;
        best = l.x;
        return true;
    };
    for (const auto& part : {normals, frictions})
        for (const int i : part) l.x[size_t(i)] = std::clamp(l.x[size_t(i)], l.low(i), l.high(i));
    improves();  // what held a moment ago may do
    // Mostly the first few rounds tell which contacts hold, though the error may rise on the way.
    for (int round = 0; round < bold_rounds && least > enough; ++round) {
        for (int k = 0; k < sweeps_between; ++k) sweep(l);
        if (l.n <= most_direct_rows) solve_those_that_hold(l);
        improves();
    }
    if (least > enough) l.x = best;
    for (int round = 0; round < careful_rounds && least > enough; ++round) {
        for (int k = 0; k < sweeps_between; ++k) sweep(l);
        if (l.n <= most_direct_rows) {
            solve_part(l, normals, 0.1 * enough);
            for (const int i : frictions) l.x[size_t(i)] = std::clamp(l.x[size_t(i)], l.low(i), l.high(i));
            solve_part(l, frictions, 0.1 * enough);
        }
        improves();
    }
    l.x = best;
    return least;
}

void apply(const Problem& p, const Row& r, double impulse, std::vector<RigidState>& states) {
    RigidState &a = states[size_t(r.a)], &b = states[size_t(r.b)];
    a.velocity += r.linear * (p.bodies[size_t(r.a)].inverse_mass * impulse);
    b.velocity -= r.linear * (p.bodies[size_t(r.b)].inverse_mass * impulse);
    a.spin += r.spin_a * impulse;
    b.spin += r.spin_b * impulse;
}

// Rows that share moving bodies, directly or through others, by group.
std::vector<std::vector<int>> islands(const Problem& p) {
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
    std::vector<int> group(p.bodies.size(), -1);
    for (size_t k = 0; k < p.rows.size(); ++k) {
        const int body = moves(p.rows[k].a) ? p.rows[k].a : p.rows[k].b;
        int& g = group[size_t(root(body))];
        if (g < 0) {
            g = int(out.size());
            out.emplace_back();
        }
        out[size_t(g)].push_back(int(k));
    }
    return out;
}

}  // namespace

double hold(const RigidScene& scene, std::vector<RigidState>& states, std::span<Contact> contacts, double seconds) {
    Problem p = make_problem(scene, states);
    for (Contact& c : contacts) add_rows(p, states, c, seconds);
    for (Row& r : p.rows) {
        r.spin_a = times_inverse_inertia(p.bodies[size_t(r.a)], r.turn_a);
        r.spin_b = times_inverse_inertia(p.bodies[size_t(r.b)], r.turn_b);
    }
    for (Contact& c : contacts)
        for (ContactPoint& point : c.points()) point.force = {};
    double worst = 0;
    for (const std::vector<int>& which : islands(p)) {
        Lcp l = make_lcp(p, which, states);
        worst = std::max(worst, solve(l));
        for (size_t i = 0; i < which.size(); ++i) {
            const Row& r = p.rows[size_t(which[i])];
            apply(p, r, l.x[i], states);
            if (r.point && seconds > 0) r.point->force += r.linear * (l.x[i] / seconds);
        }
    }
    return worst;
}

}  // namespace drt
