#include "drt/render/render.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <bit>
#include <mutex>
#include <optional>

#include "drt/base/available_memory.h"
#include "drt/base/flush_denormals.h"
#include "drt/base/task_order.h"
#include "drt/render/passes.h"
#include "drt/render/tiles.h"
#include "drt/render/unseen_light.h"

namespace drt {

std::string_view describe(StopReason r) {
    switch (r) {
        case StopReason::samples:
            return "all samples taken";
        case StopReason::time_limit:
            return "time limit reached";
        case StopReason::interrupted:
            return "interrupted";
    }
    return "";
}

std::string_view describe(PictureKnown k) {
    switch (k) {
        case PictureKnown::error:
            return "about";
        case PictureKnown::error_at_least:
            return "at least";
        case PictureKnown::nothing_hit:
            return "none: no ray hit anything";
        case PictureKnown::all_dropped:
            return "none: every sample was dropped";
        case PictureKnown::one_replicate:
            return "none: too few samples";
    }
    return "";
}

PictureKnown RenderResult::known_of() const {
    if (counters.film.nonfinite.count == counters.camera_rays) return PictureKnown::all_dropped;
    if (counters.camera_hits == 0) return PictureKnown::nothing_hit;
    if (!error.valid) return PictureKnown::one_replicate;
    return error.at_least ? PictureKnown::error_at_least : PictureKnown::error;
}

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

// What one thread owns: its batch, which is reused from tile to tile, and its counters.
template <class Real>
struct Worker {
    std::unique_ptr<RayBatch<Real>> batch;
    RenderCounters counters;
    StageTimes times;
};

// More samples of fewer pixels: what is the same for all samples of a pixel, most of the hashes, is done once, and so
// is reading and writing the film. Fewer, and larger blocks of the picture: more coherent packets after a bounce.
constexpr int most_samples_at_once = 8;

BatchPixels batch_pixels(const Tile& tile, size_t first_block, size_t count) {
    const std::span blocks = std::span(tile).subspan(first_block);
    return {blocks.first(std::min(count, blocks.size()))};
}

template <class Real>
class FrameRenderer {
public:
    FrameRenderer(const World<Real>& world, const Features& features, const RenderOptions& options,
                  const RenderEvents& events, RenderResult& result)
        : world_(world),
          pipeline_(compose<Real>(features)),
          options_(options),
          events_(events),
          result_(result),
          tiles_(make_tiles(result.film.width, result.film.height, options.tile_size)),
          workers_([&] {
              return Worker<Real>{std::make_unique<RayBatch<Real>>(world.sampling.media_capacity), {}, {}};
          }) {}

    void run() {
        int done = 0;
        double seconds_per_sample = 0;
        while (const int size = next_pass(done, seconds_per_sample)) {
            const auto pass_begin = Clock::now();
            if (!run_pass(done, size)) break;
            done += size;
            seconds_per_sample = seconds_since(pass_begin) / size;
            result_.spp_done = done;
            if (events_.pass_done) events_.pass_done(result_.film, progress(done));
        }
        for (const Worker<Real>& w : workers_) {
            merge(result_.counters, w.counters);
            merge(result_.stage_times, w.times);
        }
        result_.seconds = seconds_since(begin_);
    }

private:
    // Size of the next pass; 0 to stop, with the reason recorded.
    int next_pass(int done, double seconds_per_sample) {
        if (interrupted()) return stop(StopReason::interrupted);
        if (done >= options_.spp) return stop(StopReason::samples);
        if (options_.time_limit <= 0 || done == 0) return pass_size(done, options_.spp);
        const double left = options_.time_limit - seconds_since(begin_);
        const int size = pass_size_in_time(done, options_.spp, seconds_per_sample, left);
        return size > 0 ? size : stop(StopReason::time_limit);
    }

    int stop(StopReason why) {
        result_.stopped_by = why;
        return 0;
    }

    bool interrupted() const { return options_.stop && options_.stop->load(std::memory_order_relaxed); }

    // The very first pass is not cut short by the time limit: a picture without holes is the least one can ask for.
    bool out_of_time(int done) const {
        return done > 0 && options_.time_limit > 0 && seconds_since(begin_) > options_.time_limit;
    }

    // False when the pass was cut short; the film is valid all the same, since every pixel counts its own samples.
    bool run_pass(int done, int size) {
        std::atomic<int> tiles_done{0};
        std::atomic<bool> cut_short{false};
        const auto render_tile = [&](size_t i) {
            const task_order::Task order;
            if (cut_short.load(std::memory_order_relaxed)) return;
            if (interrupted() || out_of_time(done)) {
                cut_short = true;
                return;
            }
            run_tile(tiles_[i], std::uint32_t(done), size);
            report(done + size * double(++tiles_done) / double(tiles_.size()));
        };
        task_order::before_loop();
        tbb::parallel_for(size_t(0), tiles_.size(), render_tile);
        task_order::after_loop();
        if (cut_short) stop(interrupted() ? StopReason::interrupted : StopReason::time_limit);
        return !cut_short;
    }

    void run_tile(const Tile& tile, std::uint32_t first, int samples) {
        const FlushDenormals flush;
        Worker<Real>& w = workers_.local();
        StageContext<Real> c;
        c.world = &world_;
        c.film = &result_.film;
        c.batch = w.batch.get();
        c.counters = &w.counters;
        const int at_once = std::min(samples, most_samples_at_once);
        const size_t blocks_at_once = size_t(batch_capacity / (block_pixels * at_once));
        for (size_t first_block = 0; first_block < tile.size(); first_block += blocks_at_once) {
            c.pixels = batch_pixels(tile, first_block, blocks_at_once);
            for (int s = 0; s < samples; s += at_once) {
                c.first_sample = first + std::uint32_t(s);
                c.samples = std::min(at_once, samples - s);
                drt::run(pipeline_, c, w.times);
            }
        }
    }

    Progress progress(double spp) const {
        const double seconds = seconds_since(begin_);
        double fraction = spp / options_.spp;
        if (options_.time_limit > 0) fraction = std::max(fraction, seconds / options_.time_limit);
        return {std::min(fraction, 1.0), result_.spp_done, seconds};
    }

    void report(double spp) {
        if (!events_.progress) return;
        const std::unique_lock lock(report_mutex_, std::try_to_lock);
        if (lock.owns_lock()) events_.progress(progress(spp));
    }

    const World<Real>& world_;
    Pipeline<Real> pipeline_;
    const RenderOptions& options_;
    const RenderEvents& events_;
    RenderResult& result_;
    std::vector<Tile> tiles_;
    tbb::enumerable_thread_specific<Worker<Real>> workers_;
    Clock::time_point begin_ = Clock::now();
    std::mutex report_mutex_;
};

}  // namespace

RenderResult render(const RenderPlan& plan, const RenderOptions& options, const RenderEvents& events) {
    if (options.tile_size < block_side || options.tile_size > 32 || !std::has_single_bit(unsigned(options.tile_size)))
        throw Error(ErrorKind::usage, "the tile size must be 4, 8, 16 or 32 pixels");
    if (std::uint64_t(options.spp) > replicate_count * most_summands)
        throw Error(ErrorKind::usage, "more samples per pixel than the film holds");
    // TBB starts no more threads than there are cores unless it is told to.
    std::optional<tbb::global_control> allowed;
    if (options.threads > tbb::info::default_concurrency())
        allowed.emplace(tbb::global_control::max_allowed_parallelism, size_t(options.threads));
    tbb::task_arena arena(options.threads > 0 ? options.threads : tbb::task_arena::automatic);
    RenderResult result;
    result.threads = arena.max_concurrency();
    result.memory = estimate_memory(plan, result.threads);
    if (options.memory_limit)
        check_memory(plan, result.memory, *options.memory_limit);
    else if (const auto available = available_memory())  // a tenth is left to others, and to writing the picture
        check_memory(plan, result.memory, *available / 10 * 9);
    result.film = Film(plan.width, plan.height);
    arena.execute([&] {
        std::visit(
            [&](const auto& world) {
                using Real = typename std::decay_t<decltype(*world)>::RealType;
                FrameRenderer<Real>(*world, plan.features, options, events, result).run();
            },
            plan.world);
    });
    result.memory.film += result.film.memory() - film_memory(plan.width, plan.height);
    result.error = estimate_error(
        result.film, {unseen_brightness(plan.sights, result.counters.sources, result.spp_done), plan.random});
    return result;
}

}  // namespace drt
