// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

namespace phytobench {

/// Probability that counts of equally likely cells scatter at least as much as these (Pearson's
/// chi-square test of uniformity). At least two cells and one count.
double uniformity_p_value(std::span<const std::int64_t> counts);

}  // namespace phytobench
