#include "drt/bake/course.h"

#include <algorithm>
#include <cmath>

#include "drt/plan/motion_build.h"

namespace drt {

namespace {

Vec3d place(const MotionPiece<double>& p, double s) { return p.c0 + (p.c1 + (p.c2 + p.c3 * s) * s) * s; }
Vec3d slope(const MotionPiece<double>& p, double s) { return p.c1 + (p.c2 * 2.0 + p.c3 * (3 * s)) * s; }

// That many parabolas follow any cubic to 2e-17 of |c3|: closer than doubles do.
constexpr double most_parts = 1e5;

// A piece in time: s in [0, 1] takes `seconds` from `begin`.
struct TimedPiece {
    const MotionPiece<double>& piece;
    double begin, seconds;
};

class CourseBuilder {
public:
    CourseBuilder(const RigidUnits& units, const Quatd& frame) : units_(units), frame_(frame) {}

    void add(const TimedPiece& t) {
        const MotionPiece<double>& p = t.piece;
        // Two parabolas in place of a cubic with the same ends and slopes differ from it by |c3| / 54 at most.
        const double off = length(p.c3) / (54 * units_.length);
        if (off == 0) return add_path(t, 0, place(p, 0), slope(p, 0), p.c2 * 2.0);
        const int parts = int(std::clamp(std::ceil(std::cbrt(off / course_tolerance)), 1.0, most_parts));
        for (int i = 0; i < parts; ++i) add_parabolas(t, double(i) / parts, double(i + 1) / parts);
    }

    Track take() { return std::move(track_); }

private:
    void add_parabolas(const TimedPiece& t, double s0, double s1) {
        const Vec3d p0 = place(t.piece, s0), p1 = place(t.piece, s1), v0 = slope(t.piece, s0), v1 = slope(t.piece, s1);
        const double half = 0.5 * (s1 - s0);
        const Vec3d middle_slope = (p1 - p0) / half - (v0 + v1) * 0.5;
        const Vec3d middle = p0 + (v0 + middle_slope) * (0.5 * half);
        add_path(t, s0, p0, v0, (middle_slope - v0) / half);
        add_path(t, s0 + half, middle, middle_slope, (v1 - middle_slope) / half);
    }

    // Slope and bend are the derivatives of the place by s.
    void add_path(const TimedPiece& t, double s, const Vec3d& at, const Vec3d& slope_at, const Vec3d& bend) {
        const MotionPiece<double>& p = t.piece;
        Path path;
        path.begin = t.begin + s * t.seconds;
        path.free = false;
        path.from.position = units_.from_scene(at);
        path.from.velocity = slope_at / (t.seconds * units_.length);
        path.acceleration = bend / (t.seconds * t.seconds * units_.length);
        path.from.orientation = quat_from_axis_angle(p.axis, p.angle * s) * p.q0 * frame_;
        path.from.spin = p.axis * (p.angle / t.seconds);
        track_.push_back(path);
    }

    const RigidUnits& units_;
    const Quatd& frame_;
    Track track_;
};

}  // namespace

Track course_of(const Motion& motion, const RigidUnits& units, const Quatd& frame, double begin, double end) {
    CourseBuilder builder(units, frame);
    const std::vector<MotionPiece<double>> path = build_path(motion, begin, end);
    for (const MotionPiece<double>& p : path)
        builder.add({p, begin + p.begin * (end - begin), (end - begin) / p.inv_length});
    return builder.take();
}

}  // namespace drt
