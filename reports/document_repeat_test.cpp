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
  const auto document =
      repeat_document(judged, ExperimentCosts(judged.run, facts, false), "phytobench run");
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

}  // namespace
}  // namespace phytobench
