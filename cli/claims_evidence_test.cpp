// SPDX-License-Identifier: MIT
// Experiments and claims do not know each other; here they meet.
#include <filesystem>
#include <set>

#include <gtest/gtest.h>

#include "core/contract/text_file.hpp"
#include "core/record/run_files.hpp"
#include "experiments/experiment_registry.hpp"
#include "experiments/run_experiments.hpp"
#include "reference/claims.hpp"
#include "reference/papers.hpp"
#include "reports/judge/judged_run.hpp"
#include "reports/judge/smallest_refutation.hpp"

namespace phytobench {
namespace {

namespace fs = std::filesystem;

/// Last parts of the names of times. A smoke run does not take them, only what stands beside them.
bool is_time(const std::string& measurement) {
  const std::string last = measurement.substr(measurement.rfind('/') + 1);
  return last == "seconds" || last.ends_with("_seconds");
}

/// A claim that names what no experiment measures could never be judged.
void expect_every_measurement_recorded(const RunContents& run) {
  std::set<std::string> recorded, groups;
  for (const Record& record : run.records) {
    recorded.insert(record.measurement);
    groups.insert(record.measurement.substr(0, record.measurement.rfind('/')));
  }
  const auto is_measured = [&](const ClaimCheck& check, const std::string& id) {
    const std::size_t slash = id.rfind('/');
    if (check.subject == CheckSubject::matches)  // a smoke run takes a sample, named so
      return recorded.contains(id.substr(0, id.rfind('/', slash - 1)) + "/tried");
    return recorded.contains(id) || (is_time(id) && groups.contains(id.substr(0, slash)));
  };
  for (const std::string& paper : paper_keys())
    for (const Claim& claim : load_claims(paper).claims)
      for (const ClaimCheck& check : claim.checks)
        for (const auto& term : check.terms)
          for (const std::string& part : term)
            EXPECT_TRUE(is_measured(check, measurement_of(check, part)))
                << claim.id << " names " << part;
}

/// The judge on the same values, times as samples of six rounds that took equally long.
Verdict verdict_on_samples(const Claim& claim, const Measurements& measurements) {
  RunContents run;
  for (const auto& [name, value] : measurements) {
    if (const auto* seconds = std::get_if<double>(&value); seconds && is_time(name)) {
      for (const std::int64_t round : {0, 1, 2, 3, 4, 5})
        run.timings.push_back(
            {.experiment = "", .measurement = name, .round = round, .value = *seconds});
    } else {
      run.records.push_back({.experiment = "", .measurement = name, .value = value});
    }
  }
  return judge(claim, Evidence(run), Tier::full).verdict;
}

/// Every change of a refutation: those of several measurements are of one proportion.
Measurements refuted(Measurements measurements, const Refutation& refutation) {
  measurements.at(refutation.measurements[0]) = refutation.after;
  const auto* before = std::get_if<double>(&refutation.before);
  const auto* after = std::get_if<double>(&refutation.after);
  for (std::size_t i = 1; i < refutation.measurements.size() && before && after; ++i)
    std::get<double>(measurements.at(refutation.measurements[i])) *= *after / *before;
  return measurements;
}

/// On what was measured, completed and changed where that does not reach, `claim` must hold; and
/// changing one measurement, or one of each term, must refute it.
void expect_can_hold_and_fail(const Claim& claim, const Evidence& evidence) {
  const auto held = fulfilled(claim, measurements_of(claim, evidence));
  ASSERT_TRUE(held) << "no measurements fulfil it";
  const auto refutation = smallest_refutation(claim, *held);
  ASSERT_TRUE(refutation) << "no measurement refutes it";
  if (!is_time(refutation->measurements[0])) return;
  EXPECT_NE(verdict_on_samples(claim, *held), Verdict::not_reproduced);
  EXPECT_EQ(verdict_on_samples(claim, refuted(*held, *refutation)), Verdict::not_reproduced);
}

/// Each check alone, too: one that cannot fail hides behind one that can.
void expect_every_claim_can_hold_and_fail(const RunContents& run) {
  const Evidence evidence(run);
  for (const std::string& paper : paper_keys())
    for (const Claim& claim : load_claims(paper).claims) {
      if (claim.checks.empty()) continue;
      SCOPED_TRACE(claim.id);
      expect_can_hold_and_fail(claim, evidence);
      for (std::size_t i = 0; i < claim.checks.size(); ++i) {
        SCOPED_TRACE("check " + std::to_string(i + 1));
        Claim alone = claim;
        alone.checks = {claim.checks[i]};
        expect_can_hold_and_fail(alone, evidence);
      }
    }
}

void expect_no_unexpected_verdict(const JudgedRun& judged) {
  std::size_t decided = 0;
  for (const JudgedPaper& paper : judged.papers)
    for (const Judgement& judgement : paper.judgements) {
      EXPECT_FALSE(judgement.is_unexpected())
          << judgement.claim->id << " is " << name_of(judgement.verdict) << ", expected "
          << name_of(judgement.claim->expected_verdict) << ": " << judgement.measured;
      decided += judgement.verdict == Verdict::reproduced ||
                 judgement.verdict == Verdict::reproduced_with_erratum;
    }
  EXPECT_GT(decided, 60u);
}

void expect_timing_claims_not_measured(const JudgedRun& judged) {
  for (const Judgement& judgement : judged.papers.front().judgements) {
    if (judgement.claim->tier == Tier::smoke || judgement.claim->checks.empty()) continue;
    if (judgement.verdict == Verdict::not_reproduced) continue;  // its counts alone decide
    EXPECT_EQ(judgement.verdict, Verdict::not_measured) << judgement.claim->id;
    EXPECT_NE(judgement.reason.find("needs tier "), std::string::npos) << judgement.reason;
  }
}

/// Every derived table, number for number: the readings of the sensitivity table are pinned here.
void expect_derived_tables(const JudgedRun& judged) {
  std::size_t cells = 0;
  for (const JudgedTable& table : judged.papers.front().tables) {
    if (table.table->origin != "derived") continue;
    for (std::size_t row = 0; row < table.values.size(); ++row)
      for (std::size_t column = 0; column < table.values[row].size(); ++column, ++cells)
        EXPECT_EQ(table.values[row][column].value, table.table->values[row][column])
            << table.table->measurement_at(row, column);
  }
  EXPECT_EQ(cells, 14u * 3u);
}

fs::path smoke_run(const char* name, int threads) {
  const fs::path folder = fs::path(testing::TempDir()) / name;
  fs::remove_all(folder);
  run_experiments({.experiments = selected_experiments({}),
                   .header = {Tier::smoke, 0},
                   .threads = threads,
                   .folder = folder,
                   .command_line = "test"});
  return folder;
}

// One test, because the runs behind it take seconds.
TEST(ClaimsEvidenceSlow, ASmokeRunMeasuresWhatClaimsNameAndSurprisesNobody) {
  const fs::path folder = smoke_run("phytobench_smoke_one_thread", 1);
  const fs::path again = smoke_run("phytobench_smoke_two_threads", 2);
  EXPECT_EQ(read_text_file(folder / "records.jsonl"), read_text_file(again / "records.jsonl"))
      << "the same seed must give the same bytes for any number of threads";
  const RunContents run = read_run(folder);
  fs::remove_all(folder);
  fs::remove_all(again);
  expect_every_measurement_recorded(run);
  expect_every_claim_can_hold_and_fail(run);
  const JudgedRun judged = judge_run(run);
  expect_no_unexpected_verdict(judged);
  expect_timing_claims_not_measured(judged);
  expect_derived_tables(judged);
}

}  // namespace
}  // namespace phytobench
