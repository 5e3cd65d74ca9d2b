// SPDX-License-Identifier: MIT
#include "reports/document_timings.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace phytobench {
namespace {

/// Two quantities in four rounds: one scatters by a tenth, one not at all; and what it cost.
RunContents timed_run() {
  RunContents run;
  for (std::int64_t round = 3; round >= 0; --round) {
    const double scattered = round % 2 == 0 ? 1.0 : 1.1;
    run.timings.push_back(
        {.experiment = "b/x", .measurement = "b/x/a/seconds", .round = round, .value = scattered});
    run.timings.push_back(
        {.experiment = "b/x", .measurement = "b/x/b/seconds", .round = round, .value = 0.002});
  }
  run.timings.push_back({.experiment = "b/x", .measurement = "b/x/cost/seconds", .value = 9.0});
  return run;
}

TEST(Scatter, IsTheChangeBetweenNeighbours) {
  const std::vector<double> samples = {2.0, 3.0, 1.5};
  EXPECT_EQ(round_changes(samples), (std::vector<double>{0.5, 0.5}));
  EXPECT_TRUE(round_changes(std::vector<double>{1.0}).empty());
  EXPECT_EQ(scatter_of({}).pairs, 0u);
  const std::vector<double> changes = {0.0, 0.1, 0.3};
  EXPECT_EQ(scatter_of(changes).typical, 0.1);
  EXPECT_NEAR(scatter_of(changes).one_in_twenty, 0.28, 1e-12);
}

TEST(Scatter, IsZeroForEqualTimesAndFreeOfScale) {
  const std::vector<double> equal(9, 0.3);
  EXPECT_EQ(scatter_of(round_changes(equal)).one_in_twenty, 0.0);
  const std::vector<double> small = {1.0, 1.2, 0.9}, large = {8.0, 9.6, 7.2};
  EXPECT_NEAR(scatter_of(round_changes(small)).typical, scatter_of(round_changes(large)).typical,
              1e-12);
}

TEST(Timings, AreShownByExperimentWithoutItsCost) {
  const auto document = timings_document(timed_run(), false);
  ASSERT_EQ(document["experiments"].size(), 1u);
  const auto& experiment = document["experiments"][0];
  EXPECT_EQ(experiment["measurements"], 2);
  EXPECT_EQ(experiment["pairs"], 6);
  EXPECT_EQ(experiment["rows"][0]["name"], "a/seconds");
  EXPECT_EQ(experiment["rows"][0]["rounds"], 4);
  EXPECT_EQ(experiment["rows"][1]["median"], "2 ms");
  EXPECT_EQ(document["has_scatter"], true);
}

TEST(Timings, HaveIntervalsFromSixRoundsOnAndRangesBelow) {
  RunContents run;
  for (std::int64_t round = 0; round < 6; ++round) {
    const double seconds = 1.0 + static_cast<double>(round);
    run.timings.push_back(
        {.experiment = "b/x", .measurement = "b/x/a", .round = round, .value = seconds});
    if (round < 3)
      run.timings.push_back(
          {.experiment = "b/x", .measurement = "b/x/b", .round = round, .value = seconds});
  }
  const auto document = timings_document(run, false);
  const auto& rows = document["experiments"][0]["rows"];
  EXPECT_EQ(rows[0]["interval"], "1 s to 6 s");
  EXPECT_EQ(rows[1]["interval"], "1 s to 3 s in 3 rounds");
  EXPECT_EQ(document["ends"], "95 % interval, or range of fewer than six rounds");
}

TEST(Timings, OfOneRoundHaveNoInterval) {
  RunContents run;
  run.timings = {{.experiment = "b/x", .measurement = "b/x/bytes", .value = 5.0, .unit = "B"}};
  const auto document = timings_document(run, false);
  EXPECT_EQ(document["experiments"][0]["rows"][0]["has_interval"], false);
  EXPECT_EQ(document["experiments"][0]["rows"][0]["median"], "5 B");
  EXPECT_EQ(document["has_scatter"], false);
}

TEST(Timings, AreLeftOutOnRequest) {
  const auto document = timings_document(timed_run(), true);
  EXPECT_EQ(document["has_timings"], false);
  EXPECT_EQ(document["hidden"], true);
}

}  // namespace
}  // namespace phytobench
