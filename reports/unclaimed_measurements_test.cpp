// SPDX-License-Identifier: MIT
#include "reports/unclaimed_measurements.hpp"

#include <ostream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace phytobench {

void PrintTo(const UnclaimedGroup& group, std::ostream* out) {
  *out << group.experiment << " | " << group.group << " | " << group.count;
}

namespace {

using testing::ElementsAre;
using testing::IsEmpty;

RunContents run_of(const std::vector<std::string>& recorded,
                   const std::vector<std::string>& timed = {}) {
  RunContents run;
  for (const std::string& name : recorded)
    run.records.push_back({.experiment = "p/e", .measurement = "p/e/" + name, .value = 1.0});
  for (const std::string& name : timed)
    for (const std::int64_t round : {0, 1, 2})
      run.timings.push_back(
          {.experiment = "p/e", .measurement = "p/e/" + name, .round = round, .value = 1.0});
  return run;
}

Claim claim_on(CheckSubject subject, const std::vector<std::string>& term) {
  Claim claim;
  claim.checks.push_back({.subject = subject, .terms = {term}, .required = 1});
  return claim;
}

TEST(UnclaimedMeasurements, AreAllWhereNothingIsClaimedByGroup) {
  EXPECT_THAT(unclaimed_measurements(
                  run_of({"tree/edges", "seeds/2/vertices", "tree/nodes", "points"}), {}),
              ElementsAre(UnclaimedGroup{"p/e", "", 1}, UnclaimedGroup{"p/e", "seeds/2", 1},
                          UnclaimedGroup{"p/e", "tree", 2}));
}

TEST(UnclaimedMeasurements, AreNoneWhereEveryOneIsNamed) {
  const Claim ratio = claim_on(CheckSubject::ratio, {"p/e/a/x", "p/e/a/y"});
  const Claim sum = claim_on(CheckSubject::sum, {"+p/e/b/x", "-p/e/b/y"});
  const Claim matches = claim_on(CheckSubject::matches, {"p/e/seeds/"});
  EXPECT_THAT(unclaimed_measurements(
                  run_of({"a/x", "a/y", "b/x", "b/y", "seeds/1/vertices", "seeds/2/vertices"}),
                  {&ratio, &sum, &matches}),
              IsEmpty());
}

TEST(UnclaimedMeasurements, AreStillThoseThatAClaimOnlyResembles) {
  const Claim value = claim_on(CheckSubject::value, {"p/e/a/x"});
  EXPECT_THAT(unclaimed_measurements(run_of({"a/x", "a/x2", "a/x/y"}), {&value}),
              ElementsAre(UnclaimedGroup{"p/e", "a", 1}, UnclaimedGroup{"p/e", "a/x", 1}));
}

TEST(UnclaimedMeasurements, CountATimeOnceHoweverOftenItWasTaken) {
  EXPECT_THAT(unclaimed_measurements(run_of({}, {"a/seconds", "a/kill_seconds"}), {}),
              ElementsAre(UnclaimedGroup{"p/e", "a", 2}));
}

TEST(UnclaimedMeasurements, OfAJudgedRunMeetTheClaimsOfAllItsPapers) {
  JudgedRun judged;
  judged.run = run_of({"a/x", "a/y", "a/z"});
  judged.papers.resize(2);
  judged.papers[0].claims.claims = {claim_on(CheckSubject::value, {"p/e/a/x"})};
  judged.papers[1].claims.claims = {claim_on(CheckSubject::value, {"p/e/a/y"})};
  EXPECT_THAT(unclaimed_measurements(judged), ElementsAre(UnclaimedGroup{"p/e", "a", 1}));
}

}  // namespace
}  // namespace phytobench
