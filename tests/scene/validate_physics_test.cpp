// What validate() knows of physics, as validate_test.cpp does of the rest.
#include "drt/base/constants.h"
#include "drt/scene/mass.h"
#include "scene/validate_cases.h"

namespace drt {
namespace {

using Kind = PhysicsDesc::Kind;

class ValidatePhysics : public testing::TestWithParam<Case> {};

TEST_P(ValidatePhysics, SaysWhatIsWrongAndWhere) {
    SceneDesc scene = valid_scene();
    GetParam().change(scene);
    EXPECT_EQ(texts(validate_with_places(scene, GetParam().messages)), GetParam().messages);
}

// The first body in the simulation; the second is an infinite plane.
PhysicsDesc& falling(SceneDesc& s, const Shape& shape = Sphere{}, Kind kind = Kind::dynamic) {
    s.bodies[0].shape = shape;
    PhysicsDesc& physics = s.bodies[0].physics.emplace();
    physics.kind = kind;
    return physics;
}

const std::vector<Case> kind_cases{
    {"sphere", [](SceneDesc& s) { falling(s); }, {}},
    {"box", [](SceneDesc& s) { falling(s, Box{}); }, {}},
    {"cylinder", [](SceneDesc& s) { falling(s, Cylinder{}); }, {}},
    {"tube",
     [](SceneDesc& s) {
         falling(s, Cylinder{{}, {0, 1, 0}, 1, false});
     },
     {}},
    {"static_plane", [](SceneDesc& s) { s.bodies[1].physics.emplace().kind = Kind::fixed; }, {}},
    {"static_triangle", [](SceneDesc& s) { falling(s, Triangle{}, Kind::fixed); }, {}},
    {"kinematic_disc", [](SceneDesc& s) { falling(s, Disc{}, Kind::kinematic), s.bodies[0].motion = two_keys(); }, {}},
    {"set_falling",
     [](SceneDesc& s) { falling(s, SphereSet{"balls.txt"}); },
     {"bodies[0].physics: error: a sphere_set cannot take part in the simulation; expected single spheres"}},
    {"set_in_the_way",
     [](SceneDesc& s) { falling(s, SphereSet{"balls.txt"}, Kind::fixed); },
     {"bodies[0].physics: error: a sphere_set cannot take part in the simulation; expected single spheres"}},
    {"plane_falling",
     [](SceneDesc& s) { s.bodies[1].physics.emplace(); },
     {"bodies[1].physics.kind: error: an infinite plane cannot move \"dynamic\"; expected static"}},
    {"plane_led",
     [](SceneDesc& s) { s.bodies[1].physics.emplace().kind = Kind::kinematic, s.bodies[1].motion = two_keys(); },
     {"bodies[1].physics.kind: error: an infinite plane cannot move \"kinematic\"; expected static"}},
    {"triangle_falling",
     [](SceneDesc& s) { falling(s, Triangle{}); },
     {"bodies[0].physics.kind: error: a triangle cannot be dynamic, for it has no volume \"dynamic\"; expected static "
      "or kinematic; or a shape that has one: sphere, box, cylinder"}},
    {"rectangle_falling",
     [](SceneDesc& s) { falling(s, Rectangle{}); },
     {"bodies[0].physics.kind: error: a rectangle cannot be dynamic, for it has no volume \"dynamic\"; expected static "
      "or kinematic; or a shape that has one: sphere, box, cylinder"}},
    {"parallelogram_falling",
     [](SceneDesc& s) { falling(s, Parallelogram{}); },
     {"bodies[0].physics.kind: error: a parallelogram cannot be dynamic, for it has no volume \"dynamic\"; expected "
      "static or kinematic; or a shape that has one: sphere, box, cylinder"}},
    {"disc_falling",
     [](SceneDesc& s) { falling(s, Disc{}); },
     {"bodies[0].physics.kind: error: a disc cannot be dynamic, for it has no volume \"dynamic\"; expected static or "
      "kinematic; or a shape that has one: sphere, box, cylinder"}},
    {"dynamic_with_motion",
     [](SceneDesc& s) { falling(s), s.bodies[0].motion = two_keys(); },
     {"bodies[0].motion: error: a dynamic body cannot have a motion: its motion is what is simulated; expected no "
      "motion, or kind: kinematic"}},
    {"static_with_motion",
     [](SceneDesc& s) { falling(s, Box{}, Kind::fixed), s.bodies[0].motion = two_keys(); },
     {"bodies[0].motion: error: a static body cannot have a motion; expected no motion, or kind: kinematic"}},
    {"kinematic_without_motion",
     [](SceneDesc& s) { falling(s, Box{}, Kind::kinematic); },
     {"bodies[0].physics.kind: warning: a kinematic body without motion stands still \"kinematic\"; expected motion, "
      "or kind: static"}},
    {"static_with_everything",
     [](SceneDesc& s) {
         PhysicsDesc& p = falling(s, Box{}, Kind::fixed);
         p.mass = p.density = 1;
         p.velocity = p.angular_velocity_degrees = {0, 0, 1};
         p.impulses.resize(1);
         p.forces.resize(1);
         p.friction = p.rolling_friction = p.restitution = 1;  // these count
     },
     {"bodies[0].physics.mass: warning: mass without effect on a static body",
      "bodies[0].physics.density: warning: density without effect on a static body",
      "bodies[0].physics.velocity: warning: velocity without effect on a static body",
      "bodies[0].physics.angular_velocity_degrees: warning: angular_velocity_degrees without effect on a static body",
      "bodies[0].physics.impulses: warning: impulses without effect on a static body",
      "bodies[0].physics.forces: warning: forces without effect on a static body"}},
    {"kinematic_with_impulse",
     [](SceneDesc& s) {
         falling(s, Box{}, Kind::kinematic).impulses.resize(1);
         s.bodies[0].motion = two_keys();
     },
     {"bodies[0].physics.impulses: warning: impulses without effect on a kinematic body"}},
};

const std::vector<Case> value_cases{
    {"weightless",
     [](SceneDesc& s) { falling(s).density = 0; },
     {"bodies[0].physics.density: error: density is out of range \"0\"; expected a number > 0"}},
    {"negative_mass",
     [](SceneDesc& s) { falling(s).mass = -2; },
     {"bodies[0].physics.mass: error: mass is out of range \"-2\"; expected a number > 0"}},
    {"huge_mass",
     [](SceneDesc& s) { falling(s).mass = 1e300; },
     {"bodies[0].physics.mass: error: mass is too large \"1e+300\"; expected a number of at most 1e15 in size"}},
    {"infinite_density",
     [](SceneDesc& s) { falling(s).density = inf; },
     {"bodies[0].physics.density: error: density is not finite \"inf\"; expected a number > 0"}},
    {"surface",
     [](SceneDesc& s) {
         PhysicsDesc& p = falling(s);
         p.friction = p.rolling_friction = p.restitution = -0.5;
     },
     {"bodies[0].physics.friction: error: friction is out of range \"-0.5\"; expected a number >= 0",
      "bodies[0].physics.rolling_friction: error: rolling_friction is out of range \"-0.5\"; expected a number >= 0",
      "bodies[0].physics.restitution: error: restitution is out of range \"-0.5\"; expected a number >= 0 and <= 1"}},
    {"restitution",
     [](SceneDesc& s) { falling(s).restitution = 1.25; },
     {"bodies[0].physics.restitution: error: restitution is out of range \"1.25\"; expected a number >= 0 and <= 1"}},
    {"nan",
     [](SceneDesc& s) {
         PhysicsDesc& p = falling(s);
         p.friction = p.restitution = nan;
         p.velocity = {0, nan, 0};
         p.angular_velocity_degrees = {inf, 0, 0};
         p.impulses = {{nan, {inf, 0, 0}, Vec3d{0, 0, nan}}};
         p.forces = {{0, nan, {1, 2, -inf}}};
     },
     {"bodies[0].physics.friction: error: friction is not finite \"nan\"; expected a number >= 0",
      "bodies[0].physics.restitution: error: restitution is not finite \"nan\"; expected a number >= 0 and <= 1",
      "bodies[0].physics.velocity: error: velocity is not finite \"[0, nan, 0]\"; expected three numbers",
      "bodies[0].physics.angular_velocity_degrees: error: angular_velocity_degrees is not finite \"[inf, 0, 0]\"; "
      "expected three numbers",
      "bodies[0].physics.impulses[0].time: error: time is not finite \"nan\"; expected a number",
      "bodies[0].physics.impulses[0].impulse: error: impulse is not finite \"[inf, 0, 0]\"; expected three numbers",
      "bodies[0].physics.impulses[0].at: error: at is not finite \"[0, 0, nan]\"; expected three numbers",
      "bodies[0].physics.forces[0].until: error: until is not finite \"nan\"; expected a number",
      "bodies[0].physics.forces[0].force: error: force is not finite \"[1, 2, -inf]\"; expected three numbers"}},
    {"simulation",
     [](SceneDesc& s) {
         s.simulation = {nan, 1, 0, -1};
     },
     {"simulation.start: error: start is not finite \"nan\"; expected a number >= -1e+06 and <= 1e+06",
      "simulation.tolerance: error: tolerance is out of range \"0\"; expected a number > 0",
      "simulation.tolerance_pixels: error: tolerance_pixels is out of range \"-1\"; expected a number > 0"}},
    {"simulation_as_late_as_can_be", [](SceneDesc& s) { s.simulation.start = -1e6, s.simulation.end = 1e6; }, {}},
    {"simulation_too_late",
     [](SceneDesc& s) { s.simulation.start = -1.1e6, s.simulation.end = 1e300; },
     {"simulation.start: error: start is out of range \"-1100000\"; expected a number >= -1e+06 and <= 1e+06",
      "simulation.end: error: end is out of range \"1e+300\"; expected a number >= -1e+06 and <= 1e+06"}},
    {"simulation_without_time",
     [](SceneDesc& s) { s.simulation.start = 2, s.simulation.end = 2; },
     {"simulation.end: error: the simulation ends before it starts \"2\"; expected more than start 2"}},
};

const std::vector<Case> event_cases{
    {"in_time",
     [](SceneDesc& s) {
         s.simulation.end = 1;
         falling(s).impulses = {{0, {1, 0, 0}, {}}, {0.999, {1, 0, 0}, Vec3d{0, 1, 0}}};
         s.bodies[0].physics->forces = {{-1, 0.5, {1, 0, 0}}, {0.5, 2, {1, 0, 0}}};
     },
     {}},
    {"endless",
     [](SceneDesc& s) {
         falling(s).impulses = {{1e9, {1, 0, 0}, {}}};
     },
     {}},
    {"early_and_late",
     [](SceneDesc& s) {
         s.simulation.start = 1, s.simulation.end = 3;
         falling(s).impulses = {{0.5, {1, 0, 0}, {}}, {3, {1, 0, 0}, {}}};
         s.bodies[0].physics->forces = {{0, 1, {1, 0, 0}}, {3, 4, {1, 0, 0}}};
     },
     {"bodies[0].physics.impulses[0].time: warning: the impulse has no effect \"0.5\"; expected a time within the "
      "simulation, which starts at 1 and ends at 3",
      "bodies[0].physics.impulses[1].time: warning: the impulse has no effect \"3\"; expected a time within the "
      "simulation, which starts at 1 and ends at 3",
      "bodies[0].physics.forces[0]: warning: the force has no effect \"0 to 1\"; expected a time within the "
      "simulation, which starts at 1 and ends at 3",
      "bodies[0].physics.forces[1]: warning: the force has no effect \"3 to 4\"; expected a time within the "
      "simulation, which starts at 1 and ends at 3"}},
    {"early_in_an_endless_one",
     [](SceneDesc& s) {
         falling(s).impulses = {{-1, {1, 0, 0}, {}}};
     },
     {"bodies[0].physics.impulses[0].time: warning: the impulse has no effect \"-1\"; expected a time within the "
      "simulation, which starts at 0"}},
    {"force_backwards",
     [](SceneDesc& s) {
         falling(s).forces = {{2, 1, {1, 0, 0}}, {2, 2, {1, 0, 0}}};
     },
     {"bodies[0].physics.forces[0].until: error: the force ends before it begins \"1\"; expected more than from 2",
      "bodies[0].physics.forces[1].until: error: the force ends before it begins \"2\"; expected more than from 2"}},
};

// Two dynamic boxes of the given masses.
void weigh(SceneDesc& s, double a, double b) {
    falling(s, Box{}).mass = a;
    s.bodies[1] = {"brick", Box{}, "red", {}, PhysicsDesc{}};
    s.bodies[1].physics->mass = b;
}

const std::vector<Case> mass_cases{
    {"mass_and_density",
     [](SceneDesc& s) { falling(s).mass = 2, s.bodies[0].physics->density = 3; },
     {"bodies[0].physics.density: error: density beside mass \"3\"; expected one of the two"}},
    {"dust",
     [](SceneDesc& s) {
         falling(s, Sphere{{}, 1e-12, {0, 1, 0}, {0, 0, 1}});
     },
     {"bodies[0].physics.density: error: the body's mass cannot be reckoned with \"4.189e-36\"; expected "
      "a size and density that make a mass from 1e-30 to 1e30"}},
    {"vanishing",
     [](SceneDesc& s) {
         falling(s, Box{{}, {1e-120, 1e-120, 1e-120}, {}});
     },
     {"bodies[0].physics.density: error: the body's mass cannot be reckoned with \"0\"; expected a size and density "
      "that make a mass from 1e-30 to 1e30"}},
    {"galaxy",
     [](SceneDesc& s) {
         falling(s, Box{{}, {1e14, 1e14, 1e14}, {}}).density = 1e3;
     },
     {"bodies[0].physics.density: error: the body's mass cannot be reckoned with \"1e+45\"; expected a size and "
      "density that make a mass from 1e-30 to 1e30"}},
    {"heavy_point",
     [](SceneDesc& s) {
         falling(s, Sphere{{}, 1e-40, {0, 1, 0}, {0, 0, 1}}).mass = 1;
     },
     {"bodies[0].physics.mass: error: the body's inertia, mass * size^2, cannot be reckoned with \"4e-81\"; expected a "
      "size and mass that make it 1e-60 to 1e60"}},
    {"bad_radius_only",
     [](SceneDesc& s) {
         falling(s, Sphere{{}, 0, {0, 1, 0}, {0, 0, 1}}).mass = 1;
     },
     {"bodies[0].radius: error: radius is out of range \"0\"; expected a number > 0"}},
    {"a_hundred_thousand_to_one", [](SceneDesc& s) { weigh(s, 1e5, 1); }, {}},
    {"more_than_a_hundred_thousand_to_one",
     [](SceneDesc& s) { weigh(s, 0.5, 50001); },
     {"bodies[1].physics: warning: 'brick' has very much more mass than 'ball', the lightest dynamic body \"5e+04 to "
      "0.5\"; expected at most 100000 to 1, which is what contacts were measured to hold"}},
    {"unnamed_masses",
     [](SceneDesc& s) { weigh(s, 3e5, 2), s.bodies[0].name = s.bodies[1].name = ""; },
     {"bodies[0].physics: warning: body 1 has very much more mass than body 2, the lightest dynamic body \"3e+05 to "
      "2\"; expected at most 100000 to 1, which is what contacts were measured to hold"}},
    {"static_masses_do_not_count",
     [](SceneDesc& s) {
         weigh(s, 5e5, 1);
         s.bodies[0].physics = PhysicsDesc{};
         s.bodies[0].physics->kind = Kind::fixed;
     },
     {}},
};

INSTANTIATE_TEST_SUITE_P(Kinds, ValidatePhysics, testing::ValuesIn(kind_cases), case_name);
INSTANTIATE_TEST_SUITE_P(Values, ValidatePhysics, testing::ValuesIn(value_cases), case_name);
INSTANTIATE_TEST_SUITE_P(Events, ValidatePhysics, testing::ValuesIn(event_cases), case_name);
INSTANTIATE_TEST_SUITE_P(Masses, ValidatePhysics, testing::ValuesIn(mass_cases), case_name);

void expect_near(const Vec3d& got, const Vec3d& want) {
    for (int axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(component(got, axis), component(want, axis), 1e-12 * component(want, axis));
}

TEST(MassProperties, OfEveryShapeThatHasThem) {
    PhysicsDesc dense;
    dense.density = 3;
    const auto ball = mass_properties(Sphere{{5, 6, 7}, 2, {0, 1, 0}, {0, 0, 1}}, dense);
    EXPECT_NEAR(ball->mass, 32 * pi<double>, 1e-12);
    expect_near(ball->inertia, Vec3d{1, 1, 1} * (0.4 * 32 * pi<double> * 4));
    const auto box = mass_properties(Box{{}, {2, 3, 4}, {0, 1, 0, 0}}, dense);
    EXPECT_NEAR(box->mass, 72, 1e-12);
    expect_near(box->inertia, {6 * (9 + 16), 6 * (4 + 16), 6 * (4 + 9)});
    const auto rod = mass_properties(Cylinder{{1, 0, 0}, {1, 3, 4}, 2, false}, dense);
    EXPECT_NEAR(rod->mass, 60 * pi<double>, 1e-12);
    expect_near(rod->inertia, Vec3d{1 + 25 / 12.0, 1 + 25 / 12.0, 2} * (60 * pi<double>));
    PhysicsDesc heavy;
    heavy.mass = 7;
    EXPECT_EQ(mass_properties(Sphere{}, heavy)->mass, 7);
    expect_near(mass_properties(Sphere{}, heavy)->inertia, Vec3d{2.8, 2.8, 2.8});
    for (const Shape& flat : {Shape(Plane{}), Shape(Triangle{}), Shape(Rectangle{}), Shape(Parallelogram{}),
                              Shape(Disc{}), Shape(SphereSet{})})
        EXPECT_FALSE(mass_properties(flat, dense));
}

TEST(Gravity, IsTheEarthsInTheScenesUnits) {
    SceneDesc scene;
    EXPECT_EQ(gravity_of(scene), (Vec3d{0, -9.81, 0}));
    scene.units = 100;
    EXPECT_EQ(gravity_of(scene), (Vec3d{0, -9.81 * 100, 0}));
    scene.gravity = {1, 2, 3};
    EXPECT_EQ(gravity_of(scene), (Vec3d{1, 2, 3}));
}

}  // namespace
}  // namespace drt
