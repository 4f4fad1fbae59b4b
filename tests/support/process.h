#pragma once
// Running the real programs in tests.

#include <filesystem>
#include <string>
#include <vector>

namespace drt::test {

/// A folder of its own, removed with everything in it at the end of its life.
class TempFolder {
public:
    TempFolder();
    ~TempFolder();
    TempFolder(const TempFolder&) = delete;
    TempFolder& operator=(const TempFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    std::string file(const std::string& name) const { return (path_ / name).string(); }
    /// Writes a file (and the folders above it) and returns its path.
    std::string write(const std::string& name, const std::string& bytes) const;

private:
    std::filesystem::path path_;
};

/// The bytes of a file; "" when there is none.
std::string read_bytes(const std::string& path);

struct ProcessResult {
    int exit_code = -1;  ///< -1 when a signal ended the process
    int signal = 0;      ///< that signal
    bool timed_out = false;
    double peak_megabytes = 0;  ///< the most memory that it held (resident, 1e6 bytes)
    std::string out, err;
};

struct ProcessOptions {
    std::string folder;       ///< to run in; "" = this process's
    std::string stdout_file;  ///< where the standard output goes instead of ProcessResult::out
    double timeout = 60;      ///< seconds, then SIGKILL
};

/// A program that is still running, started as run_process() does.
class RunningProcess {
public:
    RunningProcess(const std::string& program, const std::vector<std::string>& arguments, const ProcessOptions& = {});
    ~RunningProcess();  ///< kills it if nobody has waited for it
    RunningProcess(const RunningProcess&) = delete;
    RunningProcess& operator=(const RunningProcess&) = delete;

    int id() const { return pid_; }
    void send(int signal) const;
    std::string err_so_far() const { return read_bytes(streams_.file("err")); }
    ProcessResult wait();

private:
    TempFolder streams_;
    ProcessOptions options_;
    int pid_ = 0;
};

/// Runs a program (no shell, the environment is passed on, no standard input) and waits for its end.
/// Throws std::system_error when it cannot be started.
ProcessResult run_process(const std::string& program, const std::vector<std::string>& arguments,
                          const ProcessOptions& = {});

}  // namespace drt::test
