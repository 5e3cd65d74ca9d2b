// SPDX-License-Identifier: MIT
#include "reports/document_repeat.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace phytobench {
namespace {

TEST(Repeat, ListsExperimentsThatRanAndThoseThatClaimsNeed) {
  Claim claim;
  claim.checks = {{.terms = {{"b/needed/n"}}}};
  JudgedRun judged;
  judged.papers.resize(1);
  judged.papers[0].judgements = {{.claim = &claim}};
  judged.run.header = {Tier::quick, 5};
  judged.run.complete_experiments = {"b/ran"};
  std::map<std::string, ExperimentFacts> facts;
  facts["b/ran"] = {"Did it?", "[B]", {1.0, 120.0, 1.0}};
  const auto document = repeat_document(judged, ExperimentCosts(judged.run, facts, false), nullptr);
  ASSERT_EQ(document["experiments"].size(), 2u);
  const auto& needed = document["experiments"][0];
  EXPECT_EQ(needed["id"], "b/needed");
  EXPECT_EQ(needed["in_run"], false);
  EXPECT_EQ(needed["claim_count"], 1);
  EXPECT_EQ(needed["time"], "not known");
  const auto& ran = document["experiments"][1];
  EXPECT_EQ(ran["question"], "Did it?");
  EXPECT_EQ(ran["time"], "2 min");
  EXPECT_EQ(ran["command"],
            "phytobench run b/ran --tier quick --seed 5 --out results/again-b-ran-quick-5");
}

/// Of a program that knows two experiments.
nlohmann::ordered_json repeat_of(const JudgedRun& judged, const RunComparison* comparison) {
  std::map<std::string, ExperimentFacts> facts;
  facts["b/one"] = facts["b/two"] = {};
  return repeat_document(judged, ExperimentCosts(judged.run, facts, false), comparison);
}

TEST(Repeat, NamesExperimentsOnlyWhereTheRunLacksSome) {
  JudgedRun judged;
  judged.run.header = {Tier::smoke, 7};
  judged.run.complete_experiments = {"b/two"};
  EXPECT_EQ(repeat_of(judged, nullptr)["runs"][0],
            "phytobench run b/two --tier smoke --seed 7 --out results/again");
  judged.run.complete_experiments = {"b/one", "b/two"};
  const auto whole = repeat_of(judged, nullptr);
  ASSERT_EQ(whole["runs"].size(), 1u);
  EXPECT_EQ(whole["runs"][0], "phytobench run --tier smoke --seed 7 --out results/again");
  EXPECT_EQ(whole["report"], "phytobench report results/again");
}

TEST(Repeat, RepeatsEachOfSeveralRuns) {
  RunComparison comparison;
  comparison.runs = {{"GCC", {}}, {"Clang", {}}};
  comparison.runs[0].contents.header = {Tier::quick, 1};
  comparison.runs[0].contents.complete_experiments = {"b/one", "b/two"};
  comparison.runs[1].contents.header = {Tier::full, 2};
  comparison.runs[1].contents.complete_experiments = {"b/one"};
  const auto document = repeat_of({}, &comparison);
  ASSERT_EQ(document["runs"].size(), 2u);
  EXPECT_EQ(document["runs"][0], "phytobench run --tier quick --seed 1 --out results/again-1");
  EXPECT_EQ(document["runs"][1], "phytobench run b/one --tier full --seed 2 --out results/again-2");
  EXPECT_EQ(document["report"], "phytobench report results/again-1 results/again-2");
}

}  // namespace
}  // namespace phytobench
