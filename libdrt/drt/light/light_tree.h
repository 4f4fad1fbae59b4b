#pragma once
// A tree over lights that fall off with the square of the distance, to choose a few of very many for a shaded point:
// at each node a child with a probability that is proportional to a bound on what it can send there.
// Conty Estevez and Kulla, "Importance Sampling of Many Lights with Adaptive Tree Splitting", 2018.
//
// Nodes have eight children, side by side, so that lanes hold the children of one node: a point goes through a tree of
// a million lights in seven steps, and nothing is gathered. All bounds are conservative: a light that can light a point
// has a positive probability there.
//
// Probabilities are ratios of whole numbers, and what is left of a random number below one choice, filled up with
// fresh bits, makes the next. So a stated probability is the chance of being chosen, however deep the tree.

#include <array>
#include <bit>
#include <span>
#include <vector>

#include "drt/base/vec.h"
#include "drt/light/light_id.h"
#include "drt/sampling/hash.h"

namespace drt {

inline constexpr int tree_draws = 4;  ///< lights that are chosen for a point, stratified

/// 32 bytes a child. Child i has the box origin + step / 2 * (sum[.][i] -+ extent[.][i]).
struct alignas(64) LightNode {
    static constexpr int width = 8;
    float origin[3], step[3];
    std::uint16_t sum[3][width], extent[3][width];      ///< upper + lower, upper - lower
    std::int16_t axis[3][width];                        ///< of the cone of normals, in units of 1 / 32767
    std::uint8_t cos_spread[width], sin_spread[width];  ///< of the cone, in units of 1 / 255; 0 and 255: all directions
    float strength[width];                              ///< of all: 1
    std::int32_t child[width];                          ///< a node; or ~id of a light
    std::int32_t parent;                                ///< node * width + child there; -1: the root
    std::int16_t count;                                 ///< children in use, the first ones
    std::int16_t directed;                              ///< 0: they all shine in all directions
};
static_assert(sizeof(LightNode) == 256);

struct LightTree {
    std::vector<LightNode> nodes;                              ///< the root first; empty: no tree
    std::array<std::vector<std::int32_t>, light_kinds> place;  ///< of a light, by kind and index: as `parent`
    bool empty() const { return nodes.empty(); }
};

/// A light that was chosen for a point.
struct LightDraw {
    LightId light = no_light;  ///< none if no light can send anything there
    float probability = 0;
};

namespace light_tree_detail {

using F8 = Lane<float, LightNode::width>;
using I8 = Lane<std::int32_t, LightNode::width>;

/// Child i has the units from end[i - 1] (0 for the first) up to end[i].
struct Shares {
    alignas(32) std::int32_t end[LightNode::width];
    std::int32_t total() const { return end[LightNode::width - 1]; }
    std::int32_t begin(int i) const { return i > 0 ? end[i - 1] : 0; }
    float probability(int i) const { return float(end[i] - begin(i)) / float(total()); }
};

template <class S>
[[gnu::always_inline]] inline F8 widen(const S* p) {
#if defined(__AVX2__)
    if constexpr (std::is_same_v<S, std::uint16_t>)
        return F8(_mm256_cvtepi32_ps(_mm256_cvtepu16_epi32(_mm_loadu_si128(reinterpret_cast<const __m128i*>(p)))));
    else if constexpr (std::is_same_v<S, std::int16_t>)
        return F8(_mm256_cvtepi32_ps(_mm256_cvtepi16_epi32(_mm_loadu_si128(reinterpret_cast<const __m128i*>(p)))));
    else
        return F8(_mm256_cvtepi32_ps(_mm256_cvtepu8_epi32(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(p)))));
#else
    return F8([&](auto i) { return float(p[i]); });
#endif
}

struct Box {
    Vec3<F8> center, half;  ///< center relative to the point
};

template <class Real>
[[gnu::always_inline]] inline Box child_boxes(const LightNode& node, const Vec3<Real>& p) {
    const auto along = [&](int axis, Real x, F8& center, F8& half) {
        const F8 half_step(0.5f * node.step[axis]);
        center = widen(node.sum[axis]) * half_step - F8(float(x - Real(node.origin[axis])));
        half = widen(node.extent[axis]) * half_step;
    };
    Box b;
    along(0, p.x, b.center.x, b.half.x);
    along(1, p.y, b.center.y, b.half.y);
    along(2, p.z, b.center.z, b.half.z);
    return b;
}

/// The largest value over the box of dot(direction, x): never too small but for rounding.
[[gnu::always_inline]] inline F8 farthest_along(const Vec3<F8>& direction, const Box& box) {
    using stdx::abs;
    return dot(direction, box.center) + abs(direction.x) * box.half.x + abs(direction.y) * box.half.y +
           abs(direction.z) * box.half.z;
}

/// For each child the largest value over its box, and over all normals a of its cone, of -a . x: the cosine at the
/// light, times the distance `reach`; cos(angle - spread) <= cos(angle) cos(spread) + sin(spread).
[[gnu::always_inline]] inline F8 farthest_ahead(const LightNode& node, const Box& box, const F8& reach) {
    const Vec3<F8> back = Vec3<F8>{widen(node.axis[0]), widen(node.axis[1]), widen(node.axis[2])} * F8(-1 / 32767.0f);
    const F8 end = reach + box.half.x + box.half.y + box.half.z;
    return (farthest_along(back, box) * widen(node.cos_spread) + end * widen(node.sin_spread)) * F8(1 / 255.0f);
}

/// Of each child, the sum of its own value and those before.
[[gnu::always_inline]] inline I8 running_sums(const I8& v) {
#if defined(__AVX2__)
    auto x = static_cast<__m256i>(v);
    x = _mm256_add_epi32(x, _mm256_slli_si256(x, 4));  // within the halves
    x = _mm256_add_epi32(x, _mm256_slli_si256(x, 8));
    const __m256i lower = _mm256_permute2x128_si256(x, x, 0x08);  // 0, and the lower half
    return I8(_mm256_add_epi32(x, _mm256_shuffle_epi32(lower, 0xff)));
#else
    I8 out = v;
    for (int i = 1; i < LightNode::width; ++i) out[i] = out[i - 1] + out[i];
    return out;
#endif
}

/// What the children of a node are worth for a point p with the unit normal n: strength, times bounds of both cosines,
/// over the squared distance to the middle (within the box' sphere: over the sphere's squared radius). In whole units
/// out of about 2^24, at least one for each child that can send anything.
template <class Real>
inline Shares shares(const LightNode& node, const Vec3<Real>& p, const Vec3f& n) {
    using std::sqrt;
    const Box box = child_boxes(node, p);
    const F8 reach2 = max(length_squared(box.center), length_squared(box.half));
    const F8 inverse = F8(1) / sqrt(reach2), reach = reach2 * inverse;
    const F8 above = farthest_along(Vec3<F8>(n), box) + reach * F8(1e-6f);
    auto sends = above > F8(0) && iota<F8>() < F8(float(node.count));
    F8 cosines = min(above * inverse, F8(1));
    if (node.directed != 0) {
        const F8 ahead = farthest_ahead(node, box, reach);
        sends = sends && ahead > F8(0);
        cosines *= min(ahead * inverse, F8(1));
    }
    const F8 strength(node.strength, stdx::vector_aligned);
    const F8 worth = select(sends, min(strength * cosines * (inverse * inverse), F8(1e30f)), F8(0));
    const F8 units_each = worth * F8(0x1p24f / max(stdx::reduce(worth), 1e-30f));
    const I8 units = num_cast<I8>(units_each) + I8(1);
    Shares out;
    running_sums(select(mask_cast<I8>(sends), units, I8(0))).copy_to(out.end, stdx::vector_aligned);
    return out;
}

/// On the way down. `u` is what is left of the random number: 32 binary digits, then fresh ones.
struct Descent {
    std::int32_t node = 0;  ///< -1: arrived
    std::uint32_t u = 0, fresh = 0;
    LightDraw draw{no_light, 1};
};

[[gnu::always_inline]] inline void step_down(Descent& d, const LightNode& node, const Shares& s) {
    const auto total = std::uint64_t(s.total());
    if (total == 0) {
        d.node = -1;
        d.draw.probability = 0;
        return;
    }
    const std::uint64_t x = d.u * total + ((d.fresh * total) >> 32);
    const I8 ends(s.end, stdx::vector_aligned);
    const int i = stdx::popcount(ends <= I8(std::int32_t(x >> 32)));
    const auto begin = std::uint64_t(s.begin(i)), units = std::uint64_t(s.end[i]) - begin;
    d.u = std::uint32_t((x - (begin << 32)) / units);
    d.fresh = mix_bits(d.fresh + 0x9e3779b9u);
    d.draw.probability *= s.probability(i);
    const std::int32_t child = node.child[i];
    d.node = child >= 0 ? child : -1;
    if (child < 0) d.draw.light = ~child;
}

}  // namespace light_tree_detail

/// A point that asks, with the unit normal n on whose side light arrives, and independent random bits.
template <class Real>
struct TreePoint {
    Vec3<Real> p;
    Vec3f n;
    std::uint32_t u, fresh;
};
using TreeDraws = std::array<LightDraw, tree_draws>;

inline constexpr std::size_t points_at_once = 4;

/// Draws `tree_draws` lights for each of up to `points_at_once` points, one from each part of the unit interval. A
/// light's probability is the same in all draws of a point taken together: the expected number of draws of it is
/// tree_draws times that.
template <class Real>
void choose_lights(const LightTree& tree, std::span<const TreePoint<Real>> points, TreeDraws* out) {
    using namespace light_tree_detail;
    static_assert(tree_draws == 4);
    std::array<std::array<Descent, tree_draws>, points_at_once> descents;
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::uint32_t k = 0; k < tree_draws; ++k) {
            descents[i][k].u = k << 30 | points[i].u >> 2;
            descents[i][k].fresh = mix_bits(points[i].fresh + k);
        }
    // All draws of all points a level at a time: the draws of a point often share a node, and of a large tree the
    // memory of the others arrives meanwhile.
    Shares at_node;
    for (bool under_way = true; under_way;) {
        under_way = false;
        for (std::size_t i = 0; i < points.size(); ++i) {
            std::int32_t known = -1;
            for (Descent& d : descents[i]) {
                if (d.node < 0) continue;
                const LightNode& node = tree.nodes[size_t(d.node)];
                if (d.node != known) at_node = shares(node, points[i].p, points[i].n);
                known = d.node;
                step_down(d, node, at_node);
                if (d.node < 0) continue;
                under_way = true;
                const char* next = reinterpret_cast<const char*>(&tree.nodes[size_t(d.node)]);
                for (int line = 0; line < 4; ++line) __builtin_prefetch(next + 64 * line);
            }
        }
    }
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t k = 0; k < tree_draws; ++k) out[i][k] = descents[i][k].draw;
}

/// The probability of one light of the tree in a draw.
template <class Real>
float choice_probability(const LightTree& tree, LightId light, const Vec3<Real>& p, const Vec3f& n) {
    float probability = 1;
    std::int32_t place = tree.place[size_t(light_id::kind(light))][size_t(light_id::index(light))];
    while (place >= 0) {
        const LightNode& node = tree.nodes[size_t(place / LightNode::width)];
        const light_tree_detail::Shares s = light_tree_detail::shares(node, p, n);
        probability *= s.total() > 0 ? s.probability(place % LightNode::width) : 0;
        place = node.parent;
    }
    return probability;
}

}  // namespace drt
