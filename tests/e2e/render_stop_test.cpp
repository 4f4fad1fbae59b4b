// When a render stops: samples, time, signals; and what can be seen before it does.
#include <chrono>
#include <csignal>
#include <filesystem>
#include <memory>

#include "render_programs.h"

namespace drt {
namespace {

using Clock = std::chrono::steady_clock;

const std::string endless = "16777216";

class RenderStops : public testing::Test {
protected:
    std::vector<std::string> arguments(const std::vector<std::string>& options) const {
        std::vector<std::string> all{scene_, "-o", out_, "-t", "1"};
        all.insert(all.end(), options.begin(), options.end());
        return all;
    }
    int spp(const std::string& path) const { return std::get<int>(exr_attributes(path)["drt:spp"]); }

    /// Starts an endless render and returns when the first pass is done.
    std::unique_ptr<test::RunningProcess> start(std::vector<std::string> options = {}) {
        options.insert(options.end(), {"--spp", endless, "--snapshot", snapshot_ + ":0.05"});
        auto process = std::make_unique<test::RunningProcess>(DRT_RENDER, arguments(options));
        EXPECT_TRUE(wait_until([&] { return std::filesystem::exists(snapshot_); }));
        return process;
    }

    TempFolder folder_;
    std::string scene_ = folder_.write("scene.yaml", small_scene);
    std::string out_ = folder_.file("a.exr"), snapshot_ = folder_.file("snapshot.exr");
};

TEST_F(RenderStops, AtTheSamplesAskedFor) {
    for (const std::string n : {"1", "3", "33"}) {
        ASSERT_EQ(render(arguments({"--spp", n, "--time-limit", "1h"})).exit_code, 0);
        EXPECT_EQ(spp(out_), std::stoi(n));
    }
}

TEST_F(RenderStops, AtTheTimeLimit) {
    const auto begin = Clock::now();
    const ProcessResult r = render(arguments({"--spp", endless, "--time-limit", "0.3s"}));
    const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    ASSERT_EQ(r.exit_code, 0) << r.err;
    EXPECT_TRUE(contains(r.err, "time limit reached: "));
    EXPECT_GE(spp(out_), 1);
    EXPECT_GE(std::get<float>(exr_attributes(out_)["drt:renderSeconds"]), 0.1);
    EXPECT_LT(seconds, 20);
}

TEST_F(RenderStops, NotBeforeEveryPixelHasASample) {
    ASSERT_EQ(render(arguments({"--spp", endless, "--time-limit", "0.000001", "-r", "200x100"})).exit_code, 0);
    EXPECT_EQ(spp(out_), 1);
    const Image image = read_image_raw(out_);
    for (int y = 0; y < image.height; ++y)  // everything shines in blue or red, if only by ambient light
        for (int x = 0; x < image.width; ++x)
            ASSERT_GT(image.pixel(x, y)[0] + image.pixel(x, y)[2], 0) << x << ' ' << y;
}

TEST_F(RenderStops, BySignalsWithThePictureSoFar) {
    struct Case {
        int signal, code;
    };
    for (const Case c : {Case{SIGINT, 130}, Case{SIGTERM, 75}}) {
        const auto process = start();
        process->send(c.signal);
        const ProcessResult r = process->wait();
        EXPECT_EQ(r.exit_code, c.code) << r.err;
        EXPECT_TRUE(contains(r.err, "interrupted: "));
        const size_t note = r.err.find("stopping: finishing the tiles at hand\n");
        EXPECT_LT(note, r.err.find("wrote ")) << r.err;
        EXPECT_EQ(note, r.err.rfind("stopping: ")) << r.err;
        EXPECT_GE(spp(out_), 1);
        EXPECT_EQ(read_image_raw(out_).width, 24);
        EXPECT_EQ(files_in(folder_), (std::vector<std::string>{"a.exr", "scene.yaml", "snapshot.exr"}));
        std::filesystem::remove(out_);
        std::filesystem::remove(snapshot_);
    }
}

TEST_F(RenderStops, AllFramesAtTheFirstSignal) {
    const auto process = start({"--frames", "0-9"});
    process->send(SIGTERM);
    EXPECT_EQ(process->wait().exit_code, 75);
    EXPECT_EQ(files_in(folder_), (std::vector<std::string>{"a.0000.exr", "scene.yaml", "snapshot.exr"}));
}

TEST_F(RenderStops, AtOnceByTheSecondSignal) {
#if defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "the thread sanitizer holds signals back until the next call of the system";
#endif
    const auto process = start();
    process->send(SIGSTOP);  // so that both are there when it goes on
    process->send(SIGINT);
    process->send(SIGTERM);
    process->send(SIGCONT);
    const ProcessResult r = process->wait();
    EXPECT_TRUE(r.exit_code == 128 + SIGINT || r.exit_code == 128 + SIGTERM) << r.exit_code;
    EXPECT_FALSE(std::filesystem::exists(out_));
}

TEST_F(RenderStops, SnapshotsAreWholePicturesThatGetBetter) {
    const auto process = start();
    const int first = spp(snapshot_);
    EXPECT_TRUE(wait_until([&] {
        EXPECT_EQ(read_image_raw(snapshot_).width, 24);  // at any time
        return spp(snapshot_) > 2 * first;
    }));
    EXPECT_FALSE(std::filesystem::exists(out_));
    process->send(SIGINT);
    EXPECT_EQ(process->wait().exit_code, 130);
    EXPECT_GE(spp(out_), spp(snapshot_));
}

TEST_F(RenderStops, SnapshotsMayHaveAColonInTheirName) {
    const std::string path = folder_.file("a:b.png");
    ASSERT_EQ(render(arguments({"--snapshot", path})).exit_code, 0);
    EXPECT_EQ(read_image(path).width, 24);
}

TEST_F(RenderStops, ALostSnapshotCostsNoPicture) {
    std::filesystem::create_directory(folder_.path() / "sub");
    snapshot_ = folder_.file("sub/snapshot.exr");
    const auto process = start();
    std::filesystem::rename(folder_.path() / "sub", folder_.path() / "gone");
    EXPECT_TRUE(wait_until([&] { return process->err_so_far().find("warning: snapshot: ") != std::string::npos; }));
    process->send(SIGINT);
    EXPECT_EQ(process->wait().exit_code, 130);
    EXPECT_GE(spp(out_), 1);
}

TEST_F(RenderStops, PlainProgressIsLinesThatArriveAtOnce) {
    const auto process = start({"--progress", "plain"});
    EXPECT_TRUE(wait_until([&] { return process->err_so_far().find(" s left\n") != std::string::npos; }));
    process->send(SIGINT);
    const ProcessResult r = process->wait();
    EXPECT_EQ(r.err.find("progress "), 0u) << r.err;  // how many percent depends on the machine
    EXPECT_EQ(r.err.find('\r'), std::string::npos) << r.err;
}

}  // namespace
}  // namespace drt
