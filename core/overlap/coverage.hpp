// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "core/overlap/overlap_engine.hpp"

namespace phytobench {

/// How often the ground is covered, and how much of each disc by others. Sums over pairs cannot
/// tell: where three discs overlap they count the same ground more than once, and may exceed the
/// disc.
struct Coverage {
  /// Area covered exactly k times. [0] is what is left of the window; 0 where there is none.
  std::vector<double> by_times;
  /// Of each disc, the part that at least one other disc covers: 0 to its area.
  std::vector<double> covered;
};

/// Exact up to rounding: regions are followed along the arcs that bound them. by_times counts only
/// ground in `window` (on a torus always the torus itself; without either, the whole plane),
/// covered the whole of each disc. Time grows as the number of overlapping pairs. A disc's covered
/// area is off by some 1e-15 of its radius times the largest radius of its neighbours; by_times by
/// as much of the radius times the size of the scene for each arc. The same for any number of
/// threads. Throws InputError beyond most_pairs pairs (on a torus those of images, too); discs must
/// be fit (problem_with()).
Coverage coverage(const Discs& discs, const Ground& ground,
                  const std::optional<Rectangle>& window = std::nullopt, int threads = 1,
                  std::size_t most_pairs = OverlapSetup().most_pairs);

}  // namespace phytobench
