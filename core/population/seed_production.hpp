// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

namespace phytobench {

/// How many seeds a plant of a given size bears: none below a threshold, from there on in
/// proportion to what it exceeds the threshold by, and no more beyond its largest size ([Alsweis]
/// sec. 4.4, which gives no numbers). Sizes in any one unit.
struct SeedProduction {
  double threshold = 0.0;
  double seeds_per_size = 0.0;  ///< per step and unit of size above the threshold, at least 0
  double largest_size = 0.0;    ///< at least the threshold

  /// Expected number in one step, real: draw a Poisson number of this mean for whole seeds.
  double expected_seeds(double size) const {
    return seeds_per_size * std::max(0.0, std::min(size, largest_size) - threshold);
  }
};

}  // namespace phytobench
