// SPDX-License-Identifier: MIT
// What horns and trees have in common: a bent cone ([Lintermann1997] sec. 4: a tree makes a horn).
#pragma once

#include <array>
#include <vector>

#include "core/component_graph/component.hpp"
#include "core/component_graph/shapes/component_material.hpp"
#include "core/component_graph/shapes/key_table.hpp"
#include "core/component_graph/shapes/spine.hpp"
#include "core/component_graph/shapes/tapered_tube.hpp"

namespace phytobench {

/// Positions in stem_keys.
struct StemKey {
  enum : std::size_t {
    length,
    segments,
    radius_first,
    radius_last,
    radius_power,
    bend_first,
    bend_last,
    twist,
    corners,
    caps,
    surface,
    colour,
    count
  };
};

inline constexpr std::array<ComponentKey, StemKey::count> stem_keys{{
    {"length", "length", "of the axis", in_section_4, "1.0", RangedNumber{positive_lengths, 1.0}},
    {"segments", "1", "straight pieces of the axis", in_section_4, "8",
     RangedNumber{piece_counts, 8.0}},
    {"radius_first", "length", "radius where it begins", in_section_4, "0.05",
     RangedNumber{lengths, 0.05}},
    {"radius_last", "length", "radius at its end; 0 is a point", in_section_4, "0.01",
     RangedNumber{lengths, 0.01}},
    {"radius_power", "1", "the radius goes from first to last as share of the length to this power",
     own_choice, "1.0", RangedNumber{NumberRange{.high = 100.0, .low_is_allowed = false}, 1.0}},
    {"bend_first", "degrees",
     "turn between the first two pieces about x, from y to z; linear to bend_last", in_section_5,
     "0.0", RangedNumber{turns, 0.0}},
    {"bend_last", "degrees", "turn between the last two pieces; a single joint takes the mean",
     in_section_5, "0.0", RangedNumber{turns, 0.0}},
    {"twist", "degrees", "turn about the axis at each joint: a bent stem becomes a spiral",
     own_choice, "0.0", RangedNumber{turns, 0.0}},
    {"corners", "1", "of a ring across it", in_section_5, "8", RangedNumber{corner_counts, 8.0}},
    {"caps", "-", "ends that are closed by a disc", own_choice, "\"both\"",
     WordChoice{tube_cap_words, 2}},
    {"surface", "-", "what it looks like; \"bark\" has streaks", own_choice, "\"bark\"",
     WordChoice{surface_words, 0}},
    {"colour", "-", "of the surface", own_choice, "\"#6b4a2b\"", ColourValue{"#6b4a2b"}},
}};

/// The frame turned by the bend and the twist of joint `joint` of `joints` (1 ... joints); as it is
/// at both ends of the stem. The turns about x of m joints add up to m (first + last) / 2.
Frame bent(const ComponentValues& values, const Frame& frame, int joint, int joints);

/// The axis of a stem of the given kind of turns.
Spine stem_spine(const ComponentValues& values, const SpineTurn& turn);

/// Radius at a share of the length.
double stem_radius(const ComponentValues& values, double share);

/// The cone about a spine. A resolution below 1 leaves out rings and corners, one above 1 adds
/// corners: the axis is the same for every resolution.
void add_stem(const ComponentInput& input, const Spine& spine, std::vector<MeshPart>& parts);

}  // namespace phytobench
