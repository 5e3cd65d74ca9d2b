// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/comparison_json.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "benchmarks/comparison/example_report.hpp"
#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

using Json = nlohmann::json;

TEST(ComparisonJson, HoldsEveryBlockWithAllItsSamples) {
  const ComparisonReport report = example_report();
  const Json document = Json::parse(comparison_json(report));
  EXPECT_EQ(document["schema"], "phytobench/comparison-1");
  ASSERT_EQ(document["benchmarks"].size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) {
    const Json& benchmark = document["benchmarks"][i];
    const MeasuredBenchmark& measured = report.timing.measured.benchmarks[i];
    EXPECT_EQ(benchmark["name"], measured.name);
    EXPECT_EQ(benchmark["verdict"], std::string(name_of(report.concluded[i].verdict)));
    ASSERT_EQ(benchmark["blocks"].size(), measured.blocks.size());
    ASSERT_EQ(benchmark["control_blocks"].size(), measured.control.size());
    for (std::size_t b = 0; b < measured.blocks.size(); ++b) {
      const Json& block = benchmark["blocks"][b];
      EXPECT_EQ(block["block"], b);
      EXPECT_EQ(block["new_s"].get<std::vector<double>>(), measured.blocks[b].other);
      EXPECT_EQ(block["log_ratio"], measured.blocks[b].log_ratio());
      ASSERT_EQ(block["processes"].size(), 4u);
      EXPECT_EQ(block["processes"][0]["side"], block["order"] == "ABBA" ? "base" : "new");
      EXPECT_EQ(block["processes"][0]["samples"], Json::parse("[[10, 0.01, 0.011]]"));
      EXPECT_EQ(benchmark["control_blocks"][b]["processes"][0]["side"], "base");
    }
  }
}

TEST(ComparisonJson, SaysWhatWasNotMeasured) {
  const Json document = Json::parse(comparison_json(example_report()));
  const Json& wrong = document["benchmarks"][4];
  EXPECT_EQ(wrong["verdict"], "wrong answer");
  EXPECT_TRUE(wrong["ratio"].is_null());
  EXPECT_TRUE(wrong["iterations"].is_null());
  EXPECT_EQ(wrong["objection"], "because of this");
  EXPECT_TRUE(document["environment"].is_null());
  EXPECT_EQ(document["counts"]["wrong_answer"], 1);
  EXPECT_EQ(document["counts"]["same_binary"], 0);
  EXPECT_EQ(document["base"]["commit"], "1a2b3c4d5e6f");
  EXPECT_EQ(document["new"]["changed"], true);
}

TEST(ComparisonJson, SaysWhichTrialFailedAtWhichStep) {
  ComparisonReport report;
  report.failed_trials = {{"new", "b.so", "crashed", "SIGSEGV in associate() in iteration 2"}};
  const Json document = Json::parse(comparison_json(report));
  ASSERT_EQ(document["failed_trials"].size(), 1u);
  EXPECT_EQ(document["failed_trials"][0]["side"], "new");
  EXPECT_EQ(document["failed_trials"][0]["given"], "b.so");
  EXPECT_EQ(document["failed_trials"][0]["verdict"], "crashed");
  EXPECT_EQ(document["failed_trials"][0]["detail"], "SIGSEGV in associate() in iteration 2");
  EXPECT_EQ(document["summary"], "new failed its trial, so nothing was timed");
  EXPECT_TRUE(document["benchmarks"].empty());
  EXPECT_TRUE(Json::parse(comparison_json(example_report()))["failed_trials"].empty());
}

TEST(ComparisonJson, KeepsWhatWasTimedBesideAStoredResult) {
  ComparisonReport report = example_report();
  EXPECT_TRUE(Json::parse(comparison_json(report))["results"]["new"].is_null());
  report.other_result = StoredResult{
      .origin = {.given = "build", .kind = "build"},
      .seed = 8,
      .benchmarks = {{.name = "a", .processes = {{1e-3, 2e-3}, {3e-3}}, .is_by_process = true}}};
  const Json results = Json::parse(comparison_json(report))["results"];
  EXPECT_TRUE(results["base"].is_null());
  const StoredResult kept = stored_result_from(results["new"].dump(), "results");
  ASSERT_EQ(kept.benchmarks.size(), 1u);
  EXPECT_EQ(kept.benchmarks.front().processes, report.other_result->benchmarks.front().processes);
}

TEST(ComparisonJson, SurvivesNamesThatAreNoText) {
  ComparisonReport report = example_report();
  report.concluded[0].reason = "half \xc3";
  EXPECT_TRUE(Json::accept(comparison_json(report)));
}

TEST(ComparisonJson, NeedsAVerdictForEachBenchmark) {
  ComparisonReport report = example_report();
  report.concluded.pop_back();
  EXPECT_THROW(comparison_json(report), ContractViolation);
}

}  // namespace
}  // namespace phytobench
