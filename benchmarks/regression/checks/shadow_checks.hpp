// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "benchmarks/shadow/shadow_workload.hpp"
#include "core/terrain/shadow/lit_maps.hpp"

namespace phytobench {

/// What is wrong with maps of a terrain without holes, in one line; empty if at most that share of
/// all rays ends otherwise than the literal rays of reference/oracles. Rays that pass the terrain
/// within rounding may go either way.
std::string objection_to_shadows(const ShadowWorkload& workload, const LitMaps& lit,
                                 double wrong_share);

}  // namespace phytobench
