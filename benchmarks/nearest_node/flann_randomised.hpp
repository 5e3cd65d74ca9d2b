// SPDX-License-Identifier: MIT
// Engines that only come close to the nearest node. They are in no registry: no race ranks them
// with exact ones, no test demands the oracle's answers of them (see approximate_lane.hpp).
#pragma once

#include <span>

#include "core/nearest_node/engine.hpp"

namespace phytobench {

/// flann_randomised_16, _64 and _256: FLANN's 4 randomised k-d trees, by the number of leaves (one
/// node each) that a search looks into at most. Where FLANN was not found none of them is built.
///
/// Removal is exact. Answers, and so trees, differ from run to run and cannot be made to repeat.
std::span<const EngineDescriptor> approximate_engines();

}  // namespace phytobench
