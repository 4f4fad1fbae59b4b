// Reference pictures on disk.

#include "regression/reference_picture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

namespace drt {
namespace {

class ReferenceFile : public ::testing::Test {
protected:
    void TearDown() override { std::filesystem::remove(path); }
    const std::string path =
        ::testing::TempDir() + ::testing::UnitTest::GetInstance()->current_test_info()->name() + ".exr";
};

/// Values and errors over many orders of magnitude, with exact pixels among them.
ReferencePicture varied_reference() {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> exponent(-1, 3);
    ReferencePicture reference;
    reference.picture = PictureEstimate(40, 30);
    reference.picture.freedom = 31;
    reference.seeds = 16;
    reference.spp = 64;
    reference.scene_hash = "0123";
    reference.version = "1.2.3";
    for (size_t i = 0; i < reference.picture.mean.size(); ++i) {
        const double mean = std::pow(10, exponent(random)), error = i % 5 == 0 ? 0 : mean * 1e-3;
        reference.picture.mean[i] = Rgb{mean, mean * 2, mean * 3};
        reference.picture.variance[i] = Rgb{1, 2, 3} * (error * error);
    }
    return reference;
}

TEST_F(ReferenceFile, ReadsBackWithinItsError) {
    const ReferencePicture written = varied_reference();
    write_reference(path, written);
    const ReferencePicture read = read_reference(path);
    EXPECT_EQ(read.seeds, written.seeds);
    EXPECT_EQ(read.spp, written.spp);
    EXPECT_EQ(read.scene_hash, written.scene_hash);
    EXPECT_EQ(read.version, written.version);
    EXPECT_EQ(read.picture.freedom, written.picture.freedom);
    ASSERT_EQ(read.picture.width, written.picture.width);
    ASSERT_EQ(read.picture.height, written.picture.height);
    for (size_t i = 0; i < written.picture.mean.size(); ++i) {
        const Rgb &mean = written.picture.mean[i], &variance = written.picture.variance[i];
        EXPECT_NEAR(read.picture.mean[i].r, mean.r, std::sqrt(variance.r) / 8 + mean.r * 1e-7);
        EXPECT_NEAR(read.picture.mean[i].b, mean.b, std::sqrt(variance.b) / 8 + mean.b * 1e-7);
        EXPECT_NEAR(read.picture.variance[i].g, variance.g, variance.g / 7);
    }
}

TEST_F(ReferenceFile, RoundingLeavesNoBias) {
    const ReferencePicture written = varied_reference();
    write_reference(path, written);
    const ReferencePicture read = read_reference(path);
    double ratio = 0;
    int count = 0;
    for (size_t i = 0; i < written.picture.mean.size(); ++i) {
        if (written.picture.variance[i].r == 0) continue;
        ratio += read.picture.variance[i].r / written.picture.variance[i].r;
        ++count;
    }
    EXPECT_NEAR(ratio / count, 1, 0.01);
}

TEST_F(ReferenceFile, RefusesWhatIsNone) {
    EXPECT_THROW(read_reference(path), std::exception);
    std::ofstream(path) << "no picture";
    EXPECT_THROW(read_reference(path), std::exception);
}

}  // namespace
}  // namespace drt
