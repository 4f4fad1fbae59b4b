#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfChromaticities.h>
#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfFloatAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfThreading.h>
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string_view>
#include <thread>
#include <utility>

#include "drt/image/codec.h"

namespace drt {
namespace {

/// Larger than any picture that read_image accepts by default, small enough that opening a file stays cheap.
constexpr int max_exr_side = 65536;

/// EXR into memory: our own write() then tells every errno, which OpenEXR's destructor swallows.
class MemoryStream : public Imf::OStream {
public:
    MemoryStream() : Imf::OStream("memory") {}
    void write(const char* data, int n) override {
        const size_t end = position_ + size_t(n);
        if (bytes_.size() < end) bytes_.resize(end);
        std::memcpy(bytes_.data() + position_, data, size_t(n));
        position_ = end;
    }
    uint64_t tellp() override { return position_; }
    void seekp(uint64_t position) override { position_ = position; }
    std::vector<unsigned char> take() { return std::move(bytes_); }

private:
    std::vector<unsigned char> bytes_;
    size_t position_ = 0;
};

/// The file types that OpenImageIO 2.4 encodes in memory without fault (a test writes and reads each). Others are left
/// out on purpose: writers that go to the disk themselves (sgi, rla, ico, ...) report success on a full one and leave
/// holes of zeros in a file of the right size; jpeg2000 writes nothing to memory; iff is broken for odd sizes.
constexpr std::pair<std::string_view, std::string_view> output_formats[] = {
    {"exr", "openexr"}, {"png", "png"},   {"bmp", "bmp"}, {"jpg", "jpeg"},  {"jpeg", "jpeg"},
    {"tif", "tiff"},    {"tiff", "tiff"}, {"hdr", "hdr"}, {"tga", "targa"}, {"ppm", "pnm"},
    {"webp", "webp"},   {"gif", "gif"},   {"dpx", "dpx"},
};

bool stores_float(const std::string& format) { return format == "tiff" || format == "hdr"; }

/// The first `channels` channels of every pixel.
std::vector<float> leading_channels(const Image& image, int channels) {
    std::vector<float> out;
    out.reserve(size_t(image.width) * size_t(image.height) * size_t(channels));
    for (size_t i = 0; i < image.data.size(); i += size_t(image.channels))
        out.insert(out.end(), &image.data[i], &image.data[i] + channels);
    return out;
}

/// 8-bit RGB: exposure, transfer curve, clamp, round to nearest.
std::vector<unsigned char> to_display(const Image& image, const DisplayTransform& display) {
    const float gain = std::exp2(display.exposure);
    std::vector<unsigned char> out;
    out.reserve(size_t(image.width) * size_t(image.height) * 3);
    for (size_t i = 0; i < image.data.size(); i += size_t(image.channels))
        for (size_t c = 0; c < 3; ++c) {
            const float linear = std::clamp(image.data[i + c] * gain, 0.0f, 1.0f);
            const float v = display.srgb ? linear_to_srgb(linear) : linear;
            out.push_back(static_cast<unsigned char>(std::lrint(std::clamp(v, 0.0f, 1.0f) * 255.0f)));
        }
    return out;
}

}  // namespace

void initialize_openexr() {
    static std::once_flag once;
    std::call_once(once, [] {
        Imf::Header::setMaxImageSize(max_exr_side, max_exr_side);
        if (Imf::globalThreadCount() == 0) Imf::setGlobalThreadCount(int(std::thread::hardware_concurrency()));
    });
}

std::string output_format(const std::string& path) {
    std::string extension = std::filesystem::path(path).extension().string();
    if (extension.empty()) return {};
    extension.erase(0, 1);
    for (char& c : extension) c = char(std::tolower(static_cast<unsigned char>(c)));
    for (const auto& [known, format] : output_formats)
        if (known == extension) return std::string(format);
    return {};
}

std::vector<std::string> output_extensions() {
    std::vector<std::string> result;
    for (const auto& [extension, format] : output_formats) result.emplace_back(extension);
    return result;
}

std::vector<unsigned char> encode_exr(const Image& image, const Metadata& metadata) {
    initialize_openexr();
    Imf::Header header(image.width, image.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    Imf::addChromaticities(header, Imf::Chromaticities());  // the default is Rec. 709 with white D65
    for (const auto& [name, value] : metadata)
        std::visit([&, &key = name](const auto& v) { header.insert(key, Imf::TypedAttribute(v)); }, value);

    Imf::FrameBuffer frame;
    const size_t pixel_bytes = size_t(image.channels) * sizeof(float);
    constexpr const char* names[] = {"R", "G", "B", "A"};
    for (int c = 0; c < image.channels; ++c) {
        header.channels().insert(names[c], Imf::Channel(Imf::FLOAT));
        // Imf::Slice is one type for reading and writing; writing does not touch the pixels.
        char* base = reinterpret_cast<char*>(const_cast<float*>(image.data.data() + c));
        frame.insert(names[c], Imf::Slice(Imf::FLOAT, base, pixel_bytes, pixel_bytes * size_t(image.width)));
    }
    MemoryStream stream;
    {
        Imf::OutputFile file(stream, header);
        file.setFrameBuffer(frame);
        file.writePixels(image.height);
    }  // the destructor writes the table of line offsets
    return stream.take();
}

std::vector<unsigned char> encode_other(const std::string& format, const Image& image,
                                        const DisplayTransform& display) {
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(format);
    if (!output) throw std::runtime_error(OIIO::geterror());
    const bool as_float = stores_float(format);
    // Alpha is coverage and belongs to compositing: an 8-bit picture for looking at is opaque.
    const int channels = as_float && output->supports("alpha") ? image.channels : 3;
    OIIO::ImageSpec spec(image.width, image.height, channels, as_float ? OIIO::TypeFloat : OIIO::TypeUInt8);
    // Only sRGB is tagged: the 2008 program's linear BMPs had no tag, and a viewer must not undo what was asked for.
    if (!as_float && display.srgb) spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("tiff:write_exif", 0);  // an empty EXIF folder is an error to libtiff 4.5
    if (format == "jpeg") spec.attribute("CompressionQuality", 95);

    std::vector<float> floats;
    std::vector<unsigned char> bytes;
    if (as_float)
        floats = leading_channels(image, channels);
    else
        bytes = to_display(image, display);
    const void* pixels = as_float ? static_cast<const void*>(floats.data()) : bytes.data();

    std::vector<unsigned char> encoded;
    OIIO::Filesystem::IOVecOutput memory(encoded);
    OIIO::Filesystem::IOProxy* proxy = &memory;
    spec.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
    const auto check = [&](bool ok) {
        if (ok && !output->has_error()) return;
        const std::string text = output->geterror();
        throw std::runtime_error(text.empty() ? "the encoder failed" : text.substr(0, text.find('\n')));
    };
    check(output->open("memory." + format, spec));
    check(output->write_image(spec.format, pixels));
    check(output->close());
    return encoded;
}

}  // namespace drt
