#include "support/process.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <sstream>
#include <system_error>
#include <thread>
#include <utility>

namespace drt::test {
namespace {

void check(int error, const std::string& what) {
    if (error != 0) throw std::system_error(error, std::generic_category(), what);
}

/// What the child does between fork and exec: its folder and its three streams.
class FileActions {
public:
    FileActions() { check(posix_spawn_file_actions_init(&actions_), "posix_spawn_file_actions_init"); }
    ~FileActions() { posix_spawn_file_actions_destroy(&actions_); }
    FileActions(const FileActions&) = delete;
    FileActions& operator=(const FileActions&) = delete;
    void open(int fd, const std::string& path, int flags) {
        check(posix_spawn_file_actions_addopen(&actions_, fd, path.c_str(), flags, 0600), path);
    }
    void change_folder(const std::string& folder) {
        check(posix_spawn_file_actions_addchdir_np(&actions_, folder.c_str()), folder);
    }
    const posix_spawn_file_actions_t* get() const { return &actions_; }

private:
    posix_spawn_file_actions_t actions_{};
};

pid_t spawn(const std::string& program, const std::vector<std::string>& arguments, const FileActions& actions) {
    std::vector<char*> argv{const_cast<char*>(program.c_str())};
    for (const std::string& a : arguments) argv.push_back(const_cast<char*>(a.c_str()));
    argv.push_back(nullptr);
    pid_t pid = 0;
    check(posix_spawn(&pid, program.c_str(), actions.get(), nullptr, argv.data(), environ), program);
    return pid;
}

void wait_for(pid_t pid, double timeout, ProcessResult& result) {
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::duration<double>(timeout);
    int status = 0;
    rusage usage{};
    pid_t done = 0;
    while ((done = wait4(pid, &status, WNOHANG, &usage)) == 0) {
        if (!result.timed_out && Clock::now() > end) {
            result.timed_out = true;
            kill(pid, SIGKILL);
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    if (done < 0) check(errno, "wait4");
    result.peak_megabytes = double(usage.ru_maxrss) * 1024e-6;
    if (WIFEXITED(status)) result.exit_code = WEXITSTATUS(status);
    if (WIFSIGNALED(status)) result.signal = WTERMSIG(status);
}

}  // namespace

TempFolder::TempFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "drt-test-XXXXXX").string();
    if (!mkdtemp(name.data())) check(errno, name);
    path_ = name;
}

TempFolder::~TempFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

std::string TempFolder::write(const std::string& name, const std::string& bytes) const {
    const std::filesystem::path p = path_ / name;
    std::filesystem::create_directories(p.parent_path());
    std::ofstream(p, std::ios::binary) << bytes;
    return p.string();
}

std::string read_bytes(const std::string& path) {
    std::ostringstream out;
    out << std::ifstream(path, std::ios::binary).rdbuf();
    return out.str();
}

RunningProcess::RunningProcess(const std::string& program, const std::vector<std::string>& arguments,
                               const ProcessOptions& options)
    : options_(options) {
    FileActions actions;
    const std::string out = options.stdout_file.empty() ? streams_.file("out") : options.stdout_file;
    actions.open(STDIN_FILENO, "/dev/null", O_RDONLY);
    actions.open(STDOUT_FILENO, out, O_WRONLY | O_CREAT | O_TRUNC);
    actions.open(STDERR_FILENO, streams_.file("err"), O_WRONLY | O_CREAT | O_TRUNC);
    if (!options.folder.empty()) actions.change_folder(options.folder);
    pid_ = spawn(program, arguments, actions);
}

RunningProcess::~RunningProcess() {
    if (pid_ == 0) return;
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
}

void RunningProcess::send(int signal) const { check(kill(pid_, signal) == 0 ? 0 : errno, "kill"); }

ProcessResult RunningProcess::wait() {
    ProcessResult result;
    wait_for(std::exchange(pid_, 0), options_.timeout, result);
    if (options_.stdout_file.empty()) result.out = read_bytes(streams_.file("out"));
    result.err = err_so_far();
    return result;
}

ProcessResult run_process(const std::string& program, const std::vector<std::string>& arguments,
                          const ProcessOptions& options) {
    return RunningProcess(program, arguments, options).wait();
}

}  // namespace drt::test
