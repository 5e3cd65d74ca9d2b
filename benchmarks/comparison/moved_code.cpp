// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/moved_code.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace phytobench {

namespace {

/// What the gate on instructions takes for no change: a heap that lies elsewhere changes the C
/// library's work by up to this.
constexpr double same_work = InstructionRules{}.noted;

bool is_change_of_speed(SpeedVerdict verdict) {
  return verdict == SpeedVerdict::slower || verdict == SpeedVerdict::faster;
}

bool is_counted(const CountedPair& pair) {
  return pair.base.outcome == CountOutcome::counted &&
         pair.other.outcome == CountOutcome::counted && pair.base.totals.instructions > 0;
}

}  // namespace

std::vector<std::string> names_to_count(const std::vector<ConcludedBenchmark>& concluded) {
  std::vector<std::string> names;
  for (const ConcludedBenchmark& benchmark : concluded)
    if (is_change_of_speed(benchmark.verdict)) names.push_back(benchmark.name);
  return names;
}

void consider_instructions(std::vector<ConcludedBenchmark>& concluded,
                           const std::vector<CountedPair>& counted) {
  for (ConcludedBenchmark& benchmark : concluded) {
    if (!is_change_of_speed(benchmark.verdict)) continue;
    const auto pair = std::find_if(counted.begin(), counted.end(), [&](const CountedPair& one) {
      return one.benchmark == benchmark.name;
    });
    if (pair == counted.end() || !is_counted(*pair)) continue;
    const double change = static_cast<double>(pair->other.totals.instructions) /
                              static_cast<double>(pair->base.totals.instructions) -
                          1.0;
    if (std::abs(change) > same_work) {
      benchmark.reason += fmt::format("; instructions {:+.2f} %", 100.0 * change);
      continue;
    }
    benchmark.reason = fmt::format(
        "{}: {}; but both sides execute nearly the same instructions ({:+.3f} %), so code or data "
        "probably lie "
        "elsewhere in memory",
        name_of(benchmark.verdict), benchmark.reason, 100.0 * change);
    benchmark.verdict = SpeedVerdict::inconclusive;
  }
}

}  // namespace phytobench
