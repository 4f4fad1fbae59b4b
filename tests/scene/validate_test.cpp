// Every fault that validate() knows, as one change to a scene that is fine, with the whole message it must give.
#include <cmath>

#include "scene/validate_cases.h"

namespace drt {
namespace {

class Validate : public testing::TestWithParam<Case> {};

TEST_P(Validate, SaysWhatIsWrongAndWhere) {
    SceneDesc scene = valid_scene();
    GetParam().change(scene);
    EXPECT_EQ(texts(validate_with_places(scene, GetParam().messages)), GetParam().messages);
}

Sphere& ball(SceneDesc& s) { return std::get<Sphere>(s.bodies[0].shape); }
RectLight& sun(SceneDesc& s) { return std::get<RectLight>(s.lights[0].shape); }

const std::vector<Case> render_cases{
    {"fine", [](SceneDesc&) {}, {}},
    {"zero_width",
     [](SceneDesc& s) { s.render.width = 0; },
     {"render.width: error: width is out of range \"0\"; expected an integer >= 1 and <= 65536"}},
    {"million_squared",
     [](SceneDesc& s) { s.render.width = s.render.height = 1000000; },
     {"render.width: error: width is out of range \"1000000\"; expected an integer >= 1 and <= 65536",
      "render.height: error: height is out of range \"1000000\"; expected an integer >= 1 and <= 65536"}},
    {"too_many_pixels",
     [](SceneDesc& s) { s.render.width = s.render.height = 20000; },
     {"render.width: error: too many pixels \"20000 x 20000\"; expected at most 2^28 = 268435456 in all"}},
    {"largest_picture", [](SceneDesc& s) { s.render.width = 65536, s.render.height = 4096; }, {}},
    {"fps",
     [](SceneDesc& s) { s.render.fps = 0; },
     {"render.fps: error: fps is out of range \"0\"; expected a number > 0"}},
    {"spp",
     [](SceneDesc& s) { s.render.spp = 0; },
     {"render.spp: error: spp is out of range \"0\"; expected an integer >= 1 and <= 16777216"}},
    {"depth",
     [](SceneDesc& s) { s.render.max_depth = -1; },
     {"render.max_depth: error: max_depth is out of range \"-1\"; expected an integer >= 0 and <= 10000"}},
    {"deep",
     [](SceneDesc& s) { s.render.max_depth = 10001; },
     {"render.max_depth: error: max_depth is out of range \"10001\"; expected an integer >= 0 and <= 10000"}},
    {"filter",
     [](SceneDesc& s) {
         s.render.filter = {Filter::Kind::gaussian, 0, -1};
     },
     {"render.filter.radius: error: radius is out of range \"0\"; expected a number > 0 and <= 32",
      "render.filter.sigma: error: sigma is out of range \"-1\"; expected a number > 0 and <= 32"}},
    {"globals",
     [](SceneDesc& s) {
         s.ambient_light = Color{-1.0f};
         s.background = Color{0, float(nan), 0};
         s.units = 0;
         s.gravity = {0, -inf, 0};
     },
     {"ambient_light: error: ambient_light is out of range \"-1\"; expected a colour of numbers >= 0",
      "background: error: background is not finite \"[0, nan, 0]\"; expected a colour of numbers >= 0",
      "units: error: units is out of range \"0\"; expected a number > 0",
      "gravity: error: gravity is not finite \"[0, -inf, 0]\"; expected three numbers"}},
};

const std::vector<Case> material_cases{
    {"texture_without_name",
     [](SceneDesc& s) {
         s.textures.push_back({"", "a.png", {}});
     },
     {"textures[1].name: error: name is empty; expected a name"}},
    {"texture_without_file",
     [](SceneDesc& s) { s.textures[0].file = ""; },
     {"textures[0].file: error: file is empty; expected a file"}},
    {"same_texture_twice",
     [](SceneDesc& s) { s.textures.push_back(s.textures[0]); },
     {"textures[1].name: error: duplicate name of a texture \"wood\"; expected another name; it was first used at "
      "scene"}},
    {"latin_name",
     [](SceneDesc& s) { s.cameras[0].name = "cam\xe9ra"; },
     {"cameras[0].name: error: name is not UTF-8 text"}},
    {"negative_colour",
     [](SceneDesc& s) {
         s.materials[0].diffuse = {0.5f, -0.25f, 0};
     },
     {"materials[0].diffuse: error: diffuse is out of range \"[0.5, -0.25, 0]\"; expected a colour of numbers >= 0"}},
    {"nan_colour",
     [](SceneDesc& s) {
         s.materials[0].specular = Color{float(nan), 0, 0};
     },
     {"materials[0].specular: error: specular is not finite \"[nan, 0, 0]\"; expected a colour of numbers >= 0"}},
    {"black", [](SceneDesc& s) { s.materials[0].diffuse = Color{0.0f}; }, {}},
    {"white", [](SceneDesc& s) { s.materials[0].diffuse = Color{1.0f}; }, {}},
    {"more_than_white",
     [](SceneDesc& s) {
         s.materials[0].diffuse = {1.5f, 0, 0};
     },
     {"materials[0].diffuse: warning: diffuse gives out more light than comes in \"[1.5, 0, 0]\"; expected components "
      "of at most 1"}},
    {"scalars",
     [](SceneDesc& s) {
         Material& m = s.materials[0];
         m.shininess = m.reflectance = m.reflection_spread_degrees = m.refraction = m.refraction_spread_degrees = -1;
         m.refraction_index = m.scale_u = m.scale_v = 0;
     },
     {"materials[0].shininess: error: shininess is out of range \"-1\"; expected a number >= 0",
      "materials[0].reflectance: error: reflectance is out of range \"-1\"; expected a number >= 0",
      "materials[0].reflection_spread_degrees: error: reflection_spread_degrees is out of range \"-1\"; expected a "
      "number >= 0",
      "materials[0].refraction: error: refraction is out of range \"-1\"; expected a number >= 0",
      "materials[0].refraction_spread_degrees: error: refraction_spread_degrees is out of range \"-1\"; expected a "
      "number >= 0",
      "materials[0].refraction_index: error: refraction_index is out of range \"0\"; expected a number > 0",
      "materials[0].scale_u: error: scale_u is out of range \"0\"; expected a number > 0",
      "materials[0].scale_v: error: scale_v is out of range \"0\"; expected a number > 0"}},
    {"energy",
     [](SceneDesc& s) { s.materials[0].reflectance = s.materials[0].refraction = 0.75; },
     {"materials[0].reflectance: warning: reflectance + refraction gives out more light than comes in \"1.5\"; "
      "expected at most 1"}},
    {"unknown_texture",
     [](SceneDesc& s) { s.materials[1].texture = "wod"; },
     {"materials[1].texture: error: unknown texture \"wod\"; expected the name of a texture; did you mean \"wood\"?"}},
    {"no_textures",
     [](SceneDesc& s) { s.textures.clear(); },
     {"materials[1].texture: error: unknown texture \"wood\"; expected a texture of this scene, which has none"}},
    {"same_material_twice",
     [](SceneDesc& s) { s.materials[1].name = "red", s.bodies[1].material = "red"; },
     {"materials[1].name: error: duplicate name of a material \"red\"; expected another name; it was first used at "
      "scene"}},
};

const std::vector<Case> body_cases{
    {"no_bodies",
     [](SceneDesc& s) { s.bodies.clear(); },
     {"bodies: warning: the scene has no bodies: every pixel shows the background"}},
    {"two_without_name", [](SceneDesc& s) { s.bodies[0].name = s.bodies[1].name = ""; }, {}},
    {"same_name",
     [](SceneDesc& s) { s.bodies[1].name = "ball"; },
     {"bodies[1].name: error: duplicate name of a body \"ball\"; expected another name; it was first used at scene"}},
    {"unknown_material",
     [](SceneDesc& s) { s.bodies[0].material = "rde"; },
     {"bodies[0].material: error: unknown material \"rde\"; expected the name of a material; did you mean \"red\"?"}},
    {"no_material",
     [](SceneDesc& s) { s.bodies[0].material = ""; },
     {"bodies[0].material: error: body without a material; expected the name of a material"}},
    {"radius_zero",
     [](SceneDesc& s) { ball(s).radius = 0; },
     {"bodies[0].radius: error: radius is out of range \"0\"; expected a number > 0"}},
    {"radius_negative",
     [](SceneDesc& s) { ball(s).radius = -1; },
     {"bodies[0].radius: error: radius is out of range \"-1\"; expected a number > 0"}},
    {"radius_nan",
     [](SceneDesc& s) { ball(s).radius = nan; },
     {"bodies[0].radius: error: radius is not finite \"nan\"; expected a number > 0"}},
    {"radius_huge",
     [](SceneDesc& s) { ball(s).radius = 2e15; },
     {"bodies[0].radius: error: radius is too large \"2e+15\"; expected a number of at most 1e15 in size"}},
    {"center_far",
     [](SceneDesc& s) {
         ball(s).center = {0, -1.5e15, 0};
     },
     {"bodies[0].center: error: center is too large \"[0, -1.5e+15, 0]\"; expected three numbers of at most 1e15 in "
      "size"}},
    {"center_at_the_limit",
     [](SceneDesc& s) {
         ball(s).center = {0, -1e15, 0};
     },
     {}},
    {"pole_zero",
     [](SceneDesc& s) { ball(s).pole = {}; },
     {"bodies[0].pole: error: pole has no length \"[0, 0, 0]\"; expected a vector that is not zero"}},
    {"meridian_at_pole",
     [](SceneDesc& s) {
         ball(s).meridian = {0, -3, 0};
     },
     {"bodies[0].meridian: error: meridian is parallel to pole \"[0, -3, 0]\"; expected a direction away from the "
      "axis [0, 1, 0]"}},
    {"plane_normal",
     [](SceneDesc& s) {
         s.bodies[1].shape = Plane{{}, {}};
     },
     {"bodies[1].normal: error: normal has no length \"[0, 0, 0]\"; expected a vector that is not zero"}},
    {"triangle_line",
     [](SceneDesc& s) {
         s.bodies[0].shape = Triangle{{0, 0, 0}, {1, 1, 1}, {3, 3, 3}};
     },
     {"bodies[0]: error: triangle without area; expected three points that are not on one line"}},
    {"triangle_point",
     [](SceneDesc& s) {
         s.bodies[0].shape = Triangle{{1, 1, 1}, {1, 1, 1}, {3, 0, 3}};
     },
     {"bodies[0]: error: triangle without area; expected three points that are not on one line"}},
    {"triangle_nan",
     [](SceneDesc& s) {
         s.bodies[0].shape = Triangle{{0, nan, 0}, {1, 0, 0}, {0, 1, 0}};
     },
     {"bodies[0].vertex0: error: vertex0 is not finite \"[0, nan, 0]\"; expected three numbers"}},
    {"triangle_thin",
     [](SceneDesc& s) {
         s.bodies[0].shape = Triangle{{}, {1e6, 0, 0}, {0, 1e-4, 0}};
     },
     {}},
    {"rectangle_line",
     [](SceneDesc& s) {
         s.bodies[0].shape = Rectangle{{}, {1, 0, 0}, {-2, 0, 0}};
     },
     {"bodies[0]: error: rectangle without area; expected three points that are not on one line"}},
    {"parallelogram_line",
     [](SceneDesc& s) {
         s.bodies[0].shape = Parallelogram{{}, {1, 0, 0}, {-2, 0, 0}};
     },
     {"bodies[0].edge1: error: parallelogram without area \"[-2, 0, 0]\"; expected an edge that is not parallel to "
      "edge0 [1, 0, 0]"}},
    {"parallelogram_edge",
     [](SceneDesc& s) {
         s.bodies[0].shape = Parallelogram{{}, {}, {1, 0, 0}};
     },
     {"bodies[0].edge0: error: edge0 has no length \"[0, 0, 0]\"; expected a vector that is not zero"}},
    {"box_flat",
     [](SceneDesc& s) {
         s.bodies[0].shape = Box{{}, {1, 0, 1}, {}};
     },
     {"bodies[0].size: error: size is out of range \"[1, 0, 1]\"; expected three numbers > 0"}},
    {"box_orientation",
     [](SceneDesc& s) {
         s.bodies[0].shape = Box{{}, {1, 1, 1}, {0, 0, 0, 0}};
     },
     {"bodies[0].orientation: error: orientation has no length \"[0, 0, 0, 0]\"; expected a quaternion that is not "
      "zero"}},
    {"box_needle",
     [](SceneDesc& s) {
         s.bodies[0].shape = Box{{}, {1, 1e-6, 1e6}, {}};
     },
     {}},
    {"cylinder_short",
     [](SceneDesc& s) {
         s.bodies[0].shape = Cylinder{{1, 2, 3}, {1, 2, 3}, 1, true};
     },
     {"bodies[0].to: error: cylinder without length \"[1, 2, 3]\"; expected a point away from its other end"}},
    {"cylinder_radius",
     [](SceneDesc& s) {
         s.bodies[0].shape = Cylinder{{}, {0, 1, 0}, 0, true};
     },
     {"bodies[0].radius: error: radius is out of range \"0\"; expected a number > 0"}},
    {"disc",
     [](SceneDesc& s) {
         s.bodies[0].shape = Disc{{}, {}, 0};
     },
     {"bodies[0].normal: error: normal has no length \"[0, 0, 0]\"; expected a vector that is not zero",
      "bodies[0].radius: error: radius is out of range \"0\"; expected a number > 0"}},
    {"textured_disc",
     [](SceneDesc& s) { s.bodies[1].shape = Disc{}; },
     {"bodies[1].material: error: a disc cannot carry the texture of its material \"planks\"; expected a material "
      "without texture; textures go on plane, rectangle, parallelogram, box, sphere and cylinder"}},
    {"textured_triangle",
     [](SceneDesc& s) { s.bodies[1].shape = Triangle{}; },
     {"bodies[1].material: error: a triangle cannot carry the texture of its material \"planks\"; expected a material "
      "without texture; textures go on plane, rectangle, parallelogram, box, sphere and cylinder"}},
    {"textured_set",
     [](SceneDesc& s) { s.bodies[1].shape = SphereSet{"balls.txt"}; },
     {"bodies[1].material: error: a sphere_set cannot carry the texture of its material \"planks\"; expected a "
      "material without texture; textures go on plane, rectangle, parallelogram, box, sphere and cylinder"}},
    {"set_without_file",
     [](SceneDesc& s) { s.bodies[0].shape = SphereSet{}; },
     {"bodies[0].file: error: file is empty; expected a file"}},
    {"set_moving",
     [](SceneDesc& s) { s.bodies[0].shape = SphereSet{"balls.txt"}, s.bodies[0].motion = two_keys(); },
     {"bodies[0].motion: error: a sphere_set cannot move; expected single spheres"}},
};

const std::vector<Case> motion_cases{
    {"motion", [](SceneDesc& s) { s.bodies[0].motion = two_keys(); }, {}},
    {"no_keys",
     [](SceneDesc& s) { s.bodies[0].motion.emplace(); },
     {"bodies[0].motion.keys: error: motion without keys; expected at least one"}},
    {"same_time",
     [](SceneDesc& s) { s.bodies[0].motion = two_keys(), s.bodies[0].motion->keys[1].time = 0; },
     {"bodies[0].motion.keys[1].time: error: key times do not ascend \"0\"; expected more than the previous key's 0"}},
    {"nan_time",
     [](SceneDesc& s) { s.cameras[0].motion = two_keys(), s.cameras[0].motion->keys[0].position.x = inf; },
     {"cameras[0].motion.keys[0].position: error: position is not finite \"[inf, 0, 0]\"; expected three numbers"}},
    {"turn_in_first_key",
     [](SceneDesc& s) { s.bodies[0].motion = two_keys(), s.bodies[0].motion->keys[0].turn.emplace(); },
     {"bodies[0].motion.keys[0].turn: error: the first key has no previous one to turn from; expected orientation in "
      "place of turn"}},
    {"turn_axis",
     [](SceneDesc& s) {
         s.bodies[0].motion = two_keys(), s.bodies[0].motion->keys[1].turn = Turn{{}, 10};
     },
     {"bodies[0].motion.keys[1].turn.axis: error: axis has no length \"[0, 0, 0]\"; expected a vector that is not "
      "zero"}},
    {"turn_and_orientation",
     [](SceneDesc& s) {
         s.bodies[0].motion = two_keys();
         s.bodies[0].motion->keys[1].turn.emplace();
         s.bodies[0].motion->keys[1].orientation = Quatd{};  // even the implicit one
     },
     {"bodies[0].motion.keys[1].turn: error: turn beside orientation; expected one of the two"}},
    {"orientation_zero",
     [](SceneDesc& s) {
         s.bodies[0].motion = two_keys(), s.bodies[0].motion->keys[1].orientation = Quatd{0, 0, 0, 0};
     },
     {"bodies[0].motion.keys[1].orientation: error: orientation has no length \"[0, 0, 0, 0]\"; expected a quaternion "
      "that is not zero"}},
};

const std::vector<Case> light_cases{
    {"black_light", [](SceneDesc& s) { s.lights[0].color = Color{0.0f}; }, {}},
    {"negative_light",
     [](SceneDesc& s) {
         s.lights[0].color = {1, 1, -1};
     },
     {"lights[0].color: error: color is out of range \"[1, 1, -1]\"; expected a colour of numbers >= 0"}},
    {"no_lights",
     [](SceneDesc& s) { s.lights.clear(); },
     {"lights: warning: the scene has no lights and no ambient_light: bodies will be black"}},
    {"ambient_only", [](SceneDesc& s) { s.lights.clear(), s.ambient_light = Color{0.1f}; }, {}},
    {"same_light_twice",
     [](SceneDesc& s) { s.lights.push_back(s.lights[0]); },
     {"lights[1].name: error: duplicate name of a light \"sun\"; expected another name; it was first used at scene"}},
    {"zero_edge",
     [](SceneDesc& s) { sun(s).edge_x = {}; },
     {"lights[0].edge_x: error: edge_x has no length \"[0, 0, 0]\"; expected a vector that is not zero"}},
    {"parallel_edges",
     [](SceneDesc& s) {
         sun(s).edge_y = {-2, 0, 0};
     },
     {"lights[0].edge_y: error: light without area \"[-2, 0, 0]\"; expected an edge that is not parallel to edge_x "
      "[1, 0, 0]"}},
    {"sphere_light",
     [](SceneDesc& s) {
         s.lights[0].shape = SphereLight{{}, 0, {}};
     },
     {"lights[0].radius: error: radius is out of range \"0\"; expected a number > 0"}},
    {"visible_point",
     [](SceneDesc& s) { s.lights[0].shape = PointLight{}; },
     {"lights[0].visible: error: a point light cannot be seen \"true\"; expected false, or a small light of type "
      "sphere"}},
    {"visible_without_falloff",
     [](SceneDesc& s) { s.lights[0].falloff = Light::Falloff::none; },
     {"lights[0].visible: error: a light with falloff none has no radiance to be seen \"true\"; expected false, or "
      "falloff: inverse_square"}},
    {"two_sided_without_falloff",
     [](SceneDesc& s) {
         s.lights[0].falloff = Light::Falloff::none, s.lights[0].visible = false, sun(s).two_sided = true;
     },
     {"lights[0].two_sided: warning: two_sided has no effect with falloff none"}},
    {"nan_light",
     [](SceneDesc& s) {
         s.lights[0].shape = PointLight{{nan, 0, 0}}, s.lights[0].visible = false;
     },
     {"lights[0].position: error: position is not finite \"[nan, 0, 0]\"; expected three numbers"}},
};

const std::vector<Case> camera_cases{
    {"no_camera",
     [](SceneDesc& s) { s.cameras.clear(); },
     {"cameras: error: the scene has no camera; expected at least one"}},
    {"no_position",
     [](SceneDesc& s) { s.cameras[0].positions.clear(), s.cameras[0].targets.clear(); },
     {"cameras[0].positions: error: no positions; expected at least one",
      "cameras[0].targets: error: no targets; expected at least one"}},
    {"nan_target",
     [](SceneDesc& s) { s.cameras[0].targets[0].y = nan; },
     {"cameras[0].targets[0]: error: targets is not finite \"[0, nan, 0]\"; expected three numbers"}},
    {"fov_zero",
     [](SceneDesc& s) { s.cameras[0].fov_degrees_start = 0; },
     {"cameras[0].fov_degrees.start: error: fov_degrees is out of range \"0\"; expected a number > 0 and < 180"}},
    {"fov_half_turn",
     [](SceneDesc& s) { s.cameras[0].fov_degrees_start = 180; },
     {"cameras[0].fov_degrees.start: error: fov_degrees is out of range \"180\"; expected a number > 0 and < 180"}},
    {"fov_negative_end",
     [](SceneDesc& s) { s.cameras[0].fov_degrees_end = -10, s.cameras[0].video_end = 1; },
     {"cameras[0].fov_degrees.end: error: fov_degrees is out of range \"-10\"; expected a number > 0 and < 180"}},
    {"fov_extremes", [](SceneDesc& s) { s.cameras[0].fov_degrees_start = 179.9; }, {}},
    {"up_zero",
     [](SceneDesc& s) { s.cameras[0].up_start = {}; },
     {"cameras[0].up.start: error: up has no length \"[0, 0, 0]\"; expected a vector that is not zero"}},
    {"up_parallel",
     [](SceneDesc& s) {
         s.cameras[0].positions[0] = {0, 7, 0};
     },
     {"cameras[0].up: error: up is parallel to the view \"[0, 1, 0]\"; expected a direction away from the view "
      "[0, -7, 0], for example [0, 0, 1]"}},
    {"up_parallel_at_the_end",
     [](SceneDesc& s) {
         s.cameras[0].up_end = Vec3d{0, 0, 2}, s.cameras[0].video_end = 1;
     },
     {"cameras[0].up: error: up is parallel to the view at the end \"[0, 0, 2]\"; expected a direction away from the "
      "view [0, 0, -5], for example [0, 1, 0]"}},
    {"target_is_position",
     [](SceneDesc& s) {
         s.cameras[0].targets[0] = {0, 0, 5};
     },
     {"cameras[0].targets: error: the camera's target is its position \"[0, 0, 5]\"; expected a point away from the "
      "eye [0, 0, 5]"}},
    {"target_reached_at_the_end",
     [](SceneDesc& s) {
         s.cameras[0].positions.push_back({0, 0, 0}), s.cameras[0].video_end = 1;
     },
     {"cameras[0].targets: error: the camera's target is its position at the end \"[0, 0, 0]\"; expected a point away "
      "from the eye [0, 0, 0]"}},
    {"curve_for_ever",
     [](SceneDesc& s) {
         s.cameras[0].positions.push_back({0, 0, 9});
         s.cameras[0].targets.push_back({1, 0, 0});
     },
     {"cameras[0].positions: error: several positions need a video_end; expected video_end, the time at which the "
      "curve ends",
      "cameras[0].targets: error: several targets need a video_end; expected video_end, the time at which the curve "
      "ends"}},
    {"ends_for_ever",
     [](SceneDesc& s) {
         Camera& c = s.cameras[0];
         c.up_end = Vec3d{0, 1, 1}, c.fov_degrees_end = 50, c.lens.focus_end = 3, c.time_end = 3;
         c.video_end_inclusive = true;
     },
     {"cameras[0].up.end: warning: has no effect without a video_end",
      "cameras[0].fov_degrees.end: warning: has no effect without a video_end",
      "cameras[0].lens.focus_distance.end: warning: has no effect without a video_end",
      "cameras[0].time_end: warning: has no effect without a video_end",
      "cameras[0].video_end_inclusive: warning: has no effect without a video_end"}},
    {"zoom_without_end",
     [](SceneDesc& s) { s.cameras[0].zoom = Camera::Zoom::focal_length; },
     {"cameras[0].zoom: warning: has no effect without an end of fov_degrees"}},
    {"zoom",
     [](SceneDesc& s) {
         s.cameras[0].zoom = Camera::Zoom::image_width, s.cameras[0].fov_degrees_end = 30, s.cameras[0].video_end = 1;
     },
     {}},
    {"opposite_ups",
     [](SceneDesc& s) {
         s.cameras[0].up_end = Vec3d{0, -3, 0}, s.cameras[0].video_end = 1;
     },
     {"cameras[0].up.end: warning: up is the opposite of its start: the picture turns over at once \"[0, -3, 0]\"; "
      "expected a direction that says which way round it turns"}},
    {"up_parallel_at_the_end_of_a_motion",
     [](SceneDesc& s) {
         s.cameras[0].up_end = Vec3d{0, 0, 2}, s.cameras[0].video_end = 1, s.cameras[0].motion = two_keys();
     },
     {"cameras[0].up.end: error: up is parallel to the view at the end \"[0, 0, 2]\"; expected a direction away from "
      "the view [0, 0, -5], for example [0, 1, 0]"}},
    {"no_frame",
     [](SceneDesc& s) { s.cameras[0].video_start = 0.01, s.cameras[0].video_end = 0.04; },
     {"cameras[0].video_end: warning: no frame lies in the camera's video \"0.04\"; expected a longer one: at fps 25 "
      "frames are 0.04 s apart"}},
    {"a_frame_at_an_inclusive_end",
     [](SceneDesc& s) {
         s.cameras[0].video_start = 0.01, s.cameras[0].video_end = 0.04, s.cameras[0].video_end_inclusive = true;
     },
     {}},
    {"backward_video",
     [](SceneDesc& s) { s.cameras[0].video_start = 2, s.cameras[0].video_end = 2; },
     {"cameras[0].video_end: error: the camera's video ends before it starts \"2\"; expected more than video_start "
      "2"}},
    {"backward_time", [](SceneDesc& s) { s.cameras[0].video_end = 2, s.cameras[0].time_end = -5; }, {}},
    {"lens",
     [](SceneDesc& s) {
         s.cameras[0].lens = {-1, 0, -1, {}, {}};
     },
     {"cameras[0].lens.aperture_radius: error: aperture_radius is out of range \"-1\"; expected a number >= 0",
      "cameras[0].lens.focus_distance.start: error: focus_distance is out of range \"0\"; expected a number > 0",
      "cameras[0].lens.focus_distance.end: error: focus_distance is out of range \"-1\"; expected a number > 0"}},
    {"shutter",
     [](SceneDesc& s) {
         s.cameras[0].shutter = {-1, 1.5};
     },
     {"cameras[0].shutter.duration: error: duration is out of range \"-1\"; expected a number >= 0",
      "cameras[0].shutter.switch_ratio: error: switch_ratio is out of range \"1.5\"; expected a number >= 0 and <= "
      "1"}},
    {"motion_and_curve",
     [](SceneDesc& s) {
         s.cameras[0].positions.push_back({0, 0, 9}), s.cameras[0].targets.push_back({0, 1, 0});
         s.cameras[0].video_end = 1, s.cameras[0].motion = two_keys();
     },
     {"cameras[0].positions: warning: motion replaces the positions after the first",
      "cameras[0].targets: warning: motion replaces the targets after the first"}},
    {"overlap",
     [](SceneDesc& s) {
         s.cameras.push_back(s.cameras[0]);
         s.cameras[1].name = "other", s.cameras[1].video_start = 3;
     },
     {"cameras[1].video_start: warning: 'other' and 'main' record at the same time; 'main' comes first and does"}},
    {"touching",
     [](SceneDesc& s) {
         s.cameras.push_back(s.cameras[0]);
         s.cameras[0].video_end = 3;
         s.cameras[1].name = "other", s.cameras[1].video_start = 3;
         s.cameras[0].video_end_inclusive = true;
     },
     {}},
    {"touching_but_for_rounding",
     [](SceneDesc& s) {
         s.render.fps = 10;
         s.cameras.push_back(s.cameras[0]);
         s.cameras[0].video_end = 0.1 + 0.2;
         s.cameras[1].name = "other", s.cameras[1].video_start = 0.3;
     },
     {}},
};

// Checks of how values go together look at their own values only: other faults of the object do not hide what they
// find, and what is wrong or could not be read is not told a second time.
const std::vector<Case> together_cases{
    {"picture_and_rate",
     [](SceneDesc& s) { s.render.fps = 0, s.render.width = s.render.height = 20000; },
     {"render.fps: error: fps is out of range \"0\"; expected a number > 0",
      "render.width: error: too many pixels \"20000 x 20000\"; expected at most 2^28 = 268435456 in all"}},
    {"ball_and_name",
     [](SceneDesc& s) { s.bodies[0].name = "b\xe9", ball(s).radius = -1, ball(s).meridian = ball(s).pole; },
     {"bodies[0].name: error: name is not UTF-8 text",
      "bodies[0].radius: error: radius is out of range \"-1\"; expected a number > 0",
      "bodies[0].meridian: error: meridian is parallel to pole \"[0, 1, 0]\"; expected a direction away from the "
      "axis [0, 1, 0]"}},
    {"cylinder_without_radius",
     [](SceneDesc& s) {
         s.bodies[0].shape = Cylinder{{1, 2, 3}, {1, 2, 3}, 0, true};
     },
     {"bodies[0].radius: error: radius is out of range \"0\"; expected a number > 0",
      "bodies[0].to: error: cylinder without length \"[1, 2, 3]\"; expected a point away from its other end"}},
    {"light_and_colour",
     [](SceneDesc& s) {
         s.lights[0].color = Color{-1.0f}, sun(s).edge_y = {-2, 0, 0}, s.lights[0].falloff = Light::Falloff::none;
     },
     {"lights[0].color: error: color is out of range \"-1\"; expected a colour of numbers >= 0",
      "lights[0].edge_y: error: light without area \"[-2, 0, 0]\"; expected an edge that is not parallel to edge_x "
      "[1, 0, 0]",
      "lights[0].visible: error: a light with falloff none has no radiance to be seen \"true\"; expected false, or "
      "falloff: inverse_square"}},
    {"camera_and_angle",
     [](SceneDesc& s) {
         Camera& c = s.cameras[0];
         c.targets[0] = c.positions[0], c.fov_degrees_start = 200, c.up_start = {}, c.video_end = -1;
     },
     {"cameras[0].up.start: error: up has no length \"[0, 0, 0]\"; expected a vector that is not zero",
      "cameras[0].fov_degrees.start: error: fov_degrees is out of range \"200\"; expected a number > 0 and < 180",
      "cameras[0].targets: error: the camera's target is its position \"[0, 0, 5]\"; expected a point away from the "
      "eye [0, 0, 5]",
      "cameras[0].video_end: error: the camera's video ends before it starts \"-1\"; expected more than video_start "
      "0"}},
    {"first_view_and_last_point",
     [](SceneDesc& s) {
         Camera& c = s.cameras[0];
         c.positions.push_back({0, nan, 0}), c.targets[0] = c.positions[0], c.video_end = 1;
     },
     {"cameras[0].positions[1]: error: positions is not finite \"[0, nan, 0]\"; expected three numbers",
      "cameras[0].targets: error: the camera's target is its position \"[0, 0, 5]\"; expected a point away from the "
      "eye [0, 0, 5]"}},
    {"infinite_position",
     [](SceneDesc& s) { s.cameras[0].positions[0].x = inf; },
     {"cameras[0].positions[0]: error: positions is not finite \"[inf, 0, 5]\"; expected three numbers"}},
    {"unread_position",
     [](SceneDesc& s) { s.cameras[0].targets = s.cameras[0].positions, s.sources.unread = {"cameras[0].positions"}; },
     {}},
    {"unread_end",
     [](SceneDesc& s) {
         s.cameras[0].positions.push_back({0, 0, 9}), s.sources.unread = {"cameras[0].video_end"};
     },
     {}},
    {"unread_targets",
     [](SceneDesc& s) { s.cameras[0].targets.clear(), s.sources.unread = {"cameras[0].targets"}; },
     {}},
    {"unread_pole",
     [](SceneDesc& s) {
         ball(s).meridian = ball(s).pole, s.sources.unread = {"bodies[0].pole", "bodies[1].normal"};
     },
     {}},
    {"key_without_time",
     [](SceneDesc& s) { s.bodies[0].motion = two_keys(), s.bodies[0].motion->keys[0].time = nan; },
     {"bodies[0].motion.keys[0].time: error: time is not finite \"nan\"; expected a number"}},
};

INSTANTIATE_TEST_SUITE_P(Render, Validate, testing::ValuesIn(render_cases), case_name);
INSTANTIATE_TEST_SUITE_P(Materials, Validate, testing::ValuesIn(material_cases), case_name);
INSTANTIATE_TEST_SUITE_P(Bodies, Validate, testing::ValuesIn(body_cases), case_name);
INSTANTIATE_TEST_SUITE_P(Motion, Validate, testing::ValuesIn(motion_cases), case_name);
INSTANTIATE_TEST_SUITE_P(Lights, Validate, testing::ValuesIn(light_cases), case_name);
INSTANTIATE_TEST_SUITE_P(Cameras, Validate, testing::ValuesIn(camera_cases), case_name);
INSTANTIATE_TEST_SUITE_P(Together, Validate, testing::ValuesIn(together_cases), case_name);

TEST(ValidateTogether, ReportsEveryFaultOfAScene) {
    SceneDesc scene = valid_scene();
    scene.render.spp = 0;
    ball(scene).radius = -1;
    scene.lights[0].color = Color{-1.0f};
    scene.cameras.clear();
    EXPECT_EQ(validate(scene).size(), 4u);
}

TEST(ValidateTogether, IsCheapForManyBodies) {
    SceneDesc scene = valid_scene();
    scene.bodies.assign(1000000, {"", Sphere{}, "red", {}, {}});
    EXPECT_TRUE(validate(scene).empty());
}

}  // namespace
}  // namespace drt
