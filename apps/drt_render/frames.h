#pragma once
// Frame lists and frame numbers in file names.

#include <string>
#include <vector>

namespace drt {

/// "7" -> 7. Throws Error (usage) for anything but one frame >= 0.
int parse_frame(const std::string& text);

/// "7", "1-100", "1-100:2", "1-10,50,60-70:5" -> the frames in the order written, without repeats. Frames are >= 0.
/// Throws Error (usage), also for more than a million frames.
std::vector<int> parse_frames(const std::string& text);

/// Replaces each "####" (as many digits as there are #) and each "%04d" by the frame's number. A name without a token
/// stays as it is for a single frame; for several, ".0007" goes in front of the extension, so that none overwrites
/// another.
std::string frame_path(const std::string& pattern, int frame, bool several_frames);

}  // namespace drt
