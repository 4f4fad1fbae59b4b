#include "drt/geometry/motion_path.h"

#include <gtest/gtest.h>

#include "random_paths.h"

namespace drt {
namespace {

using test::Random;

// As rotations: q and -q are the same.
template <class Real>
double difference(const Quat<Real>& a, const Quatd& b) {
    return 1 - std::abs(dot(Quatd(a), b));
}

template <class Real>
std::vector<MotionPiece<Real>> cast_path(const std::vector<MotionPiece<double>>& path) {
    std::vector<MotionPiece<Real>> out;
    for (const auto& p : path) out.push_back(cast<Real>(p));
    return out;
}

template <class Real>
void expect_poses(double position_error, double turn_error) {
    using R = typename Pack<Real>::R;
    Random r(1);
    for (int k = 0; k < 200; ++k) {
        const auto path = test::random_path(r, 1 + k % 4, k % 2 == 0);
        const auto pieces = cast_path<Real>(path);
        const std::span<const MotionPiece<Real>> span(pieces);
        R times;
        for (int i = 0; i < Pack<Real>::width; ++i) times[i] = Real(i == 0 ? 0.0 : i == 1 ? 1.0 : r.uniform(0, 1));
        const Pose<R> poses = pose_at(span, times);
        const Vec3<R> centers = center_at(span, times);
        for (int i = 0; i < Pack<Real>::width; ++i) {
            const double u = double(lane(times, i));
            const Pose<double> truth = test::slow_pose(path, u);
            const Pose<Real> one = pose_at(span, Real(u));
            const auto at = [&](const Vec3<R>& v) {
                return Vec3d{double(lane(v.x, i)), double(lane(v.y, i)), double(lane(v.z, i))};
            };
            EXPECT_LT(length(at(poses.center) - truth.center), position_error);
            EXPECT_LT(length(at(centers) - truth.center), position_error);
            EXPECT_LT(length(Vec3d(one.center) - truth.center), position_error);
            EXPECT_LT(length(Vec3d(center_at(span, Real(u))) - truth.center), position_error);
            const Quat<Real> q{lane(poses.orientation.w, i), lane(poses.orientation.x, i), lane(poses.orientation.y, i),
                               lane(poses.orientation.z, i)};
            EXPECT_LT(difference(q, truth.orientation), turn_error);
            EXPECT_LT(difference(one.orientation, truth.orientation), turn_error);
        }
    }
}

TEST(MotionPath, PosesAreThoseOfTheFormulaInDouble) { expect_poses<double>(1e-13, 1e-14); }
TEST(MotionPath, PosesAreThoseOfTheFormulaInFloat) { expect_poses<float>(5e-5, 1e-6); }

TEST(MotionPath, AFullTurnIsNotShortened) {
    MotionPiece<double> p;
    p.axis = {0, 0, 1};
    p.angle = 2 * 2 * pi<double>;  // 720 degrees
    const std::vector<MotionPiece<double>> path{p};
    const Vec3d x{1, 0, 0};
    const auto turned = [&](double u) { return rotate(pose_at<double>(path, u).orientation, x); };
    EXPECT_LT(length(turned(0.125) - Vec3d{0, 1, 0}), 1e-15);
    EXPECT_LT(length(turned(0.25) - Vec3d{-1, 0, 0}), 1e-15);
    EXPECT_LT(length(turned(0.5) - x), 1e-15);
    EXPECT_LT(length(turned(1) - x), 1e-15);
}

}  // namespace
}  // namespace drt
