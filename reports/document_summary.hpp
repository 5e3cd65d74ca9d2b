// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "reports/judge/judged_run.hpp"
#include "reports/judge/run_comparison.hpp"

namespace phytobench {

/// What a report counts over all claims. Hidden ones rest on times that are left out.
struct ClaimCounts {
  std::size_t claims = 0, measured = 0, reproduced = 0, fitted = 0, with_erratum = 0, refuted = 0;
  std::size_t from_text = 0, with_author_values = 0;  ///< of the reproduced ones
  std::size_t inconclusive = 0, not_seen = 0, without_model = 0, hidden = 0;
  std::size_t not_comparable = 0, underspecified = 0, unmeasurable = 0;  ///< no run decides these
  std::size_t unexpected = 0, contradicted = 0;  ///< contradicted: by another of several runs
  bool vary = false;                             ///< some verdict rests on times
};

ClaimCounts counts_of(const JudgedRun& judged, bool without_varying);

/// What was asked, what was found, what is wrong in the works, what is open, what no run can tell
/// and what was predicted, a line each: term and text. The numbers of claims add up to all.
/// `comparison`: of a merged run, else null.
nlohmann::ordered_json summary_document(const JudgedRun& judged, const RunComparison* comparison,
                                        bool without_varying);

/// Claims by verdict: in all, by basis and by work; those that hold corrected also by the kind of
/// their erratum. A hidden claim has a row of its own.
nlohmann::ordered_json counts_document(const JudgedRun& judged, bool without_varying);

}  // namespace phytobench
