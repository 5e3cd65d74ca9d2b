// SPDX-License-Identifier: MIT
#pragma once

namespace phytobench::oracles {

/// Probability that Kolmogorov's largest distance between the empirical distribution of n
/// independent uniform values and the uniform one is below d, exactly but for rounding: Durbin's
/// matrix to the power of n as Marsaglia, Tsang and Wang transcribe it (2003, J. Stat. Softw.
/// 8(18)). n >= 1, 0 < d < 1.
double kolmogorov_distribution(int n, double d);

}  // namespace phytobench::oracles
