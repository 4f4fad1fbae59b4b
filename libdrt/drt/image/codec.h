#pragma once
// Internal to the image room: files decoded and encoded through the libraries, without the policy around it.
// Every failure here is a std::runtime_error whose what() is the plain reason, one line, without the path.

#include <string>
#include <vector>

#include "drt/image/image.h"

namespace drt {

/// OpenEXR's process-wide settings, made once before its first use: a bound on the size that a header may claim
/// (a 50 kB file can otherwise ask for gigabytes while it is being opened) and a thread pool.
void initialize_openexr();

/// All channels as stored, as floats; integer files scaled to [0, 1], no transfer curve. `format` is an extension or
/// OpenImageIO's name of a format, for files whose own name does not tell; "" means by the name.
Image decode_all_channels(const std::string& path, const std::string& format, const ReadOptions&);

/// OpenImageIO's name of the format that writes files with this path's extension ("openexr" for .exr), "" if none.
std::string output_format(const std::string& path);

/// Every extension that output_format knows, without the dot.
std::vector<std::string> output_extensions();

/// The bytes of an EXR file: scanlines, 32-bit float, ZIP, Rec. 709 chromaticities, `metadata` as attributes.
std::vector<unsigned char> encode_exr(const Image&, const Metadata&);

/// The bytes of a file in any other format.
std::vector<unsigned char> encode_other(const std::string& format, const Image&, const DisplayTransform&);

}  // namespace drt
