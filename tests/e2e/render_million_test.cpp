// A million balls in a sphere_set: the real program renders them in under 1 GB, in float and in double.
#include <random>

#include "render_programs.h"

namespace drt {
namespace {

// "x y z radius" lines: 0.01 .. 0.05 wide balls in a cube of 20.
std::string million_balls() {
    std::mt19937 random(1);
    const auto number = [&](unsigned range, double scale, double offset) {
        return std::to_string(double(random() % range) * scale + offset) + ' ';
    };
    std::string text;
    for (int i = 0; i < 1000000; ++i) {
        for (int axis = 0; axis < 3; ++axis) text += number(200000, 1e-4, -10);
        text += number(4000, 1e-5, 0.01) + '\n';
    }
    return text;
}

const std::string scene = R"(drt: 1
render: {width: 64, height: 48, spp: 4}
materials: [{name: grey, diffuse: 0.7}]
bodies: [{type: sphere_set, file: balls.txt, material: grey}]
lights: [{type: rectangle, corner: [-5, 20, 10], edge_x: [10, 0, 0], edge_y: [0, 0, 10], color: 10}]
cameras: [{position: [0, 5, 45]}]
)";

class MillionBalls : public testing::TestWithParam<const char*> {};

TEST_P(MillionBalls, RenderInUnderAGigabyte) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "sanitizers have memory needs of their own";
#endif
    const TempFolder folder;
    folder.write("balls.txt", million_balls());
    const ProcessResult r =
        render({folder.write("scene.yaml", scene), "-o", folder.file("out.exr"), "--precision", GetParam()});
    ASSERT_EQ(r.exit_code, 0) << r.err;
    RecordProperty("peak_megabytes", std::to_string(r.peak_megabytes));
    EXPECT_GT(r.peak_megabytes, 50);  // it was measured
    EXPECT_LT(r.peak_megabytes, 1000);
    const Image picture = read_image_raw(folder.file("out.exr"));
    EXPECT_GT(picture.pixel(32, 24)[3], 0.9f);  // the cube is dense: hardly a ray passes its middle
    EXPECT_EQ(picture.pixel(0, 0)[3], 0.0f);
}

INSTANTIATE_TEST_SUITE_P(Precision, MillionBalls, testing::Values("single", "double"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace drt
