#include <OpenImageIO/imageio.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <memory>
#include <new>
#include <stdexcept>
#include <system_error>

#include "drt/base/diagnostic.h"
#include "drt/image/codec.h"
#include "drt/image/image.h"

namespace drt {
namespace {

using OIIO::ImageInput;
using OIIO::ImageSpec;

constexpr int max_channels = 64;

[[noreturn]] void refuse(const std::string& reason) { throw std::runtime_error(reason); }

[[noreturn]] void refuse(const std::string& reason, const std::string& otherwise) {
    refuse(reason.empty() ? otherwise : reason);
}

/// A library's message as a reason. OpenImageIO strings several messages together, a line each, of which the first
/// names the cause; and some of its plugins name the file, which the caller does, too.
std::string plain_reason(std::string text, const std::string& path) {
    text.erase(0, text.find_first_not_of(" \r\n"));
    text.resize(std::min(text.find_first_of("\r\n"), text.size()));
    text.resize(text.find_last_not_of(' ') + 1);
    const std::string quoted = '"' + path + '"';
    for (size_t at = text.find(quoted); at != std::string::npos; at = text.find(quoted))
        text.replace(at, quoted.size(), "the file");
    if (text.starts_with(path + ' ')) text.replace(0, path.size(), "the file");
    return text.empty() ? "corrupt" : text;
}

/// Runs `decode`; what it throws comes with a plain reason.
template <class Decode>
Image with_plain_reasons(const std::string& path, Decode&& decode) {
    try {
        return decode();
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& e) {
        refuse(plain_reason(e.what(), path));
    }
}

/// Checked before any library opens the file: a pipe would block for ever, a device would never end.
void check_regular_file(const std::string& path) {
    struct stat status = {};
    if (::stat(path.c_str(), &status) != 0) refuse(std::generic_category().message(errno));
    if (S_ISDIR(status.st_mode)) refuse("it is a directory");
    if (!S_ISREG(status.st_mode)) refuse("not a regular file");
    if (status.st_size == 0) refuse("the file is empty");
}

/// What a header claims, judged before anything is allocated for it.
void check_spec(const ImageSpec& spec, const ReadOptions& options) {
    const std::string size = std::to_string(spec.width) + " x " + std::to_string(spec.height);
    if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1) refuse("it has no pixels");
    if (spec.width > options.max_side || spec.height > options.max_side)
        refuse("too large: " + size + " pixels, at most " + std::to_string(options.max_side) + " a side");
    if (spec.nchannels > max_channels)
        refuse("too many channels: " + std::to_string(spec.nchannels) + ", at most " + std::to_string(max_channels));
    if (spec.depth > 1) refuse("it is a volume, not a picture");
    if (spec.deep) refuse("deep images are not supported");
    const std::uint64_t bytes =
        std::uint64_t(spec.width) * std::uint64_t(spec.height) * std::uint64_t(spec.nchannels) * sizeof(float);
    if (bytes > options.max_bytes)
        refuse("too large: " + size + " pixels would take " + std::to_string(bytes >> 20) + " MiB, at most " +
               std::to_string(options.max_bytes >> 20) + " MiB");
}

std::unique_ptr<ImageInput> open_checked(const std::string& path, const std::string& format,
                                         const ReadOptions& options) {
    check_regular_file(path);
    initialize_openexr();
    // Colours stay as stored: multiplied by alpha, a texture whose alpha is dropped would go black.
    ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);
    std::unique_ptr<ImageInput> input;
    try {
        if (format.empty()) {
            input = ImageInput::open(path, &config);
            if (!input) refuse(OIIO::geterror(), "not an image of any known format");
        } else {
            input = ImageInput::create(format);
            if (!input) refuse(OIIO::geterror(), "unknown format " + format);
            ImageSpec spec;
            if (!input->open(path, spec, config)) refuse(input->geterror(), "cannot be opened");
        }
    } catch (const std::bad_alloc&) {
        refuse("its header asks for more memory than there is");
    }
    check_spec(input->spec(), options);
    return input;
}

/// Reads channels [first, last) with `stride` floats from pixel to pixel.
void read_channels(ImageInput& input, int first, int last, float* out, int stride) {
    const bool ok = input.read_image(0, 0, first, last, OIIO::TypeFloat, out, OIIO::stride_t(sizeof(float)) * stride);
    // Truncated JPEG and TIFF files return true and only leave a message.
    if (input.has_error()) refuse(input.geterror(), "corrupt");
    if (!ok) refuse("corrupt or truncated");
}

/// The channels that hold red, green and blue; three times the same for a grey picture.
std::array<int, 3> color_channels(const ImageSpec& spec) {
    const auto find = [&](const char* name) { return spec.channelindex(name); };
    const std::array<int, 3> rgb = {find("R"), find("G"), find("B")};
    if (rgb[0] >= 0 && rgb[1] >= 0 && rgb[2] >= 0) return rgb;
    if (find("RY") >= 0 || find("BY") >= 0) refuse("luminance/chroma EXR is not supported");
    if (const int y = find("Y"); y >= 0) return {y, y, y};
    if (spec.nchannels <= 2) return {0, 0, 0};  // grey, or grey and alpha
    refuse("it has no channels R, G, B or Y");
}

void read_colors(ImageInput& input, Image& image) {
    const auto [r, g, b] = color_channels(input.spec());
    float* out = image.data.data();
    if (g == r + 1 && b == g + 1) {
        read_channels(input, r, r + 3, out, 3);
    } else if (r == g && g == b) {
        read_channels(input, r, r + 1, out, 3);
        for (size_t i = 0; i < image.data.size(); i += 3) out[i + 1] = out[i + 2] = out[i];
    } else {
        read_channels(input, r, r + 1, out, 3);
        read_channels(input, g, g + 1, out + 1, 3);
        read_channels(input, b, b + 1, out + 2, 3);
    }
}

/// Integer files of 8 or 16 bits have few distinct values: a table replaces a power per texel.
void decode_srgb(std::vector<float>& data, const OIIO::TypeDesc& format) {
    if (format.is_floating_point() || format.size() > 2) {
        for (float& v : data) v = srgb_to_linear(v);
        return;
    }
    const float top = format.size() == 1 ? 255.0f : 65535.0f;
    std::vector<float> table(size_t(top) + 1);
    for (size_t i = 0; i < table.size(); ++i) table[i] = srgb_to_linear(float(i) / top);
    for (float& v : data) v = table[size_t(std::lrint(std::fmin(std::fmax(v, 0.0f), 1.0f) * top))];
}

void check_finite(const Image& image) {
    for (size_t i = 0; i < image.data.size(); ++i)
        if (!std::isfinite(image.data[i])) {
            const size_t pixel = i / size_t(image.channels);
            refuse("pixel (" + std::to_string(pixel % size_t(image.width)) + ", " +
                   std::to_string(pixel / size_t(image.width)) + ") is not a finite number");
        }
}

Image decode_colors(const std::string& path, const ReadOptions& options) {
    const std::unique_ptr<ImageInput> input = open_checked(path, "", options);
    const ImageSpec& spec = input->spec();
    Image image(spec.width, spec.height, 3);
    read_colors(*input, image);
    using Transfer = ReadOptions::Transfer;
    const bool small_integers = !spec.format.is_floating_point() && spec.format.size() <= 2;
    if (options.transfer == Transfer::srgb || (options.transfer == Transfer::automatic && small_integers))
        decode_srgb(image.data, spec.format);
    check_finite(image);
    return image;
}

template <class Decode>
Image reporting(const std::string& path, Decode&& decode) {
    const std::string what = "cannot read image \"" + path + "\": ";
    try {
        return decode();
    } catch (const std::bad_alloc&) {
        throw Error(ErrorKind::memory, what + "out of memory");
    } catch (const std::exception& e) {
        throw Error(ErrorKind::asset, what + e.what());
    }
}

}  // namespace

Image decode_all_channels(const std::string& path, const std::string& format, const ReadOptions& options) {
    return with_plain_reasons(path, [&] {
        const std::unique_ptr<ImageInput> input = open_checked(path, format, options);
        const ImageSpec& spec = input->spec();
        Image image(spec.width, spec.height, spec.nchannels);
        read_channels(*input, 0, spec.nchannels, image.data.data(), spec.nchannels);
        return image;
    });
}

Image read_image(const std::string& path, const ReadOptions& options) {
    return reporting(path, [&] { return with_plain_reasons(path, [&] { return decode_colors(path, options); }); });
}

Image read_image_raw(const std::string& path) {
    return reporting(path, [&] { return decode_all_channels(path, "", ReadOptions{}); });
}

}  // namespace drt
