#include "drt/base/atomic_file.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <charconv>
#include <filesystem>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

namespace drt {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view temporary_infix = ".tmp.";

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

std::string temporary_name(const std::string& path) {
    static std::atomic<unsigned> counter = 0;
    return path + std::string(temporary_infix) + std::to_string(::getpid()) + '.' + std::to_string(counter++);
}

std::string folder_of(const std::string& path) {
    const fs::path parent = fs::path(path).parent_path();
    return parent.empty() ? "." : parent.string();
}

/// Follows links, so that `rename` replaces the file and not the link to it.
std::string resolve(const std::string& path) {
    return fs::is_symlink(path) ? fs::weakly_canonical(path).string() : path;
}

void sync(const std::string& path, int flags) {
    Descriptor file(path, flags);
    // Some file systems cannot sync a folder (EINVAL); then there is nothing to wait for.
    if (::fsync(file.get()) != 0 && errno != EINVAL) throw_errno("fsync");
    file.close();
}

bool is_dead(long pid) { return pid > 0 && ::kill(pid_t(pid), 0) != 0 && errno == ESRCH; }

/// The process in a file name `<name>.tmp.<pid>[.<n>]`, 0 when it is not such a name.
long temporary_owner(std::string_view file, std::string_view name) {
    if (!file.starts_with(name)) return 0;
    file.remove_prefix(name.size());
    if (!file.starts_with(temporary_infix)) return 0;
    file.remove_prefix(temporary_infix.size());
    int pid = 0;
    const auto [end, error] = std::from_chars(file.data(), file.data() + file.size(), pid);
    const bool complete = end == file.data() + file.size() || *end == '.';
    return error == std::errc{} && complete ? pid : 0;
}

}  // namespace

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
    const std::string target = resolve(path);
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
    const std::string target = resolve(path);
    sync(folder_of(target), O_RDONLY | O_DIRECTORY);
    const Temporary probe(temporary_name(target));
    Descriptor(probe.path(), O_WRONLY | O_CREAT | O_EXCL).close();
}

void remove_stale_temporaries(const std::string& path) {
    const fs::path target = resolve(path);
    const std::string name = target.filename().string();
    std::error_code ignored;  // tidying up must not stop a render
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_of(target.string()), ignored))
        if (is_dead(temporary_owner(entry.path().filename().string(), name))) fs::remove(entry.path(), ignored);
}

}  // namespace drt
