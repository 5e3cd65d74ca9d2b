// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/overlap/discs.hpp"

namespace phytobench {

/// Discs that own their numbers, and where they lie.
struct OverlapWorkload {
  std::string name;
  std::vector<double> x, y, radius;
  Ground ground;
  std::uint64_t seed = 0;

  Discs discs() const { return {x, y, radius}; }
};

enum class DiscSizes {
  equal,
  uniform,  ///< radii evenly between a third of the largest and the largest
  mixed,    ///< radii from 1 to 1000, evenly in their logarithm
};

std::string_view name_of(DiscSizes sizes);
/// Throws InputError naming the known ones.
DiscSizes disc_sizes_named(std::string_view name);

struct RandomDiscs {
  std::size_t count = 1'000'000;
  DiscSizes sizes = DiscSizes::equal;
  double partners =
      10.4;  ///< that a disc overlaps on average, on a torus: 5.2 million pairs at 10^6
  bool is_torus = false;
  std::uint64_t seed = 0;
};

/// Centers independent and uniform in a square of area `count`. Largest radii of small mixed scenes
/// are cut so that they fit on a torus.
OverlapWorkload random_discs(const RandomDiscs& request);

/// The same kind of scene with about `count` of its discs, in a square so much smaller.
OverlapWorkload smaller(const OverlapWorkload& workload, std::size_t count);

}  // namespace phytobench
