// SPDX-License-Identifier: MIT
// How little has to be measured otherwise for a claim to fail. A claim that nothing can refute says
// nothing, and one that bears a factor of ten says little.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/judge/fulfilled_claim.hpp"

namespace phytobench {

/// A change of measurements after which a claim is not reproduced.
struct Refutation {
  std::vector<std::string> measurements;  ///< one; several if only together they refute
  RecordValue before;                     ///< of the first
  RecordValue after;
  double relative_change = 0.0;  ///< |after - before| over |before|, or over 1 for 0; 0 for texts
};

/// The smallest change, within a hundredth of itself, that refutes a claim which holds on
/// `measurements`: one of them larger or smaller, from its last place up to 2^64 times its size
/// (or times 1, if that is more), equal to another, or another text. If no single one does it, the
/// same change of all that stand first in a check's terms, of all that stand second, and so on.
/// Nothing if that does not help, either.
std::optional<Refutation> smallest_refutation(const Claim& claim, const Measurements& measurements);

}  // namespace phytobench
