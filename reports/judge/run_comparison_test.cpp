// SPDX-License-Identifier: MIT
#include "reports/judge/run_comparison.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace phytobench {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr auto holds = Verdict::reproduced, fails = Verdict::not_reproduced,
               noise = Verdict::inconclusive, absent = Verdict::not_measured,
               amended = Verdict::reproduced_with_erratum, vague = Verdict::underspecified;

Verdict merged(const std::vector<Verdict>& verdicts) {
  return merged_verdict(verdicts).verdict;
}

TEST(MergedVerdict, IsTheOneThatAllDecidingRunsShare) {
  EXPECT_EQ(merged({holds, holds}), holds);
  EXPECT_EQ(merged({holds, absent}), holds);
  EXPECT_EQ(merged({absent, fails, noise}), fails);
  EXPECT_EQ(merged({noise, amended}), amended);
}

TEST(MergedVerdict, IsInconclusiveWhereRunsDecideDifferently) {
  for (const auto& verdicts : std::vector<std::vector<Verdict>>{
           {holds, fails}, {holds, amended}, {absent, holds, holds, fails}}) {
    EXPECT_EQ(merged(verdicts), noise);
    EXPECT_TRUE(merged_verdict(verdicts).contradicted);
  }
  EXPECT_FALSE(merged_verdict(std::vector{noise, noise}).contradicted);
}

TEST(MergedVerdict, SaysAsMuchAsAnyRunWhereNoneDecides) {
  EXPECT_EQ(merged({absent, noise}), noise);
  EXPECT_EQ(merged({absent, vague}), vague);
  EXPECT_EQ(merged({absent, absent}), absent);
}

TEST(MergedVerdict, NamesTheFirstRunThatSaysSo) {
  EXPECT_EQ(merged_verdict(std::vector{absent, noise, holds, holds}).run, 2u);
  EXPECT_EQ(merged_verdict(std::vector{absent, noise, noise}).run, 1u);
}

TEST(MergedVerdictLaw, DoesNotDependOnTheOrderOfRuns) {
  for (const Verdict a : all_verdicts)
    for (const Verdict b : all_verdicts) {
      const bool both_fixed = !is_decided(a) && !is_decided(b) && a != noise && b != noise &&
                              a != absent && b != absent;  // one claim has one fixed verdict
      if (!both_fixed) EXPECT_EQ(merged({a, b}), merged({b, a}));
      EXPECT_EQ(merged({a, a}), a);
    }
}

Record record(const std::string& name, RecordValue value) {
  return {.experiment = "p/e", .measurement = "p/e/" + name, .value = std::move(value)};
}

TEST(RecordComparison, CountsWhatIsEqualDifferentAndAlone) {
  RunContents first, second, third;
  first.records = {record("equal", 1.0 / 3.0), record("differs", 2.0), record("alone", 1.0),
                   record("in-two", std::string("yes"))};
  second.records = {record("equal", 1.0 / 3.0), record("differs", 2.0), record("in-two", "yes")};
  third.records = {record("equal", 1.0 / 3.0), record("differs", 2.5)};
  const RecordComparison comparison =
      compare_records(std::vector<const RunContents*>{&first, &second, &third});
  EXPECT_EQ(comparison.in_all, 2u);
  EXPECT_EQ(comparison.shared, 3u);
  EXPECT_EQ(comparison.equal, 2u);
  EXPECT_THAT(comparison.only_in, ElementsAre(1, 0, 0));
  ASSERT_EQ(comparison.differing.size(), 1u);
  const DifferingRecord& differing = comparison.differing[0];
  EXPECT_EQ(differing.measurement, "p/e/differs");
  EXPECT_THAT(differing.values, ElementsAre("2", "2", "2.5"));
  EXPECT_DOUBLE_EQ(differing.relative.value(), 0.2);
}

/// How two values of one measurement compare.
RecordComparison of_two(const Record& a, const Record& b) {
  RunContents first, second;
  first.records = {a};
  second.records = {b};
  return compare_records(std::vector<const RunContents*>{&first, &second});
}

TEST(RecordComparison, SeesTheLastBit) {
  const double next = std::nextafter(0.1, 1.0);
  const RecordComparison comparison = of_two(record("x", 0.1), record("x", next));
  ASSERT_EQ(comparison.differing.size(), 1u);
  EXPECT_THAT(comparison.differing[0].values, ElementsAre("0.1", "0.10000000000000002"));
  EXPECT_EQ(of_two(record("x", 0.0), record("x", -0.0)).differing.size(), 1u);
}

TEST(RecordComparison, SeesUnitSampleAndSpreadButNotTheSeed) {
  Record plain = record("x", 0.5), other = plain;
  other.seed = 7;
  EXPECT_EQ(of_two(plain, other).equal, 1u);
  other.sample_size = 2;
  EXPECT_THAT(of_two(plain, other).differing.at(0).values, ElementsAre("0.5 (n 1)", "0.5 (n 2)"));
  other = plain;
  other.spread = 0.25;
  EXPECT_THAT(of_two(plain, other).differing.at(0).values,
              ElementsAre("0.5 (n 1)", "0.5 (n 1, spread 0.25)"));
  other = plain;
  other.unit = "m";
  EXPECT_THAT(of_two(plain, other).differing.at(0).values, ElementsAre("0.5", "0.5 m"));
}

TEST(RecordComparison, ComparesTextsWithoutADistance) {
  const RecordComparison comparison =
      of_two(record("x", std::string("a")), record("x", std::int64_t{1}));
  ASSERT_EQ(comparison.differing.size(), 1u);
  EXPECT_EQ(comparison.differing[0].relative, std::nullopt);
}

Record record_of(const std::string& experiment, const std::string& name, RecordValue value) {
  return {.experiment = experiment, .measurement = experiment + "/" + name, .value = value};
}

TEST(RecordComparison, OrdersDifferencesBySizeWithinExperimentsByTheirLargest) {
  RunContents first, second;
  first.records = {record_of("p/a", "tiny", 1.0),  record_of("p/a", "small", 1.0),
                   record_of("p/b", "equal", 1.0), record_of("p/b", "text", std::string("x")),
                   record_of("p/b", "large", 1.0), record_of("p/c", "text", std::string("x"))};
  second.records = {record_of("p/a", "tiny", 1.01), record_of("p/a", "small", 1.1),
                    record_of("p/b", "equal", 1.0), record_of("p/b", "text", std::string("y")),
                    record_of("p/b", "large", 2.0), record_of("p/c", "text", std::string("y"))};
  const RecordComparison comparison =
      compare_records(std::vector<const RunContents*>{&first, &second});
  std::vector<std::string> names;
  for (const DifferingRecord& record : comparison.differing) names.push_back(record.measurement);
  EXPECT_THAT(names, ElementsAre("p/b/large", "p/b/text", "p/a/small", "p/a/tiny", "p/c/text"));
  EXPECT_EQ(comparison.differing[0].experiment, "p/b");
  EXPECT_EQ(comparison.shared_of.at("p/b"), 3u);
}

TEST(RunLetter, GoesOnBehindZ) {
  EXPECT_EQ(run_letter(0), "A");
  EXPECT_EQ(run_letter(25), "Z");
  EXPECT_EQ(run_letter(26), "AA");
  EXPECT_EQ(run_letter(26 * 27), "AAA");
}

/// A run of one paper with two claims, judged as given.
LabelledRun run_of(const std::string& label, Verdict first, Verdict second) {
  LabelledRun run{label, {}};
  run.judged.papers.resize(1);
  JudgedPaper& paper = run.judged.papers[0];
  paper.claims.claims.resize(2);
  paper.claims.claims[0].id = "p/first";
  paper.claims.claims[0].reason = "Bounds are exact.";
  paper.claims.claims[1].id = "p/second";
  paper.claims.tables.resize(1);
  paper.claims.tables[0].id = "t";
  for (std::size_t i = 0; i < 2; ++i)
    paper.judgements.push_back({.claim = &paper.claims.claims[i],
                                .verdict = i == 0 ? first : second,
                                .measured = label + " value",
                                .reason = "own",
                                .checks = {{.terms = {{.expression = "x"}}}},
                                .varies = i == 1});
  paper.tables = {{.table = &paper.claims.tables[0], .measured = first == holds}};
  run.judged.run.complete_experiments = {"p/" + label};
  run.judged.run.records = {{.experiment = "p/" + label, .measurement = label, .value = 1.0}};
  return run;
}

MergedRuns merged_runs(LabelledRun a, LabelledRun b) {
  std::vector<LabelledRun> runs;
  runs.push_back(std::move(a));
  runs.push_back(std::move(b));
  return merge_runs(std::move(runs));
}

TEST(MergeRuns, TakesVerdictAndEvidenceFromTheRunThatDecides) {
  const MergedRuns merged = merged_runs(run_of("A", absent, noise), run_of("B", holds, fails));
  const auto& judgements = merged.judged.papers[0].judgements;
  EXPECT_EQ(judgements[0].verdict, holds);
  EXPECT_EQ(judgements[0].measured, "B value");
  EXPECT_EQ(judgements[1].verdict, fails);
  EXPECT_EQ(merged.comparison.claims[0].contradicted, false);
  EXPECT_THAT(merged.comparison.claims[0].verdicts, ElementsAre(absent, holds));
  EXPECT_TRUE(merged.comparison.claims[1].varies);
  EXPECT_TRUE(merged.judged.papers[0].tables[0].measured) << "of the run that has it";
}

TEST(MergeRuns, CallsAContradictionInconclusiveAndNamesTheRuns) {
  const MergedRuns merged = merged_runs(run_of("GCC", holds, holds), run_of("Clang", fails, holds));
  const Judgement& judgement = merged.judged.papers[0].judgements[0];
  EXPECT_EQ(judgement.verdict, noise);
  EXPECT_TRUE(judgement.contradicted);
  EXPECT_EQ(judgement.reason,
            "The runs disagree: A: reproduced; B: not reproduced. Bounds are exact.");
  EXPECT_EQ(judgement.measured, "A: GCC value; B: Clang value");
  ASSERT_EQ(judgement.checks.size(), 2u) << "the evidence of both";
  EXPECT_EQ(judgement.checks[1].terms[0].expression, "x (B)");
  EXPECT_FALSE(judgement.is_unexpected()) << "as noise contradicts nothing";
  EXPECT_EQ(merged.judged.papers[0].judgements[1].verdict, holds);
  EXPECT_FALSE(merged.judged.papers[0].judgements[1].contradicted);
}

TEST(MergeRuns, CallsVerdictsOfAContradictionAsReadersSeeThem) {
  const MergedRuns merged = merged_runs(run_of("A", amended, holds), run_of("B", fails, holds));
  EXPECT_EQ(merged.judged.papers[0].judgements[0].reason,
            "The runs disagree: A: wrong as printed, holds corrected; B: not reproduced. "
            "Bounds are exact.");
}

TEST(MergeRuns, PointsToItsOwnClaimsAndTables) {
  const MergedRuns merged = merged_runs(run_of("A", absent, holds), run_of("B", holds, holds));
  const JudgedPaper& paper = merged.judged.papers[0];
  for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(paper.judgements[i].claim, &paper.claims.claims[i]);
  EXPECT_EQ(paper.tables[0].table, &paper.claims.tables[0]);
}

TEST(MergeRuns, HoldsEachExperimentOnceFromTheFirstRunThatCompletedIt) {
  LabelledRun a = run_of("A", holds, holds), b = run_of("B", holds, holds);
  b.judged.run.complete_experiments.insert("p/A");
  b.judged.run.records.push_back({.experiment = "p/A", .measurement = "A", .value = 2.0});
  b.judged.run.timings = {{.experiment = "p/A", .measurement = "s", .value = 9.0},
                          {.experiment = "p/B", .measurement = "s2", .value = 8.0}};
  const MergedRuns merged = merged_runs(std::move(a), std::move(b));
  EXPECT_THAT(merged.judged.run.complete_experiments, ElementsAre("p/A", "p/B"));
  ASSERT_EQ(merged.judged.run.records.size(), 2u);
  EXPECT_EQ(std::get<double>(merged.judged.run.records[0].value), 1.0);
  ASSERT_EQ(merged.judged.run.timings.size(), 1u) << "times of two runs never mix";
  EXPECT_EQ(merged.judged.run.timings[0].value, 8.0);
  EXPECT_EQ(merged.comparison.runs[1].contents.records.size(), 2u) << "each run stays whole";
  EXPECT_EQ(merged.comparison.records.differing.size(), 1u);
}

}  // namespace
}  // namespace phytobench
