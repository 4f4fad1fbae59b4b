#pragma once
// Sample points: a pure function of (seed, frame, pixel, replicate, index, named dimension). No state anywhere.
//
// Every named dimension is its own 2D point set: an Owen-scrambled Sobol (0, 2)-sequence whose index order is Owen-
// shuffled per dimension (padding), after Burley, "Practical Hash-based Owen Scrambling", JCGT 9(4), 2020. Because a
// dimension is found by its name, a plan that does not draw one never shifts the others.

#include <cstdint>

#include "drt/base/vec.h"

namespace drt {

/// Dimensions drawn once a camera path.
enum class PathDim : std::uint32_t { filter, lens, time };
/// Dimensions drawn at each hit.
enum class HitDim : std::uint32_t { lobe_choice, lobe, roulette, light_choice, light };

using DimId = std::uint32_t;

constexpr DimId dim(PathDim d) { return DimId(d); }
/// `bounce` counts from 0 (the camera ray's hit). `index` tells lights apart; only HitDim::light uses it.
constexpr DimId dim(HitDim d, int bounce, int index = 0) {
    return 0x100u + DimId(d) + 8u * (DimId(bounce) & 0xffffu) + 0x100000u * DimId(index);
}

enum class SamplerKind {
    sobol,        ///< the renderer's
    independent,  ///< uncorrelated hashes: for tests and as a yardstick
};

/// Names a pixel's sample set. `T` is float or double, scalar or lanes.
template <class T>
struct SampleSet {
    using U = Rebind<T, std::uint32_t>;
    U key;    ///< from sample_key()
    U index;  ///< number of the sample within its replicate, from 0
};

/// The key of a pixel's sample set: well mixed, so that neighbours, frames, seeds and replicates are independent.
template <class U>
U sample_key(std::uint32_t seed, std::uint32_t frame, std::uint32_t replicate, const U& x, const U& y);

/// In [0, 1) x [0, 1): never 1, also not after rounding to float.
template <class T>
Vec2<T> sample_2d(SamplerKind, const SampleSet<T>&, DimId);

/// In [0, 1).
template <class T>
T sample_1d(SamplerKind, const SampleSet<T>&, DimId);

}  // namespace drt
