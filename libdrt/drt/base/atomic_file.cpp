#include "drt/base/atomic_file.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <random>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

namespace drt {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void throw_errno(const std::string& what, int code = errno) {
    throw std::system_error(code, std::generic_category(), what);
}

/// An open file descriptor. close() is where some file systems (NFS, quotas) report that a write failed, so it is
/// explicit; the destructor only cleans up after an exception.
class Descriptor {
public:
    Descriptor(const std::string& path, int flags) : fd_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {
        if (fd_ < 0) throw_errno(path);
    }
    ~Descriptor() {
        if (fd_ >= 0) ::close(fd_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    int get() const { return fd_; }
    void close() {
        if (::close(std::exchange(fd_, -1)) != 0) throw_errno("close");
    }

private:
    int fd_;
};

/// Removes its file unless it has been renamed away.
class Temporary {
public:
    explicit Temporary(std::string path) : path_(std::move(path)) {}
    ~Temporary() {
        if (!path_.empty()) ::unlink(path_.c_str());
    }
    Temporary(const Temporary&) = delete;
    Temporary& operator=(const Temporary&) = delete;

    const std::string& path() const { return path_; }
    void rename_to(const std::string& target) {
        if (::rename(path_.c_str(), target.c_str()) != 0) throw_errno("rename");
        path_.clear();
    }

private:
    std::string path_;
};

/// The id of this boot of this kernel, which containers share with their host, and the pid namespace: what makes a
/// process id unique. Without /proc it is a random number, which nobody else has, so nobody removes the temporary.
std::string place_of_pids() {
    std::string boot;
    std::ifstream("/proc/sys/kernel/random/boot_id") >> boot;  // 8-4-4-4-12 hexadecimal digits
    std::error_code error;
    const std::string space = fs::read_symlink("/proc/self/ns/pid", error).string();  // "pid:[4026531836]"
    const size_t digits = space.find_first_of("0123456789");
    if (boot.size() == 36 && digits != std::string::npos)
        return boot.substr(0, 8) + boot.substr(9, 4) + '-' + space.substr(digits, space.find(']') - digits);
    static const std::string random = std::to_string(std::random_device()());
    return "unknown-" + random;
}

/// `<file>.tmp.<place>.`, which the process id and a number follow.
std::string temporary_prefix(const std::string& file) { return file + ".tmp." + place_of_pids() + '.'; }

std::string temporary_name(const std::string& path) {
    static std::atomic<unsigned> counter = 0;
    return temporary_prefix(path) + std::to_string(::getpid()) + '.' + std::to_string(counter++);
}

std::string folder_of(const std::string& path) {
    const fs::path parent = fs::path(path).parent_path();
    return parent.empty() ? "." : parent.string();
}

void sync(const std::string& path, int flags) {
    Descriptor file(path, flags);
    // Some file systems cannot sync a folder (EINVAL); then there is nothing to wait for.
    if (::fsync(file.get()) != 0 && errno != EINVAL) throw_errno("fsync");
    file.close();
}

bool is_dead(long pid) { return pid > 0 && ::kill(pid_t(pid), 0) != 0 && errno == ESRCH; }

/// The process in a file name `<prefix><pid>.<n>`, 0 when it is not such a name.
long temporary_owner(std::string_view file, std::string_view prefix) {
    if (!file.starts_with(prefix)) return 0;
    file.remove_prefix(prefix.size());
    int pid = 0;
    const auto [end, error] = std::from_chars(file.data(), file.data() + file.size(), pid);
    return error == std::errc{} && end != file.data() + file.size() && *end == '.' ? pid : 0;
}

}  // namespace

std::string follow_links(const std::string& path) {
    constexpr int most_links = 40;  // as the kernel
    fs::path target = path;
    for (int links = 0; fs::is_symlink(target); ++links) {
        if (links == most_links) throw_errno(path, ELOOP);
        target = target.parent_path() / fs::read_symlink(target);
    }
    return target.string();
}

void write_bytes(const std::string& path, std::span<const unsigned char> bytes) {
    Descriptor file(path, O_WRONLY | O_CREAT | O_TRUNC);
    while (!bytes.empty()) {
        const ssize_t written = ::write(file.get(), bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) throw_errno("write");
        bytes = bytes.subspan(size_t(written));
    }
    file.close();
}

void replace_file(const std::string& path, const std::function<void(const std::string&)>& write,
                  const std::function<void(const std::string&)>& verify) {
    const std::string target = follow_links(path);
    Temporary temporary(temporary_name(target));
    write(temporary.path());
    sync(temporary.path(), O_RDONLY);
    verify(temporary.path());
    temporary.rename_to(target);
    sync(folder_of(target), O_RDONLY | O_DIRECTORY);
}

void check_replaceable(const std::string& path) {
    struct stat status = {};
    if (::stat(path.c_str(), &status) == 0) {
        if (S_ISDIR(status.st_mode)) throw_errno(path, EISDIR);
        if (!S_ISREG(status.st_mode)) throw std::runtime_error("it is not a regular file");
    } else if (errno != ENOENT) {
        throw_errno(path);
    }
    const std::string target = follow_links(path), folder = folder_of(target);
    std::error_code unknown;  // then sync() says why
    if (fs::status(folder, unknown).type() == fs::file_type::not_found)
        throw std::runtime_error("the folder \"" + folder + "\" does not exist");
    sync(folder, O_RDONLY | O_DIRECTORY);
    const Temporary probe(temporary_name(target));
    Descriptor(probe.path(), O_WRONLY | O_CREAT | O_EXCL).close();
}

void remove_stale_temporaries(const std::string& path) {
    const fs::path target = follow_links(path);
    const std::string prefix = temporary_prefix(target.filename().string());
    std::error_code ignored;  // tidying up must not stop a render
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_of(target.string()), ignored))
        if (is_dead(temporary_owner(entry.path().filename().string(), prefix))) fs::remove(entry.path(), ignored);
}

}  // namespace drt
