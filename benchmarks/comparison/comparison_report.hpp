// SPDX-License-Identifier: MIT
// What all documents on a comparison say alike.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "benchmarks/comparison/comparison.hpp"
#include "benchmarks/comparison/paired_timing.hpp"
#include "benchmarks/comparison/stored_result.hpp"

namespace phytobench {

/// A plugin that was tried before anything was timed, and is not fit to be.
struct FailedTrial {
  std::string side;     ///< "base" or "new"
  std::string given;    ///< as the user named it
  std::string verdict;  ///< "wrong", "crashed", "hangs", "leaks"
  std::string detail;   ///< one line: at which step, and what
};

/// A comparison with everything that belongs into its documents.
struct ComparisonReport {
  PairTiming timing;  ///< without samples and times of blocks where both sides were stored
  std::vector<ConcludedBenchmark> concluded;  ///< of timing.measured, in its order
  VerdictSettings verdict_settings;
  TimingSettings timing_settings;
  std::string environment_json;         ///< see core/record/environment.hpp; empty: unknown
  std::vector<std::string> notes = {};  ///< one sentence each, on what was read rather than timed
  /// If there are any, nothing is timed, and nothing concluded.
  std::vector<FailedTrial> failed_trials = {};
  /// All times of a side that was timed alone, because the other one was stored.
  std::optional<StoredResult> base_result = std::nullopt;
  std::optional<StoredResult> other_result = std::nullopt;
};

std::size_t count_of(const ComparisonReport& report, SpeedVerdict verdict);

/// Verdicts from the one that matters most: wrong answer, slower, nothing measured, inconclusive,
/// faster, same, same binary.
const std::vector<SpeedVerdict>& verdicts_by_weight();

/// Concluded benchmarks in that order, those of a verdict in their own.
std::vector<const ConcludedBenchmark*> by_weight(const ComparisonReport& report);

/// "1 slower, 20 same, 3 inconclusive of 24 benchmarks"; "slower" is there even if none is.
std::string counts_in_words(const ComparisonReport& report);

/// The same, or "new failed its trial, so nothing was timed".
std::string summary_in_words(const ComparisonReport& report);

/// "new, late.so: crashed in its trial: SIGSEGV in create()".
std::string in_words(const FailedTrial& failed);

/// "base: 1a2b3c4 (revision HEAD~1)".
std::string side_in_words(std::string_view role, const SideOrigin& side);

/// Where the sides differ in more than their sources, a sentence each: compiler and flags as far as
/// both are known.
std::vector<std::string> differences_of_sides(const Measured& measured);

/// What a reader may do about verdicts that say little, a sentence each.
std::vector<std::string> advice(const ComparisonReport& report);

/// After an interruption no verdict on speed stands: the number of blocks was chosen by someone who
/// may have watched.
void withdraw_verdicts(std::vector<ConcludedBenchmark>& concluded);

}  // namespace phytobench
