// SPDX-License-Identifier: MIT
#include "reports/csv.hpp"

#include <cstdint>
#include <cstdlib>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace phytobench {
namespace {

/// A second, independent reading of RFC 4180: rows of fields.
std::vector<std::vector<std::string>> rows_of(const std::string& csv) {
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> row;
  std::string field;
  bool quoted = false;
  for (std::size_t i = 0; i < csv.size(); ++i) {
    const char c = csv[i];
    if (quoted) {
      if (c != '"') {
        field += c;
      } else if (i + 1 < csv.size() && csv[i + 1] == '"') {
        field += '"';
        ++i;
      } else {
        quoted = false;
      }
    } else if (c == '"') {
      quoted = true;
    } else if (c == ',' || c == '\n') {
      row.push_back(field);
      field.clear();
      if (c == '\n') {
        rows.push_back(row);
        row.clear();
      }
    } else {
      field += c;
    }
  }
  EXPECT_FALSE(quoted) << "a quote stays open";
  EXPECT_TRUE(field.empty() && row.empty()) << "the last line has no end";
  return rows;
}

TEST(Csv, LeavesPlainFieldsAsTheyAre) {
  EXPECT_EQ(csv_line({"a", "b c", "1.5"}), "a,b c,1.5\n");
  EXPECT_EQ(csv_line({"", "", ""}), ",,\n");
  EXPECT_EQ(csv_line({"it's; fine"}), "it's; fine\n");
}

TEST(Csv, QuotesCommasQuotesAndLineEnds) {
  EXPECT_EQ(csv_line({"a,b", "c"}), "\"a,b\",c\n");
  EXPECT_EQ(csv_line({"say \"no\""}), "\"say \"\"no\"\"\"\n");
  EXPECT_EQ(csv_line({"two\nlines"}), "\"two\nlines\"\n");
  EXPECT_EQ(csv_line({"old\rmac"}), "\"old\rmac\"\n");
  EXPECT_EQ(csv_line({"\""}), "\"\"\"\"\n");
}

TEST(CsvLaw, EveryLineReadsBack) {
  const std::vector<std::string> pieces = {"", "a", ",", "\"", "\n", "\r\n", "\"\"", "a,\"b\"\nc"};
  for (const std::string& first : pieces) {
    for (const std::string& second : pieces) {
      for (const std::string& third : pieces) {
        const std::vector<std::string> fields = {first + second, third, second + third + first};
        const auto rows = rows_of(csv_line(fields));
        ASSERT_EQ(rows.size(), 1u);
        EXPECT_EQ(rows[0], fields);
      }
    }
  }
}

RunContents small_run() {
  RunContents run;
  run.records.push_back({.experiment = "p/e",
                         .measurement = "p/e/edges",
                         .value = RecordValue{std::int64_t{2243}},
                         .unit = "edges",
                         .sample_size = 3,
                         .spread = 0.5,
                         .seed = std::uint64_t{7}});
  run.records.push_back({.experiment = "p/e",
                         .measurement = "p/e/third",
                         .value = RecordValue{1.0 / 3.0},
                         .unit = "1/length^3"});
  run.records.push_back({.experiment = "p/e",
                         .measurement = "p/e/stop",
                         .value = RecordValue{std::string("no, \"never\"")}});
  return run;
}

TEST(RecordsCsv, HoldsOneRowPerRecordAndSample) {
  RunContents run = small_run();
  run.timings.push_back({.experiment = "p/e",
                         .measurement = "p/e/seconds",
                         .round = 2,
                         .position = 1,
                         .value = 0.1,
                         .threads = 4,
                         .unit = "s"});
  const auto rows = rows_of(records_csv(run, false));
  ASSERT_EQ(rows.size(), 5u);
  EXPECT_EQ(rows[0],
            (std::vector<std::string>{"kind", "experiment", "measurement", "value", "unit", "n",
                                      "spread", "seed", "round", "position", "threads"}));
  EXPECT_EQ(rows[1], (std::vector<std::string>{"record", "p/e", "p/e/edges", "2243", "edges", "3",
                                               "0.5", "7", "", "", ""}));
  EXPECT_EQ(rows[3], (std::vector<std::string>{"record", "p/e", "p/e/stop", "no, \"never\"", "1",
                                               "1", "", "", "", "", ""}));
  EXPECT_EQ(rows[4], (std::vector<std::string>{"sample", "p/e", "p/e/seconds", "0.1", "s", "1", "",
                                               "", "2", "1", "4"}));
  EXPECT_EQ(rows_of(records_csv(run, true)).size(), 4u) << "samples are never the same twice";
}

TEST(RecordsCsv, LosesNoDigit) {
  const auto rows = rows_of(records_csv(small_run(), false));
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(std::strtod(rows[2][3].c_str(), nullptr), 1.0 / 3.0);
}

TEST(RecordsCsv, OfAnEmptyRunIsTheHeading) {
  EXPECT_EQ(rows_of(records_csv(RunContents{}, false)).size(), 1u);
}

TEST(RecordsCsv, NamesEachOfSeveralRuns) {
  const std::vector<ComparedRun> runs = {{"here, now", small_run()}, {"there", small_run()}};
  const auto rows = rows_of(records_csv(runs, false));
  ASSERT_EQ(rows.size(), 7u);
  EXPECT_EQ(rows[0][0], "letter");
  EXPECT_EQ(rows[0][1], "run");
  EXPECT_EQ(rows[0].size(), rows[1].size());
  EXPECT_EQ(rows[1][0], "A");
  EXPECT_EQ(rows[1][1], "here, now");
  EXPECT_EQ(rows[6][0], "B");
  EXPECT_EQ(rows[6][1], "there");
}

/// A paper with one exact and one timed judgement; they point into the claims beside them.
JudgedRun small_judged_run() {
  JudgedRun judged;
  judged.papers.resize(1);
  JudgedPaper& paper = judged.papers[0];
  paper.claims.claims.resize(2);
  Claim& exact = paper.claims.claims[0];
  exact.id = "p/exact";
  exact.paper = "p";
  exact.topic = "Growth";
  exact.text = "Two, or more";
  exact.unit = "edges";
  exact.digits = 1;
  exact.locator = "eq. 1, sec. 2";
  exact.kind = "count";
  exact.basis = "paper";
  exact.published = "5 \"edges\"";
  Claim& timed = paper.claims.claims[1];
  timed.id = "p/timed";
  timed.paper = "p";
  timed.reason = "bounds";
  timed.predicted_verdict = Verdict::underspecified;
  timed.checks.push_back({.terms = {{"p/e/seconds"}}});
  timed.kind = "ratio";
  timed.basis = "assumed";
  timed.published = "2";
  timed.machine_dependence = "Other caches.";
  timed.expected_verdict = Verdict::not_reproduced;
  paper.judgements.push_back(
      {.claim = &exact, .verdict = Verdict::reproduced, .measured = "5", .reason = "exact"});
  paper.judgements.push_back({.claim = &timed,
                              .verdict = Verdict::inconclusive,
                              .measured = "2.1 [1.9, 2.3]",
                              .reason = "noise",
                              .checks = {},
                              .varies = true});
  return judged;
}

/// One row by the names of its columns.
std::map<std::string, std::string> csv_row_of(const std::string& csv, std::size_t row) {
  const auto rows = rows_of(csv);
  std::map<std::string, std::string> named;
  for (std::size_t column = 0; column < rows.at(row).size(); ++column)
    named[rows[0].at(column)] = rows[row][column];
  return named;
}

TEST(ClaimsCsv, HoldsOneRowPerClaim) {
  const JudgedRun judged = small_judged_run();
  const std::string csv = claims_csv(judged, false);
  ASSERT_EQ(rows_of(csv).size(), 3u);
  EXPECT_EQ(csv_row_of(csv, 1),
            (std::map<std::string, std::string>{{"id", "p/exact"},
                                                {"paper", "p"},
                                                {"topic", "Growth"},
                                                {"locator", "eq. 1, sec. 2"},
                                                {"kind", "count"},
                                                {"text", "Two, or more"},
                                                {"published", "5 \"edges\""},
                                                {"unit", "edges"},
                                                {"digits", "1"},
                                                {"measured", "5"},
                                                {"verdict", "reproduced"},
                                                {"row", "reproduced"},
                                                {"basis", "paper"},
                                                {"expected_verdict", "reproduced"},
                                                {"predicted_verdict", ""},
                                                {"difference", ""},
                                                {"machine_dependence", ""},
                                                {"erratum", ""},
                                                {"tier", "smoke"},
                                                {"reason", "exact"},
                                                {"repeat", ""}}));
  auto timed = csv_row_of(csv, 2);
  EXPECT_EQ(timed["verdict"], "inconclusive");
  EXPECT_EQ(timed["row"], "inconclusive");
  EXPECT_EQ(timed["expected_verdict"], "not reproduced");
  EXPECT_EQ(timed["predicted_verdict"], "underspecified");
  EXPECT_EQ(timed["machine_dependence"], "Other caches.");
  EXPECT_EQ(timed["repeat"], "phytobench run p/e --tier smoke --out results/again-p-e-smoke");
}

TEST(ClaimsCsv, NamesTheRowThatTheReportCountsAClaimIn) {
  JudgedRun judged = small_judged_run();
  judged.papers[0].claims.claims[0].basis = "fitted";
  auto fitted = csv_row_of(claims_csv(judged, false), 1);
  EXPECT_EQ(fitted["verdict"], "reproduced");
  EXPECT_EQ(fitted["row"], "reproduced, fitted");
  judged.papers[0].judgements[0].verdict = Verdict::reproduced_with_erratum;
  EXPECT_EQ(csv_row_of(claims_csv(judged, false), 1)["row"], "reproduced with erratum");
}

TEST(ClaimsCsv, LeavesOutWhatRestsOnTimesOnRequest) {
  const JudgedRun judged = small_judged_run();
  EXPECT_EQ(csv_row_of(claims_csv(judged, true), 1), csv_row_of(claims_csv(judged, false), 1));
  auto timed = csv_row_of(claims_csv(judged, true), 2);
  EXPECT_EQ(timed["id"], "p/timed");
  EXPECT_EQ(timed["verdict"], "");
  EXPECT_EQ(timed["row"], "left out: rests on times");
  EXPECT_EQ(timed["measured"], "");
  EXPECT_EQ(timed["reason"], "bounds") << "what the run found may differ in the next one";
}

TEST(ClaimsByRunCsv, HoldsOneRowPerClaimAndRun) {
  RunComparison comparison;
  comparison.runs = {{"here", {}}, {"there", {}}};
  comparison.claims = {{.id = "p/a",
                        .verdicts = {Verdict::reproduced, Verdict::not_reproduced},
                        .measured = {"1", "2"},
                        .merged = Verdict::inconclusive,
                        .contradicted = true},
                       {.id = "p/b",
                        .verdicts = {Verdict::inconclusive, Verdict::reproduced},
                        .measured = {"1.9", "2.1"},
                        .merged = Verdict::reproduced,
                        .varies = true}};
  const auto rows = rows_of(claims_by_run_csv(comparison, false));
  ASSERT_EQ(rows.size(), 5u);
  EXPECT_EQ(rows[0], (std::vector<std::string>{"id", "letter", "run", "verdict", "measured",
                                               "merged_verdict"}));
  EXPECT_EQ(rows[2],
            (std::vector<std::string>{"p/a", "B", "there", "not reproduced", "2", "inconclusive"}));
  EXPECT_EQ(rows[3],
            (std::vector<std::string>{"p/b", "A", "here", "inconclusive", "1.9", "reproduced"}));
  EXPECT_EQ(rows_of(claims_by_run_csv(comparison, true)).size(), 3u);
}

TEST(DifferingRecordsCsv, HoldsOneRowPerValue) {
  RunComparison comparison;
  comparison.runs = {{"here", {}}, {"there", {}}, {"elsewhere", {}}};
  comparison.records.differing = {
      {.measurement = "p/e/x", .values = {"1", std::nullopt, "2"}, .relative = 0.5}};
  const auto rows = rows_of(differing_records_csv(comparison));
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0], (std::vector<std::string>{"measurement", "letter", "run", "value"}));
  EXPECT_EQ(rows[2], (std::vector<std::string>{"p/e/x", "C", "elsewhere", "2"}));
}

}  // namespace
}  // namespace phytobench
