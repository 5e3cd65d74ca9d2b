// SPDX-License-Identifier: MIT
// What faulty engines begin with, before each makes its mistake.
#pragma once

#include "core/overlap/overlap_registry.hpp"

namespace phytobench::overlap_engines {

inline OverlapWork find_rightly(const Discs& discs, const Ground& ground, const OverlapSetup& setup,
                                OverlapPairs& pairs) {
  return overlap_engine_named("layered_grid").create()->find(discs, ground, setup, pairs);
}

}  // namespace phytobench::overlap_engines
