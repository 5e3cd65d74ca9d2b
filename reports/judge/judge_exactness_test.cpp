// SPDX-License-Identifier: MIT
// Ways in which a lenient judge would be wrong.
#include <cmath>

#include <gtest/gtest.h>

#include "reports/judge/judge.hpp"

namespace phytobench {
namespace {

Claim claim_with(ClaimCheck check) {
  check.required = check.terms.size();
  Claim claim;
  claim.id = "p/c";
  claim.tier = Tier::quick;
  claim.reason = "because";
  claim.checks = {std::move(check)};
  return claim;
}

RunContents run_with(const std::vector<std::pair<std::string, RecordValue>>& values) {
  RunContents run;
  for (const auto& [name, value] : values)
    run.records.push_back({.experiment = "p/e", .measurement = name, .value = value});
  return run;
}

void add_times(RunContents& run, const std::string& name, std::int64_t first_round, int rounds,
               double seconds) {
  for (int i = 0; i < rounds; ++i)
    run.timings.push_back({"p/e", name, first_round + i, 0, seconds, 1});
}

TEST(JudgeExactness, SameMeansEveryBit) {
  const Claim claim = claim_with({.subject = CheckSubject::same, .terms = {{"p/a", "p/b"}}});
  const double next = std::nextafter(1.0, 2.0);
  EXPECT_EQ(judge(claim, Evidence(run_with({{"p/a", 1.0}, {"p/b", 1.0}})), Tier::quick).verdict,
            Verdict::reproduced);
  EXPECT_EQ(judge(claim, Evidence(run_with({{"p/a", 1.0}, {"p/b", next}})), Tier::quick).verdict,
            Verdict::not_reproduced);
}

TEST(JudgeExactness, TextIsNotARoundedNumber) {
  const Claim claim = claim_with({.terms = {{"p/a"}}, .equals_text = "0.123457"});
  EXPECT_EQ(judge(claim, Evidence(run_with({{"p/a", 0.12345678}})), Tier::quick).verdict,
            Verdict::not_reproduced);
}

TEST(JudgeExactness, ARatioOverZeroFails) {
  const Claim claim =
      claim_with({.subject = CheckSubject::ratio, .terms = {{"p/a", "p/b"}}, .low = 1.0});
  EXPECT_EQ(judge(claim, Evidence(run_with({{"p/a", 1.0}, {"p/b", 0.0}})), Tier::quick).verdict,
            Verdict::not_reproduced);
}

TEST(JudgeExactness, TimesPairOnlyWithinTheirRound) {
  const Claim claim =
      claim_with({.subject = CheckSubject::ratio, .terms = {{"p/a", "p/b"}}, .low = 1.0});
  RunContents shifted;
  add_times(shifted, "p/a", 0, 3, 2.0);
  add_times(shifted, "p/b", 7, 3, 1.0);
  EXPECT_EQ(judge(claim, Evidence(shifted), Tier::quick).verdict, Verdict::not_measured);
  RunContents single;
  add_times(single, "p/a", 0, 5, 2.0);
  add_times(single, "p/b", 0, 1, 1.0);
  const Judgement judgement = judge(claim, Evidence(single), Tier::quick);
  EXPECT_EQ(judgement.verdict, Verdict::not_measured);
  EXPECT_NE(judgement.reason.find("rounds"), std::string::npos) << judgement.reason;
}

TEST(JudgeExactness, AFailedTermDecidesAlthoughAnotherIsMissing) {
  const Claim claim = claim_with({.terms = {{"p/a"}, {"p/missing"}}, .low = 1.0});
  EXPECT_EQ(judge(claim, Evidence(run_with({{"p/a", 0.5}})), Tier::quick).verdict,
            Verdict::not_reproduced);
}

}  // namespace
}  // namespace phytobench
