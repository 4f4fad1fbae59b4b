#pragma once
// What a run prints: progress, notes, the summary. Everything goes to stderr, a flushed line at a time, and never
// fails: nobody loses a picture because a log could not be written.

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "drt/render/render.h"
#include "options.h"

namespace drt {

class Console {
public:
    Console(bool quiet, bool verbose, ProgressStyle style);
    ~Console();
    Console(const Console&) = delete;
    Console& operator=(const Console&) = delete;

    /// Warnings always (unless quiet), notes when verbose; each once, though every frame may have it.
    void print(const Diagnostics&);
    void note(const std::string& line);     ///< unless quiet
    void alert(const std::string& line);    ///< always, quiet or not
    void verbose(const std::string& line);  ///< when verbose

    void progress(const Progress&);
    void end_progress();  ///< takes the bar off the terminal

private:
    struct Bar;
    void print_line(const std::string&);
    bool quiet_, verbose_;
    ProgressStyle style_;
    std::unique_ptr<Bar> bar_;
    double last_line_ = 0;
    std::set<std::string> printed_;
};

std::string explain_text(const Explanation&);

/// Samples, estimated error, rays by kind, rays per second, time per stage, memory.
std::string summary(const RenderResult&, bool verbose);

/// A warning for each kind of thing that is wrong with the picture.
std::vector<std::string> faults(const RenderResult&);

}  // namespace drt
