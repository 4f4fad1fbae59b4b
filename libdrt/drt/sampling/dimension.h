#pragma once
// What a path draws, by name. Every picture depends on this table, and so do checkpoints and references: its rows stay
// as they are.
//
// A new quantity takes a free id, which has a group of its own already: give it a name in the enumeration, and nothing
// else changes. It never joins an older group, where it would take the place of what a later bounce draws. One
// dimension is a point of the unit square, or its x.

#include <array>
#include <cstdint>

#include "drt/sampling/joint_index.h"

namespace drt {

/// Drawn once a camera path. 5 to 15 are free.
enum class PathDim : std::uint32_t { filter, lens, time, wavelength, camera_medium };

/// Drawn at each hit. 27 to 31 are free. Nobody draws those from `closure_choice` on yet.
enum class HitDim : std::uint32_t {
    lobe_choice = 16,  ///< reflected or refracted
    lobe,
    roulette,
    light_choice,  ///< from a table
    light,         ///< the point on it
    light_tree,    ///< choice from a tree
    closure_choice,
    second_lobe,
    medium_distance,
    medium_phase,
    subsurface,
};

/// Keeps the scrambles of a dimension apart from those of all others: name, bounce and number, from the lowest bit.
using DimId = std::uint32_t;

inline constexpr int name_bits = 6, bounce_bits = 16, number_bits = 10;
inline constexpr int most_bounces = 1 << bounce_bits, most_numbers = 1 << number_bits;

constexpr DimId dim(PathDim d) { return DimId(d); }
/// `bounce` counts from 0 (the camera ray's hit). `number` tells apart what is drawn at one hit for terms that are only
/// added: the lights.
constexpr DimId dim(HitDim d, int bounce, int number = 0) {
    return DimId(d) | DimId(bounce) << name_bits | DimId(number) << (name_bits + bounce_bits);
}

/// Where a dimension stands among those that it is stratified with.
struct JointSlot {
    std::uint32_t group;  ///< dimensions of a group share a shuffled index
    int slot;             ///< 0..3: which of the four joint matrices
};

/// Where a dimension stands at bounce 0. Each bounce takes the next slot, so the last one is followed by slot 0 of a
/// further group.
struct DimensionRow {
    std::uint32_t id, group;
    int slot;
};

/// The main group has the points on a path in the order of its events. What a hit draws for terms that are only added,
/// the lights and the lobe, shares a slot: the scrambles differ, so the errors of the terms are independent. So does
/// what takes the lobe's place in a medium.
inline constexpr std::array<DimensionRow, 32> dimension_table{{
    {0, 0, 0},    // filter
    {1, 0, 1},    // lens
    {2, 0, 2},    // time
    {3, 3, 0},    // wavelength
    {4, 4, 0},    // camera_medium
    {5, 5, 0},    // free
    {6, 6, 0},    // free
    {7, 7, 0},    // free
    {8, 8, 0},    // free
    {9, 9, 0},    // free
    {10, 10, 0},  // free
    {11, 11, 0},  // free
    {12, 12, 0},  // free
    {13, 13, 0},  // free
    {14, 14, 0},  // free
    {15, 15, 0},  // free
    {16, 16, 0},  // lobe_choice
    {17, 0, 3},   // lobe
    {18, 18, 0},  // roulette
    {19, 19, 0},  // light_choice
    {20, 0, 3},   // light
    {21, 21, 0},  // light_tree
    {22, 22, 0},  // closure_choice
    {23, 23, 0},  // second_lobe
    {24, 24, 0},  // medium_distance
    {25, 0, 3},   // medium_phase
    {26, 26, 0},  // subsurface
    {27, 27, 0},  // free
    {28, 28, 0},  // free
    {29, 29, 0},  // free
    {30, 30, 0},  // free
    {31, 31, 0},  // free
}};

constexpr JointSlot joint_slot(DimId d) {
    const DimensionRow& row = dimension_table[d % (1u << name_bits)];
    const std::uint32_t bounce = (d >> name_bits) % most_bounces;
    const std::uint32_t position = std::uint32_t(row.slot) + bounce;
    return {row.group | (position / joint_dims) << name_bits, int(position % joint_dims)};
}

/// Stands for all that share the main group's slot at a hit.
constexpr DimId hit_dim(int bounce) { return dim(HitDim::light, bounce); }

}  // namespace drt
