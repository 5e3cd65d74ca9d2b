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

}  // namespace
}  // namespace phytobench
