// SPDX-License-Identifier: MIT
// Mann and Whitney's test (1947, Ann. Math. Stat. 18:50; Wilcoxon's rank-sum test): do the values
// of one sample tend to lie above those of another? For results that were not measured in pairs.
#pragma once

#include <cstddef>
#include <span>

namespace phytobench {

struct RankSumSettings {
  /// Up to so many values of both samples together the law is enumerated; of more it is taken as
  /// normal.
  std::size_t largest_exact = 60;
};

struct RankSumTest {
  double u = 0.0;            ///< pairs in which the first sample's value is the larger; ties half
  double p_greater = 1.0;    ///< that chance gives a u as large or larger
  double p_less = 1.0;       ///< that it gives one as small or smaller
  double p_two_sided = 1.0;  ///< twice the smaller of both, at most 1
};

/// The law is that of all ways to split the values into samples of these sizes, ties as they are:
/// exact with ties, too. The normal law has the variance of the tied ranks and a continuity
/// correction of half a pair. If all values are equal every p is 1. At least one value in each,
/// none of them NaN; ContractViolation otherwise.
RankSumTest rank_sum_test(std::span<const double> first, std::span<const double> second,
                          const RankSumSettings& settings = {});

}  // namespace phytobench
