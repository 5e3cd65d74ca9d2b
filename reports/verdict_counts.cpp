// SPDX-License-Identifier: MIT
#include "reports/verdict_counts.hpp"

#include <algorithm>

#include "core/contract/check.hpp"

namespace phytobench {

namespace {

constexpr std::string_view unseen_row = "not measured in this run";
constexpr std::string_view modelless_row = "not measured: model not built yet";
constexpr std::string_view uncheckable_row = "not measured: no check";

constexpr VerdictRow rows[] = {
    {"reproduced", Verdict::reproduced},
    {fitted_row, Verdict::reproduced},
    {"reproduced with erratum", Verdict::reproduced_with_erratum},
    {"not reproduced", Verdict::not_reproduced},
    {"inconclusive", Verdict::inconclusive},
    {"not comparable", Verdict::not_comparable},
    {"underspecified", Verdict::underspecified},
    {unseen_row, Verdict::not_measured},
    {modelless_row, Verdict::not_measured},
    {uncheckable_row, Verdict::not_measured},
};

std::string_view row_name(const Judgement& judgement) {
  if (is_fitted(judgement)) return fitted_row;
  if (judgement.verdict != Verdict::not_measured) return name_of(judgement.verdict);
  if (!judgement.claim->missing_model.empty()) return modelless_row;
  return lacks_evidence(judgement) ? unseen_row : uncheckable_row;
}

}  // namespace

bool is_fitted(const Judgement& judgement) {
  return judgement.verdict == Verdict::reproduced && judgement.claim->basis == "fitted";
}

bool has_measurement(const Judgement& judgement) {
  return std::any_of(judgement.checks.begin(), judgement.checks.end(), [](const auto& check) {
    return std::any_of(check.terms.begin(), check.terms.end(),
                       [](const auto& term) { return term.outcome != CheckOutcome::missing; });
  });
}

bool lacks_evidence(const Judgement& judgement) {
  return judgement.verdict == Verdict::not_measured && !judgement.claim->fixed_verdict;
}

std::span<const VerdictRow> verdict_rows() {
  return rows;
}

const VerdictRow& row_of(const Judgement& judgement) {
  const auto* const row = std::find_if(std::begin(rows), std::end(rows), [&](const auto& r) {
    return r.name == row_name(judgement);
  });
  PHYTOBENCH_EXPECT(row != std::end(rows));
  return *row;
}

}  // namespace phytobench
