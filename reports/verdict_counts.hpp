// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "reports/judge/judge.hpp"

namespace phytobench {

/// Whether a claim holds only because a parameter was chosen to meet a number: such a verdict is
/// counted apart from the plain ones.
bool is_fitted(const Judgement& judgement);

inline constexpr const char* fitted_row = "reproduced, fitted";

/// Whether the run measured anything that the claim rests on.
bool has_measurement(const Judgement& judgement);

/// Whether a claim has checks for which this run holds no evidence: nothing was found, so nothing
/// differs from what was predicted.
bool lacks_evidence(const Judgement& judgement);

/// A verdict as readers see it. It is its name, but for "reproduced with erratum", which would be
/// taken for a success: "wrong as printed, holds corrected". Machine formats keep the name.
std::string_view label_of(Verdict verdict);

/// A row of the counts: a verdict, or a part of one that must not be mistaken for the rest.
struct VerdictRow {
  std::string_view name;  ///< as readers see it
  Verdict verdict;
  std::string_view identifier;  ///< in machine formats, addresses and filters: never changes
};

/// All rows, in the order of a report. Each claim belongs to exactly one.
std::span<const VerdictRow> verdict_rows();

const VerdictRow& row_of(const Judgement& judgement);

}  // namespace phytobench
