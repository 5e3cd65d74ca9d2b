// SPDX-License-Identifier: MIT
#include "reports/document_measured.hpp"

#include <gtest/gtest.h>

namespace phytobench {
namespace {

JudgedCheck check_of(const std::string& wanted, const std::vector<std::string>& values) {
  JudgedCheck check{.wanted = wanted, .why = "exact", .outcome = CheckOutcome::holds, .terms = {}};
  for (const std::string& value : values)
    check.terms.push_back({"a/" + value, value, CheckOutcome::holds});
  return check;
}

Judgement judgement_of(std::vector<JudgedCheck> checks) {
  Judgement judgement{.verdict = Verdict::reproduced, .measured = "all of them"};
  judgement.checks = std::move(checks);
  return judgement;
}

TEST(ShownMeasured, LeavesFewValuesAsTheyAre) {
  EXPECT_EQ(shown_measured(judgement_of({})), "all of them");
  EXPECT_EQ(shown_measured(judgement_of({check_of(">= 1", {"1", "2", "3", "4"})})), "all of them");
}

TEST(ShownMeasured, SumsUpManyValues) {
  EXPECT_EQ(
      shown_measured(judgement_of({check_of(">= 1.5 in 5 of 5", {"2", "1.6", "1e+01", "3", "4"})})),
      "5 values, from 1.6 to 1e+01 (wanted >= 1.5 in 5 of 5; all hold)");
  EXPECT_EQ(shown_measured(judgement_of({check_of("= 0 in 5 of 5", {"0", "0", "0", "0", "0"})})),
            "5 values, all 0 (wanted = 0 in 5 of 5; all hold)");
}

TEST(ShownMeasured, TakesIntervalsForWhatTheyAreAround) {
  const auto text = shown_measured(
      judgement_of({check_of("<= 9 in 5 of 5", {"2 [1, 3]", "5, 4 to 6 in 3 rounds, 6 needed",
                                                "3 [1, 4]", "4 [3, 5]", "4.5 [1, 5]"})}));
  EXPECT_EQ(text, "5 values, from 2 to 5 (wanted <= 9 in 5 of 5; all hold)");
}

TEST(ShownMeasured, NamesWhatKeepsACheckFromHolding) {
  JudgedCheck check = check_of(">= 1 in 5 of 5", {"2", "0.5", "3", "0.1", "4"});
  check.outcome = check.terms[1].outcome = check.terms[3].outcome = CheckOutcome::fails;
  EXPECT_EQ(shown_measured(judgement_of({check})),
            "5 values, from 0.1 to 4 (wanted >= 1 in 5 of 5; 3 hold); the first that does not: "
            "a/0.5 is 0.5");
}

TEST(ShownMeasured, CountsTextsAndComparisons) {
  EXPECT_EQ(shown_measured(
                judgement_of({check_of("all the same in 5 of 5", {"1f", "2", "3", "4", "5"})})),
            "5 comparisons (wanted all the same in 5 of 5; all hold)");
  EXPECT_EQ(shown_measured(judgement_of({check_of("= x in 5 of 5", {"x", "x", "x", "x", "x"})})),
            "5 values (wanted = x in 5 of 5; all hold)");
}

TEST(ShownMeasured, CountsManyChecks) {
  const JudgedCheck check = check_of("= 1", {"1", "1"});
  EXPECT_EQ(shown_measured(judgement_of({check, check, check, check})),
            "8 values in 4 checks, all as wanted");
  JudgedCheck failing = check;
  failing.outcome = failing.terms[1].outcome = CheckOutcome::fails;
  EXPECT_EQ(shown_measured(judgement_of({check, check, failing, check})),
            "8 values in 4 checks, 3 as wanted; the first that does not: a/1 is 1 (wanted = 1)");
}

TEST(ShownMeasured, SaysWhatIsMissing) {
  JudgedCheck check = check_of("= 1 in 5 of 5", {"1", "1", "1", "1", "not measured"});
  check.terms[4].outcome = CheckOutcome::missing;
  check.outcome = CheckOutcome::missing;
  Judgement judgement = judgement_of({check});
  judgement.verdict = Verdict::not_measured;
  EXPECT_EQ(shown_measured(judgement), "4 of 5 values");
  for (JudgedTerm& term : check.terms) term.outcome = CheckOutcome::missing;
  EXPECT_EQ(shown_measured(judgement_of({check})), "not measured");
}

TEST(ShownMeasured, DoesNotHideWhatFailsBehindWhatIsMissing) {
  JudgedCheck check = check_of(">= 1 in 5 of 5", {"2", "not measured", "0.5", "3", "4"});
  check.terms[1].outcome = CheckOutcome::missing;
  check.outcome = check.terms[2].outcome = CheckOutcome::fails;
  Judgement judgement = judgement_of({check});
  judgement.verdict = Verdict::not_reproduced;
  EXPECT_EQ(shown_measured(judgement),
            "4 of 5 values, from 0.5 to 4 (wanted >= 1 in 5 of 5; 3 hold); the first that does "
            "not: a/0.5 is 0.5");
  JudgedCheck missing = check_of("= 1", {"not measured"});
  missing.outcome = missing.terms[0].outcome = CheckOutcome::missing;
  judgement.checks = {missing, missing, check, missing};
  EXPECT_EQ(shown_measured(judgement),
            "4 of 8 values in 4 checks, 0 as wanted; the first that does not: a/0.5 is 0.5 "
            "(wanted >= 1 in 5 of 5)");
}

TEST(ShownMeasured, SaysOfAFailingCheckOfFewTermsWhatWasWanted) {
  const JudgedCheck many = check_of("= 1 in 3 of 3", {"1", "1", "1"});
  JudgedCheck pair = check_of(">= 1 in 2 of 2", {"2", "0.5"});
  pair.outcome = pair.terms[1].outcome = CheckOutcome::fails;
  EXPECT_EQ(shown_measured(judgement_of({many, pair})),
            "3 values, all 1 (wanted = 1 in 3 of 3; all hold); 2, 0.5 (wanted >= 1 in 2 of 2; 1 "
            "holds); the first that does not: a/0.5 is 0.5");
  JudgedCheck single = check_of("<= 9", {"10 [8, 12]"});
  single.outcome = single.terms[0].outcome = CheckOutcome::undecided;
  EXPECT_EQ(shown_measured(judgement_of({many, check_of(">= 1", {"2"}), single})),
            "3 values, all 1 (wanted = 1 in 3 of 3; all hold); 2; 10 [8, 12] (wanted <= 9; none "
            "holds); the first that does not: a/10 [8, 12] is 10 [8, 12]");
}

TEST(ShownMeasured, TakesNoPairShareOrNotANumberForANumber) {
  for (const char* other : {"15344 20046", "3 of 7", "nan", "inf", "1f"})
    EXPECT_EQ(shown_measured(judgement_of({check_of(">= 1", {"1", "2", "3", "4", other})})),
              "5 values (wanted >= 1; all hold)")
        << other;
}

TEST(ShownExpression, DoesNotBeginWithAPlus) {
  EXPECT_EQ(shown_expression({"+ a - b", "1", CheckOutcome::holds}), "a - b");
  EXPECT_EQ(shown_expression({"- a - b", "1", CheckOutcome::holds}), "- a - b");
}

}  // namespace
}  // namespace phytobench
