#include <gtest/gtest.h>

#include "drt/formats/formats.h"
#include "drt/scene/scene_fields.h"
#include "formats/random_scene.h"
#include "formats/temporary_files.h"

namespace drt {
namespace {

// Writes to a file of the working directory, so that relative files come back as they went.
class LocalFile {
public:
    explicit LocalFile(const std::string& text) { std::ofstream(path(), std::ios::binary) << text; }
    ~LocalFile() { std::filesystem::remove(path()); }
    static std::string path() {
        return std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + ".yaml";
    }
};

SceneDesc read_back(const SceneDesc& scene) {
    const LocalFile file(write_yaml_scene(scene, ""));
    return read_yaml_scene(file.path()).scene;
}

TEST(YamlRoundTrip, SmallestScene) {
    SceneDesc scene;
    scene.cameras.resize(1);
    EXPECT_EQ(write_yaml_scene(scene, ""), "drt: 1\n\ncameras:\n  - {}\n");
    EXPECT_EQ(read_back(scene), scene);
}

TEST(YamlRoundTrip, LooksAsAPersonWouldWriteIt) {
    SceneDesc scene;
    scene.render.width = 320;
    scene.render.filter = {Filter::Kind::gaussian, 2, 0.5};
    scene.ambient_light = Color{0.12f};
    scene.materials.resize(1);
    scene.materials[0].name = "red paint";
    scene.materials[0].diffuse = {0.8f, 0.1f, 0.1f};
    Motion motion{Motion::Interpolation::cubic, {{0, {1, 2, 3}, {}, {}}, {1, {4, 5, 6}, {}, Turn{{0, 1, 0}, 350}}}};
    scene.bodies = {{"ball", Sphere{{1, 2, 3}, 0.5, {0, 1, 0}, {0, 0, 1}}, "red paint", motion, {}}};
    scene.lights = {{"", PointLight{{0, 9, 0}}, Color{10.0f}, {}, false}};
    scene.lights[0].falloff = Light::Falloff::inverse_square;
    scene.cameras.resize(1);
    scene.cameras[0].positions = {{0, 1, 9}, {0, 2, 9}};
    scene.cameras[0].fov_degrees_start = 40;
    scene.cameras[0].fov_degrees_end = 20;
    scene.cameras[0].lens.focus_start = 8;
    scene.cameras[0].video_end = 4;
    EXPECT_EQ(write_yaml_scene(scene, "", "one\n\ntwo\x07 \xe9"),
              "# one\n"
              "#\n"
              "# two? ?\n"
              "drt: 1\n"
              "\n"
              "render:\n"
              "  width: 320\n"
              "  filter:\n"
              "    kind: gaussian\n"
              "    radius: 2\n"
              "ambient_light: 0.12\n"
              "\n"
              "materials:\n"
              "  - name: \"red paint\"\n"
              "    diffuse: [0.8, 0.1, 0.1]\n"
              "\n"
              "bodies:\n"
              "  - name: ball\n"
              "    type: sphere\n"
              "    center: [1, 2, 3]\n"
              "    radius: 0.5\n"
              "    material: \"red paint\"\n"
              "    motion:\n"
              "      interpolation: cubic\n"
              "      keys:\n"
              "        - {time: 0, position: [1, 2, 3]}\n"
              "        - {time: 1, position: [4, 5, 6], turn: {degrees: 350}}\n"
              "\n"
              "lights:\n"
              "  - type: point\n"
              "    position: [0, 9, 0]\n"
              "    color: 10\n"
              "\n"
              "cameras:\n"
              "  - positions:\n"
              "      - [0, 1, 9]\n"
              "      - [0, 2, 9]\n"
              "    fov_degrees: {start: 40, end: 20}\n"
              "    lens:\n"
              "      focus_distance: 8\n"
              "    video_end: 4\n");
    EXPECT_EQ(read_back(scene), scene);
}

TEST(YamlRoundTrip, EveryShapeAndLightAtItsDefaults) {
    SceneDesc scene;
    scene.materials.resize(1);
    scene.materials[0].name = "m";
    for_each_alternative<Shape>([&]<class A>() { scene.bodies.push_back({"", A{}, "m", {}, {}}); });
    std::get<SphereSet>(scene.bodies.back().shape).file = "balls.txt";
    for_each_alternative<LightShape>([&]<class A>() {
        scene.lights.emplace_back();
        scene.lights.back().shape = A{};
    });
    scene.cameras.resize(1);
    scene.bodies[0].physics.emplace().kind = PhysicsDesc::Kind::fixed;
    scene.bodies[1].physics.emplace();  // there, with nothing but defaults
    scene.cameras[0].motion = Motion{{}, {MotionKey{}}};
    EXPECT_EQ(read_back(scene), scene);
}

TEST(YamlRoundTrip, PhysicsLooksAsAPersonWouldWriteIt) {
    SceneDesc scene;
    scene.units = 100;
    scene.gravity = {0, -981, 0};
    scene.simulation.end = 2.5;
    scene.simulation.tolerance = 0.01;
    scene.materials.resize(1);
    scene.materials[0].name = "m";
    scene.bodies = {{"ball", Sphere{}, "m", {}, PhysicsDesc{}}, {"table", Box{}, "m", {}, PhysicsDesc{}}};
    PhysicsDesc& ball = *scene.bodies[0].physics;
    ball.mass = 170;
    ball.restitution = 0.9;
    ball.angular_velocity_degrees = {0, 0, -720};
    ball.impulses = {{0.1, {5, 0, 0}, {}}, {0.2, {0, 0, 1}, Vec3d{0, 0.5, 0}}};
    ball.forces = {{1, 1.5, {0, 3, 0}}};
    scene.bodies[1].physics->kind = PhysicsDesc::Kind::fixed;
    scene.cameras.resize(1);
    EXPECT_EQ(write_yaml_scene(scene, ""),
              "drt: 1\n"
              "units: 100\n"
              "gravity: [0, -981, 0]\n"
              "\n"
              "simulation:\n"
              "  end: 2.5\n"
              "  tolerance: 0.01\n"
              "\n"
              "materials:\n"
              "  - name: m\n"
              "\n"
              "bodies:\n"
              "  - name: ball\n"
              "    type: sphere\n"
              "    material: m\n"
              "    physics:\n"
              "      mass: 170\n"
              "      restitution: 0.9\n"
              "      angular_velocity_degrees: [0, 0, -720]\n"
              "      impulses:\n"
              "        - {time: 0.1, impulse: [5, 0, 0]}\n"
              "        - {time: 0.2, impulse: [0, 0, 1], at: [0, 0.5, 0]}\n"
              "      forces:\n"
              "        - {from: 1, until: 1.5, force: [0, 3, 0]}\n"
              "  - name: table\n"
              "    type: box\n"
              "    material: m\n"
              "    physics:\n"
              "      kind: static\n"
              "\n"
              "cameras:\n"
              "  - {}\n");
    EXPECT_EQ(read_back(scene), scene);
}

TEST(YamlRoundTrip, RandomScenesWithEveryFieldOnAndOff) {
    for (std::uint32_t seed = 0; seed < 400; ++seed) {
        const SceneDesc scene = random_scene(seed);
        const std::string text = write_yaml_scene(scene, "");
        try {
            ASSERT_EQ(read_back(scene), scene) << "seed " << seed << '\n' << text;
            ASSERT_EQ(write_yaml_scene(read_back(scene), ""), text) << "seed " << seed;
        } catch (const Error& e) {
            FAIL() << "seed " << seed << '\n' << e.what() << '\n' << text;
        }
    }
}

TEST(YamlRoundTrip, FilesAreRelativeToTheScene) {
    const TemporaryFiles files;
    SceneDesc scene;
    scene.textures = {{"below", files.path("textures/a.png"), {}}, {"outside", "/somewhere/else/b.png", {}}};
    scene.cameras.resize(1);
    const std::string text = write_yaml_scene(scene, files.folder());
    EXPECT_NE(text.find("file: textures/a.png\n"), std::string::npos) << text;
    EXPECT_NE(text.find("file: \"/somewhere/else/b.png\"\n"), std::string::npos) << text;
    EXPECT_EQ(read_yaml_scene(files.write("scene.yaml", text)).scene, scene);
    scene.textures = {{"beside", "textures/c.png", {}}, {"here", "scenes/d.png", {}}};
    const std::string local = write_yaml_scene(scene, "scenes");
    EXPECT_NE(local.find("file: \"../textures/c.png\"\n"), std::string::npos) << local;
    EXPECT_NE(local.find("file: d.png\n"), std::string::npos) << local;
}

TEST(YamlRoundTrip, ManyBodiesInReasonableTime) {
    SceneDesc scene;
    scene.materials.resize(1);
    scene.materials[0].name = "m";
    scene.cameras.resize(1);
    for (int i = 0; i < 10000; ++i) scene.bodies.push_back({"", Sphere{{0.1 * i, 1, 2}, 0.05, {}, {}}, "m", {}, {}});
    for (Body& b : scene.bodies)
        std::get<Sphere>(b.shape).pole = {0, 1, 0}, std::get<Sphere>(b.shape).meridian = {0, 0, 1};
    EXPECT_EQ(read_back(scene), scene);
}

}  // namespace
}  // namespace drt
