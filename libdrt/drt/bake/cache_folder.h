#pragma once
// The folder that the cache's files lie in, beside whatever else may be there.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace drt {

/// What every file of the cache begins with.
inline constexpr std::string_view bake_file_magic = "drt bake\n";

/// No file of the cache is larger, in bytes: two million keys.
inline constexpr std::uintmax_t largest_bake_file = std::uintmax_t(256) << 20;

/// The file for a key of 32 hexadecimal digits.
std::string bake_file_path(const std::string& folder, const std::string& key);

/// Is there a file? Throws std::runtime_error for what is neither a file nor nothing: a folder, a pipe, a link to
/// anywhere.
bool is_bake_file_there(const std::string& path);

/// Files are deleted in the order of their last use.
void note_use(const std::string& path);

struct CacheLimits {
    std::size_t files = 1000;
    std::uintmax_t bytes = std::uintmax_t(1) << 30;
};

/// Deletes the files that were not used for longest until the rest is within the limits (the latest stays in any case),
/// and temporary files that a killed process left a day ago. Never deletes anything but regular files with the names
/// and the first bytes of the cache's. Does what it can and never throws. Others may read, write and prune at the same
/// time: who has a file open goes on reading it, who finds it gone computes its motion anew.
void prune_cache(const std::string& folder, const CacheLimits& = {}) noexcept;

}  // namespace drt
