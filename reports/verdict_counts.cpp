// SPDX-License-Identifier: MIT
#include "reports/verdict_counts.hpp"

#include <algorithm>

#include "core/contract/check.hpp"

namespace phytobench {

namespace {

constexpr std::string_view corrected_label = "wrong as printed, holds corrected";
constexpr std::string_view unseen_row = "not measured in this run";
constexpr std::string_view modelless_row = "not measured: model not built yet";
constexpr std::string_view uncheckable_row = "not measured: no check";

constexpr VerdictRow row(Verdict verdict, std::string_view name) {
  return {name, verdict, name};
}

constexpr VerdictRow row_table[] = {
    row(Verdict::reproduced, "reproduced"),
    row(Verdict::reproduced, fitted_row),
    {corrected_label, Verdict::reproduced_with_erratum, "reproduced with erratum"},
    row(Verdict::not_reproduced, "not reproduced"),
    row(Verdict::inconclusive, "inconclusive"),
    row(Verdict::not_comparable, "not comparable"),
    row(Verdict::underspecified, "underspecified"),
    row(Verdict::not_measured, unseen_row),
    row(Verdict::not_measured, modelless_row),
    row(Verdict::not_measured, uncheckable_row),
};

std::string_view row_identifier(const Judgement& judgement) {
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

std::string_view label_of(Verdict verdict) {
  return verdict == Verdict::reproduced_with_erratum ? corrected_label : name_of(verdict);
}

std::span<const VerdictRow> verdict_rows() {
  return row_table;
}

const VerdictRow& row_of(const Judgement& judgement) {
  const auto* const row =
      std::find_if(std::begin(row_table), std::end(row_table),
                   [&](const auto& r) { return r.identifier == row_identifier(judgement); });
  PHYTOBENCH_EXPECT(row != std::end(row_table));
  return *row;
}

}  // namespace phytobench
