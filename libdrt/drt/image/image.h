#pragma once
// Images in memory and on disk. Reading decodes and checks the whole file; writing is atomic.

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "drt/base/color.h"

namespace drt {

/// Row-major, rows from the top, `channels` interleaved floats a pixel, linear.
struct Image {
    int width = 0, height = 0, channels = 0;
    std::vector<float> data;

    Image() = default;
    Image(int w, int h, int c) : width(w), height(h), channels(c), data(size_t(w) * size_t(h) * size_t(c)) {}
    float* pixel(int x, int y) { return &data[(size_t(y) * size_t(width) + size_t(x)) * size_t(channels)]; }
    const float* pixel(int x, int y) const { return &data[(size_t(y) * size_t(width) + size_t(x)) * size_t(channels)]; }
};

struct ReadOptions {
    enum class Transfer { automatic, srgb, linear };  ///< automatic: integer files are sRGB, float files linear
    Transfer transfer = Transfer::automatic;
    int max_side = 16384;  ///< pixels; larger images are refused before anything is allocated
    std::uint64_t max_bytes = std::uint64_t(4) << 30;  ///< of decoded float data
};

/// Reads any format OpenImageIO reads, as 3 channels (grey is spread, alpha dropped) of finite linear values.
/// Throws Error (asset) with a plain reason for whatever is missing, truncated, corrupt, too large or not an image.
/// (OIIO reports success for truncated JPEG and TIFF; this checks has_error() too.)
Image read_image(const std::string& path, const ReadOptions& = {});

/// All channels of an EXR as stored, for comparisons.
Image read_image_raw(const std::string& path);

/// Numbers that do not fit into 32 bits with their sign are double: EXR readers know no unsigned integers.
using MetadataValue = std::variant<std::string, int, float, double>;
using Metadata = std::vector<std::pair<std::string, MetadataValue>>;

struct DisplayTransform {
    float exposure = 0;  ///< stops
    bool srgb = true;    ///< false: values are written linearly, as the 2008 program's BMP
};

/// Writes RGBA (4 channels; alpha = coverage) linear float, by the file's extension: .exr as scene-linear float with
/// `metadata` as attributes of their types; .png .bmp .jpg .tif .hdr .tga .ppm .webp .gif .dpx through OIIO:
/// .tif and .hdr as scene-linear float, all others as 8-bit RGB through `display`. Alpha is kept by EXR and TIFF;
/// a picture for looking at is opaque. Three channels (RGB) are accepted too.
///
/// Atomic: a temporary file in the same folder, fsync, re-opened and verified, then renamed; whatever fails leaves
/// the old file as it was, removes the temporary and throws Error (output) with the reason (errno text).
/// A name with an unknown extension is an Error (usage). Non-finite values are refused (Error internal): the film never
/// produces them.
void write_image(const std::string& path, const Image&, const Metadata& = {}, const DisplayTransform& = {});

/// Throws Error (usage) unless the extension is known, and Error (output) unless write_image(path) has a chance:
/// existing writable folder, not a directory. Also removes temporaries that dead processes left for this path.
void check_writable(const std::string& path);

}  // namespace drt
