#include "drt/plan/motion_build.h"

#include <algorithm>
#include <cmath>

namespace drt {

namespace {

// One interval between keys: centre = cubic in h, orientation = turn(axis, angle h) q0, h in [0, 1].
struct KeySpan {
    double begin = 0, end = 0;  // scene time; +-infinity for the constant ends
    Vec3d c0, c1, c2, c3;
    Quatd q0;
    Vec3d axis{0, 0, 1};
    double angle = 0;
};

Vec3d tangent(const std::vector<MotionKey>& k, size_t i) {
    const size_t a = i == 0 ? 0 : i - 1, b = i + 1 == k.size() ? i : i + 1;
    return (k[b].position - k[a].position) / (k[b].time - k[a].time);
}

void set_positions(KeySpan& s, const Motion& m, size_t i) {
    const MotionKey &a = m.keys[i], &b = m.keys[i + 1];
    const Vec3d step = b.position - a.position;
    s.c0 = a.position;
    if (m.interpolation == Motion::Interpolation::linear) {
        s.c1 = step;
        return;
    }
    const double dt = b.time - a.time;
    const Vec3d m0 = tangent(m.keys, i) * dt, m1 = tangent(m.keys, i + 1) * dt;
    s.c1 = m0;
    s.c2 = step * 3.0 - m0 * 2.0 - m1;
    s.c3 = m0 + m1 - step * 2.0;
}

// Returns the orientation at the span's end.
Quatd set_orientations(KeySpan& s, const Quatd& from, const MotionKey& to) {
    s.q0 = from;
    if (to.turn) {
        s.axis = normalize(to.turn->axis);
        s.angle = radians(to.turn->degrees);
        return quat_from_axis_angle(s.axis, s.angle) * from;
    }
    const Quatd target = orientation_of(to);
    Quatd delta = target * conjugate(from);
    if (delta.w < 0) delta = -delta;  // the short way
    const Vec3d v{delta.x, delta.y, delta.z};
    const double sine = length(v);
    if (sine > 0) {
        s.axis = v / sine;
        s.angle = 2 * std::atan2(sine, delta.w);
    }
    return target;
}

std::vector<KeySpan> key_spans(const Motion& m) {
    constexpr double inf = std::numeric_limits<double>::infinity();
    const auto constant = [](const MotionKey& k, const Quatd& q, double begin, double end) {
        KeySpan s;
        s.begin = begin;
        s.end = end;
        s.c0 = k.position;
        s.q0 = q;
        return s;
    };
    const MotionKey& first = m.keys.front();
    Quatd q = orientation_of(first);
    std::vector<KeySpan> spans{constant(first, q, -inf, first.time)};
    for (size_t i = 0; i + 1 < m.keys.size(); ++i) {
        KeySpan s;
        s.begin = m.keys[i].time;
        s.end = m.keys[i + 1].time;
        set_positions(s, m, i);
        q = set_orientations(s, q, m.keys[i + 1]);
        spans.push_back(s);
    }
    spans.push_back(constant(m.keys.back(), q, m.keys.back().time, inf));
    return spans;
}

// The part of a span for h in [h0, h1], as a piece over u in [begin, begin + length].
MotionPiece<double> cut(const KeySpan& s, double h0, double h1, double begin, double length) {
    const double w = h1 - h0;
    MotionPiece<double> p;
    p.begin = begin;
    p.inv_length = length > 0 ? 1 / length : 1;
    p.c0 = s.c0 + h0 * (s.c1 + h0 * (s.c2 + h0 * s.c3));
    p.c1 = w * (s.c1 + h0 * (2.0 * s.c2 + 3.0 * h0 * s.c3));
    p.c2 = w * w * (s.c2 + 3.0 * h0 * s.c3);
    p.c3 = w * w * w * s.c3;
    p.axis = s.axis;
    p.angle = s.angle * w;
    p.q0 = quat_from_axis_angle(s.axis, s.angle * h0) * s.q0;
    return p;
}

MotionPiece<double> cut_at_times(const KeySpan& s, double ta, double tb, double begin, double length) {
    if (!std::isfinite(s.begin) || !std::isfinite(s.end)) return cut(s, 0, 0, begin, length);
    const double inv = 1 / (s.end - s.begin);
    return cut(s, (ta - s.begin) * inv, (tb - s.begin) * inv, begin, length);
}

const KeySpan& span_at(const std::vector<KeySpan>& spans, double time) {
    for (const KeySpan& s : spans)
        if (time < s.end) return s;
    return spans.back();
}

}  // namespace

std::vector<MotionPiece<double>> build_path(const Motion& m, double time0, double time1) {
    const std::vector<KeySpan> spans = key_spans(m);
    if (time0 == time1) return {cut_at_times(span_at(spans, time0), time0, time0, 0, 1)};
    std::vector<double> times{time0, time1};  // and every key in between
    const double lo = std::min(time0, time1), hi = std::max(time0, time1);
    for (const MotionKey& k : m.keys)
        if (k.time > lo && k.time < hi) times.push_back(k.time);
    std::sort(times.begin(), times.end());
    if (time1 < time0) std::reverse(times.begin(), times.end());
    std::vector<MotionPiece<double>> path;
    for (size_t i = 0; i + 1 < times.size(); ++i) {
        const double u0 = (times[i] - time0) / (time1 - time0), u1 = (times[i + 1] - time0) / (time1 - time0);
        const KeySpan& s = span_at(spans, (times[i] + times[i + 1]) / 2);
        path.push_back(cut_at_times(s, times[i], times[i + 1], u0, u1 - u0));
    }
    if (is_constant(path)) path.resize(1);
    return path;
}

bool is_constant(const std::vector<MotionPiece<double>>& path) {
    const Vec3d zero;
    return std::all_of(path.begin(), path.end(), [&](const MotionPiece<double>& p) {
        return p.angle == 0 && p.c1 == zero && p.c2 == zero && p.c3 == zero && p.c0 == path[0].c0 && p.q0 == path[0].q0;
    });
}

}  // namespace drt
