// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/statistics/estimate.hpp"

namespace phytobench {

/// The share of successes with the interval of Clopper and Pearson (1934, Biometrika 26:404): never
/// less sure than it says, at any share and any number of trials. 0 <= successes <= trials,
/// trials > 0; ContractViolation otherwise.
Estimate share_estimate(std::int64_t successes, std::int64_t trials, double confidence = 0.95);

}  // namespace phytobench
