#pragma once
// Do two noisy pictures show the same thing? Statistics over blocks of pixels, with stated confidence.
//
// Noise averages out over a block and a fault does not, so blocks see faults far below the noise of a pixel. Three
// questions are asked of each channel: is one block off (its z-score against the Sidak limit for the number of
// blocks), are many blocks slightly off (sum of z^2 against the chi^2 limit), is the whole picture off (z of the
// mean). The false alarm rate alpha is shared evenly among all questions.
//
// z-scores allow for variances that are themselves estimates: Student's t with the effective degrees of freedom of
// the pooled variance (after Welch and Satterthwaite), mapped to a normal score.

#include <string>
#include <vector>

#include "drt/image/image.h"
#include "support/estimate.h"

namespace drt {

/// The mean of two or more independent replicates of a picture (as the film keeps them; 3 or more channels, the first
/// 3 count), each of as many samples, with the variance of the mean told from their differences.
PictureEstimate estimate_from_replicates(const std::vector<Image>&);

struct CompareOptions {
    std::vector<int> blocks{8, 4};     ///< pixels along a block's side; small blocks see what cancels in large ones
    double alpha = 1e-4;               ///< probability that equal pictures are called different
    double relative_tolerance = 1e-5;  ///< differences of block means up to this (of the larger) count as rounding
    double absolute_tolerance = 1e-7;  ///< the same, absolute
    /// `a` counts in each block as at least this many times as noisy (in variance) as `b`; 0 = as noisy as it says.
    /// For `b` of the same scene with that many times `a`'s samples: where rare bright samples make the picture, a's
    /// few may not include one, so a's own variance is 0 and b knows better what it should be.
    double least_variance_ratio = 0;
    /// The most that one sample adds to the mean of a pixel of `b` where bright samples are rare: their value over the
    /// samples of a pixel; 0 = none are. A block of b that met none, where it should have met one or two, has a
    /// variance that knows of none, with however many samples. So b counts as noisy as it would be if the mean of a,
    /// where that is higher, were its true one, and what it lacks came in such samples.
    double rare_step = 0;
};

struct BlockScore {
    int x = 0, y = 0, width = 0, height = 0;  ///< pixels
    int channel = 0;
    double mean_a = 0, mean_b = 0;
    double sigma = 0;  ///< standard error of mean_a - mean_b
    double z = 0;      ///< of the difference beyond tolerance; infinite where the variance is zero
};

struct CompareResult {
    bool same = false;
    std::string report;              ///< the verdict, the limits and the worst blocks with their coordinates
    std::vector<BlockScore> blocks;  ///< every block and channel, worst first
};

/// The pictures must have the same size (else: different).
CompareResult compare_pictures(const PictureEstimate& a, const PictureEstimate& b, const CompareOptions& = {});

}  // namespace drt
