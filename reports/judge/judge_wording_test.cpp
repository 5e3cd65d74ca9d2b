// SPDX-License-Identifier: MIT
#include "reports/judge/judge_wording.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace phytobench {
namespace {

/// A check on as many terms as there are values, judged on them.
JudgedCheck worded(ClaimCheck check, const std::vector<double>& values) {
  RunContents run;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::string name = "p/e/" + std::to_string(i);
    run.records.push_back({.experiment = "p/e", .measurement = name, .value = values[i]});
    if (check.subject == CheckSubject::value)
      check.terms.push_back({name});
    else if (i == 0)
      check.terms = {{name}};
    else
      check.terms[0].push_back(name);
  }
  check.required = check.terms.size();
  Claim claim;
  claim.checks = {check};
  return judge(claim, Evidence(run), Tier::full).checks[0];
}

TEST(JudgeWording, ShowsSixDigitsWhereTheyTellValueAndBoundApart) {
  const JudgedCheck check = worded({.low = 0.25}, {1.0 / 3.0});
  EXPECT_EQ(check.wanted, ">= 0.25");
  EXPECT_EQ(check.terms[0].measured, "0.333333");
}

TEST(JudgeWording, AValueThatMissesItsBoundDoesNotLookEqualToIt) {
  const JudgedCheck above = worded({.high = 0.9}, {0.9 + 1e-9});
  EXPECT_EQ(above.outcome, CheckOutcome::fails);
  EXPECT_EQ(above.wanted, "<= 0.9");
  EXPECT_EQ(above.terms[0].measured, "0.900000001");
  const JudgedCheck equal = worded({.equals = 1.0}, {std::nextafter(1.0, 0.0)});
  EXPECT_EQ(equal.outcome, CheckOutcome::fails);
  EXPECT_EQ(equal.terms[0].measured, "0.9999999999999999");
  const JudgedCheck within = worded({.low = 0.5 - 1e-9, .high = 0.5 + 1e-9}, {0.5 + 3e-9});
  EXPECT_EQ(within.outcome, CheckOutcome::fails);
  EXPECT_EQ(within.terms[0].measured, "0.500000003");
}

// The bound is 1.23456789: with six digits it would look larger than a value that exceeds it.
TEST(JudgeWording, ShowsBoundsWithTheDigitsOfTheirValues) {
  const JudgedCheck check = worded({.high = 1.23456789}, {1.234568, 1.0});
  EXPECT_EQ(check.wanted, "<= 1.2345679 in 2 of 2");
  EXPECT_EQ(check.terms[0].measured, "1.234568");
  EXPECT_EQ(check.terms[0].outcome, CheckOutcome::fails);
  EXPECT_EQ(check.terms[1].measured, "1");
}

// Seven digits, which the second value needs, would show the first as equal to its bound.
TEST(JudgeWording, TellsAllValuesOfACheckFromItsBound) {
  const JudgedCheck check = worded({.low = 1.2345651}, {1.2345649, 1.2345688});
  EXPECT_EQ(check.wanted, ">= 1.2345651 in 2 of 2");
  EXPECT_EQ(check.terms[0].measured, "1.2345649");
  EXPECT_EQ(check.terms[0].outcome, CheckOutcome::fails);
  EXPECT_EQ(check.terms[1].measured, "1.2345688");
}

TEST(JudgeWording, ShowsThatValuesAreNotAllTheSame) {
  const double third = 1.0 / 3.0;
  EXPECT_EQ(worded({.subject = CheckSubject::same}, {third, third}).terms[0].measured, "0.333333");
  EXPECT_EQ(worded({.subject = CheckSubject::same}, {third, std::nextafter(third, 1.0)})
                .terms[0]
                .measured,
            "0.3333333333333333, 0.3333333333333334");
}

JudgedTerm timed_term(int rounds, double low, double step, double first = 1.0) {
  RunContents run;
  for (int i = 0; i < rounds; ++i)
    run.timings.push_back(
        {.experiment = "p/e", .measurement = "p/e/a", .round = i, .value = first + step * i});
  Claim claim;
  claim.checks = {{.terms = {{"p/e/a"}}, .low = low, .required = 1}};
  return judge(claim, Evidence(run), Tier::full).checks[0].terms[0];
}

TEST(JudgeWording, ShowsIntervalsFromSixRoundsOnAndRangesBelow) {
  EXPECT_EQ(timed_term(6, 0.5, 0.125).measured, "1.312 [1, 1.625]");
  EXPECT_EQ(timed_term(3, 0.5, 0.125).measured, "1.125, 1 to 1.25 in 3 rounds, 6 needed");
  EXPECT_EQ(timed_term(6, 0.99999, 0.125).measured, "1.312 [1, 1.625]");
  EXPECT_EQ(timed_term(6, 0.9999999, 0.125).measured, "1.3125 [1, 1.625]")
      << "the bound would look equal to its lower end";
}

// Four digits of the lower end, 1.234e+04, would look less than the bound.
TEST(JudgeWording, ShowsWholeNumbersOfAnIntervalInFull) {
  const JudgedTerm term = timed_term(6, 12344, 2, 12345);
  EXPECT_EQ(term.outcome, CheckOutcome::holds);
  EXPECT_EQ(term.measured, "12350 [12345, 12355]");
}

}  // namespace
}  // namespace phytobench
