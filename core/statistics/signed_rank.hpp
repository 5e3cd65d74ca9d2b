// SPDX-License-Identifier: MIT
// Wilcoxon's signed-rank test (1945, Biometrics Bulletin 1:80): do paired differences lean to one
// side? Its law is that of fair coins for the signs: exact where either side of a pair could as
// well have been the other, whatever the law of the differences.
#pragma once

#include <cstddef>
#include <span>

namespace phytobench {

struct SignedRankSettings {
  /// Up to so many differences other than 0 the law is enumerated; of more it is taken as normal.
  std::size_t largest_exact = 60;
};

struct SignedRankTest {
  std::size_t signs = 0;      ///< differences other than 0
  double positive_sum = 0.0;  ///< of the ranks of positive differences
  double p_greater = 1.0;     ///< that chance gives a sum as large or larger
  double p_less = 1.0;        ///< that it gives one as small or smaller
  double p_two_sided = 1.0;   ///< twice the smaller of both, at most 1
};

/// Ranks are those of the absolute values, ties share their mean rank. Zeros are ranked with the
/// others and then take no part (Pratt 1959, J. Am. Stat. Assoc. 54:655). Wilcoxon dropped them
/// before ranking, by which a sample can lose its significance when all its values rise. Ties and
/// zeros are exact, too. The normal law has the variance of the ranks as they are and a continuity
/// correction of half a rank. Without a difference other than 0 every p is 1. Differences must be
/// finite; ContractViolation otherwise.
SignedRankTest signed_rank_test(std::span<const double> differences,
                                const SignedRankSettings& settings = {});

}  // namespace phytobench
