#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <system_error>

#include "drt/base/atomic_file.h"
#include "drt/base/diagnostic.h"
#include "drt/image/codec.h"
#include "drt/image/image.h"

namespace drt {
namespace {

std::string prefix(const std::string& path) { return "cannot write image \"" + path + "\": "; }

std::string known_format(const std::string& path) {
    std::string format = output_format(path);
    if (!format.empty()) return format;
    std::string known;
    for (const std::string& e : output_extensions()) known += (known.empty() ? "." : ", .") + e;
    const std::string extension = std::filesystem::path(path).extension().string();
    const std::string reason = extension.empty() ? "the name has no extension" : "unknown file type " + extension;
    Diagnostic diagnostic;
    diagnostic.message = prefix(path) + reason;
    diagnostic.expected = "one of " + known;
    throw Error(ErrorKind::usage, Diagnostics{diagnostic});
}

void check_pixels(const std::string& path, const Image& image) {
    const bool shape = image.width > 0 && image.height > 0 && (image.channels == 3 || image.channels == 4) &&
                       image.data.size() == size_t(image.width) * size_t(image.height) * size_t(image.channels);
    if (!shape) throw Error(ErrorKind::internal, prefix(path) + "the picture must be RGB or RGBA and not empty");
    for (size_t i = 0; i < image.data.size(); ++i)
        if (!std::isfinite(image.data[i])) {
            const size_t pixel = i / size_t(image.channels), width = size_t(image.width);
            throw Error(ErrorKind::internal, prefix(path) + "pixel (" + std::to_string(pixel % width) + ", " +
                                                 std::to_string(pixel / width) + ") is not a finite number");
        }
}

/// Decodes the file from disk: an EXR must give back the very bits, other formats the size.
void verify(const std::string& file, const std::string& format, const Image& image) {
    ReadOptions limits;
    limits.max_side = std::max(image.width, image.height);
    limits.max_bytes = std::uint64_t(image.width) * std::uint64_t(image.height) * 64 * sizeof(float);
    Image stored;
    try {
        stored = decode_all_channels(file, format, limits);
    } catch (const std::runtime_error& e) {
        throw std::runtime_error(std::string("the written file does not read back (disk full?): ") + e.what());
    }
    if (stored.width != image.width || stored.height != image.height)
        throw std::runtime_error("the written file reads back with another size");
    if (format == "openexr" && (stored.data.size() != image.data.size() ||
                                std::memcmp(stored.data.data(), image.data.data(), image.data.size() * sizeof(float))))
        throw std::runtime_error("the written file reads back with other pixels");
}

/// Runs `body`; whatever it throws becomes an Error that names the file. errno texts come without the inner path.
template <class Body>
void reporting(const std::string& path, Body&& body) {
    try {
        body();
    } catch (const Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw Error(ErrorKind::memory, prefix(path) + "out of memory");
    } catch (const std::system_error& e) {
        throw Error(ErrorKind::output, prefix(path) + e.code().message());
    } catch (const std::exception& e) {
        throw Error(ErrorKind::output, prefix(path) + e.what());
    }
}

}  // namespace

void write_image(const std::string& path, const Image& image, const Metadata& metadata,
                 const DisplayTransform& display) {
    const std::string format = known_format(path);
    check_pixels(path, image);
    const auto write = [&](const std::string& file) {
        write_bytes(file, format == "openexr" ? encode_exr(image, metadata) : encode_other(format, image, display));
    };
    reporting(path, [&] { replace_file(path, write, [&](const std::string& file) { verify(file, format, image); }); });
}

void check_writable(const std::string& path) {
    known_format(path);
    reporting(path, [&] {
        check_replaceable(path);
        remove_stale_temporaries(path);
    });
}

}  // namespace drt
