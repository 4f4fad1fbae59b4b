// Programs that are stopped while they simulate.

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <thread>

#include "physics_scene.h"
#include "render_programs.h"

namespace drt {
namespace {

class BakeStops : public testing::Test {
protected:
    // Sends the signal in the middle of a simulation of minutes.
    ProcessResult stop(const std::string& program, const std::vector<std::string>& arguments, int signal) {
        test::RunningProcess process(program, arguments, {.folder = {}, .stdout_file = {}, .timeout = 20});
        const std::string maps = "/proc/" + std::to_string(process.id()) + "/maps";
        EXPECT_TRUE(wait_until([&] { return read_bytes(maps).find("libdrt-bullet") != std::string::npos; }));
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        process.send(signal);
        return process.wait();
    }

    TempFolder folder;
    std::string scene = folder.write("scene.yaml", endless_physics_scene());
};

TEST_F(BakeStops, AtOnceAndWithoutATrace) {
    const std::string out = folder.write("out.yaml", "precious");
    for (const int signal : {SIGINT, SIGTERM}) {
        const ProcessResult r = stop(DRT_BAKE, {scene, "-o", out}, signal);
        EXPECT_EQ(r.signal, signal);
        EXPECT_FALSE(r.timed_out);
    }
    EXPECT_EQ(read_bytes(out), "precious");
    EXPECT_EQ(files_in(folder), (std::vector<std::string>{"out.yaml", "scene.yaml"}));
}

TEST_F(BakeStops, RenderingWithItsExitCodesAndTheCacheAsItWas) {
#if defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "the thread sanitizer holds signals back until the next call of the system";
#endif
    setenv("XDG_CACHE_HOME", "/dev/null", 1);
    const std::string cache = folder.file("cache"), other = folder.write("other.yaml", physics_scene);
    ASSERT_EQ(render({other, "--explain", "--bake-cache", cache}).exit_code, 0);
    const std::string kept = std::filesystem::directory_iterator(cache)->path().string(), bytes = read_bytes(kept);
    struct Case {
        int signal, code;
    };
    for (const Case c : {Case{SIGINT, 130}, Case{SIGTERM, 75}}) {
        const ProcessResult r = stop(DRT_RENDER, {scene, "-o", folder.file("a.exr"), "--bake-cache", cache}, c.signal);
        EXPECT_EQ(r.exit_code, c.code) << r.signal << r.err;
        EXPECT_FALSE(r.timed_out);
    }
    EXPECT_EQ(files_in(folder), (std::vector<std::string>{"cache", "other.yaml", "scene.yaml"}));
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(cache), std::filesystem::directory_iterator()), 1);
    EXPECT_EQ(read_bytes(kept), bytes);
    EXPECT_TRUE(contains(render({other, "--explain", "-v", "--bake-cache", cache}).err, "physics: motion found"));
}

}  // namespace
}  // namespace drt
