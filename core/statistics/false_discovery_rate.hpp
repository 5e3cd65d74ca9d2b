// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

namespace phytobench {

/// p-values of several tests adjusted to be judged together, in the order given (Benjamini and
/// Hochberg 1995, J. R. Stat. Soc. B 57:289): where those of at most q are taken for discoveries,
/// the expected share of false ones among them is at most q. Holds for independent tests and for
/// positively dependent ones. Each is the least p_k n / k among the p_k at and above it, k its rank
/// from the smallest; never below p, at most 1. All p in [0, 1]; ContractViolation otherwise.
std::vector<double> false_discovery_adjusted(std::span<const double> p_values);

}  // namespace phytobench
