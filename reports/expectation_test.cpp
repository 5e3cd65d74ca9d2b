// SPDX-License-Identifier: MIT
#include "reports/expectation.hpp"

#include <gtest/gtest.h>

namespace phytobench {
namespace {

Expectation of(const Claim& claim, Verdict verdict, bool varies) {
  Judgement judgement{.claim = &claim, .verdict = verdict};
  judgement.varies = varies;
  return expectation_of(judgement);
}

TEST(Expectation, HasAThirdStateBetweenMetAndUnexpected) {
  Claim claim;
  claim.expected_verdict = Verdict::reproduced;
  EXPECT_EQ(of(claim, Verdict::reproduced, true), Expectation::met);
  EXPECT_EQ(of(claim, Verdict::not_reproduced, true), Expectation::unexpected);
  claim.machine_dependence = "above 10 here, below 10 there";
  EXPECT_EQ(of(claim, Verdict::reproduced, true), Expectation::met);
  EXPECT_EQ(of(claim, Verdict::not_reproduced, true), Expectation::depends_on_machine);
  EXPECT_EQ(of(claim, Verdict::not_reproduced, false), Expectation::unexpected)
      << "what is counted is the same on every machine";
}

TEST(Expectation, IsUndecidedWhereNothingWasFound) {
  Claim claim;
  claim.machine_dependence = "above 10 here, below 10 there";
  for (const Verdict verdict : {Verdict::not_measured, Verdict::inconclusive})
    EXPECT_EQ(of(claim, verdict, true), Expectation::undecided);
}

}  // namespace
}  // namespace phytobench
