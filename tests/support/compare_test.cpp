// compare_pictures lets noise pass and catches the faults it must catch, on synthetic pictures.

#include "support/compare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace drt {
namespace {

constexpr int width = 64, height = 48;

/// A picture with a gradient, a soft highlight of relative width `lobe`, and edges shifted by `shift` pixels.
Rgb truth(int x, int y, double light, double lobe, double shift) {
    const double r2 = (x - 40.0) * (x - 40) + (y - 20.0) * (y - 20);
    const double highlight = std::exp(-r2 / (2 * 36 * lobe * lobe)) / (lobe * lobe);
    const double coverage = std::clamp(x + 1.0 - (20.3 + 0.2 * y) - shift, 0.0, 1.0);
    const double base = (0.2 + 0.004 * x) * coverage + 0.05 + 0.4 * highlight;
    return Rgb{base, 0.7 * base, 0.3 * base} * light;
}

Image noisy(std::mt19937_64& random, double noise, double light = 1, double lobe = 1, double shift = 0) {
    Image image(width, height, 3);
    std::normal_distribution<double> normal;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const double factor = 1 + noise * normal(random);  // channels are noisy together, as under white light
            const Rgb color = truth(x, y, light, lobe, shift) * factor;
            float* pixel = image.pixel(x, y);
            pixel[0] = float(color.r), pixel[1] = float(color.g), pixel[2] = float(color.b);
        }
    }
    return image;
}

PictureEstimate estimate(std::mt19937_64& random, double noise, double light = 1, double lobe = 1, double shift = 0) {
    const Image a = noisy(random, noise, light, lobe, shift), b = noisy(random, noise, light, lobe, shift);
    return estimate_from_replicates({a, b});
}

/// Relative, of each replicate: about what one pixel of a soft shadow has at 64 stratified samples.
constexpr double pixel_noise = 0.02;

TEST(ComparePictures, NoisePasses) {
    std::mt19937_64 random(1);
    for (int i = 0; i < 300; ++i) {
        const CompareResult result = compare_pictures(estimate(random, pixel_noise), estimate(random, pixel_noise));
        EXPECT_TRUE(result.same) << result.report;
    }
}

// At alpha = 20 % the verdict must err about that often: neither blind nor jumpy. Channels are fully correlated
// here, so that the three channels ask one question and the rate lies between alpha / 3 and alpha.
TEST(ComparePictures, FalseAlarmsComeAtTheStatedRate) {
    std::mt19937_64 random(2);
    CompareOptions options;
    options.alpha = 0.2;
    int alarms = 0;
    constexpr int trials = 400;
    for (int i = 0; i < trials; ++i)
        alarms += !compare_pictures(estimate(random, pixel_noise), estimate(random, pixel_noise), options).same;
    EXPECT_LT(alarms, trials * 0.2 + 4 * std::sqrt(trials * 0.2 * 0.8));
    EXPECT_GT(alarms, trials * 0.02);
}

// One noisy pixel dominates its block: the variance then rests on one degree of freedom.
TEST(ComparePictures, FewFireflyPixelsPass) {
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal;
    int alarms = 0;
    for (int i = 0; i < 200; ++i) {
        Image images[4];
        for (Image& image : images) {
            image = noisy(random, 0.001);
            for (int k = 0; k < 10; ++k) image.pixel(5 + 5 * k, 30)[0] += float(5 * std::abs(normal(random)));
        }
        alarms += !compare_pictures(estimate_from_replicates({images[0], images[1]}),
                                    estimate_from_replicates({images[2], images[3]}))
                       .same;
    }
    EXPECT_EQ(alarms, 0);
}

/// Each pixel is hit by 0.02 bright samples on average (a Poisson number) in every replicate.
PictureEstimate rarely_bright(std::mt19937_64& random, int replicates) {
    std::poisson_distribution<int> hits(0.02);
    std::vector<Image> images;
    for (int i = 0; i < replicates; ++i) {
        Image image(width, height, 3);
        for (float& value : image.data) value = 0.5f + 20 * float(hits(random));
        images.push_back(image);
    }
    return estimate_from_replicates(images);
}

// In blocks of 16 pixels, 8 replicates meet 2.56 of them: none at all in many a block.
TEST(ComparePictures, RareBrightSamplesPassWithTheVarianceOfTheBetterPicture) {
    std::mt19937_64 random(5);
    const PictureEstimate better = rarely_bright(random, 256);
    CompareOptions options;
    EXPECT_FALSE(compare_pictures(rarely_bright(random, 8), better, options).same) << "no need for the option";
    options.least_variance_ratio = 256.0 / 8;
    int alarms = 0;
    for (int i = 0; i < 50; ++i) alarms += !compare_pictures(rarely_bright(random, 8), better, options).same;
    EXPECT_EQ(alarms, 0);
    PictureEstimate darker = rarely_bright(random, 8);
    for (Rgb& color : darker.mean) color *= 0.9;
    EXPECT_FALSE(compare_pictures(darker, better, options).same);
}

// The same against a picture that knows the mean: blocks without a bright sample have a variance of 0.
TEST(ComparePictures, RareBrightSamplesThatABlockMissedPassWithTheirStep) {
    std::mt19937_64 random(6);
    PictureEstimate exact(width, height);
    for (Rgb& color : exact.mean) color = Rgb(0.5 + 20 * 0.02);
    CompareOptions options;
    EXPECT_FALSE(compare_pictures(exact, rarely_bright(random, 8), options).same) << "no need for the option";
    options.rare_step = 20.0 / 8;
    int alarms = 0;
    for (int i = 0; i < 50; ++i) alarms += !compare_pictures(exact, rarely_bright(random, 8), options).same;
    EXPECT_EQ(alarms, 0);
    for (const double factor : {0.8, 1.2}) {
        PictureEstimate changed = exact;
        for (Rgb& color : changed.mean) color *= factor;
        EXPECT_FALSE(compare_pictures(changed, rarely_bright(random, 8), options).same) << factor;
    }
}

int times_caught(double light, double lobe, double shift) {
    std::mt19937_64 random(4);
    int caught = 0;
    for (int i = 0; i < 50; ++i)
        caught +=
            !compare_pictures(estimate(random, pixel_noise), estimate(random, pixel_noise, light, lobe, shift)).same;
    return caught;
}

TEST(ComparePictures, CatchesALightTwoPercentOff) {
    EXPECT_EQ(times_caught(1.02, 1, 0), 50);
    EXPECT_EQ(times_caught(0.98, 1, 0), 50);
}
TEST(ComparePictures, CatchesALobeFivePercentWider) { EXPECT_EQ(times_caught(1, 1.05, 0), 50); }
TEST(ComparePictures, CatchesAShiftOfATenthOfAPixel) { EXPECT_EQ(times_caught(1, 1, 0.1), 50); }

TEST(ComparePictures, ZeroVarianceAllowsRoundingOnly) {
    PictureEstimate a(16, 16), b(16, 16);
    for (Rgb& color : a.mean) color = Rgb(0.5);
    b.mean = a.mean;
    for (Rgb& color : b.mean) color = color * (1 + 0.9e-5);
    EXPECT_TRUE(compare_pictures(a, b).same);
    for (Rgb& color : b.mean) color = color * (1 + 2e-5);
    EXPECT_FALSE(compare_pictures(a, b).same);
}

TEST(ComparePictures, ReportNamesTheWorstBlock) {
    PictureEstimate a(24, 16), b(24, 16);
    b.mean[b.index(17, 9)].g = 1;
    const CompareResult result = compare_pictures(a, b);
    EXPECT_FALSE(result.same);
    EXPECT_NE(result.report.find("G of pixels [16, 24) x [8, 16)"), std::string::npos) << result.report;
}

TEST(ComparePictures, NaNAndOtherSizesAreDifferent) {
    PictureEstimate a(8, 8), b(8, 8);
    b.mean[3].r = std::nan("");
    EXPECT_FALSE(compare_pictures(a, b).same);
    EXPECT_FALSE(compare_pictures(a, PictureEstimate(8, 9)).same);
}

}  // namespace
}  // namespace drt
