// From contact to contact, against exact solutions.

#include <gtest/gtest.h>

#include "drt/dynamics/audit.h"
#include "dynamics/rigid_scenes.h"

namespace drt {
namespace {

using namespace test;

RigidScene on_floor(std::vector<RigidBody> bodies, double gravity = 9.81) {
    bodies.insert(bodies.begin(), floor_body());
    return {std::move(bodies), {0, -gravity, 0}};
}

// A bounce ends where it is slower than 0.02 sqrt(g r); what is lost then is less than 2e-4 of the radius.
TEST(Simulate, BouncesToTheExactHeights) {
    for (const double e : {1.0, 0.8, 0.5, 0.0})
        for (const double step : {1.0 / 24, 1.0 / 960}) {
            const RigidScene scene = on_floor({ball({0, 51, 0}, e)}, 98.1);
            const Simulation r = simulate(scene, 0, 12, step);
            double worst = 0;
            for (double t = 0; t <= 12; t += 1.0 / 240) {
                const double height = state_at(scene.bodies[1], r.tracks[1], t).position.y - 1;
                worst = std::max(worst, std::abs(height - bounce_height(t, 50, e, 98.1)));
            }
            EXPECT_LE(worst, e == 1 ? 1e-10 : 2e-4) << e;
            for (const Impact& i : r.impacts) EXPECT_LE(i.energy_after, i.energy_before * (1 + 1e-12));
        }
}

// Sliding turns to rolling at 5/7 of the speed whatever the friction; the way there is second order in the step.
TEST(Simulate, ASlidingBallEndsRolling) {
    RigidScene scene = on_floor({ball({0, 1, 0}, 0)});
    scene.bodies[1].start.velocity = {5, 0, 0};
    const double rolls_from = 2 * 5 / (7 * 0.5 * 9.81);
    const double way = 5 * rolls_from - 0.25 * 9.81 * rolls_from * rolls_from;
    double last_error = 0;
    for (const double step : {1.0 / 24, 1.0 / 240}) {
        const Simulation r = simulate(scene, 0, 2, step);
        const RigidState s = state_at(scene.bodies[1], r.tracks[1], 1.9);
        EXPECT_NEAR(s.velocity.x, 25.0 / 7, 1e-12);
        EXPECT_NEAR(s.spin.z, -25.0 / 7, 1e-12);
        EXPECT_NEAR(s.position.y, 1, 1e-11);
        last_error = std::abs(s.position.x - (way + 25.0 / 7 * (1.9 - rolls_from)));
        EXPECT_LE(last_error, 2e-3 * step) << step;
    }
}

TEST(Simulate, RestsForAMinute) {
    for (const RigidBody& body : {ball({0, 1, 0}, 0.5), box({0, 1, 0}, {1, 1, 1}, 0.5)}) {
        const RigidScene scene = on_floor({body});
        const Simulation r = simulate(scene, 0, 60, 1.0 / 96);
        for (double t = 0; t <= 60; t += 0.5)
            EXPECT_LE(length(state_at(scene.bodies[1], r.tracks[1], t).position - Vec3d{0, 1, 0}), 1e-9);
    }
}

TEST(Simulate, NothingPassesAThinWall) {
    for (const double speed : {20.0, 200.0, 2e4, 2e6}) {
        RigidBody wall = box({0, 0, 0}, {0.05, 10, 10}, 1);
        wall.kind = RigidBody::Kind::fixed;
        RigidScene scene{{wall, ball({-20, 0, 0}, 1)}, {}};
        scene.bodies[1].start.velocity = {speed, 0, 0};
        const double hit = 18.95 / speed;
        const Simulation r = simulate(scene, 0, 2 * hit, 1);
        const RigidState s = state_at(scene.bodies[1], r.tracks[1], 2 * hit);
        EXPECT_NEAR(s.position.x, -20, 1e-9) << speed;
        EXPECT_NEAR(s.velocity.x / speed, -1, 1e-12);
    }
}

// Five balls in a row that touch: the last one leaves, the others stay.
TEST(Simulate, NewtonsCradle) {
    std::vector<RigidBody> balls{ball({-10, 0, 0}, 1)};
    balls[0].start.velocity = {3, 0, 0};
    for (int i = 0; i < 4; ++i) balls.push_back(ball({2.0 * i, 0, 0}, 1));
    for (RigidBody& b : balls) b.friction = 0;
    const RigidScene scene{balls, {}};
    const Simulation r = simulate(scene, 0, 5, 1);
    for (size_t i = 0; i < balls.size(); ++i)
        EXPECT_NEAR(state_at(balls[i], r.tracks[i], 5).velocity.x, i + 1 == balls.size() ? 3 : 0, 1e-12) << i;
}

// A ball that strikes the foremost of a tight rack in the middle sends it off evenly: its mirror image is itself.
TEST(Simulate, ARackBreaksEvenly) {
    RigidScene scene = billiard_break(0);
    scene.bodies.back().start.position.z = 0;
    const Simulation r = simulate(scene, 0, 0.11, 1.0 / 96);
    double widest = 0;
    for (size_t row = 0, first = 1; row < 5; first += ++row)
        for (size_t k = 0; k <= row; ++k) {
            const auto place = [&](size_t i) { return state_at(scene.bodies[i], r.tracks[i], 0.11).position; };
            const Vec3d p = place(first + k), q = place(first + row - k);
            EXPECT_LE(length(p - Vec3d{q.x, q.y, -q.z}), 1e-6) << row << " " << k;
            widest = std::max(widest, p.z - scene.bodies[first + k].start.position.z);
        }
    EXPECT_GT(widest, 0.2);
}

// A row of bricks without restitution: each brings down the next, nothing gets into anything, energy only falls.
TEST(Simulate, DominoesFall) {
    constexpr int count = 6;
    RigidScene scene{{floor_body()}, {0, -9.81, 0}};
    for (int i = 0; i < count; ++i) scene.bodies.push_back(box({4.0 * i, 5, 0}, {1, 5, 2}, 0));
    for (int i = 1; i <= count; ++i)
        scene.bodies[size_t(i)].start.orientation = quat_from_axis_angle({0, 1, 0}, 0.1 * i);
    scene.bodies[1].blows = {{0, {3, 0, 0}, {0, 4, 0}}};
    const Simulation r = simulate(scene, 0, 12, 1.0 / 48);
    EXPECT_LE(r.deepest_overlap, 1e-3);
    EXPECT_LE(audit(scene, r.tracks, 12).energy_rise, 1e-3);
    for (int i = 1; i <= count; ++i) {
        const RigidState s = state_at(scene.bodies[size_t(i)], r.tracks[size_t(i)], 12);
        EXPECT_LE(rotate(s.orientation, Vec3d{0, 1, 0}).y, 0.7) << i;
        EXPECT_GE(s.position.y, 0.9) << i;
    }
}

// A ball hits light boxes under a heavy one, turned against each other: they give way, but never sink in.
TEST(Simulate, AHitStackDoesNotSinkIn) {
    RigidScene scene{{floor_body()}, {0, -65.4, 0}};
    for (int i = 0; i < 4; ++i) {
        scene.bodies.push_back(box({0, 1 + 2.0 * i, 0}, {1.7, 1, 1.7}, 0));
        scene.bodies.back().start.orientation = quat_from_axis_angle({0, 1, 0}, 0.1 * std::sin(7.0 * i));
    }
    scene.bodies.push_back(box({0, 9.5, 0}, {1.5, 1.5, 1.5}, 0));
    scene.bodies.back().mass *= 1e4;
    scene.bodies.back().inertia = scene.bodies.back().inertia * 1e4;
    scene.bodies.push_back(ball({-6, 1.1, 0.4}, 0.7, 1.1, 3));
    scene.bodies.back().start.velocity = {15, 0, 0};
    const Simulation r = simulate(scene, 0, 1.5, 1.0 / 96);
    EXPECT_LE(r.deepest_overlap, 1e-3);
    EXPECT_LE(audit(scene, r.tracks, 1.5).energy_rise, 1e-4);
    EXPECT_NEAR(state_at(scene.bodies[5], r.tracks[5], 1.5).position.y, 9.5, 1e-2);
    EXPECT_GT(r.impacts.size(), 0u);
}

// A brick tips over its edge without slipping: what its centre has fallen is in its speed, but for an error that halves
// with the step.
TEST(Simulate, ABrickTipsOverItsEdge) {
    RigidScene scene{{floor_body(), box({0, 5, 0}, {1, 5, 1}, 0)}, {0, -9.81, 0}};
    for (RigidBody& b : scene.bodies) b.friction = 3;
    const Vec3d edge{1, 0, 0};
    scene.bodies[1].start.spin = {0, 0, -0.7};
    scene.bodies[1].start.velocity = cross(scene.bodies[1].start.spin, scene.bodies[1].start.position - edge);
    const double inertia = scene.bodies[1].inertia.z + 26;  // about the edge
    double last = 1;
    for (const double step : {1.0 / 48, 1.0 / 96, 1.0 / 192}) {
        const Simulation r = simulate(scene, 0, 0.8, step);
        const Track& track = r.tracks[1];  // a step's velocity is that of its middle
        const double middle = 0.5 * (track[track.size() - 2].begin + track.back().begin);
        const RigidState s = state_at(scene.bodies[1], track, middle);
        EXPECT_NEAR(length(s.position - edge), std::sqrt(26.0), 1e-5);
        const double energy = 0.5 * inertia * s.spin.z * s.spin.z + 9.81 * s.position.y;
        const double error = std::abs(energy / (0.5 * inertia * 0.49 + 9.81 * 5) - 1);
        EXPECT_LE(error, 0.55 * last) << step;
        last = error;
    }
    EXPECT_LE(last, 5e-5);
}

TEST(Simulate, ABreakNeverGainsEnergyAndNoBallOverlaps) {
    for (const double gap : {0.0, 1e-6, 1e-2}) {
        const RigidScene scene = billiard_break(gap);
        const Simulation r = simulate(scene, 0, 1, 1.0 / 96);
        for (const Impact& i : r.impacts) EXPECT_LE(i.energy_after, i.energy_before * (1 + 1e-9));
        for (double t = 0; t <= 1; t += 1.0 / 64)
            for (size_t a = 1; a < scene.bodies.size(); ++a)
                for (size_t b = a + 1; b < scene.bodies.size(); ++b) {
                    const Vec3d apart = state_at(scene.bodies[a], r.tracks[a], t).position -
                                        state_at(scene.bodies[b], r.tracks[b], t).position;
                    EXPECT_GE(length(apart), 2 - 1e-4) << gap << ": " << a << " and " << b << " at " << t;
                }
    }
}

TEST(Simulate, GivesTheSameBitsEveryTime) {
    const RigidScene scene = billiard_break(1e-3);
    const Simulation a = simulate(scene, 0, 1, 1.0 / 96), b = simulate(scene, 0, 1, 1.0 / 96);
    ASSERT_EQ(a.impacts.size(), b.impacts.size());
    for (size_t i = 0; i < scene.bodies.size(); ++i) {
        ASSERT_EQ(a.tracks[i].size(), b.tracks[i].size());
        for (size_t k = 0; k < a.tracks[i].size(); ++k) {
            ASSERT_EQ(a.tracks[i][k].begin, b.tracks[i][k].begin);
            ASSERT_EQ(a.tracks[i][k].from.position, b.tracks[i][k].from.position);
            ASSERT_EQ(a.tracks[i][k].from.spin, b.tracks[i][k].from.spin);
        }
    }
}

// A box that is dropped on a corner comes to rest on a face; then it takes no steps any more.
TEST(Simulate, ATumblingBoxComesToRest) {
    RigidBody b = box({0, 4, 0}, {1, 1, 1}, 0.3);
    b.start.orientation = quat_from_axis_angle(normalize(Vec3d{1, 0.3, 0.2}), 0.5);
    const RigidScene scene = on_floor({b});
    const Simulation r = simulate(scene, 0, 60, 1.0 / 192);
    EXPECT_NEAR(state_at(b, r.tracks[1], 60).position.y, 1, 1e-5);
    EXPECT_LE(r.tracks[1].back().begin, 8);
    EXPECT_LE(audit(scene, r.tracks, 60).energy_rise, Audit::most_energy_rise);
}

// One corner lands, then the next: none sinks in, however little the box is tilted.
TEST(Simulate, ASlightlyTiltedBoxDoesNotSinkIn) {
    for (const double tilt : {2e-6, 1e-5, 1e-4, 1e-3}) {
        RigidBody b = box({0, 6, 0}, {1, 1, 1}, 0.5);
        b.start.orientation = quat_from_axis_angle(normalize(Vec3d{1, 0, 0.3}), tilt);
        const RigidScene scene = on_floor({b});
        const Simulation r = simulate(scene, 0, 3, 1.0 / 96);
        for (double t = 0; t <= 3; t += 1.0 / 512) {
            const RigidState s = state_at(b, r.tracks[1], t);
            const Vec3d down = rotate_back(s.orientation, Vec3d{0, 1, 0});
            const double lowest = s.position.y - (std::abs(down.x) + std::abs(down.y) + std::abs(down.z));
            ASSERT_GE(lowest, -2e-3) << tilt << " at " << t;
        }
    }
}

// What sleeps on a box wakes up when the box is knocked away.
TEST(Simulate, NothingHoversWhereItsSupportIsGone) {
    RigidBody support = box({0, 1, 0}, {1, 1, 1}, 0), plate = box({0, 2.1, 0}, {1, 0.1, 1}, 0);
    plate.friction = 0;
    RigidScene scene = on_floor({support, plate});
    scene.bodies[1].blows = {{10, {200, 0, 0}, {}}};
    const Simulation r = simulate(scene, 0, 14, 1.0 / 96);
    EXPECT_NEAR(state_at(scene.bodies[2], r.tracks[2], 10).position.y, 2.1, 1e-6);
    EXPECT_NEAR(state_at(scene.bodies[2], r.tracks[2], 14).position.y, 0.1, 1e-3);
}

TEST(Simulate, ABallThatStartsInTheFloorIsPushedOutWithoutSpeed) {
    const RigidScene scene = on_floor({ball({0, 0.95, 0}, 0.9)});
    const Simulation r = simulate(scene, 0, 1, 1.0 / 96);
    for (double t = 0; t <= 1; t += 1.0 / 64)
        EXPECT_NEAR(state_at(scene.bodies[1], r.tracks[1], t).position.y, 1, 1e-9);
}

}  // namespace
}  // namespace drt
