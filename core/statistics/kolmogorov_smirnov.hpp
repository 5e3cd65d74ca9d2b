// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

namespace phytobench {

/// The largest distance between the values' empirical distribution and the uniform one on [0, 1]
/// (Kolmogorov 1933); in [0.5 / n, 1]. Values need no order. At least one, none of them NaN;
/// ContractViolation otherwise. Values outside [0, 1] count as its ends.
double kolmogorov_distance(std::span<const double> values);

/// Probability that as many independent uniform values lie at least that far from uniform.
/// Kolmogorov's limit law at Stephens' argument (sqrt(n) + 0.12 + 0.11 / sqrt(n)) D (Stephens 1970,
/// J. R. Stat. Soc. B 32). Against the exact law, for n = 10 to 100: p-values from 0.01 to 0.1 are
/// off by up to 4 % of themselves, from 0.001 to 0.01 by 21 % at n = 10 and 5 % from n = 20 on;
/// larger ones by up to 0.023. For fewer than ten values only good near p = 0.05. For values of a
/// discrete law the test is conservative.
double kolmogorov_p_value(double distance, std::size_t count);

/// kolmogorov_p_value() of kolmogorov_distance(values): the one-sample test of uniformity.
double kolmogorov_uniformity_p_value(std::span<const double> values);

}  // namespace phytobench
