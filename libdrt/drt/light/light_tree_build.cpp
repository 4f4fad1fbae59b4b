#include "drt/light/light_tree_build.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <span>

namespace drt {
namespace {

using Lights = std::span<BoundedLight>;
constexpr int width = LightNode::width;

Vec3d centroid(const LightBounds& b) { return (b.lower + b.upper) * 0.5; }

// ---- where to cut --------------------------------------------------------------------------------------------------

// What a set of lights would cost as one: its strength, times the square of its extent, times how far its directions
// spread. After the surface area orientation heuristic; the squared diagonal stands for the area, so that lights in a
// row count, and the spread is seen from the length of the mean axis (1: all the same, 0: all over the place) between
// the two values that it has for a flat set and for one that shines all around (pi and 4 pi, up to a factor).
struct SetSum {
    Vec3d lower{1, 1, 1}, upper{-1, -1, -1};
    Vec3d axes;
    double strength = 0;
    int count = 0;

    void add(const SetSum& o) {
        if (o.count == 0) return;
        if (count == 0) {
            *this = o;
            return;
        }
        lower = {std::min(lower.x, o.lower.x), std::min(lower.y, o.lower.y), std::min(lower.z, o.lower.z)};
        upper = {std::max(upper.x, o.upper.x), std::max(upper.y, o.upper.y), std::max(upper.z, o.upper.z)};
        axes += o.axes;
        strength += o.strength;
        count += o.count;
    }
    void add(const LightBounds& b) {
        const bool directed = b.spread < pi<double> / 2;
        add(SetSum{b.lower, b.upper, directed ? b.axis * b.strength : Vec3d{}, b.strength, 1});
    }
    double cost() const {
        if (count == 0 || strength <= 0) return 0;
        return strength * length_squared(upper - lower) * (4 - 3 * length(axes) / strength);
    }
};

struct Cut {
    int axis = -1;  ///< -1: none, all centroids are one point
    double first = 0, per_length = 0;
    int below = 0;  ///< bins up to this one go left
    double cost = std::numeric_limits<double>::infinity();
    static constexpr int bins = 16;
    int bin(const LightBounds& b) const {
        return std::clamp(int((component(centroid(b), axis) - first) * per_length), 0, bins - 1);
    }
};

// The best of the planes between bins. `stretch` is large for a short axis: thin slabs make bad sets.
void try_axis(Lights lights, int axis, double first, double extent, double stretch, Cut& best) {
    Cut cut{axis, first, Cut::bins / extent, 0, 0};
    std::array<SetSum, Cut::bins> sums{}, right{};
    for (const BoundedLight& l : lights) sums[size_t(cut.bin(l.bounds))].add(l.bounds);
    right[Cut::bins - 1] = sums[Cut::bins - 1];
    for (int i = Cut::bins - 2; i > 0; --i) (right[size_t(i)] = sums[size_t(i)]).add(right[size_t(i) + 1]);
    SetSum left;
    for (int i = 0; i + 1 < Cut::bins; ++i) {
        left.add(sums[size_t(i)]);
        if (left.count == 0 || right[size_t(i) + 1].count == 0) continue;
        cut.cost = stretch * (left.cost() + right[size_t(i) + 1].cost());
        cut.below = i;
        if (cut.cost < best.cost) best = cut;
    }
}

Cut best_cut(Lights lights) {
    constexpr size_t many = 1024;  // for large sets the longest axis does, at a third of the time
    Vec3d lower = centroid(lights[0].bounds), upper = lower;
    for (const BoundedLight& l : lights) {
        const Vec3d c = centroid(l.bounds);
        lower = {std::min(lower.x, c.x), std::min(lower.y, c.y), std::min(lower.z, c.z)};
        upper = {std::max(upper.x, c.x), std::max(upper.y, c.y), std::max(upper.z, c.z)};
    }
    const Vec3d extent = upper - lower;
    const double longest = std::max({extent.x, extent.y, extent.z});
    Cut best;
    for (int axis = 0; axis < 3; ++axis) {
        const double e = component(extent, axis);
        if (!(e > 0) || !std::isfinite(Cut::bins / e) || (lights.size() > many && e < longest)) continue;
        try_axis(lights, axis, component(lower, axis), e, longest / e, best);
    }
    return best;
}

std::pair<Lights, Lights> split(Lights lights) {
    const Cut cut = best_cut(lights);
    size_t left = lights.size() / 2;
    if (cut.axis >= 0) {
        const auto middle = std::partition(lights.begin(), lights.end(),
                                           [&](const BoundedLight& l) { return cut.bin(l.bounds) <= cut.below; });
        left = size_t(middle - lights.begin());
    }
    return {lights.first(left), lights.subspan(left)};
}

// ---- nodes ---------------------------------------------------------------------------------------------------------

void write_box(LightNode& node, const LightBounds& all, const LightBounds* children) {
    for (int axis = 0; axis < 3; ++axis) {
        const double lower = component(all.lower, axis), upper = component(all.upper, axis);
        // Not finer than what a coordinate loses as a float: a step more to either side then covers the light.
        const double coordinate = std::max(std::abs(lower), std::abs(upper));
        const auto step = float(std::max({(upper - lower) / 32752, coordinate * 0x1p-22, 1e-18}));
        const auto origin = float(lower - 4.0 * double(step));
        node.step[axis] = step;
        node.origin[axis] = origin;
        const auto quantised = [&](double v, double more) {
            return int(std::clamp((v - double(origin)) / double(step) + more, 0.0, 32767.0));
        };
        for (int i = 0; i < node.count; ++i) {
            const int from = quantised(component(children[i].lower, axis), -1);
            const int to = quantised(component(children[i].upper, axis), 2);
            node.sum[axis][i] = std::uint16_t(to + from);
            node.extent[axis][i] = std::uint16_t(to - from);
        }
    }
}

void write_cone(LightNode& node, int i, const LightBounds& b) {
    for (int axis = 0; axis < 3; ++axis)
        node.axis[axis][i] = std::int16_t(std::lround(component(b.axis, axis) * 32767));
    // Wider by more than cosine and axis lose; the bound grows with both bytes only if the sine has the margin.
    const double sine = std::ceil(std::sin(b.spread) * 255 + 2);
    const bool all_directions = b.spread >= pi<double> / 2 || sine >= 255;
    node.cos_spread[i] = all_directions ? 0 : std::uint8_t(std::lround(std::cos(b.spread) * 255));
    node.sin_spread[i] = all_directions ? 255 : std::uint8_t(sine);
    if (!all_directions) node.directed = 1;
}

class Builder {
public:
    explicit Builder(LightTree& tree) : tree_(tree) {}

    LightBounds build(Lights lights, std::int32_t parent) {
        const auto index = std::int32_t(tree_.nodes.size());
        tree_.nodes.emplace_back();
        std::vector<Lights> parts = parts_of(lights);
        std::array<LightBounds, width> bounds;
        std::array<std::int32_t, width> child{};
        for (size_t i = 0; i < parts.size(); ++i) {
            const std::int32_t place = index * width + std::int32_t(i);
            if (parts[i].size() > 1) {
                child[i] = std::int32_t(tree_.nodes.size());
                bounds[i] = build(parts[i], place);
            } else {
                const LightId id = parts[i][0].id;
                child[i] = ~id;
                bounds[i] = parts[i][0].bounds;
                tree_.place[size_t(light_id::kind(id))][size_t(light_id::index(id))] = place;
            }
        }
        LightNode node{};
        node.parent = parent;
        node.count = std::int16_t(parts.size());
        std::copy(child.begin(), child.end(), node.child);
        const LightBounds all = unite(bounds.data(), node.count);
        write_box(node, all, bounds.data());
        for (int i = 0; i < node.count; ++i) {
            write_cone(node, i, bounds[size_t(i)]);
            node.strength[i] = float(bounds[size_t(i)].strength);
        }
        tree_.nodes[size_t(index)] = node;
        return all;
    }

private:
    // Up to eight: the one that costs most is cut, until there are enough.
    static std::vector<Lights> parts_of(Lights lights) {
        struct Part {
            Lights lights;
            double cost;
        };
        const auto weigh = [](Lights s) {
            SetSum sum;
            for (const BoundedLight& l : s) sum.add(l.bounds);
            return Part{s, sum.cost()};
        };
        std::vector<Part> parts{{lights, 0}};
        while (int(parts.size()) < width) {
            const auto worst = std::max_element(parts.begin(), parts.end(), [](const Part& a, const Part& b) {
                const bool single_a = a.lights.size() == 1, single_b = b.lights.size() == 1;
                if (single_a != single_b) return single_a;
                return a.cost != b.cost ? a.cost < b.cost : a.lights.size() < b.lights.size();
            });
            if (worst->lights.size() == 1) break;
            const auto [left, right] = split(worst->lights);
            *worst = weigh(left);
            parts.push_back(weigh(right));
        }
        std::vector<Lights> out;
        for (const Part& p : parts) out.push_back(p.lights);
        return out;
    }

    LightTree& tree_;
};

}  // namespace

LightTree build_light_tree(std::vector<BoundedLight>& lights) {
    LightTree tree;
    if (lights.empty()) return tree;
    double total = 0;
    std::array<size_t, light_kinds> length{};
    for (const BoundedLight& l : lights) {
        total += l.bounds.strength;
        size_t& n = length[size_t(light_id::kind(l.id))];
        n = std::max(n, size_t(light_id::index(l.id)) + 1);
    }
    for (BoundedLight& l : lights) l.bounds.strength /= total;
    for (size_t k = 0; k < length.size(); ++k) tree.place[k].assign(length[k], -1);
    Builder(tree).build(lights, -1);
    return tree;
}

}  // namespace drt
