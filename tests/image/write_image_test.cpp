// What write_image stores, and that reading gives it back.
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfChromaticitiesAttribute.h>
#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfFloatAttribute.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "drt/base/diagnostic.h"
#include "drt/image/codec.h"
#include "image/image_files.h"

namespace drt {
namespace {

std::string output_error(const std::string& path, const Image& image = Image(2, 2, 4)) {
    try {
        write_image(path, image);
    } catch (const Error& e) {
        const bool bad_name = std::string(e.what()).find("expected one of .exr") != std::string::npos;
        EXPECT_EQ(e.kind(), bad_name ? ErrorKind::usage : ErrorKind::output) << e.what();
        return e.what();
    }
    return {};
}

TEST(WriteImage, ExrGivesBackTheVeryBits) {
    const TestFolder folder;
    for (const int channels : {3, 4}) {
        Image image = noisy_picture(37, 23, channels);
        image.data[0] = -0.0f;
        image.data[1] = std::numeric_limits<float>::max();
        image.data[2] = std::numeric_limits<float>::denorm_min();
        image.data[3] = -1e-20f;
        write_image(folder.file("a.exr"), image);
        const Image stored = read_image_raw(folder.file("a.exr"));
        ASSERT_EQ(stored.channels, channels);
        ASSERT_EQ(stored.width, 37);
        ASSERT_EQ(stored.height, 23);
        EXPECT_TRUE(std::equal(image.data.begin(), image.data.end(), stored.data.begin(), stored.data.end()));
        EXPECT_TRUE(std::signbit(stored.data[0]));
    }
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(WriteImage, ExrCarriesMetadataAndColourSpace) {
    const TestFolder folder;
    const Metadata metadata = {{"drt:version", "0.1"}, {"software", "drt"}, {"comments", "ž \" ' \n"},
                               {"drt:spp", -42},       {"time", 0.1f},      {"drt:seed", 4294967295.0}};
    write_image(folder.file("a.exr"), Image(4, 3, 4), metadata);
    const Imf::InputFile file(folder.file("a.exr").c_str());
    const Imf::Header& header = file.header();
    for (const auto& [name, value] : metadata)
        std::visit(
            [&, &key = name](const auto& v) {
                const auto* attribute =
                    header.findTypedAttribute<Imf::TypedAttribute<std::remove_cvref_t<decltype(v)>>>(key);
                ASSERT_NE(attribute, nullptr) << key;
                EXPECT_EQ(attribute->value(), v);
            },
            value);
    EXPECT_EQ(header["drt:spp"].typeName(), std::string("int"));
    EXPECT_EQ(header["time"].typeName(), std::string("float"));
    EXPECT_EQ(header["drt:seed"].typeName(), std::string("double"));
    ASSERT_TRUE(Imf::hasChromaticities(header));
    EXPECT_FLOAT_EQ(Imf::chromaticities(header).red.x, 0.64f);
    EXPECT_FLOAT_EQ(Imf::chromaticities(header).white.y, 0.329f);
    EXPECT_EQ(header.compression(), Imf::ZIP_COMPRESSION);
    EXPECT_FALSE(header.hasTileDescription());
    for (const char* channel : {"R", "G", "B", "A"}) EXPECT_EQ(header.channels()[channel].type, Imf::FLOAT);
}

TEST(WriteImage, MetadataMayNotReplaceExrStructure) {
    const TestFolder folder;
    EXPECT_THROW(write_image(folder.file("a.exr"), Image(4, 3, 4), {{"channels", "none"}}), Error);
    EXPECT_EQ(folder.entries(), 0u);
}

TEST(WriteImage, EightBitFilesGoThroughTheDisplayTransform) {
    const TestFolder folder;
    Image image(4, 1, 4);
    const float values[] = {0.0f, 0.05f, 0.25f, 3.0f};
    for (int x = 0; x < 4; ++x)
        for (int c = 0; c < 3; ++c) image.pixel(x, 0)[c] = values[x];
    for (const char* name : {"a.png", "a.bmp", "a.tga", "a.ppm", "a.PNG"})
        for (const bool srgb : {true, false}) {
            write_image(folder.file(name), image, {}, {1.0f, srgb});
            const Image stored = read_image_raw(folder.file(name));
            ASSERT_EQ(stored.channels, 3) << name;
            for (int x = 0; x < 4; ++x) {
                const double linear = std::min(1.0, 2.0 * values[x]);
                const double curve = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
                const double byte = std::round(255 * (srgb ? curve : linear));
                EXPECT_EQ(std::lround(255.0 * double(stored.pixel(x, 0)[0])), byte) << name << " " << x;
            }
        }
}

TEST(WriteImage, ReadingUndoesSrgbAndRoundsToNearest) {
    const TestFolder folder;
    Image image(256, 1, 3);
    for (int x = 0; x < 256; ++x)
        for (int c = 0; c < 3; ++c) image.pixel(x, 0)[c] = srgb_to_linear(float(x) / 255);
    write_image(folder.file("a.png"), image);
    const Image stored = read_image(folder.file("a.png"));
    for (size_t i = 0; i < image.data.size(); ++i) ASSERT_EQ(stored.data[i], image.data[i]) << i;
}

TEST(WriteImage, FloatFormatsStaySceneLinear) {
    const TestFolder folder;
    Image image = noisy_picture(16, 9);
    image.data[0] = 100;
    for (const char* name : {"a.hdr", "a.tif"}) {
        write_image(folder.file(name), image, {}, {3.0f, true});
        const Image stored = read_image(folder.file(name));
        const float tolerance = name == std::string("a.hdr") ? 1.0f / 128 : 0;  // 8-bit shared exponent
        for (int y = 0; y < 9; ++y)
            for (int x = 0; x < 16; ++x) {
                const float* pixel = image.pixel(x, y);
                const float scale = std::max({pixel[0], pixel[1], pixel[2]});
                for (int c = 0; c < 3; ++c)
                    ASSERT_NEAR(stored.pixel(x, y)[c], pixel[c], tolerance * scale) << name << x << ' ' << y;
            }
    }
    EXPECT_EQ(read_image_raw(folder.file("a.tif")).data, image.data);
}

TEST(WriteImage, EveryKnownFormatReadsBack) {
    const TestFolder folder;
    const Image image = noisy_picture(33, 17);
    const std::vector<std::string> extensions = output_extensions();
    for (const char* needed : {"exr", "png", "bmp", "jpg", "jpeg", "tif", "tiff", "hdr", "tga", "ppm", "webp"})
        EXPECT_EQ(std::count(extensions.begin(), extensions.end(), needed), 1) << needed;
    for (const std::string& extension : extensions) {
        const std::string path = folder.file("a." + extension);
        write_image(path, image);
        const Image stored = read_image(path);
        EXPECT_EQ(stored.width, 33) << path;
        EXPECT_EQ(stored.height, 17) << path;
    }
    EXPECT_EQ(folder.entries(), extensions.size());
}

TEST(WriteImage, ExtremeShapes) {
    const TestFolder folder;
    for (const auto& [w, h] : {std::pair{1, 1}, {1, 300}, {300, 1}, {16384, 2}}) {
        const Image image = noisy_picture(w, h);
        write_image(folder.file("a.exr"), image);
        EXPECT_EQ(read_image_raw(folder.file("a.exr")).data, image.data) << w << "x" << h;
        write_image(folder.file("a.png"), image);
        EXPECT_EQ(read_image(folder.file("a.png")).width, w);
    }
}

TEST(WriteImage, RefusesWhatTheFilmNeverMakes) {
    const TestFolder folder;
    Image image(3, 2, 4);
    image.pixel(2, 1)[0] = std::nanf("");
    try {
        write_image(folder.file("a.exr"), image);
        FAIL();
    } catch (const Error& e) {
        EXPECT_EQ(e.kind(), ErrorKind::internal);
        EXPECT_NE(std::string(e.what()).find("pixel (2, 1)"), std::string::npos) << e.what();
    }
    image.pixel(2, 1)[0] = std::numeric_limits<float>::infinity();
    EXPECT_THROW(write_image(folder.file("a.png"), image), Error);
    EXPECT_THROW(write_image(folder.file("a.exr"), Image()), Error);
    EXPECT_THROW(write_image(folder.file("a.exr"), Image(2, 2, 1)), Error);
    EXPECT_EQ(folder.entries(), 0u);
}

TEST(WriteImage, FollowsALinkInsteadOfReplacingIt) {
    const TestFolder folder;
    write_image(folder.file("real.exr"), Image(1, 1, 4));
    std::filesystem::create_symlink("real.exr", folder.file("link.exr"));
    write_image(folder.file("link.exr"), Image(7, 5, 4));
    EXPECT_TRUE(std::filesystem::is_symlink(folder.file("link.exr")));
    EXPECT_EQ(read_image_raw(folder.file("real.exr")).width, 7);
    std::filesystem::remove(folder.file("real.exr"));
    write_image(folder.file("link.exr"), Image(5, 5, 4));  // where there is no file yet
    EXPECT_TRUE(std::filesystem::is_symlink(folder.file("link.exr")));
    EXPECT_EQ(read_image_raw(folder.file("real.exr")).width, 5);
}

TEST(WriteImage, NamesThePathAndTheReason) {
    const TestFolder folder;
    write_text(folder.file("plain"), "x");
    EXPECT_NE(output_error(folder.file("missing/a.exr")).find("missing/a.exr\": No such file"), std::string::npos);
    EXPECT_NE(output_error(folder.file("plain/a.exr")).find("Not a directory"), std::string::npos);
    const std::string unknown = output_error(folder.file("a.exrr"));
    EXPECT_NE(unknown.find(".exrr"), std::string::npos) << unknown;
    EXPECT_NE(unknown.find(".png"), std::string::npos) << unknown;
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(CheckWritable, FindsWhatWouldFailLater) {
    const TestFolder folder;
    std::filesystem::create_directory(folder.file("dir.exr"));
    std::filesystem::create_symlink("/dev/full", folder.file("full.exr"));
    write_text(folder.file("plain"), "x");
    const auto reason = [&](const std::string& path) -> std::string {
        try {
            check_writable(path);
        } catch (const Error& e) {
            const bool bad_name = std::string(e.what()).find("expected one of .exr") != std::string::npos;
            EXPECT_EQ(e.kind(), bad_name ? ErrorKind::usage : ErrorKind::output) << e.what();
            return e.what();
        }
        return "fine";
    };
    EXPECT_EQ(reason(folder.file("a.exr")), "fine");
    EXPECT_EQ(reason(folder.file("a.JPG")), "fine");
    EXPECT_NE(reason(folder.file("none/a.exr")).find("none\" does not exist"), std::string::npos);
    EXPECT_NE(reason(folder.file("plain/a.exr")).find("Not a directory"), std::string::npos);
    EXPECT_NE(reason(folder.file("dir.exr")).find("Is a directory"), std::string::npos);
    EXPECT_NE(reason(folder.file("full.exr")).find("not a regular file"), std::string::npos);
    EXPECT_NE(reason(folder.file("noextension")).find("no extension"), std::string::npos);
    EXPECT_NE(reason(folder.file("a.xyz")).find("unknown file type .xyz"), std::string::npos);
    EXPECT_NE(reason(folder.file("a.sgi")).find("unknown file type"), std::string::npos);
    EXPECT_NE(reason(folder.file("a.null")).find("unknown"), std::string::npos);
    EXPECT_NE(reason(folder.file(std::string(300, 'a') + ".exr")).find("too long"), std::string::npos);
    EXPECT_NE(reason("/proc/a.exr").find("/proc/a.exr"), std::string::npos);
    EXPECT_EQ(folder.entries(), 3u);  // the probe is gone
}

}  // namespace
}  // namespace drt
