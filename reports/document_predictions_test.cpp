// SPDX-License-Identifier: MIT
#include "reports/document_predictions.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace phytobench {
namespace {

Claim predicted_claim(const std::string& id, std::optional<Verdict> predicted) {
  Claim claim;
  claim.id = id;
  claim.predicted_verdict = predicted;
  return claim;
}

/// One claim as predicted, one otherwise, one that waits for a model, one without evidence, one
/// without a prediction.
struct FiveClaims {
  Claim same = predicted_claim("b/same", Verdict::reproduced);
  Claim other = predicted_claim("b/other", Verdict::underspecified);
  Claim waiting = predicted_claim("b/waiting", Verdict::reproduced);
  Claim unseen = predicted_claim("b/unseen", Verdict::reproduced);
  Claim unpredicted = predicted_claim("b/unpredicted", std::nullopt);
  JudgedRun judged;

  FiveClaims() {
    other.difference = "The text says more than we saw.";
    waiting.missing_model = "L-systems";
    waiting.fixed_verdict = Verdict::not_measured;
    judged.papers.resize(1);
    judged.papers[0].judgements = {{.claim = &same, .verdict = Verdict::reproduced},
                                   {.claim = &other, .verdict = Verdict::reproduced},
                                   {.claim = &waiting, .verdict = Verdict::not_measured},
                                   {.claim = &unseen, .verdict = Verdict::not_measured},
                                   {.claim = &unpredicted, .verdict = Verdict::reproduced}};
  }
};

TEST(Predictions, CountWhatWasFoundAgainstWhatWasPredicted) {
  const auto document = predictions_document(FiveClaims().judged, false);
  EXPECT_EQ(document["predicted"], 4);
  EXPECT_EQ(document["same"], 1);
  EXPECT_EQ(document["differ"], 1);
  EXPECT_EQ(document["not_built"], 1);
  EXPECT_EQ(document["not_seen"], 1);
  EXPECT_EQ(document["unpredicted"], 1);
}

TEST(Predictions, ShowOneColumnForEachVerdictThatWasFound) {
  const auto document = predictions_document(FiveClaims().judged, false);
  ASSERT_EQ(document["columns"].size(), 1u);
  ASSERT_EQ(document["rows"].size(), 2u);
  EXPECT_EQ(document["rows"][0]["predicted"], "reproduced");
  EXPECT_EQ(document["rows"][0]["total"], 3);
  EXPECT_EQ(document["rows"][0]["cells"][0]["same"], true);
  EXPECT_EQ(document["rows"][1]["predicted"], "underspecified");
  EXPECT_EQ(document["rows"][1]["cells"][0]["other"], true);
}

TEST(Predictions, NameEachDifferenceWithItsReason) {
  const auto document = predictions_document(FiveClaims().judged, false);
  ASSERT_EQ(document["differences"].size(), 1u);
  EXPECT_EQ(document["differences"][0]["id"], "b/other");
  EXPECT_EQ(document["differences"][0]["difference"], "The text says more than we saw.");
  EXPECT_EQ(document["differences"][0]["differs"], true);
  ASSERT_EQ(document["waiting"].size(), 1u);
  EXPECT_EQ(document["waiting"][0]["model"], "L-systems");
}

TEST(Predictions, ListWhatDependsOnTheMachineApart) {
  FiveClaims claims;
  EXPECT_EQ(predictions_document(claims.judged, false)["has_by_machine"], false);
  claims.same.machine_dependence = "above 10 here, below 10 there";
  claims.judged.papers[0].judgements[0].verdict = Verdict::not_reproduced;
  claims.judged.papers[0].judgements[0].varies = true;
  const auto document = predictions_document(claims.judged, false);
  ASSERT_EQ(document["by_machine"].size(), 1u);
  EXPECT_EQ(document["by_machine"][0]["id"], "b/same");
  EXPECT_EQ(document["by_machine"][0]["expected"], "reproduced");
  EXPECT_EQ(predictions_document(claims.judged, true)["by_machine_count"], 0);
}

TEST(Predictions, TellNothingOfAHiddenVerdict) {
  FiveClaims claims;
  claims.judged.papers[0].judgements[1].varies = true;
  const auto document = predictions_document(claims.judged, true);
  EXPECT_EQ(document["differ"], 0);
  EXPECT_EQ(document["not_seen"], 2);
}

TEST(Predictions, CountWhatNoRunDecidesApart) {
  FiveClaims claims;
  Claim fixed = predicted_claim("b/fixed", Verdict::not_measured);
  Claim reread = predicted_claim("b/reread", Verdict::reproduced);
  fixed.fixed_verdict = reread.fixed_verdict = Verdict::not_measured;
  Claim noisy = predicted_claim("b/noisy", Verdict::reproduced);
  for (const Claim* claim : {&fixed, &reread})
    claims.judged.papers[0].judgements.push_back(
        {.claim = claim, .verdict = Verdict::not_measured});
  claims.judged.papers[0].judgements.push_back({.claim = &noisy, .verdict = Verdict::inconclusive});
  const auto document = predictions_document(claims.judged, false);
  EXPECT_EQ(document["same"], 1);
  EXPECT_EQ(document["differ"], 1);
  EXPECT_EQ(document["undecided"], 1);
  EXPECT_EQ(document["fixed"], 2);
  EXPECT_EQ(document["fixed_same"], 1);
  ASSERT_EQ(document["fixed_differences"].size(), 1u);
  EXPECT_EQ(document["fixed_differences"][0]["id"], "b/reread");
  EXPECT_EQ(document["rows"][0]["predicted"], "reproduced");
  EXPECT_EQ(document["rows"][0]["fixed"], 1);
  EXPECT_EQ(document["rows"][0]["cells"][1]["other"], false) << "noise differs from nothing";
}

}  // namespace
}  // namespace phytobench
