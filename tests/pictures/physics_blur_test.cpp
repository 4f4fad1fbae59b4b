// Motion blur of simulated balls: the picture of a baked scene is the time average of the exact motion.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "drt/bake/bake.h"
#include "drt/base/constants.h"
#include "pictures/scene_kit.h"
#include "pictures/time_average.h"
#include "support/compare.h"
#include "support/render_picture.h"

namespace drt {
namespace {

constexpr Vec3d earth{0, -9.81, 0}, weightless{};

/// How a ball is let go at time 0.
struct Start {
    Vec3d position, velocity;
    Vec3d spin;  ///< radians / s
};

reference::Pose fly(const Start& s, const Vec3d& gravity, double t) {
    const double speed = length(s.spin);
    return {s.position + s.velocity * t + gravity * (0.5 * t * t),
            speed > 0 ? quat_from_axis_angle(s.spin / speed, speed * t) : Quatd{}};
}

Course flight(const Start& s, const Vec3d& gravity) {
    return [=](double t) { return fly(s, gravity, t); };
}

/// A ball and the floor y = 0, weighed so that the formulas' mass cancels.
struct Contact {
    double radius = 0.25, restitution = 0.8, friction = 0;
};

/// Falls, and goes on as `after` from where it is at `time`; a bounce at the floor if both are the exact ones.
Course turning_point(const Start& s, const Vec3d& gravity, double time, const Start& after) {
    return [=](double t) {
        if (t < time) return fly(s, gravity, t);
        const reference::Pose at = fly(s, gravity, time), since = fly(after, gravity, t - time);
        return reference::Pose{at.position + since.position, since.orientation * at.orientation};
    };
}

double time_of_bounce(const Start& s, const Vec3d& gravity, const Contact& c) {
    const double height = s.position.y - c.radius, down = -s.velocity.y, g = -gravity.y;
    return 2 * height / (down + std::sqrt(down * down + 2 * g * height));
}

/// Newton's restitution; Coulomb's friction that slides throughout the blow, which lasts no time. Motion in the plane
/// z = 0, spin about z. `position` is relative to the place of the bounce.
Start rebound(const Start& s, const Vec3d& gravity, const Contact& c) {
    const double down = -(s.velocity.y + gravity.y * time_of_bounce(s, gravity, c));
    const double slip = s.velocity.x + s.spin.z * c.radius;
    const double brake = std::copysign(c.friction * (1 + c.restitution) * down, slip);  // impulse / mass
    if (std::abs(slip) < 3.5 * std::abs(brake)) throw std::logic_error("this ball would cease to slide");
    return {{}, {s.velocity.x - brake, c.restitution * down, 0}, s.spin - Vec3d{0, 0, 2.5 * brake / c.radius}};
}

Course bounce(const Start& s, const Vec3d& gravity, const Contact& c, double late = 0) {
    return turning_point(s, gravity, time_of_bounce(s, gravity, c) + late, rebound(s, gravity, c));
}

/// 64 x 48 pixels of 0.0375 look level along -z at the origin, from time `begin` for `seconds`.
SceneDesc exposed(double begin, double seconds, const Vec3d& gravity) {
    SceneDesc scene = simple_scene({0, 0, 12}, {0, 0, 0}, degrees(2 * std::atan(0.1)));
    scene.ambient_light = Color(1.0f);
    scene.gravity = gravity;
    scene.cameras[0].time_start = begin;
    scene.cameras[0].shutter.duration = seconds;
    return scene;
}

void add_ball(SceneDesc& scene, const Start& s, const Contact& c, const Material& material = glow("", Color(1.0f))) {
    add(scene, "ball", sphere(s.position, c.radius), material);
    PhysicsDesc& physics = scene.bodies.back().physics.emplace();
    physics.velocity = s.velocity;
    physics.angular_velocity_degrees = s.spin * degrees(1.0);
    physics.restitution = c.restitution;
    physics.friction = c.friction;
}

void add_floor(SceneDesc& scene, const Contact& c) {
    add(scene, "floor", Plane{}, glow("", Color(0.0f)));
    PhysicsDesc& physics = scene.bodies.back().physics.emplace();
    physics.kind = PhysicsDesc::Kind::fixed;
    physics.friction = c.friction;
}

/// One half of the ball white, the other black.
Material half_white(SceneDesc& scene) {
    constexpr int width = 16, height = 2;
    // Tests run side by side: each writes its own.
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    const std::string path = testing::TempDir() + "/half_white_" + test->name() + ".ppm";
    std::filesystem::create_directories(std::filesystem::path(path).parent_path());
    std::ofstream file(path, std::ios::binary);
    file << "P6\n" << width << ' ' << height << "\n255\n";
    for (int i = 0; i < width * height; ++i)
        for (int channel = 0; channel < 3; ++channel) file << char(i % width < width / 2 ? 255 : 0);
    scene.textures = {Texture{"half white", path, Texture::ColorSpace::linear}};
    Material m = glow("", Color(1.0f));
    m.texture = "half white";
    return m;
}

/// drt's picture of the baked scene. The floor is taken out before: it would hide what is below it.
PictureEstimate baked_picture(const SceneDesc& scene) {
    for (const Diagnostic& d : validate(scene))
        if (d.severity == Severity::error) ADD_FAILURE() << to_string(d);
    const Camera& camera = scene.cameras[0];
    SceneDesc baked = bake(scene, *camera.time_start + *camera.shutter.duration).scene;
    baked.bodies.resize(1);
    return estimate_scene(baked, {}, 32);
}

/// A picture and what it must and must not agree with.
class Blur {
public:
    /// `tolerance`: of a block's mean, for what the texture filter blurs and the exact picture does not.
    explicit Blur(const SceneDesc& scene, double tolerance = 1e-7) : scene_(scene), picture_(baked_picture(scene)) {
        scene_.bodies.resize(1);
        options_.absolute_tolerance = tolerance;
    }

    const PictureEstimate& picture() const { return picture_; }

    void expect(const Course& course) const {
        const CompareResult result = compare_with(scene_, course);
        EXPECT_TRUE(result.same) << result.report;
    }
    void expect_not(const std::string& fault, const Course& course) const {
        const CompareResult result = compare_with(scene_, course);
        EXPECT_FALSE(result.same) << fault << ": " << result.report;
    }
    /// A shutter that is open 5 % longer.
    void expect_not_longer(const Course& course) const {
        SceneDesc longer = scene_;
        *longer.cameras[0].shutter.duration *= 1.05;
        const CompareResult result = compare_with(longer, course);
        EXPECT_FALSE(result.same) << "longer shutter: " << result.report;
    }

private:
    CompareResult compare_with(const SceneDesc& scene, const Course& course) const {
        return compare_pictures(picture_, time_average(scene, course, 64, /*seed=*/1), options_);
    }

    SceneDesc scene_;
    PictureEstimate picture_;
    CompareOptions options_;
};

constexpr double texture_tolerance = 1.5e-3;

TEST(PhysicsBlur, OfAFlight) {
    const Start start{{-0.68, -0.4, 0}, {3.4, 2.4, 1}, {}};
    SceneDesc scene = exposed(0, 0.4, earth);
    add_ball(scene, start, {});
    const Blur blur(scene);
    blur.expect(flight(start, earth));
    blur.expect_not_longer(flight(start, earth));
    blur.expect_not("5 % less gravity", flight(start, earth * 0.95));
    blur.expect_not("no gravity", flight(start, weightless));
}

TEST(PhysicsBlur, OfABounce) {
    const Start start{{-0.6, 0.75, 0}, {4, -3, 0}, {}};
    const Contact contact;
    SceneDesc scene = exposed(0, 0.3, earth);
    add_ball(scene, start, contact);
    add_floor(scene, contact);
    const Blur blur(scene);
    blur.expect(bounce(start, earth, contact));
    blur.expect_not_longer(bounce(start, earth, contact));
    blur.expect_not("5 ms late", bounce(start, earth, contact, 5e-3));
    blur.expect_not("through the floor", flight(start, earth));
    blur.expect_not("restitution 0.7", bounce(start, earth, {.restitution = 0.7}));

    // The eye is at the floor's height, so what is below the picture's middle would be in the floor.
    const PictureEstimate& picture = blur.picture();
    double above = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const double value = picture.mean[picture.index(x, y)].r;
            if (y < picture.height / 2)
                above += value;
            else
                ASSERT_EQ(value, 0) << x << ' ' << y;
        }
    EXPECT_GT(above, 0);
}

/// Spins this often while the shutter is open, and drifts, so that whole turns show.
void expect_spin(double turns) {
    constexpr double seconds = 0.4;
    const Contact contact{.radius = 0.5};
    const Vec3d axis = normalize(Vec3d{0.3, 1, 0.4}), drift{1.2, 0, 0};
    const auto start = [&](double n) { return Start{{-0.3, 0, 0}, drift, axis * (2 * pi<double> * n / seconds)}; };
    SceneDesc scene = exposed(0, seconds, weightless);
    add_ball(scene, start(turns), contact, half_white(scene));
    const Blur blur(scene, texture_tolerance);
    blur.expect(flight(start(turns), weightless));
    blur.expect_not_longer(flight(start(turns), weightless));
    blur.expect_not("10 % less", flight(start(0.9 * turns), weightless));
    blur.expect_not("backwards", flight(start(-turns), weightless));
    if (turns < 3)  // five turns and four are much the same smear
        blur.expect_not("a turn less", flight(start(turns - 1), weightless));
    blur.expect_not("the short way", flight(start(turns - std::ceil(turns - 0.499)), weightless));
}

TEST(PhysicsBlur, OfHalfATurn) { expect_spin(0.5); }
TEST(PhysicsBlur, OfMoreThanATurn) { expect_spin(1.4); }
TEST(PhysicsBlur, OfFiveTurns) { expect_spin(5); }

// Friction takes a fifth of the spin and throws the ball back.
TEST(PhysicsBlur, OfASpinningBounce) {
    const Start start{{-0.3, 0.75, 0}, {4, -3, 0}, {0, 0, 80}};
    const Contact contact{.friction = 0.2};
    SceneDesc scene = exposed(0, 0.3, earth);
    add_ball(scene, start, contact, half_white(scene));
    add_floor(scene, contact);
    const Blur blur(scene, texture_tolerance);
    blur.expect(bounce(start, earth, contact));
    blur.expect_not_longer(bounce(start, earth, contact));
    blur.expect_not("5 ms late", bounce(start, earth, contact, 5e-3));

    const double time = time_of_bounce(start, earth, contact);
    Start slower = start, after = rebound(start, earth, contact);
    slower.spin = start.spin * 0.9;
    blur.expect_not("10 % less spin before", turning_point(slower, earth, time, after));
    after.spin = after.spin * 0.9;
    blur.expect_not("10 % less spin after", turning_point(start, earth, time, after));
    after.spin = start.spin;
    blur.expect_not("all its spin after", turning_point(start, earth, time, after));
}

}  // namespace
}  // namespace drt
