// SPDX-License-Identifier: MIT
#include "reports/document_summary.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "reports/document_attention.hpp"
#include "reports/document_claims.hpp"
#include "reports/run_limits.hpp"
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
  Claim amended = claim_of("b/amended", "paper", Verdict::reproduced_with_erratum);
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
    amended.erratum = "E1";
    judged.papers.resize(1);
    judged.papers[0].errata = {{.id = "E1", .kind = ErratumKind::number}};
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
        {.claim = &modelless, .verdict = Verdict::not_measured},
        {.claim = &amended, .verdict = Verdict::reproduced_with_erratum}};
  }
};

std::size_t total_of(const nlohmann::ordered_json& counts, std::string_view row) {
  for (const auto& candidate : counts["rows"])
    if (candidate["verdict"] == row) return candidate["total"];
  return 999;
}

std::string line_of(const nlohmann::ordered_json& lines, std::string_view term) {
  for (const auto& line : lines)
    if (line["term"] == term) return line["text"];
  return "no such line";
}

TEST(Summary, SaysALineEachWhatWasAskedFoundWrongAndOpen) {
  const auto lines = summary_document(ManyVerdicts().judged, nullptr, false);
  EXPECT_EQ(lines.size(), 7u);
  EXPECT_THAT(line_of(lines, "Asked"), HasSubstr("8 claims of Ada (1999)"));
  EXPECT_THAT(line_of(lines, "Found"), HasSubstr("2 claims are reproduced: 2 from the text alone"));
  EXPECT_THAT(line_of(lines, "Found"), HasSubstr("1 more holds only with a parameter"));
  EXPECT_EQ(
      line_of(lines, "Wrong in the works"),
      "1 claim holds only once corrected. What is wrong: a number (1). 1 claim is not reproduced: "
      "what was measured contradicts it. If something that the work does not state would make one "
      "hold, its reason says what.");
  EXPECT_THAT(line_of(lines, "Open"), HasSubstr("3 claims: 1 waits for a model"));
  EXPECT_THAT(line_of(lines, "Cannot be told"), HasSubstr("0 claims: 0 state seconds"));
}

TEST(Summary, CountsEachClaimInOneLine) {
  ManyVerdicts of;
  Claim vague = claim_of("b/vague", "paper", Verdict::underspecified);
  Claim slow = claim_of("b/slow", "paper", Verdict::not_comparable);
  Claim empty = claim_of("b/empty", "paper", Verdict::not_measured);
  empty.fixed_verdict = Verdict::not_measured;
  auto& judgements = of.judged.papers[0].judgements;
  judgements.push_back({.claim = &vague, .verdict = Verdict::underspecified});
  judgements.push_back({.claim = &slow, .verdict = Verdict::not_comparable});
  judgements.push_back({.claim = &empty, .verdict = Verdict::not_measured});
  for (const bool without_varying : {false, true}) {
    const ClaimCounts c = counts_of(of.judged, without_varying);
    EXPECT_EQ(c.not_comparable + c.underspecified + c.unmeasurable, 3u);
    EXPECT_EQ(c.claims, c.reproduced + c.fitted + c.with_erratum + c.refuted + c.inconclusive +
                            c.not_seen + c.without_model + 3 + c.hidden);
  }
  EXPECT_THAT(line_of(summary_document(of.judged, nullptr, false), "Cannot be told"),
              HasSubstr("3 claims: 1 states seconds of another machine (not comparable), 1 leaves "
                        "too much open to be checked (underspecified), 1 states nothing"));
}

TEST(Summary, SaysWhatTheTextAloneFixesApartFromWhatTheRunDecided) {
  ManyVerdicts of;
  Claim vague = claim_of("b/vague", "paper", Verdict::underspecified);
  vague.fixed_verdict = vague.predicted_verdict = Verdict::underspecified;
  of.holds.predicted_verdict = Verdict::reproduced;
  of.judged.papers[0].judgements.push_back({.claim = &vague, .verdict = Verdict::underspecified});
  EXPECT_THAT(line_of(summary_document(of.judged, nullptr, false), "Predicted"),
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
  EXPECT_THAT(line_of(lines, "Run"),
              HasSubstr("2 runs, see below: A (tier quick, seed 1); B (tier full, seed 2)."));
  EXPECT_THAT(line_of(lines, "Open"), HasSubstr("On 1 claim the runs disagree."));
}

TEST(Counts, GiveEachClaimToOneRow) {
  const auto counts = counts_document(ManyVerdicts().judged, false);
  std::size_t total = 0;
  for (const auto& row : counts["rows"]) total += row["total"].get<std::size_t>();
  EXPECT_EQ(total, 8u);
  EXPECT_EQ(total_of(counts, "reproduced"), 2u);
  EXPECT_EQ(total_of(counts, "wrong as printed, holds corrected"), 1u);
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

TEST(Counts, TellKindsOfErrataAndKeepIdentifiersForFilters) {
  const auto row = counts_document(ManyVerdicts().judged, false)["rows"][2];
  EXPECT_EQ(row["row"], "reproduced-with-erratum");
  EXPECT_EQ(row["class"], "reproduced-with-erratum");
  ASSERT_EQ(row["kinds"].size(), 1u);
  EXPECT_EQ(row["kinds"][0]["verdict"], "number");
  EXPECT_EQ(row["kinds"][0]["total"], 1);
  EXPECT_EQ(row["kinds"][0]["by_basis"][0]["count"], 1);
}

TEST(Counts, FilterWhatIsLeftOutByTheRowOfItsClaims) {
  const ManyVerdicts of;
  const auto rows = counts_document(of.judged, true)["rows"];
  EXPECT_EQ(rows.back()["row"], shown_verdict(of.judged.papers[0].judgements[3], true).row);
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
  const std::vector<std::string> limits = run_limits(ManyVerdicts().judged, false);
  EXPECT_THAT(limits.at(0), HasSubstr("1 claim has checks"));
}

}  // namespace
}  // namespace phytobench
