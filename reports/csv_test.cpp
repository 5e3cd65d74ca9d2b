// SPDX-License-Identifier: MIT
#include "reports/csv.hpp"

#include <cstdint>
#include <cstdlib>
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

TEST(RecordsCsv, HoldsOneRowPerRecord) {
  const auto rows = rows_of(records_csv(small_run()));
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(rows[0], (std::vector<std::string>{"measurement", "value", "unit", "n", "seed"}));
  EXPECT_EQ(rows[1], (std::vector<std::string>{"p/e/edges", "2243", "edges", "3", "7"}));
  EXPECT_EQ(rows[3], (std::vector<std::string>{"p/e/stop", "no, \"never\"", "1", "1", ""}));
}

TEST(RecordsCsv, LosesNoDigit) {
  const auto rows = rows_of(records_csv(small_run()));
  ASSERT_EQ(rows.size(), 4u);
  ASSERT_EQ(rows[2].size(), 5u);
  EXPECT_EQ(std::strtod(rows[2][1].c_str(), nullptr), 1.0 / 3.0);
}

TEST(RecordsCsv, OfAnEmptyRunIsTheHeading) {
  EXPECT_EQ(rows_of(records_csv(RunContents{})).size(), 1u);
}

/// A paper with one exact and one timed judgement; they point into the claims beside them.
JudgedRun small_judged_run() {
  JudgedRun judged;
  judged.papers.resize(1);
  JudgedPaper& paper = judged.papers[0];
  paper.claims.claims.resize(2);
  Claim& exact = paper.claims.claims[0];
  exact.id = "p/exact";
  exact.locator = "eq. 1, sec. 2";
  exact.kind = "count";
  exact.basis = "paper";
  exact.published = "5 \"edges\"";
  Claim& timed = paper.claims.claims[1];
  timed.id = "p/timed";
  timed.kind = "ratio";
  timed.basis = "assumed";
  timed.published = "2";
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

TEST(ClaimsCsv, HoldsOneRowPerClaim) {
  const JudgedRun judged = small_judged_run();
  const auto rows = rows_of(claims_csv(judged, false));
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0],
            (std::vector<std::string>{"id", "locator", "kind", "verdict", "basis", "published",
                                      "measured", "expected_verdict", "reason"}));
  EXPECT_EQ(rows[1],
            (std::vector<std::string>{"p/exact", "eq. 1, sec. 2", "count", "reproduced", "paper",
                                      "5 \"edges\"", "5", "reproduced", "exact"}));
  EXPECT_EQ(rows[2], (std::vector<std::string>{"p/timed", "", "ratio", "inconclusive", "assumed",
                                               "2", "2.1 [1.9, 2.3]", "not reproduced", "noise"}));
}

TEST(ClaimsCsv, LeavesOutWhatRestsOnTimesOnRequest) {
  const JudgedRun judged = small_judged_run();
  const auto all = rows_of(claims_csv(judged, false));
  const auto rows = rows_of(claims_csv(judged, true));
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[1], all[1]);
  ASSERT_EQ(rows[2].size(), all[2].size());
  EXPECT_EQ(rows[2][0], "p/timed");
  EXPECT_EQ(rows[2][3], "");
  EXPECT_EQ(rows[2][6], "");
}

}  // namespace
}  // namespace phytobench
