// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "core/tree/skeleton.hpp"

namespace phytobench {

/// A tree as [Brzoska2019] listing 1 defines it, after Oppenheimer 1986. The thesis names the
/// parameters without values; the defaults are ours.
struct RecursiveTreeParameters {
  double size = 1.0;               ///< length of the first segment, > 0
  double smallest = 0.3;           ///< a shorter segment carries a leaf and ends, > 0
  std::int32_t branches = 2;       ///< n, side branches of each segment, 0 to 100
  double stem_ratio = 0.8;         ///< length of the next stem segment over this one's, (0, 1)
  double branch_ratio = 0.8;       ///< length of a side branch over its segment's, (0, 1)
  double branch_angle_deg = 40.0;  ///< between stem and side branch, [0, 180]
  double twist_deg = 137.5;        ///< by which the branches of the next segment are turned
  std::size_t most_segments = 10'000'000;
};

struct RecursiveTree {
  Skeleton skeleton{Vector3{}};
  std::vector<std::int32_t> leaf_nodes;  ///< ends of the segments that carry a leaf, ascending
};

/// Grows upwards from the origin: a segment; if it is too small a leaf, else a stem and n branches,
/// each a tree. Throws InputError naming the parameter that is out of range, or if there would be
/// more than most_segments.
RecursiveTree grow_recursive_tree(const RecursiveTreeParameters& parameters);

}  // namespace phytobench
