// Good files give the right colours; every bad file gives an error, never a half-read picture (numerics: table D2).
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "drt/base/diagnostic.h"
#include "image/image_files.h"

namespace drt {
namespace {

/// The text of the asset error, or "" when the file was read.
std::string asset_error(const std::string& path, const ReadOptions& options = {}) {
    try {
        read_image(path, options);
    } catch (const Error& e) {
        EXPECT_EQ(e.kind(), ErrorKind::asset) << e.what();
        const std::string text = e.what(), start = "error: cannot read image \"" + path + "\": ";
        EXPECT_EQ(text.find(start), 0u) << text;
        EXPECT_EQ(text.find(path, start.size()), std::string::npos) << "the path twice: " << text;
        EXPECT_EQ(text.find_first_of("\r\n"), std::string::npos) << "several lines: " << text;
        return text;
    }
    return {};
}

#define EXPECT_REASON(text, part) EXPECT_NE((text).find(part), std::string::npos) << "\"" << (text) << "\""

/// Writes with OpenImageIO itself, any channel count and type.
void write_plain(const std::string& path, int width, int height, int channels, OIIO::TypeDesc type,
                 const std::vector<float>& data, const OIIO::ParamValueList& attributes = {}) {
    const auto out = OIIO::ImageOutput::create(path);
    ASSERT_TRUE(out) << OIIO::geterror();
    OIIO::ImageSpec spec(width, height, channels, type);
    for (const OIIO::ParamValue& p : attributes) spec.extra_attribs.push_back(p);
    ASSERT_TRUE(out->open(path, spec)) << out->geterror();
    ASSERT_TRUE(out->write_image(OIIO::TypeFloat, data.data())) << out->geterror();
    ASSERT_TRUE(out->close());
}

TEST(ReadImage, GreyIsSpreadAndAlphaDropped) {
    const TestFolder folder;
    const std::vector<float> texels = {1.0f, 0.2f, 0.6f, 0.0f, 0.4f, 0.8f, 0.6f, 1.0f, 0.2f, 0.4f, 0.0f, 1.0f};
    for (const int channels : {1, 2, 3, 4}) {
        const int width = 12 / channels;
        write_plain(folder.file("a.png"), width, 1, channels, OIIO::TypeUInt8, texels, [] {
            OIIO::ParamValueList list;
            list.attribute("oiio:UnassociatedAlpha", 1);
            return list;
        }());
        ReadOptions linear;
        linear.transfer = ReadOptions::Transfer::linear;
        const Image image = read_image(folder.file("a.png"), linear);
        ASSERT_EQ(image.channels, 3);
        ASSERT_EQ(image.width, width);
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 3; ++c)
                EXPECT_FLOAT_EQ(image.pixel(x, 0)[c], texels[size_t(x * channels + (channels < 3 ? 0 : c))])
                    << channels;
    }
}

TEST(ReadImage, TransferFollowsTheFileTypeOrTheOption) {
    const TestFolder folder;
    const std::vector<float> half(3, 0.5f);
    using Transfer = ReadOptions::Transfer;
    const auto red = [&](const char* name, Transfer transfer) {
        ReadOptions options;
        options.transfer = transfer;
        return read_image(folder.file(name), options).data[0];
    };
    write_plain(folder.file("8.png"), 1, 1, 3, OIIO::TypeUInt8, half);
    write_plain(folder.file("16.png"), 1, 1, 3, OIIO::TypeUInt16, half);
    write_plain(folder.file("f.exr"), 1, 1, 3, OIIO::TypeFloat, half);
    write_plain(folder.file("f.tif"), 1, 1, 3, OIIO::TypeFloat, half);
    const double srgb_half = std::pow((0.5 + 0.055) / 1.055, 2.4);
    EXPECT_NEAR(red("8.png", Transfer::automatic), std::pow((128.0 / 255 + 0.055) / 1.055, 2.4), 1e-7);
    EXPECT_NEAR(red("16.png", Transfer::automatic), srgb_half, 1e-5);
    EXPECT_FLOAT_EQ(red("8.png", Transfer::linear), 128.0f / 255);
    EXPECT_EQ(red("f.exr", Transfer::automatic), 0.5f);
    EXPECT_EQ(red("f.tif", Transfer::automatic), 0.5f);
    EXPECT_NEAR(red("f.exr", Transfer::srgb), srgb_half, 1e-7);
}

TEST(ReadImage, MissingAndNotImages) {
    const TestFolder folder;
    write_text(folder.file("empty.png"), "");
    write_text(folder.file("text.tga"), "This is a text, not a picture at all.\n");
    write_text(folder.file("text.exr"), "This is a text, not a picture at all.\n");
    std::filesystem::create_directory(folder.file("dir.png"));
    ASSERT_EQ(::mkfifo(folder.file("pipe.png").c_str(), 0600), 0);
    EXPECT_REASON(asset_error(folder.file("none.png")), "No such file");
    EXPECT_REASON(asset_error(folder.file("empty.png")), "empty");
    EXPECT_NE(asset_error(folder.file("text.tga")), "");
    EXPECT_NE(asset_error(folder.file("text.exr")), "");
    for (const char* type : {"bmp", "fits", "ico", "jpg", "pic", "png", "psd", "rla", "tif", "webp", "yaml"}) {
        const std::string path = folder.file(std::string("text.") + type);
        write_text(path, "This is a text, not a picture at all.\n");
        EXPECT_NE(asset_error(path), "") << type;
    }
    EXPECT_REASON(asset_error(folder.file("dir.png")), "directory");
    EXPECT_REASON(asset_error(folder.file("pipe.png")), "not a regular file");
    EXPECT_REASON(asset_error("/dev/zero"), "not a regular file");
}

class Truncated : public testing::TestWithParam<const char*> {};

TEST_P(Truncated, IsAlwaysAnError) {
    const TestFolder folder;
    const std::string whole = folder.file(std::string("whole.") + GetParam());
    write_image(whole, noisy_picture(64, 48));
    const std::string bytes = read_bytes(whole);
    const Image picture = read_image(whole);
    const std::string cut = folder.file(std::string("cut.") + GetParam());
    for (const int percent : {99, 95, 90, 75, 50, 25, 10, 5, 1}) {
        write_text(cut, bytes.substr(0, bytes.size() * size_t(percent) / 100));
        // the last bytes of a TGA are not its picture, which may still be whole
        if (percent > 90 && asset_error(cut).empty()) {
            EXPECT_EQ(read_image(cut).data, picture.data) << percent << " %";
            continue;
        }
        EXPECT_NE(asset_error(cut), "") << percent << " %";
        EXPECT_THROW(read_image_raw(cut), Error) << percent << " %";
    }
}

INSTANTIATE_TEST_SUITE_P(Formats, Truncated, testing::Values("png", "jpg", "tif", "tga", "exr", "bmp", "hdr"));

class Flipped : public testing::TestWithParam<const char*> {};

// Formats without a checksum cannot tell; then the picture must still have its size and finite values.
TEST_P(Flipped, IsAnErrorOrAWholePicture) {
    const TestFolder folder;
    const std::string whole = folder.file(std::string("whole.") + GetParam());
    // Smooth, because EXR stores a block that does not shrink without compression, hence without a checksum.
    Image picture(64, 48, 4);
    for (size_t i = 0; i < picture.data.size(); ++i) picture.data[i] = float(i / 16) / float(picture.data.size());
    write_image(whole, picture);
    const std::string bytes = read_bytes(whole);
    unsigned state = 7;
    int errors = 0;
    for (int round = 0; round < 40; ++round) {
        std::string broken = bytes;
        for (int i = 0; i < 16; ++i) {
            state = state * 1664525u + 1013904223u;
            broken[size_t(state >> 4) % broken.size()] ^= char(1 << (state >> 29));
        }
        const std::string path = folder.file(std::string("broken.") + GetParam());
        write_text(path, broken);
        try {
            const Image image = read_image(path);
            EXPECT_EQ(image.data.size(), size_t(image.width) * size_t(image.height) * 3);
            EXPECT_TRUE(std::all_of(image.data.begin(), image.data.end(), [](float v) { return std::isfinite(v); }));
        } catch (const Error& e) {
            EXPECT_EQ(e.kind(), ErrorKind::asset) << e.what();
            ++errors;
        }
    }
    const std::string format = GetParam();
    if (format == "png" || format == "exr") {
        EXPECT_GE(errors, 39) << "checksummed";
    }
}

INSTANTIATE_TEST_SUITE_P(Formats, Flipped, testing::Values("png", "jpg", "tif", "tga", "exr", "bmp", "hdr"));

TEST(ReadImage, HugeClaimsAreRefusedBeforeAllocation) {
    const TestFolder folder;
    // 18 bytes that claim 65535 x 65535 pixels of 24 bits: 51 GB as floats
    const unsigned char tga[18] = {0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0xff, 0xff, 0xff, 0xff, 24, 0};
    write_text(folder.file("huge.tga"), std::string(reinterpret_cast<const char*>(tga), 18));
    EXPECT_REASON(asset_error(folder.file("huge.tga")), "65535 x 65535");

    // an EXR whose windows are patched to 1e5 x 1e5
    write_image(folder.file("small.exr"), noisy_picture(8, 8));
    std::string bytes = read_bytes(folder.file("small.exr"));
    for (const std::string name : {"dataWindow", "displayWindow"}) {
        const size_t at = bytes.find(name + '\0' + "box2i") + name.size() + 1 + 6 + 4 + 8;
        for (const size_t offset : {size_t(0), size_t(4)}) {
            const int side = 99999;
            std::copy_n(reinterpret_cast<const char*>(&side), 4, bytes.begin() + long(at + offset));
        }
    }
    write_text(folder.file("huge.exr"), bytes);
    EXPECT_NE(asset_error(folder.file("huge.exr")), "");

    write_image(folder.file("wide.png"), Image(300, 2, 3));
    ReadOptions options;
    options.max_side = 299;
    EXPECT_REASON(asset_error(folder.file("wide.png"), options), "at most 299");
    options.max_side = 300;
    options.max_bytes = 300 * 2 * 3 * 4 - 1;
    EXPECT_REASON(asset_error(folder.file("wide.png"), options), "too large");
    options.max_bytes += 1;
    EXPECT_EQ(asset_error(folder.file("wide.png"), options), "");
}

TEST(ReadImage, ManyChannelsAreRefused) {
    const TestFolder folder;
    for (const int channels : {64, 65}) {
        write_plain(folder.file("a.tif"), 2, 2, channels, OIIO::TypeFloat, std::vector<float>(size_t(4 * channels)));
        EXPECT_EQ(asset_error(folder.file("a.tif")).empty(), channels == 64);
    }
}

TEST(ReadImage, NonFiniteTexelsNameTheFirstPixel) {
    const TestFolder folder;
    for (const float bad : {std::nanf(""), std::numeric_limits<float>::infinity()}) {
        std::vector<float> data(5 * 4 * 3, 0.5f);
        data[(2 * 5 + 3) * 3 + 1] = bad;
        data[(3 * 5 + 1) * 3] = bad;
        write_plain(folder.file("a.exr"), 5, 4, 3, OIIO::TypeFloat, data);
        EXPECT_REASON(asset_error(folder.file("a.exr")), "pixel (3, 2)");
        EXPECT_FALSE(std::isfinite(read_image_raw(folder.file("a.exr")).data[(2 * 5 + 3) * 3 + 1]));
    }
}

}  // namespace
}  // namespace drt
