// How the matrices of drt/sampling/joint_index.h were found, what they gain, and what the sampler costs. Not a test:
//   ninja -C build/release joint_index_study && build/release/tests/sampling/joint_index_study [gains | cost | search]

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <random>
#include <string>

#include "drt/sampling/sampler.h"
#include "drt/sampling/warps.h"

namespace drt {
namespace {

using u32 = std::uint32_t;
constexpr int columns = joint_columns;
using Matrix = std::array<u32, columns>;
using Matrices = std::array<Matrix, joint_dims>;

// ---- the search -----------------------------------------------------------------------------------------------------

int rank_of(std::vector<u32>& rows) {
    int rank = 0;
    for (size_t i = 0; i < rows.size(); ++i) {
        if (!rows[i]) continue;
        ++rank;
        for (size_t j = i + 1; j < rows.size(); ++j)
            if (rows[j] & rows[i] & -rows[i]) rows[j] ^= rows[i];
    }
    return rank;
}

/// Row `digit` of the generator matrix of M's Sobol pair (which = 0, 1), restricted to m columns.
u32 generator_row(const Matrix& matrix, int which, int digit, int m) {
    u32 row = 0;
    for (int b = 0; b < m; ++b) {
        const u32 column = which ? sobol_second_digits(matrix[size_t(b)]) : matrix[size_t(b)];
        row |= (column >> digit & 1u) << b;
    }
    return row;
}

/// How far the first 2^m points of two sets together are from a (0, m, 4)-net: the mean over all shapes of elementary
/// intervals of 2^deficiency - 1, those of few dimensions counting more, as integrands depend on few at once.
double unevenness(const Matrix& a, const Matrix& b, int m) {
    std::array<std::array<u32, columns>, 4> rows{};
    for (int r = 0; r < m; ++r)
        for (int k = 0; k < 4; ++k) rows[size_t(k)][size_t(r)] = generator_row(k < 2 ? a : b, k % 2, r, m);
    double sum = 0;
    std::vector<u32> chosen;
    for (int i = 0; i <= m; ++i)
        for (int j = 0; i + j <= m; ++j)
            for (int k = 0; i + j + k <= m; ++k) {
                const std::array<int, 4> digits{i, j, k, m - i - j - k};
                if (i + j == 0 || i + j == m) continue;  // within one pair: a net already
                chosen.clear();
                int used = 0;
                for (size_t d = 0; d < 4; ++d) {
                    used += digits[d] > 0;
                    for (int r = 0; r < digits[d]; ++r) chosen.push_back(rows[d][size_t(r)]);
                }
                const double weight = used == 2 ? 6 : used == 3 ? 2 : 1;
                sum += weight * ((1 << std::min(m - rank_of(chosen), 6)) - 1);
            }
    return sum / ((m + 3) * (m + 2) * (m + 1) / 6.0);
}

double cost_of(const Matrices& matrices, int m) {
    double worst = 0, sum = 0;
    for (size_t k = 1; k < joint_dims; ++k)
        for (size_t j = 0; j < k; ++j) {
            const double u = unevenness(matrices[j], matrices[k], m);
            worst = std::max(worst, u);
            sum += u;
        }
    return worst + 0.2 * sum;
}

/// Beam search, one column of all matrices at a time: column m - 1 first matters for blocks of 2^m points.
Matrices search() {
    struct State {
        double cost = 0;
        Matrices matrices{};
    };
    constexpr size_t beam_width = 64;
    std::mt19937 rng(1);
    State start;
    for (Matrix& matrix : start.matrices)
        for (int b = 0; b < columns; ++b) matrix[size_t(b)] = 1u << b;
    std::vector<State> beam{start};
    for (int m = 2; m <= columns; ++m) {
        std::vector<State> next;
        const int free_bits = (m - 1) * (joint_dims - 1);  // below the diagonal's 1, in all matrices but the first
        const int sample = m <= 6 ? 400 : m <= 9 ? 80 : 24;
        const bool all = free_bits < 20 && 1 << free_bits <= sample;
        for (const State& state : beam)
            for (int t = 0; t < (all ? 1 << free_bits : sample); ++t) {
                State candidate = state;
                const std::uint64_t high = all ? 0 : rng(), low = all ? std::uint64_t(t) : rng();
                const std::uint64_t bits = high << 31 ^ low;
                for (size_t k = 1; k < joint_dims; ++k) {
                    const u32 above = u32(bits >> (size_t(m - 1) * (k - 1))) & ((1u << (m - 1)) - 1u);
                    candidate.matrices[k][size_t(m - 1)] = (1u << (m - 1)) | above;
                }
                candidate.cost += cost_of(candidate.matrices, m);
                next.push_back(candidate);
            }
        std::sort(next.begin(), next.end(), [](const State& a, const State& b) { return a.cost < b.cost; });
        if (next.size() > beam_width) next.resize(beam_width);
        beam = next;
        std::printf("%2d columns: cost %.3f\n", m, beam[0].cost);
    }
    return beam[0].matrices;
}

// ---- the gains ------------------------------------------------------------------------------------------------------

enum class Points { independent, padded, joint };

/// A dimension with an index shuffle of its own, Burley's padding.
Vec2d padded_2d(u32 key, u32 index, DimId d) {
    const auto keys = sampler_detail::scramble_keys<u32>(key, d);
    const u32 s = reverse_bits(owen_scramble_reversed(reverse_bits(index), mix_bits(keys.x + 1)));
    return {unit_interval<double>(reverse_bits(owen_scramble_reversed(s, keys.x))),
            unit_interval<double>(reverse_bits(owen_scramble_reversed(sobol_second_digits(s), keys.y)))};
}

using Point = std::array<Vec2d, 4>;  // filter, lens, time, light
using Integrand = std::function<double(const Point&)>;

Point point(Points kind, u32 key, u32 index) {
    const DimId dims[] = {dim(PathDim::filter), dim(PathDim::lens), dim(PathDim::time), dim(HitDim::light, 0)};
    Point p;
    for (size_t k = 0; k < 4; ++k) {
        const auto sampler = kind == Points::joint ? SamplerKind::sobol : SamplerKind::independent;
        p[k] = kind == Points::padded ? padded_2d(key, index, dims[k])
                                      : sample_2d(sampler, SampleSet<double>{key, index}, dims[k]);
    }
    return p;
}

/// Root mean square over `sets` sets of the error of the mean over n points.
double rms_error(Points kind, u32 n, int sets, double truth, const Integrand& f) {
    double sum2 = 0;
    for (int r = 0; r < sets; ++r) {
        const u32 key = sample_key<u32>(5, 0, 0, u32(r), 3u);
        double sum = 0;
        for (u32 i = 0; i < n; ++i) sum += f(point(kind, key, i));
        sum2 += (sum / n - truth) * (sum / n - truth);
    }
    return std::sqrt(sum2 / sets);
}

void print_gain(const char* name, const Integrand& f) {
    double truth = 0;
    constexpr int sets = 1000, truth_sets = 512;
    for (u32 r = 0; r < truth_sets; ++r)
        for (u32 i = 0; i < 4096; ++i) truth += f(point(Points::joint, sample_key<u32>(99, 0, 0, r, 0u), i));
    truth /= 4096.0 * truth_sets;
    std::printf("| %s |", name);
    for (const u32 n : {4u, 8u, 16u, 32u, 64u, 128u, 256u}) {
        const double random = rms_error(Points::independent, n, sets, truth, f);
        std::printf(" %.2f / %.2f |", random / rms_error(Points::padded, n, sets, truth, f),
                    random / rms_error(Points::joint, n, sets, truth, f));
    }
    std::puts("");
}

void gains() {
    std::puts("error of random sampling / error of padded | joint dimensions, at 4, 8, 16, 32, 64, 128, 256 samples");
    const auto ball = [](Vec2d a, Vec2d b) {
        const Vec2d p = uniform_disc(a), q = uniform_disc(b);
        return std::hypot(p.x + q.x - 0.2, p.y + q.y - 0.3) < 0.7 ? 1.0 : 0.0;
    };
    print_gain("one pair: edge in the lens", [](const Point& p) { return p[1].x + 0.6 * p[1].y < 0.7 ? 1.0 : 0.0; });
    print_gain("interaction lens.x * light.x", [](const Point& p) { return (p[1].x - 0.5) * (p[3].x - 0.5); });
    print_gain("ball: lens disc + light disc", [&](const Point& p) { return ball(p[1], p[3]); });
    print_gain("ball: filter + lens disc", [&](const Point& p) { return ball(p[0], p[1]); });
    print_gain("ball: lens disc + time", [&](const Point& p) { return ball(p[1], {p[2].x, 0.5}); });
    print_gain("half space, lens + light",
               [](const Point& p) { return p[1].x + p[1].y + p[3].x + p[3].y < 2 ? 1.0 : 0.0; });
    // A moving ball out of focus before a plane, both lit by an area light, the plane in a penumbra that moves along.
    print_gain("filter, lens, time, light: a picture's pixel", [](const Point& p) {
        const Vec2d lens = uniform_disc(p[1]);
        const double x = p[0].x + 0.8 * lens.x + 0.7 * p[2].x - 0.9, y = p[0].y + 0.8 * lens.y - 0.4;
        const bool on_ball = x * x + y * y < 0.8;
        const bool lit = p[3].x + 0.5 * p[3].y + 0.4 * p[2].x + 0.1 * p[0].x < 1.1;
        return on_ball ? 0.3 + 0.2 * p[3].y : lit ? 1.0 : 0.1;
    });
}

// ---- the cost -------------------------------------------------------------------------------------------------------

void cost() {
    using F = Lane<float, native_width<float>>;
    using U = Rebind<F, u32>;
    constexpr int rounds = 10000, width = width_of<F>;
    const auto nanoseconds = [&](auto draw) {
        double best = 1e9;
        for (int trial = 0; trial < 200; ++trial) {
            F sum(0.0f);
            const auto start = std::chrono::steady_clock::now();
            for (int i = 0; i < rounds; ++i) sum += draw(SampleSet<F>{U(mix_bits(u32(i))), iota<U>() + U(u32(i))});
            const std::chrono::duration<double, std::nano> elapsed = std::chrono::steady_clock::now() - start;
            if (reduce_max(sum) > 0) best = std::min(best, elapsed.count() / (double(rounds) * width));
        }
        return best;
    };
    const auto sobol = SamplerKind::sobol;
    const auto sum = [](const Vec2<F>& p) { return p.x + p.y; };
    std::printf("%d lanes, nanoseconds a sample\n", width);
    std::printf("independent 2D          %.2f\n", nanoseconds([&](const SampleSet<F>& s) {
                    return sum(sample_2d(SamplerKind::independent, s, dim(PathDim::lens)));
                }));
    std::printf("filter (no matrix)      %.2f\n",
                nanoseconds([&](const SampleSet<F>& s) { return sum(sample_2d(sobol, s, dim(PathDim::filter))); }));
    std::printf("lens                    %.2f\n",
                nanoseconds([&](const SampleSet<F>& s) { return sum(sample_2d(sobol, s, dim(PathDim::lens))); }));
    std::printf("filter + lens + time    %.2f\n", nanoseconds([&](const SampleSet<F>& s) {
                    return sum(sample_2d(sobol, s, dim(PathDim::filter))) +
                           sum(sample_2d(sobol, s, dim(PathDim::lens))) + sample_1d(sobol, s, dim(PathDim::time));
                }));
    std::printf(
        "uniform disc            %.2f more\n",
        nanoseconds([&](const SampleSet<F>& s) {
            return sum(uniform_disc(sample_2d(sobol, s, dim(PathDim::filter))));
        }) - nanoseconds([&](const SampleSet<F>& s) { return sum(sample_2d(sobol, s, dim(PathDim::filter))); }));
}

}  // namespace
}  // namespace drt

int main(int argc, char** argv) {
    const std::string what = argc > 1 ? argv[1] : "gains";
    if (what == "search") {
        for (const auto& matrix : drt::search()) {
            for (const std::uint32_t column : matrix) std::printf("0x%x, ", column);
            std::puts("");
        }
    } else if (what == "cost") {
        drt::cost();
    } else {
        drt::gains();
    }
}
