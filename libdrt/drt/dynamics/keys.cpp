#include "drt/dynamics/keys.h"

#include <algorithm>
#include <cmath>

#include "drt/base/constants.h"

namespace drt {

namespace {

constexpr int checks = 12;                // points between two keys where the interpolation is compared
constexpr double largest_short_turn = 2;  // radians; beyond it a key says how far the body turned

Vec3d rotation_vector(Quatd q) {
    if (q.w < 0) q = -q;
    const Vec3d v{q.x, q.y, q.z};
    const double sine = length(v);
    return sine > 0 ? v * (2 * std::atan2(sine, q.w) / sine) : Vec3d{};
}

// Of all the turns that lead from a to b, with any number of whole revolutions, the one nearest to what the spins say.
Vec3d turn_between(const RigidState& a, const RigidState& b, double seconds) {
    const Vec3d shortest = rotation_vector(b.orientation * conjugate(a.orientation));
    const Vec3d expected = (a.spin + b.spin) * (0.5 * seconds);
    const double angle = length(shortest);
    const Vec3d axis =
        angle > 0 ? shortest / angle
                  : normalize(expected.x == 0 && expected.y == 0 && expected.z == 0 ? Vec3d{0, 0, 1} : expected);
    const double revolutions = std::round((dot(expected, axis) - angle) / (2 * pi<double>));
    return axis * (angle + 2 * pi<double> * revolutions);
}

Quatd turned(const Quatd& q, const Vec3d& rotation, double share) {
    const double angle = length(rotation);
    return angle > 0 ? quat_from_axis_angle(rotation / angle, angle * share) * q : q;
}

bool interpolates(const RigidBody& body, const Track& track, double t0, double t1, const KeyTolerance& tolerance) {
    // Just inside, so that what a contact does at the ends is not part of it.
    const RigidState a = state_at(body, track, t0), b = state_at(body, track, std::nextafter(t1, t0));
    const Vec3d turn = turn_between(a, b, t1 - t0);
    const double rounding = 1e-15 * (length(a.position) + length(b.position));
    for (int i = 1; i <= checks; ++i) {
        const double share = double(i) / (checks + 1);
        const RigidState s = state_at(body, track, t0 + (t1 - t0) * share);
        const Vec3d position = a.position + (b.position - a.position) * share;
        if (length(position - s.position) > tolerance.position + rounding) return false;
        const Quatd orientation = turned(a.orientation, turn, share);
        if (length(rotation_vector(s.orientation * conjugate(orientation))) > tolerance.angle) return false;
    }
    return true;
}

// Times at which the motion jumps: a bounce, a blow. In lasting contact every step changes the velocity a little; what
// matters there moves the body by a good part of the tolerance within a step.
std::vector<double> jumps(const RigidBody& body, const Track& track, double begin, double end,
                          const KeyTolerance& tolerance) {
    std::vector<double> out;
    for (size_t i = 1; i < track.size(); ++i) {
        const double t = track[i].begin;
        if (t <= begin || t >= end) continue;
        const RigidState before = state_at(body, track[i - 1], t), &after = track[i].from;
        const bool steps = !track[i - 1].free && !track[i].free;
        const double next = i + 1 < track.size() ? track[i + 1].begin : end;
        const double seconds = std::max(t - track[i - 1].begin, next - t);
        const auto is_jump = [&](const Vec3d& from, const Vec3d& to, double allowed) {
            const double change = length(to - from), share = change / (length(from) + length(to) + 1e-30);
            if (change <= 1e-9) return false;
            return steps ? share > 0.02 && change * seconds > 0.1 * allowed : share > 1e-3;
        };
        if (is_jump(before.velocity, after.velocity, tolerance.position) ||
            is_jump(before.spin, after.spin, tolerance.angle))
            out.push_back(t);
    }
    return out;
}

}  // namespace

std::vector<MotionKey> keys_of(const RigidBody& body, const Track& track, double begin, double end,
                               const KeyTolerance& tolerance) {
    std::vector<double> fixed = jumps(body, track, begin, end, tolerance);
    fixed.push_back(end);
    std::vector<MotionKey> keys;
    RigidState last = state_at(body, track, begin);
    keys.push_back({begin, last.position, last.orientation, {}});
    double t = begin;
    for (const double limit : fixed)
        while (t < limit) {
            // The longest stretch that will do, to a sixteenth.
            double shortest = 0, longest = limit - t;
            if (!interpolates(body, track, t, limit, tolerance)) {
                while (shortest == 0 || longest - shortest > shortest / 16) {
                    const double middle = shortest == 0 ? longest / 2 : 0.5 * (shortest + longest);
                    if (middle < 1e-9 * (end - begin) || interpolates(body, track, t, t + middle, tolerance))
                        shortest = middle;
                    else
                        longest = middle;
                }
                longest = shortest;
            }
            const double next = longest >= limit - t ? limit : t + longest;
            const RigidState s = state_at(body, track, next);
            MotionKey key{next, s.position, {}, {}};
            // What happens at the key itself is not part of the way there.
            const Vec3d turn = turn_between(last, state_at(body, track, std::nextafter(next, t)), next - t);
            if (const double angle = length(turn); angle > largest_short_turn)
                key.turn = Turn{turn / angle, degrees(angle)};
            else
                key.orientation = s.orientation;
            keys.push_back(key);
            last = s;
            t = next;
        }
    const bool still = std::all_of(keys.begin(), keys.end(), [&](const MotionKey& k) {
        return length(k.position - keys[0].position) <= tolerance.position && !k.turn &&
               length(rotation_vector(*k.orientation * conjugate(*keys[0].orientation))) <= tolerance.angle;
    });
    if (still) keys.resize(1);
    return keys;
}

}  // namespace drt
