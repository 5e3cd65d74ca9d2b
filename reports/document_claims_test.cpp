// SPDX-License-Identifier: MIT
#include "reports/document_claims.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace phytobench {
namespace {

struct OneClaim {
  Claim claim;
  RunContents run;
  Judgement judgement;

  OneClaim() {
    claim.id = "b/eq-17/holds";
    claim.paper = "b";
    claim.locator = "eq. 17, fig. 4";
    claim.published = "5200";
    claim.unit = "edges";
    claim.basis = "paper";
    claim.checks = {{.terms = {{"b/x/edges"}, {"b/x/other"}}}};
    judgement = {.claim = &claim, .verdict = Verdict::reproduced, .measured = "5200"};
    judgement.checks = {{.wanted = "= 5200 in 1 of 2",
                         .why = "exact",
                         .outcome = CheckOutcome::holds,
                         .terms = {{"edges", "5200", CheckOutcome::holds},
                                   {"other", "5201", CheckOutcome::fails}}}};
  }
  nlohmann::ordered_json document(bool without_varying = false) const {
    const Evidence evidence(run);
    std::map<std::string, ExperimentFacts> facts;
    facts["b/x"] = {"Does it?", "[B]", {3.0, 30.0, 300.0}};
    const ExperimentCosts costs(run, facts, without_varying);
    return claim_document(judgement, {evidence, costs, without_varying, 0, {{claim.id, {"A2"}}}});
  }
};

TEST(ClaimDocument, HasAnAnchorAndItsPlacesForASearch) {
  const auto document = OneClaim().document();
  EXPECT_EQ(document["anchor"], "claim-b-eq-17-holds");
  EXPECT_EQ(document["short_id"], "eq-17/holds");
  EXPECT_EQ(document["places"], "eq:17 fig:4");
}

TEST(ClaimDocument, NamesTheUnitOnce) {
  OneClaim of;
  EXPECT_EQ(of.document()["published_text"], "5200 edges");
  of.claim.published = "5200 edges of two trees";
  EXPECT_EQ(of.document()["published_text"], "5200 edges of two trees");
  of.claim.published = "-";
  EXPECT_EQ(of.document()["has_published"], false);
}

TEST(ClaimDocument, SeesTheUnitInItsPlural) {
  OneClaim of;
  of.claim.published = "180 and 120 degrees";
  of.claim.unit = "degree";
  EXPECT_EQ(of.document()["published_text"], "180 and 120 degrees");
}

TEST(ClaimDocument, NamesSeveralDegrees) {
  OneClaim of;
  of.claim.published = "60";
  of.claim.unit = "degree";
  EXPECT_EQ(of.document()["published_text"], "60 degrees");
  of.claim.published = "1";
  EXPECT_EQ(of.document()["published_text"], "1 degree");
}

TEST(ClaimDocument, SaysOnceWhatAllTermsOfACheckShare) {
  OneClaim of;
  EXPECT_EQ(of.document()["checks"][0]["mixed"], true);
  of.judgement.checks[0].terms[1].outcome = CheckOutcome::holds;
  EXPECT_EQ(of.document()["checks"][0]["alike"], true);
  EXPECT_EQ(of.document()["checks"][0]["mixed"], false);
}

TEST(ClaimDocument, ExplainsIntervalsWhereThereAreSome) {
  OneClaim of;
  EXPECT_EQ(of.document()["has_intervals"], false);
  of.judgement.checks[0].terms[0].measured = "1.9 [1.8, 2.0]";
  EXPECT_EQ(of.document()["has_intervals"], true);
}

TEST(ClaimDocument, SaysWhereAVerdictDependsOnTheMachine) {
  OneClaim of;
  of.claim.machine_dependence = "above 10 here, below 10 there";
  of.judgement.varies = true;
  EXPECT_EQ(of.document()["by_machine"], false) << "it is the expected one";
  of.judgement.verdict = Verdict::not_reproduced;
  EXPECT_EQ(of.document()["by_machine"], true);
  EXPECT_EQ(of.document()["unexpected"], false);
  EXPECT_EQ(of.document(true)["by_machine"], false) << "hidden";
}

TEST(ClaimDocument, TellsItsPredictionApartOnlyWhereItSaysMore) {
  OneClaim of;
  EXPECT_EQ(of.document()["shows_prediction"], false);
  of.claim.predicted_verdict = Verdict::reproduced;
  EXPECT_EQ(of.document()["as_predicted"], true);
  EXPECT_EQ(of.document()["shows_prediction"], false);
  of.claim.difference = "It changed.";
  EXPECT_EQ(of.document()["shows_prediction"], true);
  of.claim.difference = "";
  of.judgement.verdict = Verdict::not_reproduced;
  EXPECT_EQ(of.document()["shows_prediction"], true);
}

TEST(ClaimDocument, HasNoAgreementOfOneRunWhereRunsDisagree) {
  OneClaim of;
  of.claim.checks = {{.terms = {{"b/x/edges"}}, .equals = 5200.0}};
  of.run.records = {{.experiment = "b/x", .measurement = "b/x/edges", .value = std::int64_t{5200}}};
  EXPECT_EQ(of.document()["agreement"], "all digits");
  of.judgement.contradicted = true;
  EXPECT_EQ(of.document()["agreement"], "");
}

TEST(ClaimDocument, ShowsEvidenceTermByTerm) {
  const auto check = OneClaim().document()["checks"][0];
  EXPECT_EQ(check["term_count"], 2);
  EXPECT_EQ(check["several"], true);
  EXPECT_EQ(check["terms"][0]["first"], true);
  EXPECT_EQ(check["terms"][1]["first"], false);
  EXPECT_EQ(check["terms"][1]["outcome"], "fails");
}

TEST(ClaimDocument, SaysHowToRepeatItAndWhatThatCosts) {
  const auto document = OneClaim().document();
  EXPECT_EQ(document["repeat"], "phytobench run b/x --tier smoke --out results/again-b-x-smoke");
  EXPECT_EQ(document["time"], "3 s");
  EXPECT_EQ(document["has_memory"], false);
}

TEST(ClaimDocument, LeadsToAssumptions) {
  EXPECT_EQ(OneClaim().document()["assumptions"][0]["anchor"], "assumption-b-A2");
}

TEST(ClaimDocument, HidesWhatRestsOnTimes) {
  OneClaim of;
  of.judgement.varies = true;
  const auto document = of.document(true);
  EXPECT_EQ(document["verdict"], "left out: rests on times");
  EXPECT_EQ(document["measured"], "left out: rests on times");
  EXPECT_TRUE(document["checks"].empty());
  EXPECT_EQ(of.document(false)["verdict"], "reproduced");
}

TEST(ClaimDocument, DiffersFromItsPredictionOnlyWhereSomethingWasFound) {
  OneClaim of;
  EXPECT_EQ(of.document()["differs"], false);
  of.claim.predicted_verdict = Verdict::not_reproduced;
  EXPECT_EQ(of.document()["differs"], true);
  of.judgement.verdict = Verdict::inconclusive;
  EXPECT_EQ(of.document()["differs"], false);
  of.judgement.verdict = Verdict::not_measured;
  EXPECT_EQ(of.document()["differs"], false);
}

TEST(ClaimProblems, AreTheTermsOfChecksThatDoNotHold) {
  OneClaim of;
  EXPECT_TRUE(claim_problems(of.judgement).empty());
  of.judgement.checks[0].outcome = CheckOutcome::fails;
  const auto problems = claim_problems(of.judgement);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0]["measured"], "5201");
}

}  // namespace
}  // namespace phytobench
