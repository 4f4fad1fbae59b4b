// Textures are filtered by the pixel filter, and by nothing else once there are many samples; with few, they do not
// alias more than as many samples of any kind do.

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <functional>

#include "drt/base/constants.h"
#include "drt/image/image.h"
#include "pictures/scene_kit.h"
#include "support/render_picture.h"

namespace drt {
namespace {

constexpr int width = 64, height = 8;
constexpr double unit = 4;  ///< pixels, at the wall

/// One period of 1/2 + 1/2 sin over 64 texels.
std::string sine_texture() {
    Image image(64, 1, 3);
    for (int x = 0; x < 64; ++x)
        std::fill_n(image.pixel(x, 0), 3, float(0.5 + 0.5 * std::sin(2 * pi<double> * (x + 0.5) / 64)));
    const std::string path = ::testing::TempDir() + "sine.exr";
    write_image(path, image);
    return path;
}

/// A wall ten units before the camera, with vertical stripes.
SceneDesc stripes(double period_in_pixels, const Filter& filter) {
    SceneDesc scene = simple_scene({0, 0, 10}, {0, 0, 0}, 2 * std::atan(width / unit / 20) * 180 / pi<double>);
    scene.render.width = width;
    scene.render.height = height;
    scene.render.filter = filter;
    scene.ambient_light = Color(1.0f);
    scene.textures = {Texture{"sine", sine_texture(), Texture::ColorSpace::linear}};
    Material wall = glow("", Color(1.0f));
    wall.texture = "sine";
    wall.scale_u = wall.scale_v = period_in_pixels / unit;
    add(scene, "wall", Rectangle{{-32, 32, 0}, {32, 32, 0}, {-32, -32, 0}}, wall);
    return scene;
}

/// The same, seen in a mirror: also ten units away.
SceneDesc mirrored_stripes(double period_in_pixels, const Filter& filter) {
    SceneDesc scene = stripes(period_in_pixels, filter);
    scene.render.max_depth = 1;
    scene.cameras.front().positions = {{0, 0, -2}};
    scene.cameras.front().targets = {{0, 0, -6}};
    add(scene, "mirror", Rectangle{{-32, 32, -6}, {32, 32, -6}, {-32, -32, -6}}, mirror(1));
    return scene;
}

Image picture(const SceneDesc& scene, int spp) {
    RenderOptions options;
    options.spp = spp;
    return resolve(render_scene(scene, {}, options).film);
}

/// Amplitude of the stripes in the picture.
double contrast(const Image& image, double period_in_pixels) {
    std::complex<double> sum;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            sum += double(image.pixel(x, y)[0]) * std::polar(1.0, 2 * pi<double> * (x + 0.5) / period_in_pixels);
    return 2 * std::abs(sum) / (width * height);
}

double rms_from_grey(const Image& image) {
    double sum = 0;
    for (int i = 0; i < width * height; ++i) {
        const double error = double(image.data[size_t(i * image.channels)]) - 0.5;
        sum += error * error;
    }
    return std::sqrt(sum / (width * height));
}

const Filter box{Filter::Kind::box, 0.5}, blackman_harris{Filter::Kind::blackman_harris, 1.5},
    point{Filter::Kind::point};

/// How much of a sine a filter leaves: the ratio of two integrals.
double transfer(const Filter& filter, double period) {
    const auto value = [&](double x) {
        if (filter.kind == Filter::Kind::box) return 1.0;
        const double t = pi<double> * (x / filter.radius + 1);
        return 0.35875 - 0.48829 * std::cos(t) + 0.14128 * std::cos(2 * t) - 0.01168 * std::cos(3 * t);
    };
    constexpr int steps = 10000;
    double sum = 0, all = 0;
    for (int i = 0; i < steps; ++i) {
        const double x = ((i + 0.5) / steps * 2 - 1) * filter.radius;
        sum += value(x) * std::cos(2 * pi<double> * x / period), all += value(x);
    }
    return sum / all;
}

TEST(TextureFootprint, ContrastConvergesToThatOfThePixelFilter) {
    EXPECT_NEAR(0.5 * transfer(box, 4), 0.450, 0.0005);
    EXPECT_NEAR(0.5 * transfer(blackman_harris, 4), 0.403, 0.0005);
    for (const Filter& filter : {box, blackman_harris})
        for (const double period : {4.0, 8.0}) {
            const double truth = 0.5 * transfer(filter, period);
            const Image direct = picture(stripes(period, filter), 1024);
            EXPECT_NEAR(contrast(direct, period), truth, 0.0015) << "period " << period;
        }
}

TEST(TextureFootprint, ConvergesInMirrorsToo) {
    EXPECT_NEAR(contrast(picture(mirrored_stripes(4, box), 1024), 4), 0.5 * transfer(box, 4), 0.0015);
}

TEST(TextureFootprint, StripesTooFineForThePictureDoNotAlias) {
    // Samples whose footprints are wider than the period see the mean, the others are random: at n samples at most
    // sqrt(n - m) / n of a sample's deviation, where m ~ 1 / period^2 have wide ones. That is largest at n = 2 m.
    const double deviation = std::sqrt(0.125);
    for (const Filter& filter : {box, blackman_harris})
        for (const double period : {0.23, 0.37, 0.71})
            for (const int spp : {1, 2, 4, 8, 16, 64}) {
                const double error = rms_from_grey(picture(stripes(period, filter), spp));
                EXPECT_LT(error, deviation * period / 2) << "period " << period << ", " << spp << " spp";
            }
}

TEST(TextureFootprint, APointSampledPixelKeepsItsWholeFootprint) {
    EXPECT_EQ(picture(stripes(0.37, point), 1).data, picture(stripes(0.37, point), 16).data);
    EXPECT_LT(rms_from_grey(picture(stripes(0.37, point), 16)), 0.04);
}

TEST(TextureFootprint, DoesNotDependOnHowManySamplesThereWillBe) {
    const SceneDesc scene = stripes(4, blackman_harris);
    RenderOptions options;
    options.spp = 32;
    std::vector<Image> on_the_way;
    RenderEvents events;
    events.pass_done = [&](const Film& film, const Progress& p) {
        if (p.spp_done == 8) on_the_way.push_back(resolve(film));
    };
    render(compile(scene, {}), options, events);
    ASSERT_EQ(on_the_way.size(), 1u);
    EXPECT_EQ(on_the_way.front().data, picture(scene, 8).data);
}

TEST(TextureFootprint, BothReplicatesSeeTheSameFootprints) {
    const Film film = [&] {
        RenderOptions options;
        options.spp = 2;
        return render_scene(stripes(16, box), {}, options).film;
    }();
    EXPECT_NEAR(contrast(resolve(film, 0), 16), contrast(resolve(film, 1), 16), 0.01);
}

}  // namespace
}  // namespace drt
