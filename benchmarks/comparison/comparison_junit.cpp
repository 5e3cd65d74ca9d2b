// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/comparison_junit.hpp"

#include <vector>

#include <fmt/format.h>

#include "benchmarks/comparison/gate_junit.hpp"

namespace phytobench {

namespace {

GateOutcome outcome_of(const ConcludedBenchmark& benchmark) {
  if (is_base_to_blame(benchmark)) return GateOutcome::skipped;
  switch (benchmark.verdict) {
    case SpeedVerdict::slower:
    case SpeedVerdict::wrong_answer:
    case SpeedVerdict::nothing_measured:
      return GateOutcome::failed;
    case SpeedVerdict::inconclusive:
      return GateOutcome::skipped;
    case SpeedVerdict::faster:
    case SpeedVerdict::same:
    case SpeedVerdict::same_binary:
      return GateOutcome::passed;
  }
  return GateOutcome::failed;
}

}  // namespace

std::string comparison_junit(const ComparisonReport& report) {
  std::vector<GateCase> cases;
  for (const FailedTrial& failed : report.failed_trials)
    cases.push_back({.name = "plugin trial of " + failed.side,
                     .outcome = GateOutcome::failed,
                     .message = in_words(failed)});
  for (const ConcludedBenchmark& benchmark : report.concluded)
    cases.push_back(
        {.name = benchmark.name,
         .outcome = outcome_of(benchmark),
         .message = fmt::format("{}: {}", name_of(benchmark.verdict), benchmark.reason)});
  return gate_junit("compare", cases);
}

}  // namespace phytobench
