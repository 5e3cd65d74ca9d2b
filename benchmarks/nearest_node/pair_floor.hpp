// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/colonization/growth.hpp"

namespace phytobench {

/// Pairs that any exact method must look at.
struct PairFloor {
  std::uint64_t association = 0;  ///< new node, live point within the influence distance
  std::uint64_t removal = 0;      ///< removed point and the killer that reached it first
};

/// Pairs of a growth, counted by an engine that looks at all of them.
PairFloor count_pairs(const Seedling& seedling, const GrowthRun& run);

}  // namespace phytobench
