#pragma once
// A stage is a plain function over a batch. The pipeline of a frame is a short list of them, composed once from the
// plan's features: a stage that a scene does not need is not in the list.

#include <array>
#include <bit>
#include <chrono>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "drt/film/film.h"
#include "drt/plan/features.h"
#include "drt/plan/world.h"
#include "drt/stages/ray_batch.h"

namespace drt {

/// A block of the film (film.h): 4 x 4 pixels, contiguous in the batch and in the film.
struct TileBlock {
    std::int32_t x = 0, y = 0;  ///< its upper left pixel
    unsigned valid = 0xffff;    ///< bit i: the block's pixel i is part of the picture
};

/// What one batch takes of a tile: some of its blocks, in Morton order, so that each packet is a small square of pixels
/// whatever its width. Pixels beyond the picture's edge are there too, but carry no ray.
struct BatchPixels {
    std::span<const TileBlock> blocks;
    int count() const { return int(blocks.size()) * block_pixels; }
};

/// How often camera rays and scattered rays met visible lights, by the octave of their radiance.
struct SourceHits {
    std::array<std::uint64_t, 256> direct{}, scattered{};
    static size_t bin(float radiance) { return std::bit_cast<std::uint32_t>(radiance) >> 23; }
};

/// Counted per thread, added up at the end of a pass.
struct RenderCounters {
    std::uint64_t camera_rays = 0, scattered_rays = 0, shadow_rays = 0;
    std::uint64_t camera_hits = 0;      ///< camera rays that met a body or a visible light
    std::uint64_t cut_paths = 0;        ///< times that a path was brightened beyond the largest float and cut to it
    std::uint64_t media_overflows = 0;  ///< paths inside more bodies than the stack holds
    SourceHits sources;
    TraceCounters trace;
    FilmCounters film;
};

void merge(RenderCounters& into, const RenderCounters& from);

/// Everything that a stage may touch. One per thread and in use by one tile at a time.
template <class Real>
struct StageContext {
    const World<Real>* world = nullptr;
    Film* film = nullptr;
    BatchPixels pixels;
    std::uint32_t first_sample = 0;
    int samples = 0;  ///< of each pixel in this batch; pixels.count() * samples <= batch_capacity
    RayBatch<Real>* batch = nullptr;
    RenderCounters* counters = nullptr;
};

enum class StageKind { generate, intersect, surface, emit, light, scatter, splat };
inline constexpr int stage_kinds = 7;
std::string_view name_of(StageKind);

template <class Real>
struct Stage {
    StageKind kind;
    void (*run)(StageContext<Real>&);
};

/// `first` once, then `bounce` while rays are left, then `last`.
template <class Real>
struct Pipeline {
    std::vector<Stage<Real>> first, bounce, last;
};

template <class Real>
Pipeline<Real> compose(const Features&);

struct StageTimes {
    std::array<std::chrono::nanoseconds, stage_kinds> spent{};
};
void merge(StageTimes& into, const StageTimes& from);

/// Runs a pipeline over one batch.
template <class Real>
void run(const Pipeline<Real>&, StageContext<Real>&, StageTimes&);

}  // namespace drt
