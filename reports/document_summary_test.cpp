// SPDX-License-Identifier: MIT
#include "reports/document_summary.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "reports/document_attention.hpp"
#include "reports/verdict_counts.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;

Claim claim_of(const std::string& id, const std::string& basis, Verdict expected) {
  Claim claim;
  claim.id = id;
  claim.basis = basis;
  claim.kind = "value";
  claim.expected_verdict = expected;
  return claim;
}

/// One claim for each row of the counts that differs from the others in kind.
struct ManyVerdicts {
  Claim holds = claim_of("b/holds", "paper", Verdict::reproduced);
  Claim fitted = claim_of("b/fitted", "fitted", Verdict::reproduced);
  Claim fails = claim_of("b/fails", "assumed", Verdict::reproduced);
  Claim noisy = claim_of("b/noisy", "paper", Verdict::reproduced);
  Claim surprising = claim_of("b/surprising", "paper", Verdict::not_reproduced);
  Claim absent = claim_of("b/absent", "paper", Verdict::reproduced);
  Claim modelless = claim_of("b/modelless", "paper", Verdict::not_measured);
  JudgedRun judged;

  ManyVerdicts() {
    modelless.missing_model = "L-systems";
    modelless.fixed_verdict = Verdict::not_measured;
    judged.papers.resize(1);
    judged.papers[0].paper.key = "b";
    judged.papers[0].paper.author = "Ada";
    judged.papers[0].paper.year = "1999";
    judged.papers[0].judgements = {
        {.claim = &holds, .verdict = Verdict::reproduced},
        {.claim = &fitted, .verdict = Verdict::reproduced},
        {.claim = &fails, .verdict = Verdict::not_reproduced},
        {.claim = &noisy, .verdict = Verdict::inconclusive, .varies = true},
        {.claim = &surprising, .verdict = Verdict::reproduced},
        {.claim = &absent, .verdict = Verdict::not_measured},
        {.claim = &modelless, .verdict = Verdict::not_measured}};
  }
};

std::size_t total_of(const nlohmann::ordered_json& counts, std::string_view row) {
  for (const auto& candidate : counts["rows"])
    if (candidate["verdict"] == row) return candidate["total"];
  return 999;
}

TEST(Summary, SaysInFiveLinesWhatWasAskedAndFound) {
  const auto lines = summary_document(ManyVerdicts().judged, nullptr, false);
  ASSERT_EQ(lines.size(), 5u);
  EXPECT_THAT(lines[0]["text"].get<std::string>(), HasSubstr("7 claims of Ada (1999)"));
  EXPECT_THAT(lines[2]["text"].get<std::string>(), HasSubstr("2 claims hold from the text alone"));
  EXPECT_THAT(lines[2]["text"].get<std::string>(), HasSubstr("1 holds only with a parameter"));
  EXPECT_THAT(lines[3]["text"].get<std::string>(), HasSubstr("1 waits for a model"));
}

TEST(Summary, SaysWhatTheTextAloneFixesApartFromWhatTheRunDecided) {
  ManyVerdicts of;
  Claim vague = claim_of("b/vague", "paper", Verdict::underspecified);
  vague.fixed_verdict = vague.predicted_verdict = Verdict::underspecified;
  of.holds.predicted_verdict = Verdict::reproduced;
  of.judged.papers[0].judgements.push_back({.claim = &vague, .verdict = Verdict::underspecified});
  EXPECT_THAT(summary_document(of.judged, nullptr, false)[4]["text"].get<std::string>(),
              HasSubstr("decided, 1 was found as predicted and 0 otherwise; 1 more has a verdict"));
}

TEST(Summary, TellsSeveralRunsApart) {
  ManyVerdicts of;
  of.judged.papers[0].judgements[3].contradicted = true;
  RunComparison comparison;
  comparison.runs = {{"GCC", {}}, {"Clang", {}}};
  comparison.runs[0].contents.header = {Tier::quick, 1};
  comparison.runs[1].contents.header = {Tier::full, 2};
  const auto lines = summary_document(of.judged, &comparison, false);
  EXPECT_THAT(lines[1]["text"].get<std::string>(),
              HasSubstr("2 runs, see below: GCC (tier quick, seed 1); Clang (tier full, seed 2)."));
  EXPECT_THAT(lines[4]["text"].get<std::string>(), HasSubstr("on 1 claim the runs disagree."));
}

TEST(Counts, GiveEachClaimToOneRow) {
  const auto counts = counts_document(ManyVerdicts().judged, false);
  std::size_t total = 0;
  for (const auto& row : counts["rows"]) total += row["total"].get<std::size_t>();
  EXPECT_EQ(total, 7u);
  EXPECT_EQ(total_of(counts, "reproduced"), 2u);
  EXPECT_EQ(total_of(counts, fitted_row), 1u);
  EXPECT_EQ(total_of(counts, "not measured in this run"), 1u);
  EXPECT_EQ(total_of(counts, "not measured: model not built yet"), 1u);
  EXPECT_EQ(total_of(counts, "not measured: no check"), 0u);
}

TEST(Counts, SplitRowsByBasisAndWork) {
  const auto counts = counts_document(ManyVerdicts().judged, false);
  EXPECT_EQ(counts["works"][0], "Ada 1999");
  EXPECT_EQ(counts["rows"][1]["by_basis"][3]["count"], 1);
  EXPECT_EQ(counts["rows"][1]["by_paper"][0]["count"], 1);
}

TEST(Attention, ComesInGroupsThatShareNoClaim) {
  const auto groups = attention_document(ManyVerdicts().judged, false);
  ASSERT_EQ(groups.size(), 3u);
  EXPECT_EQ(groups[0]["claims"][0]["id"], "b/fails");
  EXPECT_EQ(groups[1]["claims"][0]["id"], "b/noisy");
  EXPECT_EQ(groups[2]["claims"][0]["id"], "b/surprising");
  EXPECT_EQ(groups[0]["claim_count"], 1);
}

TEST(Attention, LeavesOutWhatRestsOnTimes) {
  const auto groups = attention_document(ManyVerdicts().judged, true);
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_EQ(total_of(counts_document(ManyVerdicts().judged, true), "left out: rests on times"), 1u);
  EXPECT_EQ(total_of(counts_document(ManyVerdicts().judged, true), "inconclusive"), 0u);
}

TEST(Limits, NameClaimsThatTheRunDidNotFeed) {
  const auto limits = limits_document(ManyVerdicts().judged, false);
  EXPECT_THAT(limits[0].get<std::string>(), HasSubstr("1 claim has checks"));
}

}  // namespace
}  // namespace phytobench
