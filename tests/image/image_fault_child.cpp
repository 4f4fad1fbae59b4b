// The child process of write_faults_test.cpp. Exit codes: 0 as it should be, 77 this machine cannot make the fault,
// 1 wrong (the reason on stderr).
//
//   image_fault_child loop FILE           writes FILE again and again until it is killed
//   image_fault_child size-limit FOLDER   file size limit (EFBIG) in the middle and near the end of a picture
//   image_fault_child full-disk FOLDER    the same on a file system of 200 kB, mounted for this process alone

#include <sched.h>
#include <signal.h>
#include <sys/mount.h>
#include <sys/resource.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "drt/base/diagnostic.h"
#include "image/image_files.h"

namespace {

using namespace drt;

[[noreturn]] void wrong(const std::string& why) {
    std::fprintf(stderr, "%s\n", why.c_str());
    std::exit(1);
}

[[noreturn]] void loop(const std::string& path) {
    for (int round = 0;; ++round) {
        Image image = noisy_picture(256, 128);
        image.data[0] = float(round);
        write_image(path, image);
    }
}

void limit_file_size(rlim_t bytes) {
    const rlimit limit = {bytes, RLIM_INFINITY};
    if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) std::exit(77);
}

/// The picture `path` holds is `old`; writing `big` must fail with one of the reasons and leave everything as it was.
void expect_failure(const std::string& path, const Image& big, const Image& old, const std::string& reason) {
    const std::string before = read_bytes(path);
    try {
        write_image(path, big);
        wrong(path + ": writing succeeded");
    } catch (const Error& e) {
        if (e.kind() != ErrorKind::output) wrong(path + ": wrong kind of error");
        if (std::string(e.what()).find(reason) == std::string::npos) wrong(std::string("another reason: ") + e.what());
    }
    if (read_bytes(path) != before) wrong(path + ": the old file has changed");
    if (read_image_raw(path).width != old.width) wrong(path + ": the old file does not read");
    const auto folder = std::filesystem::path(path).parent_path();
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().string().find(".tmp.") != std::string::npos) wrong("temporary left: " + entry.path().string());
}

void size_limit(const std::string& folder) {
    ::signal(SIGXFSZ, SIG_IGN);
    const Image old = noisy_picture(16, 16), big = noisy_picture(128, 128);
    for (const char* name : {"a.exr", "a.png", "a.bmp", "a.hdr", "a.jpg", "a.tga", "a.tif"}) {
        const std::string path = folder + '/' + name;
        limit_file_size(RLIM_INFINITY);
        write_image(path, big);
        const auto whole = std::filesystem::file_size(path);
        write_image(path, old);
        for (const rlim_t limit : {rlim_t(0), whole / 2, whole - 1}) {
            limit_file_size(limit);
            expect_failure(path, big, old, "File too large");
        }
        limit_file_size(whole);
        write_image(path, big);
    }
}

void full_disk(const std::string& folder) {
    if (::unshare(CLONE_NEWNS) != 0 && ::unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0) std::exit(77);
    ::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr);  // the mount must not outlive this process
    if (::mount("drt", folder.c_str(), "tmpfs", 0, "size=200k") != 0) std::exit(77);
    const Image old = noisy_picture(16, 16);
    for (const char* name : {"a.exr", "a.png", "a.bmp", "a.tif"}) {
        const std::string path = folder + '/' + name;
        write_image(path, old);
        expect_failure(path, noisy_picture(400, 400), old, "No space left");
        std::filesystem::remove(path);
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) return 1;
    const std::string mode = argv[1];
    try {
        if (mode == "loop") loop(argv[2]);
        if (mode == "size-limit") size_limit(argv[2]);
        if (mode == "full-disk") full_disk(argv[2]);
    } catch (const std::exception& e) {
        wrong(e.what());
    }
    return 0;
}
