#include "drt/bake/cache_folder.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <tuple>
#include <vector>

namespace drt {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t key_digits = 32;
constexpr std::string_view extension = ".bake", temporary_mark = ".bake.tmp.";  // base/atomic_file.h

bool starts_with_key(std::string_view name) {
    return name.size() > key_digits && name.find_first_not_of("0123456789abcdef") == key_digits;
}

bool starts_with_magic(const fs::path& path) {
    std::array<char, bake_file_magic.size()> bytes{};
    std::ifstream(path, std::ios::binary).read(bytes.data(), bytes.size());
    return std::string_view(bytes.data(), bytes.size()) == bake_file_magic;
}

struct CacheFile {
    fs::path path;
    fs::file_time_type used;
    std::uintmax_t bytes = 0;
    bool is_temporary = false;
};

std::vector<CacheFile> files_of(const std::string& folder) {
    std::vector<CacheFile> out;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        if (!starts_with_key(name)) continue;
        const std::string_view rest = std::string_view(name).substr(key_digits);
        const bool is_temporary = rest.starts_with(temporary_mark);
        std::error_code gone;  // others prune, too
        if ((rest != extension && !is_temporary) || !fs::is_regular_file(entry.symlink_status(gone))) continue;
        const CacheFile file{entry.path(), entry.last_write_time(gone), entry.file_size(gone), is_temporary};
        if (!gone) out.push_back(file);
    }
    return out;
}

void prune(const std::string& folder, const CacheLimits& limits) {
    std::vector<CacheFile> files = files_of(folder);
    std::sort(files.begin(), files.end(), [](const CacheFile& a, const CacheFile& b) {
        return std::tie(a.used, a.path) > std::tie(b.used, b.path);
    });
    const auto yesterday = fs::file_time_type::clock::now() - std::chrono::hours(24);
    std::size_t count = 0;
    std::uintmax_t bytes = 0;
    for (const CacheFile& file : files) {
        std::error_code ignored;
        if (file.is_temporary) {
            if (file.used < yesterday) fs::remove(file.path, ignored);
            continue;
        }
        bytes += file.bytes;
        const bool has_room = ++count == 1 || (count <= limits.files && bytes <= limits.bytes);
        if (!has_room && starts_with_magic(file.path)) fs::remove(file.path, ignored);
    }
}

}  // namespace

std::string bake_file_path(const std::string& folder, const std::string& key) {
    return (fs::path(folder) / (key + std::string(extension))).string();
}

bool is_bake_file_there(const std::string& path) {
    std::error_code ignored;
    const fs::file_status status = fs::symlink_status(path, ignored);
    if (!fs::exists(status)) return false;
    if (fs::is_directory(status)) throw std::runtime_error("it is a folder");
    if (!fs::is_regular_file(status)) throw std::runtime_error("it is not a regular file");
    return true;
}

void note_use(const std::string& path) {
    std::error_code ignored;  // a cache that can only be read is one all the same
    fs::last_write_time(path, fs::file_time_type::clock::now(), ignored);
}

void prune_cache(const std::string& folder, const CacheLimits& limits) noexcept {
    try {
        prune(folder, limits);
    } catch (const std::exception&) {  // tidying up must not stop a render
    }
}

}  // namespace drt
