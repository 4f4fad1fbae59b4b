// The progress bar, on a terminal.
#include <pty.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "render_programs.h"

namespace drt {
namespace {

struct Terminal {
    unsigned short columns = 80;
    const char* type = "xterm";
};

/// Runs drt-render on a terminal of its own; returns all that appeared there.
std::string render_on(const Terminal& terminal, const std::vector<std::string>& arguments, int* exit_code) {
    std::vector<char*> argv{const_cast<char*>(DRT_RENDER)};
    for (const std::string& a : arguments) argv.push_back(const_cast<char*>(a.c_str()));
    argv.push_back(nullptr);
    setenv("TERM", terminal.type, 1);
    winsize size{24, terminal.columns, 0, 0};
    int screen = -1;
    const pid_t pid = forkpty(&screen, nullptr, nullptr, &size);
    if (pid == 0) {
        execv(argv[0], argv.data());
        _exit(127);
    }
    *exit_code = -1;
    if (pid < 0) return std::string("forkpty: ") + std::strerror(errno);
    std::string seen;
    char buffer[4096];
    ssize_t n = 0;
    while ((n = read(screen, buffer, sizeof buffer)) > 0) seen.append(buffer, size_t(n));
    close(screen);
    int status = 0;
    waitpid(pid, &status, 0);
    *exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return seen;
}

class RenderTerminal : public testing::Test {
protected:
    void SetUp() override {
        int screen = -1, program = -1;
        if (openpty(&screen, &program, nullptr, nullptr, nullptr) != 0)
            GTEST_SKIP() << "this system has no pseudo-terminals: " << std::strerror(errno);
        close(screen);
        close(program);
    }

    std::string run(const Terminal& terminal, const std::vector<std::string>& options) {
        std::vector<std::string> all{scene_, "-t", "1", "-o", folder_.file("a.exr")};
        all.insert(all.end(), options.begin(), options.end());
        int code = -1;
        const std::string seen = render_on(terminal, all, &code);
        EXPECT_EQ(code, 0) << seen;
        return seen;
    }

    TempFolder folder_;
    std::string scene_ = folder_.write("scene.yaml", small_scene);
};

const std::vector<std::string> short_render{"--spp", "16777216", "--time-limit", "0.3"};

TEST_F(RenderTerminal, ShowsABarAndLeavesACleanLine) {
    const std::string seen = run({}, short_render);
    EXPECT_TRUE(contains(seen, "=>"));
    EXPECT_TRUE(contains(seen, "% \r"));
    // The bar is wiped with blanks before the first line that stays.
    const size_t wrote = seen.find("wrote ");
    ASSERT_NE(wrote, std::string::npos) << seen;
    EXPECT_EQ(seen.substr(wrote - 79, 79), std::string(78, ' ') + '\r');
    EXPECT_EQ(seen.find('[', wrote), std::string::npos) << seen;
}

TEST_F(RenderTerminal, NarrowOrDumbTerminalsGetLines) {
    EXPECT_EQ(run({.columns = 60, .type = "xterm"}, short_render).find("=>"), std::string::npos);
    EXPECT_EQ(run({.columns = 80, .type = "dumb"}, short_render).find("=>"), std::string::npos);
}

TEST_F(RenderTerminal, CanDoWithoutABar) {
    EXPECT_EQ(run({}, {"--progress", "none"}).find('['), std::string::npos);
    EXPECT_EQ(run({}, {"--quiet"}), "");
}

}  // namespace
}  // namespace drt
