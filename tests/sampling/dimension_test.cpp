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
            const SampleSet<T> set{sample_key<U>(1, 2, 1, U(x * 37u), U(x * x)), U(index)};
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
    0x258f08ea0ae7cfbeu, 0xc5fc58a11a31714au, 0xc209a57f5cf975f8u, 0x8bc79e7827492bdfu, 0x632fa3447bf2230cu,
    0x15485d7dbc2c468du, 0x509eb9d37c97cc05u, 0x365231c15905724cu, 0x4914b72246eb0a4au, 0xe61ca2e054f59350u,
    0x7b7e92c03cd51b97u, 0xf2dc8ad918a13484u, 0x9c92d7a81247ae26u, 0x9805dbbbffd2bdcau, 0x8a2bf7456d3c7fb5u,
    0x8a876d73cdfc4933u, 0x7a72864550cd8760u, 0xde2ddc3a694d8bd3u, 0x3cf5e743e78a0819u, 0xbdbbbc7af909328cu,
    0x989526f303d9ffa8u, 0x712ac1346607d0d3u, 0xdad6f2770d82c306u, 0xff064f91c5c84a05u, 0x7992c07bd55f436fu,
    0x6e06eb8933c8c03cu, 0xce4b3206ade8953fu, 0xf21d82b76d884f5du, 0x6d75d80b549dbc83u, 0xeb0ee00b4c43cb42u,
    0x8336345edd59247eu, 0x973c5c1a79c00feau, 0xb8724da513622ed7u, 0x15127b5433252073u, 0x740bbc4ce5a2cbeeu,
    0xcc6ac4857186f55du, 0x2684f3febd55fb8eu, 0xa26486b117840c4u,  0x3c15ec5b36bde3edu, 0x91e1602fde85495au,
    0x63adcdfd78507a31u, 0xc112590ab1e07d11u, 0x267217e8e9d1cdafu, 0x4f651fdc1ae93bd7u, 0x2d2ed51fc54c59ebu,
    0xb0ad7b2bf41cbac2u, 0x2acd6acef4bfa2feu, 0x3d2b400dc23a5727u};

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
