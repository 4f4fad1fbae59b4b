// The contract that pins every picture: which dimensions there are, where they stand, and their points bit for bit.

#include "drt/sampling/dimension.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "drt/sampling/sampler.h"

namespace drt {
namespace {

constexpr std::uint32_t first_hit_id = DimId(HitDim::lobe_choice);

/// The table's dimensions by id.
constexpr DimId dim_of(std::uint32_t id, int bounce, int number) {
    return id < first_hit_id ? dim(PathDim(id)) : dim(HitDim(id), bounce, number);
}

TEST(Dimensions, TableIsSortedWithSixteenIdsForAHit) {
    for (size_t i = 0; i < dimension_table.size(); ++i) EXPECT_EQ(dimension_table[i].id, i);
    EXPECT_EQ(dimension_table.size(), first_hit_id + 16);
    EXPECT_LE(dimension_table.size(), 1u << name_bits);
}

TEST(Dimensions, PathFillsGroupsInOrder) {
    const auto at = [](DimId d) { return std::pair(joint_slot(d).group, joint_slot(d).slot); };
    EXPECT_EQ(at(dim(PathDim::filter)), std::pair(0u, 0));
    EXPECT_EQ(at(dim(PathDim::time)), std::pair(0u, 2));
    EXPECT_EQ(at(dim(HitDim::light, 0, 7)), std::pair(0u, 3));
    EXPECT_EQ(at(dim(HitDim::lobe, 0)), std::pair(0u, 3));
    EXPECT_EQ(at(dim(HitDim::lobe, 1)), std::pair(64u, 0));
    EXPECT_EQ(at(dim(HitDim::light, 4)), std::pair(64u, 3));
    EXPECT_EQ(at(dim(HitDim::light_choice, 5, 1)), std::pair(64u + 19u, 1));
    EXPECT_EQ(at(dim(HitDim::roulette, 3)), std::pair(18u, 3));
}

TEST(Dimensions, ShareASlotOnlyAsTermsOfOneHit) {
    std::map<std::pair<std::uint32_t, int>, std::set<DimId>> users;
    const auto add = [&](DimId d) { users[{joint_slot(d).group, joint_slot(d).slot}].insert(d); };
    for (std::uint32_t id = 0; id < first_hit_id; ++id) add(dim_of(id, 0, 0));
    for (std::uint32_t id = first_hit_id; id < dimension_table.size(); ++id)
        for (int bounce = 0; bounce < 20000; ++bounce) add(dim_of(id, bounce, 0));
    for (const auto& [place, ids] : users) {
        if (ids.size() == 1) continue;
        const int bounce = int(*ids.begin() >> name_bits);
        const std::set<DimId> terms{dim(HitDim::light, bounce), dim(HitDim::lobe, bounce),
                                    dim(HitDim::medium_phase, bounce)};
        ASSERT_EQ(ids, terms);
    }
}

TEST(Dimensions, NoTwoIdsAreTheSame) {
    std::set<DimId> ids;
    size_t made = 0;
    for (std::uint32_t id = first_hit_id; id < dimension_table.size(); ++id)
        for (const int bounce : {0, 1, 2, 3, 31, 32, 255, 256, 4095, 10000, 32768, most_bounces - 1})
            for (int number = 0; number < most_numbers; ++number, ++made) ids.insert(dim_of(id, bounce, number));
    EXPECT_EQ(ids.size(), made);
}

// ---- bit for bit
// ------------------------------------------------------------------------------------------------------

/// FNV-1a of the points of 16 pixels at five samples each, in the 24 bits that float and double have in common.
template <class T>
std::uint64_t digest(DimId d) {
    using U = Rebind<T, std::uint32_t>;
    constexpr std::uint32_t pixels = 16;
    std::uint64_t h = 0xcbf29ce484222325u;
    const auto add = [&](double v) { h = (h ^ std::uint64_t(v * 0x1p24)) * 0x100000001b3u; };
    for (const std::uint32_t index : {0u, 1u, 2u, 77u, 5000u})
        for (std::uint32_t first = 0; first < pixels; first += std::uint32_t(width_of<T>)) {
            U x{};
            if constexpr (is_lane<T>)
                x = U([&](auto i) { return first + std::uint32_t(i); });
            else
                x = first;
            const SampleSet<T> set = pixel_sample<T>(1, 2, 1, U(x * 37u), U(x * x), U(index));
            const Vec2<T> p = sample_2d(SamplerKind::sobol, set, d);
            const T x_alone = sample_1d(SamplerKind::sobol, set, d);
            for (int i = 0; i < width_of<T>; ++i) {
                EXPECT_EQ(lane(x_alone, i), lane(p.x, i));
                add(double(lane(p.x, i)));
                add(double(lane(p.y, i)));
            }
        }
    return h;
}

/// Sixteen ids of a path; sixteen of a hit at bounce 0, and at bounce 6 with number 3.
std::vector<DimId> pinned_dimensions() {
    std::vector<DimId> out;
    for (std::uint32_t id = 0; id < dimension_table.size(); ++id) out.push_back(dim_of(id, 0, 0));
    for (std::uint32_t id = first_hit_id; id < dimension_table.size(); ++id) out.push_back(dim_of(id, 6, 3));
    return out;
}

constexpr std::uint64_t pinned[] = {
    0x08c5f69aabe42214u, 0xb181fc71f8e8b4f3u, 0xa69eba7dde9ecc5bu, 0x93c27220d8ce08c6u, 0x8750f85d7bfb1ab6u,
    0x1c96849dd458e4b1u, 0xcf83d04816cda1b1u, 0x0e227b7eec49f137u, 0xe4880f7835b935ffu, 0x3138006e87f61581u,
    0xed3849e8a08b7d45u, 0x9d45ee5f2e3df814u, 0xb78573f3c8a5a3dbu, 0xfce5597b22d7f5cdu, 0x16793a9bfefda057u,
    0xbea92d61a0ff4621u, 0xc149102b9c9e5f2cu, 0xe72e0bd8567f5dcau, 0x50434e0651ed347eu, 0x056d5e3ae4b72575u,
    0xbf3ee456402d36feu, 0xff5e8d9b852427e4u, 0x9a456c5a08cd1dfcu, 0x4f2127fbc6786a0cu, 0x6ec1e92321e7c845u,
    0x01189a2a6fff1e99u, 0xe825d46746e74039u, 0xac307bec7e6b827du, 0xde05bc621b0b7776u, 0x005bd69388825a94u,
    0x0635f0cc7e96f2eau, 0x69416445fa7bbcd6u, 0x7f2ef2ad5f363ecau, 0xf04bbcc2fd8d7136u, 0xf581c1da002e425au,
    0x37b0e1d878026dedu, 0x967657f1a6f8dae5u, 0x8a9ebfd830319110u, 0xeafe7a95366583a5u, 0x8b10c707c1eb661cu,
    0xf99998f05599fc5cu, 0xbadbb034aea3bbbau, 0x4d9274ecac06d291u, 0x81341bbda89bafd2u, 0x482146fced1fae25u,
    0x04b70de48bad1082u, 0x47df96208193b44au, 0xb7609d3c7235b51eu};

TEST(Dimensions, PointsStayTheSame) {
    // 3840 points. A change of their bits changes every picture, and makes checkpoints and references of older versions
    // unusable.
    const std::vector<DimId> dimensions = pinned_dimensions();
    ASSERT_EQ(dimensions.size(), std::size(pinned));
    for (size_t i = 0; i < dimensions.size(); ++i) {
        const DimId d = dimensions[i];
        EXPECT_EQ(digest<float>(d), pinned[i]) << "dimension " << d;
        EXPECT_EQ(digest<double>(d), pinned[i]) << "dimension " << d;
        EXPECT_EQ((digest<Lane<float, 4>>(d)), pinned[i]) << "dimension " << d;
        EXPECT_EQ((digest<Lane<float, 8>>(d)), pinned[i]) << "dimension " << d;
        EXPECT_EQ((digest<Lane<float, 16>>(d)), pinned[i]) << "dimension " << d;
        EXPECT_EQ((digest<Lane<double, 8>>(d)), pinned[i]) << "dimension " << d;
    }
}

}  // namespace
}  // namespace drt
