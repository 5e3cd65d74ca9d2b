// SPDX-License-Identifier: MIT
#include "reports/document.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/contract/text_file.hpp"
#include "reference/data_folder.hpp"
#include "reports/render_template.hpp"

namespace phytobench {
namespace {

using nlohmann::ordered_json;

Claim claim_with_basis(const std::string& id, const std::string& basis) {
  Claim claim;
  claim.id = id;
  claim.basis = basis;
  return claim;
}

/// Two works; only the second was run: one claim holds, one by fitting, one lacks evidence.
struct PartialRun {
  Claim plain = claim_with_basis("b/plain", "paper"),
        fitted = claim_with_basis("b/fitted", "fitted"),
        absent = claim_with_basis("a/absent", "paper");
  JudgedRun judged;

  PartialRun() {
    const std::vector<JudgedCheck> measured = {{.terms = {{.outcome = CheckOutcome::holds}}}};
    judged.papers.resize(2);
    judged.papers[0].paper.key = "a";
    judged.papers[0].judgements = {{.claim = &absent, .checks = {{.terms = {{}}}}}};
    judged.papers[1].paper.key = "b";
    judged.papers[1].judgements = {
        {.claim = &plain, .verdict = Verdict::reproduced, .checks = measured},
        {.claim = &fitted, .verdict = Verdict::reproduced, .checks = measured}};
    judged.run.header = {Tier::smoke, 3};
    judged.run.complete_experiments = {"b/x"};
  }

  ordered_json document() const {
    return make_document(judged, {.environment_json = R"({"suite_version": "0.0.9"})",
                                  .run_folder = "here",
                                  .pictures = {{"b/x/drawn.svg", "<svg aria-label=\"Drawn\"/>"}},
                                  .photographs = {},
                                  .plots = {}});
  }
};

TEST(Document, PutsWorksThatWereNotRunAfterTheOthers) {
  const ordered_json document = PartialRun().document();
  EXPECT_EQ(document["papers"][0]["key"], "b");
  EXPECT_EQ(document["papers"][0]["in_run"], true);
  EXPECT_EQ(document["papers"][1]["key"], "a");
  EXPECT_EQ(document["papers"][1]["in_run"], false);
}

TEST(Document, CountsTheClaimsThatHadAMeasurement) {
  const ordered_json document = PartialRun().document();
  EXPECT_EQ(document["run"]["claims"], 3);
  EXPECT_EQ(document["run"]["measured_claims"], 2);
  EXPECT_EQ(document["run"]["open"], 1);
}

TEST(Document, CountsFittedVerdictsApartFromPlainOnes) {
  const ordered_json document = PartialRun().document();
  EXPECT_EQ(document["run"]["reproduced"], 1);
  EXPECT_EQ(document["run"]["fitted"], 1);
  const ordered_json& rows = document["counts"]["rows"];
  EXPECT_EQ(rows[0]["verdict"], "reproduced");
  EXPECT_EQ(rows[0]["total"], 1);
  EXPECT_EQ(rows[1]["verdict"], "reproduced, fitted");
  EXPECT_EQ(rows[1]["total"], 1);
}

TEST(Document, BeginsWithWhatTheRunLacks) {
  PartialRun run;
  EXPECT_EQ(run.document()["summary"][0]["term"], "Asked");
  run.judged.run.unfinished = "a/y";
  EXPECT_EQ(run.document()["summary"][0]["term"], "Incomplete");
  EXPECT_EQ(run.document()["limits"][0], run.document()["summary"][0]["text"]);
}

TEST(Document, SaysInItsFirstLinesWhatDependsOnTheMachine) {
  PartialRun run;
  run.plain.machine_dependence = "below 2 there";
  run.judged.papers[1].judgements[0].varies = true;
  run.judged.papers[1].judgements[0].verdict = Verdict::not_reproduced;
  const ordered_json line = run.document()["summary"].back();
  EXPECT_EQ(line["term"], "Machines");
  EXPECT_EQ(line["varies"], true);
  EXPECT_NE(line["text"].get<std::string>().find("1 verdict is not as expected"),
            std::string::npos);
}

TEST(Document, HoldsPicturesInFewerBytesThanTheirFiles) {
  const PartialRun partial;
  const DocumentSources sources{
      .environment_json = "{}",
      .run_folder = "here",
      .pictures = {{"b/x/drawn.svg", "<svg>\n<g>\n<path/>\n</g>\n</svg>"}},
      .photographs = {},
      .plots = {}};
  EXPECT_EQ(make_document(partial.judged, sources)["papers"][0]["pictures"][0]["svg"],
            "<svg><g><path/></g></svg>");
}

TEST(Document, RepeatsWhatTheRunHolds) {
  EXPECT_EQ(PartialRun().document()["repeat"]["runs"][0],
            "phytobench run b/x --tier smoke --seed 3 --out results/again");
}

std::string head_of(const ordered_json& document) {
  return render_template(read_text_file(data_folder() / "templates" / "html" / "header.mustache"),
                         document, EscapeFor::html);
}

TEST(Document, TellsTheProgramThatRanFromTheOneThatReports) {
  const ordered_json run = PartialRun().document()["run"];
  EXPECT_EQ(run["run_version"], "0.0.9");
  EXPECT_NE(run["version"], "0.0.9");
  EXPECT_EQ(run["several"], false);
  EXPECT_NE(head_of({{"run", run}}).find("run by phytobench 0.0.9, commit"), std::string::npos);
}

TEST(Document, NamesEachOfSeveralRuns) {
  PartialRun merged;
  RunComparison comparison;
  comparison.runs = {{"GCC", {}}, {"Clang", {}}};
  comparison.runs[1].contents.header = {Tier::full, 2};
  const ordered_json document = make_document(merged.judged, {.environment_json = "{}",
                                                              .run_folder = "here",
                                                              .pictures = {},
                                                              .photographs = {},
                                                              .plots = {},
                                                              .comparison = &comparison});
  EXPECT_EQ(document["timing"]["machine"],
            "The times of each experiment are of the first run that completed it.");
  const ordered_json& run = document["run"];
  EXPECT_EQ(run["several"], true);
  EXPECT_EQ(run["one_with_varying"], false) << "date and commit are of the first run only";
  ASSERT_EQ(run["runs"].size(), 2u);
  EXPECT_EQ(run["runs"][1]["label"], "Clang");
  EXPECT_EQ(run["runs"][1]["tier"], "full");
  EXPECT_EQ(run["runs"][1]["seed"], 2);
  const std::string head = head_of({{"run", run}});
  EXPECT_NE(head.find("see below</a>: A (tier quick, seed 0); B (tier full, seed 2);"),
            std::string::npos)
      << head;
  EXPECT_EQ(head.find("run by phytobench"), std::string::npos);
}

TEST(Document, ShowsFiguresInTheirWorkAlone) {
  const ordered_json document = PartialRun().document();
  EXPECT_EQ(document["papers"][0]["has_pictures"], true);
  EXPECT_EQ(document["papers"][0]["pictures"][0]["caption"], "Drawn");
  EXPECT_EQ(document["papers"][1]["has_pictures"], false);
}

TEST(Document, GroupsClaimsUnderTheirTopics) {
  PartialRun run;
  run.plain.topic = "Growth";
  run.fitted.topic = "Leaves";
  const ordered_json topics = run.document()["papers"][0]["topics"];
  ASSERT_EQ(topics.size(), 2u);
  EXPECT_EQ(topics[0]["title"], "Growth");
  EXPECT_EQ(topics[0]["anchor"], "topic-b-Growth");
  EXPECT_EQ(topics[1]["claims"][0]["id"], "b/fitted");
  EXPECT_EQ(topics[1]["tally"][0]["label"], "reproduced, fitted");
}

TEST(Document, ListsWhatWasMeasuredButNotClaimed) {
  PartialRun run;
  run.judged.run.records = {{.experiment = "b/x", .measurement = "b/x/a/n", .value = 1.0},
                            {.experiment = "b/x", .measurement = "b/x/a/m", .value = 1.0}};
  run.judged.run.timings = {{.experiment = "b/x", .measurement = "b/x/cost/seconds", .value = 1.0}};
  const ordered_json document = run.document();
  EXPECT_EQ(document["unclaimed"], 2);
  EXPECT_EQ(document["unclaimed_groups"][0]["groups"][0]["group"], "a");
}

TEST(Document, LeavesSlotsForWhatOthersAdd) {
  const ordered_json document = PartialRun().document();
  EXPECT_EQ(document["has_comparison"], false);
  EXPECT_EQ(document["has_validation"], false);
}

}  // namespace
}  // namespace phytobench
