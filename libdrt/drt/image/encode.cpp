#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfChromaticities.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
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
#include <map>
#include <mutex>
#include <sstream>
#include <stdexcept>
#include <thread>

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

bool encodes_in_memory(const std::string& format) {
    // `term` prints the picture on the terminal, `null` discards it, `jpeg2000` (OIIO 2.4) claims to but writes nothing
    if (format == "term" || format == "null" || format == "jpeg2000") return false;
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(format);
    return output && output->supports("ioproxy");
}

/// extension -> OpenImageIO's format, for everything it can encode into memory. Formats that it only writes to a file
/// by itself (sgi, rla, ico, ...) are left out: on a full disk their writers report success and leave holes of zeros
/// in a file of the right size, which no check short of the pixels finds.
const std::map<std::string, std::string>& output_formats() {
    static const std::map<std::string, std::string> formats = [] {
        std::string writable, lists;
        OIIO::getattribute("output_format_list", writable);
        OIIO::getattribute("extension_list", lists);
        writable = ',' + writable + ',';
        std::map<std::string, std::string> result;
        std::istringstream formats_in(lists);
        for (std::string entry; std::getline(formats_in, entry, ';');) {
            const size_t colon = entry.find(':');
            const std::string format = entry.substr(0, colon);
            if (writable.find(',' + format + ',') == std::string::npos || !encodes_in_memory(format)) continue;
            std::istringstream extensions(entry.substr(colon + 1));
            for (std::string e; std::getline(extensions, e, ',');)
                // the pnm writer would put a PPM into these
                if (e != "pfm" && e != "pgm" && e != "pbm") result.emplace(e, format);
        }
        return result;
    }();
    return formats;
}

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
    const auto found = output_formats().find(extension);
    return found == output_formats().end() ? std::string() : found->second;
}

std::vector<std::string> output_extensions() {
    std::vector<std::string> result;
    for (const auto& [extension, format] : output_formats()) result.push_back(extension);
    return result;
}

std::vector<unsigned char> encode_exr(const Image& image, const Metadata& metadata) {
    initialize_openexr();
    Imf::Header header(image.width, image.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    Imf::addChromaticities(header, Imf::Chromaticities());  // the default is Rec. 709 with white D65
    for (const auto& [name, value] : metadata) header.insert(name, Imf::StringAttribute(value));

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
