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
#include "reports/judge/judged_run.hpp"

namespace phytobench {
namespace {

namespace fs = std::filesystem;

void expect_every_measurement_recorded(const RunContents& run) {
  std::set<std::string> recorded;
  std::set<std::string> cells;  // of Table 1, whose times a smoke run does not take
  for (const Record& record : run.records) {
    recorded.insert(record.measurement);
    cells.insert(record.measurement.substr(0, record.measurement.rfind('/')));
  }
  const std::set<std::string> times = {"seconds", "association_seconds", "kill_seconds",
                                       "growth_seconds"};
  for (const Claim& claim : load_claims("brzoska2019").claims)
    for (const ClaimCheck& check : claim.checks)
      for (const auto& term : check.terms)
        for (const std::string& part : term) {
          const std::string id = check.subject == CheckSubject::sum ? part.substr(1) : part;
          const std::size_t slash = id.rfind('/');
          if (check.subject == CheckSubject::matches) {  // a smoke run takes a sample, named so
            EXPECT_TRUE(recorded.contains(id.substr(0, id.rfind('/', slash - 1)) + "/tried"))
                << claim.id << " names " << id;
            continue;
          }
          const bool is_time =
              times.contains(id.substr(slash + 1)) && cells.contains(id.substr(0, slash));
          EXPECT_TRUE(is_time || recorded.contains(id)) << claim.id << " names " << id;
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
  const JudgedRun judged = judge_run(run);
  expect_no_unexpected_verdict(judged);
  expect_timing_claims_not_measured(judged);
  expect_derived_tables(judged);
}

}  // namespace
}  // namespace phytobench
