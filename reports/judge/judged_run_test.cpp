// SPDX-License-Identifier: MIT
#include "reports/judge/judged_run.hpp"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace phytobench {
namespace {

using Numbers = std::vector<std::vector<double>>;

PublishedTable two_by_two(Numbers values) {
  PublishedTable table;
  table.id = "times";
  table.rows = {"slow", "fast"};
  table.columns = {"s", "d"};
  table.measurement = "p/e/{row}.{column}/seconds";
  table.values = std::move(values);
  return table;
}

void add_timing(RunContents& run, const std::string& measurement,
                const std::vector<double>& seconds) {
  std::int64_t round = 0;
  for (const double value : seconds) {
    run.timings.push_back({.experiment = "p/e",
                           .measurement = measurement,
                           .round = round,
                           .position = 0,
                           .value = value,
                           .threads = 1});
    ++round;
  }
}

void add_count(RunContents& run, const std::string& measurement, std::int64_t value) {
  run.records.push_back(
      {.experiment = "p/e", .measurement = measurement, .value = RecordValue{value}});
}

/// Four cells whose rounds share the machine's mood: the second is twice as slow throughout.
RunContents complete_run() {
  RunContents run;
  add_timing(run, "p/e/slow.s/seconds", {8.0, 16.0, 8.0});
  add_timing(run, "p/e/slow.d/seconds", {4.0, 8.0, 4.0});
  add_timing(run, "p/e/fast.s/seconds", {2.0, 4.0, 2.0});
  add_timing(run, "p/e/fast.d/seconds", {1.0, 2.0, 1.0});
  return run;
}

TEST(JudgedTable, HoldsMediansAndSharesOfTheSlowestCell) {
  const PublishedTable table = two_by_two({{40.0, 30.0}, {20.0, 10.0}});
  const JudgedTable judged = judge_table(table, Evidence(complete_run()));
  EXPECT_EQ(judged.table, &table);
  EXPECT_TRUE(judged.measured);
  EXPECT_TRUE(judged.timed);
  EXPECT_EQ(judged.published_share, (Numbers{{1.0, 0.75}, {0.5, 0.25}}));
  const Numbers medians = {{8.0, 4.0}, {2.0, 1.0}};
  EXPECT_TRUE(judged.values[0][0].is_only_range()) << "three rounds have no interval";
  ASSERT_EQ(judged.values.size(), 2u);
  ASSERT_EQ(judged.share.size(), 2u);
  for (std::size_t row = 0; row < 2; ++row) {
    ASSERT_EQ(judged.values[row].size(), 2u);
    ASSERT_EQ(judged.share[row].size(), 2u);
    for (std::size_t column = 0; column < 2; ++column) {
      EXPECT_EQ(judged.values[row][column].value, medians[row][column]);
      // Paired by round, the slower second round leaves no trace in the shares.
      EXPECT_EQ(judged.share[row][column].value, medians[row][column] / 8.0);
      EXPECT_EQ(judged.share[row][column].low, medians[row][column] / 8.0);
      EXPECT_EQ(judged.share[row][column].high, medians[row][column] / 8.0);
    }
  }
}

TEST(JudgedTable, TakesTheSlowestCellOfEachTableOnItsOwn) {
  // Published: the last cell is the slowest; measured: the first.
  const PublishedTable table = two_by_two({{1.0, 2.0}, {3.0, 4.0}});
  const JudgedTable judged = judge_table(table, Evidence(complete_run()));
  EXPECT_EQ(judged.published_share, (Numbers{{0.25, 0.5}, {0.75, 1.0}}));
  ASSERT_EQ(judged.share.size(), 2u);
  EXPECT_EQ(judged.share[0][0].value, 1.0);
  EXPECT_EQ(judged.share[1][1].value, 0.125);
}

TEST(JudgedTable, WithACellMissingIsNotMeasured) {
  const PublishedTable table = two_by_two({{4.0, 3.0}, {2.0, 1.0}});
  RunContents run = complete_run();
  run.timings.pop_back();
  run.timings.pop_back();
  run.timings.pop_back();
  const JudgedTable judged = judge_table(table, Evidence(run));
  EXPECT_FALSE(judged.measured);
  EXPECT_TRUE(judged.share.empty());
  EXPECT_EQ(judged.published_share, (Numbers{{1.0, 0.75}, {0.5, 0.25}}));
}

TEST(JudgedTable, OfCountsIsNotTimed) {
  PublishedTable table = two_by_two({{4.0, 3.0}, {2.0, 1.0}});
  table.measurement = "p/e/{row}.{column}/edges";
  RunContents run;
  add_count(run, "p/e/slow.s/edges", 4);
  add_count(run, "p/e/slow.d/edges", 4);
  add_count(run, "p/e/fast.s/edges", 2);
  add_count(run, "p/e/fast.d/edges", 1);
  const JudgedTable judged = judge_table(table, Evidence(run));
  EXPECT_TRUE(judged.measured);
  EXPECT_FALSE(judged.timed);
  ASSERT_EQ(judged.values.size(), 2u);
  EXPECT_EQ(judged.values[1][0].value, 2.0);
  EXPECT_EQ(judged.values[1][0].rounds, 0u);
  EXPECT_EQ(judged.values[1][0].low, 2.0);
  EXPECT_EQ(judged.values[1][0].high, 2.0);
}

TEST(JudgedTable, DividesBothSidesByTheSameWork) {
  PublishedTable table = two_by_two({{40.0, 30.0}, {20.0, 10.0}});
  table.companions = {"evaluations", "never_recorded"};
  table.per = "evaluations";
  RunContents run = complete_run();
  add_count(run, "p/e/slow.s/evaluations", 4);
  add_count(run, "p/e/slow.d/evaluations", 2);
  add_count(run, "p/e/fast.s/evaluations", 2);
  add_count(run, "p/e/fast.d/evaluations", 1);
  const JudgedTable judged = judge_table(table, Evidence(run));
  EXPECT_EQ(judged.published_per, (Numbers{{10.0, 15.0}, {10.0, 10.0}}));
  EXPECT_EQ(judged.measured_per, (Numbers{{2.0, 2.0}, {1.0, 1.0}}));
  // A companion without evidence in every cell is left out.
  ASSERT_EQ(judged.companions.size(), 1u);
  EXPECT_EQ(judged.companions[0].name, "evaluations");
  EXPECT_FALSE(judged.companions[0].timed);
  EXPECT_EQ(judged.companions[0].values[0][1].value, 2.0);
}

TEST(JudgedTable, WithoutTheWorkGivesNoQuotients) {
  PublishedTable table = two_by_two({{40.0, 30.0}, {20.0, 10.0}});
  table.per = "evaluations";
  RunContents run = complete_run();
  add_count(run, "p/e/slow.s/evaluations", 4);
  const JudgedTable judged = judge_table(table, Evidence(run));
  EXPECT_TRUE(judged.published_per.empty());
  EXPECT_TRUE(judged.measured_per.empty());
}

TEST(JudgedRun, ReproducesNothingWithoutEvidence) {
  const JudgedRun judged = judge_run(RunContents{});
  ASSERT_FALSE(judged.papers.empty());
  for (const JudgedPaper& paper : judged.papers) {
    ASSERT_EQ(paper.judgements.size(), paper.claims.claims.size());
    ASSERT_EQ(paper.tables.size(), paper.claims.tables.size());
    for (std::size_t i = 0; i < paper.judgements.size(); ++i) {
      const Claim& claim = paper.claims.claims[i];
      SCOPED_TRACE(claim.id);
      EXPECT_EQ(paper.judgements[i].claim, &claim);
      EXPECT_EQ(paper.judgements[i].verdict, claim.fixed_verdict.value_or(Verdict::not_measured));
      EXPECT_FALSE(paper.judgements[i].is_unexpected());
      EXPECT_FALSE(paper.judgements[i].reason.empty());
    }
    for (const JudgedTable& table : paper.tables) EXPECT_FALSE(table.measured);
  }
}

}  // namespace
}  // namespace phytobench
