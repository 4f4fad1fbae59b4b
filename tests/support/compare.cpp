#include "support/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace drt {
namespace {

constexpr int channels = 3;
constexpr const char* channel_names = "RGB";
constexpr double infinity = std::numeric_limits<double>::infinity();

double channel_of(const Rgb& color, int c) { return c == 0 ? color.r : c == 1 ? color.g : color.b; }

/// z with P(|normal| > z) = p: bisection on erfc, exact enough at any p.
double two_sided_limit(double p) {
    double low = 0, high = 40;
    for (int i = 0; i < 200; ++i) {
        const double middle = (low + high) / 2;
        (std::erfc(middle / std::sqrt(2.0)) > p ? low : high) = middle;
    }
    return high;
}

/// The normal score of a Student t value (Wallace 1959): within 1 % of z for 2 and more degrees of freedom.
double normal_score(double t, double freedom) {
    if (!std::isfinite(t) || freedom > 1e6) return t;
    const double z = (8 * freedom + 1) / (8 * freedom + 3) * std::sqrt(freedom * std::log1p(t * t / freedom));
    return std::copysign(z, t);
}

/// The normal score of a chi^2 value with n degrees of freedom (Wilson and Hilferty 1931).
double chi_squared_score(double sum, double n) {
    const double spread = 2 / (9 * n);
    return (std::cbrt(sum / n) - (1 - spread)) / std::sqrt(spread);
}

/// Sums over the pixels of a block.
struct BlockSum {
    double mean = 0, variance = 0;
    double squares = 0;  ///< of the variances, each over its degrees of freedom
};

BlockSum sum_block(const PictureEstimate& picture, const BlockScore& block) {
    BlockSum sum;
    for (int y = block.y; y < block.y + block.height; ++y) {
        for (int x = block.x; x < block.x + block.width; ++x) {
            const size_t i = picture.index(x, y);
            const double variance = channel_of(picture.variance[i], block.channel);
            sum.mean += channel_of(picture.mean[i], block.channel);
            sum.variance += variance;
            sum.squares += variance * variance / picture.freedom;
        }
    }
    return sum;
}

BlockScore score_block(const PictureEstimate& a, const PictureEstimate& b, BlockScore block,
                       const CompareOptions& options) {
    BlockSum sum_a = sum_block(a, block);
    BlockSum sum_b = sum_block(b, block);
    if (const double ratio = options.least_variance_ratio; sum_a.variance < ratio * sum_b.variance) {
        sum_a.variance = ratio * sum_b.variance;
        sum_a.squares = ratio * ratio * sum_b.squares;
    }
    // A Poisson number of steps has a variance of its mean times the step. As the score test has it: Rao 1948.
    sum_b.variance += options.rare_step * std::max(0.0, sum_a.mean - sum_b.mean);
    const double variance = sum_a.variance + sum_b.variance;
    const double pixels = double(block.width) * block.height;
    block.mean_a = sum_a.mean / pixels;
    block.mean_b = sum_b.mean / pixels;
    block.sigma = std::sqrt(variance) / pixels;
    const double tolerance =
        std::max(options.absolute_tolerance,
                 options.relative_tolerance * std::max(std::abs(block.mean_a), std::abs(block.mean_b)));
    const double difference = block.mean_a - block.mean_b;
    const double excess = std::copysign(std::max(0.0, std::abs(difference) - tolerance), difference);
    if (!std::isfinite(difference) || !std::isfinite(block.sigma)) {
        block.z = infinity;
    } else if (block.sigma == 0) {
        block.z = excess == 0 ? 0 : std::copysign(infinity, excess);
    } else {
        block.z = normal_score(excess / block.sigma, variance * variance / (sum_a.squares + sum_b.squares));
    }
    return block;
}

std::vector<BlockScore> score_blocks(const PictureEstimate& a, const PictureEstimate& b, int channel, int side,
                                     const CompareOptions& options) {
    std::vector<BlockScore> blocks;
    for (int y = 0; y < a.height; y += side) {
        for (int x = 0; x < a.width; x += side) {
            BlockScore block;
            block.x = x, block.y = y, block.channel = channel;
            block.width = std::min(side, a.width - x);
            block.height = std::min(side, a.height - y);
            blocks.push_back(score_block(a, b, block, options));
        }
    }
    return blocks;
}

std::string describe(const BlockScore& block) {
    return fmt::format(
        "  {} of pixels [{}, {}) x [{}, {}): {:.6g} and {:.6g}, difference {:+.3g}, sigma {:.2g}, z {:+.2f}\n",
        channel_names[block.channel], block.x, block.x + block.width, block.y, block.y + block.height, block.mean_a,
        block.mean_b, block.mean_a - block.mean_b, block.sigma, block.z);
}

class Judge {
public:
    Judge(CompareResult& result, double alpha) : result_(result), alpha_(alpha) {}

    /// Is one block off, are many slightly off? `blocks` are all of one channel and size.
    void blocks(const std::vector<BlockScore>& blocks) {
        const double n = double(blocks.size());
        double worst = 0, sum = 0;
        for (const BlockScore& block : blocks) {
            worst = std::max(worst, std::abs(block.z));
            sum += block.z * block.z;
        }
        const std::string where = fmt::format("{} in blocks of {} pixels: ", channel_names[blocks[0].channel],
                                              std::max(blocks[0].width, blocks[0].height));
        const double worst_limit = two_sided_limit(-std::expm1(std::log1p(-alpha_) / n));  // Sidak
        if (worst > worst_limit) fail(where + fmt::format("worst |z| {:.2f} > {:.2f}", worst, worst_limit));
        const double score = std::isfinite(sum) ? chi_squared_score(sum, n) : infinity;
        const double score_limit = two_sided_limit(2 * alpha_);  // one-sided
        if (score > score_limit)
            fail(where +
                 fmt::format("sum of z^2 {:.1f} over {} blocks, score {:.2f} > {:.2f}", sum, n, score, score_limit));
    }

    /// Is the whole picture off?
    void whole(const BlockScore& all) {
        const double limit = two_sided_limit(alpha_);
        if (std::abs(all.z) > limit)
            fail(fmt::format("{} of the whole picture: |z| {:.2f} > {:.2f}, means {:.6g} and {:.6g}",
                             channel_names[all.channel], std::abs(all.z), limit, all.mean_a, all.mean_b));
    }

private:
    void fail(const std::string& why) {
        result_.same = false;
        result_.report += why + "\n";
    }
    CompareResult& result_;
    double alpha_;  ///< of one question
};

void append_worst_blocks(CompareResult& result) {
    std::stable_sort(result.blocks.begin(), result.blocks.end(),
                     [](const BlockScore& p, const BlockScore& q) { return std::abs(p.z) > std::abs(q.z); });
    result.report += "worst blocks:\n";
    for (size_t i = 0; i < std::min<size_t>(6, result.blocks.size()); ++i) result.report += describe(result.blocks[i]);
}

}  // namespace

PictureEstimate estimate_from_replicates(const std::vector<Image>& replicates) {
    const int width = replicates.front().width, height = replicates.front().height;
    const double n = double(replicates.size());
    PictureEstimate estimate(width, height);
    estimate.freedom = n - 1;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const auto value = [&](const Image& image) {
                const float* p = image.pixel(x, y);
                return Rgb{p[0], p[1], p[2]};
            };
            Rgb sum, squares;
            for (const Image& image : replicates) sum += value(image);
            const Rgb mean = sum * (1 / n);
            for (const Image& image : replicates) squares += (value(image) - mean) * (value(image) - mean);
            estimate.mean[estimate.index(x, y)] = mean;
            estimate.variance[estimate.index(x, y)] = squares * (1 / (n * (n - 1)));
        }
    }
    return estimate;
}

CompareResult compare_pictures(const PictureEstimate& a, const PictureEstimate& b, const CompareOptions& options) {
    CompareResult result;
    if (a.width != b.width || a.height != b.height) {
        result.report = fmt::format("sizes differ: {}x{} and {}x{}\n", a.width, a.height, b.width, b.height);
        return result;
    }
    result.same = true;
    Judge judge(result, options.alpha / double(channels * (2 * options.blocks.size() + 1)));
    for (int channel = 0; channel < channels; ++channel) {
        BlockScore whole;
        whole.width = a.width, whole.height = a.height, whole.channel = channel;
        judge.whole(score_block(a, b, whole, options));
        for (const int side : options.blocks) {
            const std::vector<BlockScore> blocks = score_blocks(a, b, channel, side, options);
            judge.blocks(blocks);
            result.blocks.insert(result.blocks.end(), blocks.begin(), blocks.end());
        }
    }
    result.report =
        fmt::format("{} (false alarms: {:g} of equal pictures)\n", result.same ? "same" : "different", options.alpha) +
        result.report;
    append_worst_blocks(result);
    return result;
}

}  // namespace drt
