#include "console.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <osmium/util/progress_bar.hpp>
#include <string_view>

#include "apps/standard_streams.h"

namespace drt {

namespace {

constexpr size_t bar_units = 1000;
constexpr double seconds_between_lines = 2;

constexpr int bar_columns = 79;

// Can the bar be drawn and redrawn in place? A narrower terminal would wrap it.
bool shows_bar(int stream) {
    const char* terminal = std::getenv("TERM");  // NOLINT(concurrency-mt-unsafe): nothing writes the environment
    if (!isatty(stream) || !terminal || std::string_view(terminal) == "dumb") return false;
    winsize size{};
    const bool known = ioctl(stream, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
    return !known || size.ws_col >= bar_columns;
}

ProgressStyle resolve(ProgressStyle style, bool quiet) {
    if (quiet) return ProgressStyle::none;
    if (style != ProgressStyle::automatic) return style;
    return shows_bar(STDERR_FILENO) ? ProgressStyle::bar : ProgressStyle::plain;
}

}  // namespace

struct Console::Bar : osmium::ProgressBar {
    Bar() : ProgressBar(bar_units, true) {}
    // The library's bar ends by showing 100 %, which is not true of a render that was stopped. A disabled one ends in
    // silence.
    ~Bar() {
        remove();
        static_cast<ProgressBar&>(*this) = ProgressBar(bar_units, false);
    }
    Bar(const Bar&) = delete;
    Bar& operator=(const Bar&) = delete;
};

Console::Console(bool quiet, bool verbose, ProgressStyle style)
    : quiet_(quiet), verbose_(verbose), style_(resolve(style, quiet)) {}

Console::~Console() = default;

void Console::print_line(const std::string& line) {
    if (bar_) bar_->remove();  // it comes back with the next progress
    write_stderr(line + '\n');
}

void Console::print(const Diagnostics& ds) {
    for (const Diagnostic& d : ds) {
        const bool shown = !quiet_ && (verbose_ || d.severity != Severity::note);
        if (shown && printed_.insert(to_string(d)).second) print_line(to_string(d));
    }
}

void Console::note(const std::string& line) {
    if (!quiet_) print_line(line);
}

void Console::alert(const std::string& line) { print_line(line); }

void Console::verbose(const std::string& line) {
    if (verbose_ && !quiet_) print_line(line);
}

void Console::progress(const Progress& p) {
    if (style_ == ProgressStyle::bar) {
        if (!bar_) bar_ = std::make_unique<Bar>();
        bar_->update(size_t(std::lround(p.fraction * bar_units)));
    } else if (style_ == ProgressStyle::plain && p.seconds - last_line_ >= seconds_between_lines) {
        last_line_ = p.seconds;
        const double left = p.fraction > 0 ? p.seconds / p.fraction - p.seconds : 0;
        print_line(fmt::format("progress {:.0f}%  {} spp  {:.0f} s, about {:.0f} s left", 100 * p.fraction, p.spp_done,
                               p.seconds, left));
    }
}

void Console::end_progress() {
    bar_.reset();
    last_line_ = 0;
}

std::string explain_text(const Explanation& explanation) {
    std::string out;
    for (const Decision& d : explanation)
        out += fmt::format("{:10} {:24} {}\n", d.kept ? "kept" : "left out", d.what, d.why);
    return out;
}

namespace {

std::string rays_line(const RenderResult& r) {
    const RenderCounters& c = r.counters;
    const double all = double(c.camera_rays + c.scattered_rays + c.shadow_rays);
    return fmt::format("rays: {:.3g} M camera, {:.3g} M scattered, {:.3g} M shadow; {:.3g} M rays/s on {} threads",
                       double(c.camera_rays) * 1e-6, double(c.scattered_rays) * 1e-6, double(c.shadow_rays) * 1e-6,
                       all * 1e-6 / std::max(r.seconds, 1e-9), r.threads);
}

std::string stages_line(const RenderResult& r) {
    using Seconds = std::chrono::duration<double>;
    Seconds total{0};
    for (const auto t : r.stage_times.spent) total += t;
    std::string out = fmt::format("stages ({:.2f} s of thread time):", total.count());
    for (int k = 0; k < stage_kinds; ++k) {
        const Seconds t = r.stage_times.spent[size_t(k)];
        if (t.count() > 0) out += fmt::format(" {} {:.0f}%", name_of(StageKind(k)), 100 * t / total);
    }
    return out;
}

std::string error_line(const RenderResult& r) {
    switch (r.known_of()) {
        case PictureKnown::nothing_hit:
            return ", no ray hit anything: all of the picture is background";
        case PictureKnown::all_dropped:
            return ", every sample was dropped: the picture shows nothing";
        case PictureKnown::one_replicate:
            return "";
        case PictureKnown::error_at_least:
        case PictureKnown::error:
            break;
    }
    return fmt::format(", estimated error {}{:.3g} % (RMSE {:.3g})", r.error.at_least ? "at least " : "",
                       100 * r.error.relative, r.error.rmse);
}

}  // namespace

std::vector<std::string> faults(const RenderResult& r) {
    std::vector<std::string> out;
    const RenderCounters& c = r.counters;
    const auto lost = [&](const LostSamples& l, std::string_view what, std::string_view counts_as) {
        if (l.count > 0)
            out.push_back(fmt::format("warning: {} {} samples count as {}, the first at pixel {},{} sample {}", l.count,
                                      what, counts_as, l.first_x, l.first_y, l.first_sample));
    };
    lost(c.film.nonfinite, "non-finite", "black");
    lost(c.film.overflowed, "too bright", "3.4e38");
    if (c.cut_paths > 0)
        out.push_back(fmt::format("warning: {} times a path was brightened beyond 3.4e38 and cut", c.cut_paths));
    if (c.trace.rejected > 0) out.push_back(fmt::format("warning: {} rays were not traceable", c.trace.rejected));
    if (c.media_overflows > 0)
        out.push_back(fmt::format("warning: {} times a path was inside more bodies than its media stack holds",
                                  c.media_overflows));
    return out;
}

std::string summary(const RenderResult& r, bool verbose) {
    std::string out = fmt::format("{}: {} spp in {:.2f} s", describe(r.stopped_by), r.spp_done, r.seconds);
    out += error_line(r) + '\n' + rays_line(r);
    const auto mb = [](std::size_t bytes) { return double(bytes) * 1e-6; };
    const MemoryEstimate& m = r.memory;
    out += fmt::format("\nmemory: {:.1f} MB (scene {:.1f}, film {:.1f}, picture {:.1f}, batches {:.1f})", mb(m.total()),
                       mb(m.scene), mb(m.film), mb(m.picture), mb(m.batches));
    if (verbose) out += '\n' + stages_line(r);
    return out;
}

}  // namespace drt
