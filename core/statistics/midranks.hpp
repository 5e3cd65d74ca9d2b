// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace phytobench {

/// Twice the rank of each value, in the order of the values; the smallest has rank 1. Equal values
/// share the mean of the ranks that they take up, which is a half at worst: hence twice. No NaN;
/// ContractViolation otherwise.
std::vector<std::int64_t> doubled_midranks(std::span<const double> values);

}  // namespace phytobench
