#include "regression/reference_picture.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <fmt/format.h>
#include <xxhash.h>

#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "drt/base/atomic_file.h"
#include "drt/formats/formats.h"

namespace drt {
namespace {

constexpr std::array<const char*, 6> channel_names{"R", "G", "B", "error.R", "error.G", "error.B"};
constexpr size_t error_of = 3;  ///< a channel's error is this many channels later

/// One plane a channel.
using Planes = std::array<std::vector<float>, channel_names.size()>;

/// To a multiple of error / 2^bits, rounded down to a power of two.
float round_to(double error, int bits, double value) {
    if (error == 0) return float(value);
    const double step = std::exp2(std::floor(std::log2(error)) - bits);
    return float(std::nearbyint(value / step) * step);
}

Planes to_planes(const PictureEstimate& picture) {
    Planes planes;
    for (size_t i = 0; i < picture.mean.size(); ++i) {
        const Rgb &m = picture.mean[i], &v = picture.variance[i];
        const std::array<double, 3> mean{m.r, m.g, m.b}, variance{v.r, v.g, v.b};
        for (size_t c = 0; c < mean.size(); ++c) {
            const double error = std::sqrt(variance[c]);
            planes[c].push_back(round_to(error, 2, mean[c]));
            planes[c + error_of].push_back(round_to(error, 3, error));
        }
    }
    return planes;
}

PictureEstimate to_estimate(const Planes& planes, int width, int height, double freedom) {
    PictureEstimate picture(width, height);
    picture.freedom = freedom;
    for (size_t i = 0; i < picture.mean.size(); ++i) {
        const auto error = [&](size_t c) { return double(planes[c + error_of][i]); };
        picture.mean[i] = {planes[0][i], planes[1][i], planes[2][i]};
        picture.variance[i] = {error(0) * error(0), error(1) * error(1), error(2) * error(2)};
    }
    return picture;
}

/// All channels as floats in memory, whatever they are in the file.
Imf::FrameBuffer frame_buffer(Planes& planes, int width) {
    Imf::FrameBuffer frame;
    for (size_t c = 0; c < planes.size(); ++c)
        frame.insert(channel_names[c], Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(planes[c].data()), sizeof(float),
                                                  sizeof(float) * size_t(width)));
    return frame;
}

std::string text_attribute(const Imf::Header& header, const std::string& name) {
    const auto* attribute = header.findTypedAttribute<Imf::StringAttribute>(name);
    if (!attribute) throw std::runtime_error("no attribute " + name);
    return attribute->value();
}

int number_attribute(const Imf::Header& header, const std::string& name) {
    const std::string text = text_attribute(header, name);
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) throw std::runtime_error(name + " is not a number");
    return value;
}

}  // namespace

void write_reference(const std::string& path, const ReferencePicture& reference) {
    const PictureEstimate& picture = reference.picture;
    Imf::Header header(picture.width, picture.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    const auto describe = [&](const char* name, const std::string& value) {
        header.insert(name, Imf::StringAttribute(value));
    };
    describe("drt:version", reference.version);
    describe("drt:sceneHash", reference.scene_hash);
    describe("drt:seeds", fmt::format("{}", reference.seeds));
    describe("drt:spp", fmt::format("{}", reference.spp));
    describe("drt:errorFreedom", fmt::format("{:.0f}", picture.freedom));
    Planes planes = to_planes(picture);
    for (size_t c = 0; c < planes.size(); ++c)
        header.channels().insert(channel_names[c], Imf::Channel(c < error_of ? Imf::FLOAT : Imf::HALF));

    // OpenEXR converts nothing when it writes: the errors need a plane of halfs.
    std::vector<std::vector<half>> halfs;
    Imf::FrameBuffer frame = frame_buffer(planes, picture.width);
    for (size_t c = error_of; c < planes.size(); ++c) {
        halfs.emplace_back(planes[c].begin(), planes[c].end());
        frame.insert(channel_names[c], Imf::Slice(Imf::HALF, reinterpret_cast<char*>(halfs.back().data()), sizeof(half),
                                                  sizeof(half) * size_t(picture.width)));
    }
    const auto write = [&](const std::string& file) {
        Imf::OutputFile output(file.c_str(), header);
        output.setFrameBuffer(frame);
        output.writePixels(picture.height);
    };
    replace_file(path, write, [](const std::string& file) { read_reference(file); });
}

ReferencePicture read_reference(const std::string& path) {
    Imf::InputFile file(path.c_str());
    const Imf::Header& header = file.header();
    const Imath::Box2i& window = header.dataWindow();
    const int width = window.max.x - window.min.x + 1, height = window.max.y - window.min.y + 1;
    Planes planes;
    for (size_t c = 0; c < planes.size(); ++c) {
        if (!header.channels().findChannel(channel_names[c]))
            throw std::runtime_error(path + ": no channel " + channel_names[c]);
        planes[c].resize(size_t(width) * size_t(height));
    }
    file.setFrameBuffer(frame_buffer(planes, width));
    file.readPixels(window.min.y, window.max.y);

    ReferencePicture reference;
    reference.picture = to_estimate(planes, width, height, number_attribute(header, "drt:errorFreedom"));
    reference.seeds = number_attribute(header, "drt:seeds");
    reference.spp = number_attribute(header, "drt:spp");
    reference.scene_hash = text_attribute(header, "drt:sceneHash");
    reference.version = text_attribute(header, "drt:version");
    return reference;
}

std::string hash_scene(const SceneDesc& scene, const std::string& folder) {
    const std::string text = write_yaml_scene(scene, folder);
    const XXH128_hash_t h = XXH3_128bits(text.data(), text.size());
    return fmt::format("{:016x}{:016x}", h.high64, h.low64);
}

}  // namespace drt
