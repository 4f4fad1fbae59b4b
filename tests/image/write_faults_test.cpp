// Full disks, size limits and SIGKILL: the previous file stays whole (numerics: table D3, row W1).
#include <gtest/gtest.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>

#include <chrono>
#include <thread>

#include "drt/base/atomic_file.h"
#include "drt/base/diagnostic.h"
#include "image/image_files.h"

namespace drt {
namespace {

pid_t start_child(const std::string& mode, const std::string& path) {
    std::string program = DRT_IMAGE_FAULT_CHILD, m = mode, p = path;
    char* arguments[] = {program.data(), m.data(), p.data(), nullptr};
    pid_t pid = 0;
    if (::posix_spawn(&pid, program.c_str(), nullptr, nullptr, arguments, environ) != 0) return -1;
    return pid;
}

int exit_code(pid_t pid) {
    int status = 0;
    ::waitpid(pid, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

TEST(WriteFaults, SizeLimitLeavesTheOldFile) {
    const TestFolder folder;
    EXPECT_EQ(exit_code(start_child("size-limit", folder.path().string())), 0);
}

TEST(WriteFaults, FullDiskLeavesTheOldFile) {
    const TestFolder folder;
    const int code = exit_code(start_child("full-disk", folder.path().string()));
    if (code == 77) GTEST_SKIP() << "mounting a small tmpfs is not permitted here";
    EXPECT_EQ(code, 0);
}

TEST(WriteFaults, EveryWrittenByteIsChecked) {
    const std::vector<unsigned char> bytes(1000);
    try {
        write_bytes("/dev/full", bytes);
        FAIL() << "writing to a full device succeeded";
    } catch (const std::system_error& e) {
        EXPECT_EQ(e.code().value(), ENOSPC);
    }
}

TEST(WriteFaults, AFileThatDoesNotVerifyIsNotPutInPlace) {
    const TestFolder folder;
    const std::string path = folder.file("a");
    write_text(path, "old");
    const auto short_write = [](const std::string& file) { write_text(file, "ne"); };
    const auto verify = [](const std::string& file) {
        if (read_bytes(file) != "new") throw std::runtime_error("short");
    };
    EXPECT_THROW(replace_file(path, short_write, verify), std::runtime_error);
    EXPECT_EQ(read_bytes(path), "old");
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(WriteFaults, KilledAnywhereTheFileIsWhole) {
    const TestFolder folder;
    const std::string path = folder.file("a.exr");
    write_image(path, noisy_picture(256, 128));
    for (int kill = 0; kill < 20; ++kill) {
        const pid_t child = start_child("loop", path);
        ASSERT_GT(child, 0);
        std::this_thread::sleep_for(std::chrono::milliseconds(30 + 7 * kill));
        ::kill(child, SIGKILL);
        EXPECT_EQ(exit_code(child), -SIGKILL);
        EXPECT_NO_THROW(EXPECT_EQ(read_image_raw(path).width, 256));
    }
    check_writable(path);
    EXPECT_EQ(folder.entries(), 1u) << "temporaries of dead processes must go";
}

}  // namespace
}  // namespace drt
