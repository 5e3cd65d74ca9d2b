// SPDX-License-Identifier: MIT
#include "reports/verdicts_json.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace phytobench {
namespace {

using nlohmann::json;

struct TwoClaims {
  JudgedRun judged;

  TwoClaims() {
    judged.run.header = {Tier::quick, 7};
    judged.papers.resize(1);
    JudgedPaper& paper = judged.papers[0];
    paper.claims.claims.resize(2);
    Claim& refuted = paper.claims.claims[0];
    refuted.id = "p/refuted";
    refuted.kind = "count";
    refuted.topic = "Growth";
    refuted.locator = "eq. 1";
    refuted.digits = 3;
    refuted.predicted_verdict = Verdict::underspecified;
    refuted.erratum = "eq-1";
    paper.claims.claims[1].id = "p/timed";
    paper.judgements = {{.claim = &refuted, .verdict = Verdict::not_reproduced, .measured = "4"},
                        {.claim = &paper.claims.claims[1],
                         .verdict = Verdict::reproduced,
                         .measured = "2.1",
                         .reason = {},
                         .checks = {},
                         .varies = true}};
  }
};

TEST(VerdictsJson, NamesTheRowThatTheReportCountsAClaimIn) {
  TwoClaims of;
  of.judged.papers[0].claims.claims[1].basis = "fitted";
  const json claim = json::parse(verdicts_json(of.judged, nullptr, false))["claims"][1];
  EXPECT_EQ(claim["verdict"], "reproduced");
  EXPECT_EQ(claim["row"], "reproduced, fitted");
}

TEST(VerdictsJson, SaysAllOfAClaim) {
  const json verdicts = json::parse(verdicts_json(TwoClaims().judged, nullptr, false));
  EXPECT_EQ(verdicts["schema"], "phytobench/verdicts-1");
  EXPECT_EQ(verdicts["tier"], "quick");
  EXPECT_EQ(verdicts["seed"], 7);
  EXPECT_FALSE(verdicts.contains("runs"));
  ASSERT_EQ(verdicts["claims"].size(), 2u);
  const json& claim = verdicts["claims"][0];
  EXPECT_EQ(claim["id"], "p/refuted");
  EXPECT_EQ(claim["verdict"], "not reproduced");
  EXPECT_EQ(claim["row"], "not reproduced");
  EXPECT_EQ(claim["expected"], "reproduced");
  EXPECT_EQ(claim["unexpected"], true);
  EXPECT_EQ(claim["expectation"], "unexpected");
  EXPECT_EQ(claim["machine_dependence"], nullptr);
  EXPECT_EQ(claim["predicted"], "underspecified");
  EXPECT_EQ(claim["digits"], 3);
  EXPECT_EQ(claim["kind"], "count");
  EXPECT_EQ(claim["topic"], "Growth");
  EXPECT_EQ(claim["locator"], "eq. 1");
  EXPECT_EQ(claim["erratum"], "eq-1");
  EXPECT_EQ(verdicts["claims"][1]["predicted"], nullptr);
  EXPECT_EQ(verdicts["claims"][1]["digits"], nullptr);
  EXPECT_EQ(verdicts["claims"][1]["erratum"], nullptr);
}

TEST(VerdictsJson, SaysWhereAVerdictDependsOnTheMachine) {
  TwoClaims of;
  of.judged.papers[0].claims.claims[1].machine_dependence = "below 2 there";
  of.judged.papers[0].judgements[1].verdict = Verdict::not_reproduced;
  const json claim = json::parse(verdicts_json(of.judged, nullptr, false))["claims"][1];
  EXPECT_EQ(claim["unexpected"], false);
  EXPECT_EQ(claim["expectation"], "depends on the machine");
  EXPECT_EQ(claim["machine_dependence"], "below 2 there");
}

TEST(VerdictsJson, LeavesOutWhatRestsOnTimesOnRequest) {
  const json verdicts = json::parse(verdicts_json(TwoClaims().judged, nullptr, true));
  ASSERT_EQ(verdicts["claims"].size(), 1u);
  EXPECT_EQ(verdicts["claims"][0]["id"], "p/refuted");
}

TEST(VerdictsJson, SaysWhatEachOfSeveralRunsFound) {
  RunComparison comparison;
  comparison.runs = {{"here", {}}, {"there", {}}};
  comparison.claims.resize(2);
  comparison.claims[1].verdicts = {Verdict::reproduced, Verdict::inconclusive};
  comparison.claims[1].measured = {"2.1", "1.9"};
  const json verdicts = json::parse(verdicts_json(TwoClaims().judged, &comparison, false));
  EXPECT_EQ(verdicts["runs"][1]["letter"], "B");
  EXPECT_EQ(verdicts["runs"][1]["label"], "there");
  const json& second = verdicts["claims"][1]["by_run"][1];
  EXPECT_EQ(second["run"], 1);
  EXPECT_EQ(second["verdict"], "inconclusive");
  EXPECT_EQ(second["measured"], "1.9");
}

}  // namespace
}  // namespace phytobench
