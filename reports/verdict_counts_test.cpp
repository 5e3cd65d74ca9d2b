// SPDX-License-Identifier: MIT
#include "reports/verdict_counts.hpp"

#include <gtest/gtest.h>

namespace phytobench {
namespace {

TEST(IsFitted, HoldsForReproducedByFittingAlone) {
  Claim claim;
  Judgement judgement{.claim = &claim, .verdict = Verdict::reproduced};
  claim.basis = "fitted";
  EXPECT_TRUE(is_fitted(judgement));
  judgement.verdict = Verdict::not_reproduced;
  EXPECT_FALSE(is_fitted(judgement));
  judgement.verdict = Verdict::reproduced;
  claim.basis = "assumed";
  EXPECT_FALSE(is_fitted(judgement));
}

TEST(HasMeasurement, NeedsOneTermThatIsNotMissing) {
  const Claim claim;
  Judgement judgement{.claim = &claim};
  EXPECT_FALSE(has_measurement(judgement));
  judgement.checks = {{.terms = {{}}}, {.terms = {{}, {}}}};
  EXPECT_FALSE(has_measurement(judgement));
  judgement.checks[1].terms[1].outcome = CheckOutcome::fails;
  EXPECT_TRUE(has_measurement(judgement));
}

std::string row_name(Verdict verdict, const Claim& claim) {
  return std::string(row_of({.claim = &claim, .verdict = verdict}).name);
}

TEST(VerdictRow, IsTheVerdictWhereThatSaysAll) {
  for (const Verdict verdict : all_verdicts) {
    if (verdict == Verdict::not_measured) continue;
    const Claim claim;
    const VerdictRow& row = row_of({.claim = &claim, .verdict = verdict});
    EXPECT_EQ(row.name, label_of(verdict));
    EXPECT_EQ(row.identifier, name_of(verdict)) << "machine formats";
  }
}

TEST(Label, CallsAnErratumNoSuccess) {
  EXPECT_EQ(label_of(Verdict::reproduced_with_erratum), "wrong as printed, holds corrected");
  for (const Verdict verdict : all_verdicts) {
    if (verdict == Verdict::reproduced_with_erratum) continue;
    EXPECT_EQ(label_of(verdict), name_of(verdict));
  }
}

TEST(VerdictRow, TellsApartWhatWasFitted) {
  Claim fitted;
  fitted.basis = "fitted";
  EXPECT_EQ(row_name(Verdict::reproduced, fitted), fitted_row);
  EXPECT_EQ(row_name(Verdict::not_reproduced, fitted), "not reproduced");
}

TEST(VerdictRow, TellsApartWhyNothingWasMeasured) {
  Claim unseen, uncheckable, without_model;
  uncheckable.fixed_verdict = without_model.fixed_verdict = Verdict::not_measured;
  without_model.missing_model = "L-systems";
  EXPECT_EQ(row_name(Verdict::not_measured, unseen), "not measured in this run");
  EXPECT_EQ(row_name(Verdict::not_measured, uncheckable), "not measured: no check");
  EXPECT_EQ(row_name(Verdict::not_measured, without_model), "not measured: model not built yet");
}

}  // namespace
}  // namespace phytobench
