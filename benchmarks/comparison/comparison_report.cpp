// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/comparison_report.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace phytobench {

namespace {

void add_difference(std::vector<std::string>& sentences, const std::string& what,
                    const std::string& base, const std::string& other) {
  if (base.empty() || other.empty() || base == other) return;
  sentences.push_back(
      fmt::format("The sides differ in more than their sources: {} of base '{}', of new '{}'.",
                  what, base, other));
}

/// The highest noise floor of those on which nothing could be said; 0 if there are none.
double noise_of_inconclusive(const ComparisonReport& report) {
  double highest = 0.0;
  for (const ConcludedBenchmark& benchmark : report.concluded)
    if (benchmark.verdict == SpeedVerdict::inconclusive)
      highest = std::max(highest, benchmark.noise_floor);
  return highest;
}

}  // namespace

std::size_t count_of(const ComparisonReport& report, SpeedVerdict verdict) {
  return static_cast<std::size_t>(
      std::count_if(report.concluded.begin(), report.concluded.end(),
                    [&](const ConcludedBenchmark& b) { return b.verdict == verdict; }));
}

const std::vector<SpeedVerdict>& verdicts_by_weight() {
  static const std::vector<SpeedVerdict> verdicts = {
      SpeedVerdict::wrong_answer, SpeedVerdict::slower, SpeedVerdict::nothing_measured,
      SpeedVerdict::inconclusive, SpeedVerdict::faster, SpeedVerdict::same,
      SpeedVerdict::same_binary};
  return verdicts;
}

std::vector<const ConcludedBenchmark*> by_weight(const ComparisonReport& report) {
  std::vector<const ConcludedBenchmark*> ordered;
  for (const SpeedVerdict verdict : verdicts_by_weight())
    for (const ConcludedBenchmark& benchmark : report.concluded)
      if (benchmark.verdict == verdict) ordered.push_back(&benchmark);
  return ordered;
}

std::string counts_in_words(const ComparisonReport& report) {
  std::vector<std::string> parts;
  for (const SpeedVerdict verdict : verdicts_by_weight()) {
    const std::size_t count = count_of(report, verdict);
    if (count > 0 || verdict == SpeedVerdict::slower)
      parts.push_back(fmt::format("{} {}", count, name_of(verdict)));
  }
  const std::size_t all = report.concluded.size();
  return fmt::format("{} of {} benchmark{}", fmt::join(parts, ", "), all, all == 1 ? "" : "s");
}

std::string summary_in_words(const ComparisonReport& report) {
  if (report.failed_trials.empty()) return counts_in_words(report);
  std::vector<std::string> sides;
  for (const FailedTrial& failed : report.failed_trials) sides.push_back(failed.side);
  return fmt::format("{} failed {} trial, so nothing was timed", fmt::join(sides, " and "),
                     sides.size() == 1 ? "its" : "their");
}

std::string in_words(const FailedTrial& failed) {
  return fmt::format("{}, {}: {} in its trial: {}", failed.side, failed.given, failed.verdict,
                     failed.detail);
}

std::string side_in_words(std::string_view role, const SideOrigin& side) {
  const std::string changed = side.changed ? " with changes" : "";
  if (side.commit.empty() || side.commit == side.given)
    return fmt::format("{}: {} ({}{})", role, side.given, side.kind, changed);
  return fmt::format("{}: {} ({}, commit {}{})", role, side.given, side.kind, side.commit, changed);
}

std::vector<std::string> differences_of_sides(const Measured& measured) {
  std::vector<std::string> sentences;
  add_difference(sentences, "compiler", measured.base.compiler, measured.other.compiler);
  add_difference(sentences, "flags", measured.base.flags, measured.other.flags);
  return sentences;
}

std::vector<std::string> advice(const ComparisonReport& report) {
  std::vector<std::string> sentences;
  if (report.timing.measured.is_same_program)
    sentences.push_back("Both programs are the same, so nothing was timed; --time-anyway does.");
  if (report.timing.was_interrupted)
    sentences.push_back("It was interrupted, so no verdict on speed stands: run it again.");
  else if (count_of(report, SpeedVerdict::inconclusive) > 0)
    sentences.push_back(
        fmt::format("Inconclusive is no pass. Equal things differed by up to {:.1f} % here: give "
                    "more time (--budget), let the machine rest, or accept more (--tolerance).",
                    100.0 * noise_of_inconclusive(report)));
  if (count_of(report, SpeedVerdict::nothing_measured) > 0)
    sentences.push_back("What was not measured is no pass, either; its line says why.");
  if (report.timing.busy_blocks > 0)
    sentences.push_back(
        fmt::format("The machine was busy with something else: {} blocks were kept in spite of it.",
                    report.timing.busy_blocks));
  const int dead = report.timing.dead_blocks;
  if (dead > 0)
    sentences.push_back(
        fmt::format("Workers died in {} block{}, which {} thrown away and measured again.", dead,
                    dead == 1 ? "" : "s", dead == 1 ? "was" : "were"));
  return sentences;
}

void withdraw_verdicts(std::vector<ConcludedBenchmark>& concluded) {
  for (ConcludedBenchmark& benchmark : concluded) {
    const bool is_on_speed =
        benchmark.verdict == SpeedVerdict::slower || benchmark.verdict == SpeedVerdict::faster ||
        benchmark.verdict == SpeedVerdict::same ||
        benchmark.verdict == SpeedVerdict::inconclusive ||
        (benchmark.verdict == SpeedVerdict::nothing_measured && benchmark.control.has_value());
    if (!is_on_speed) continue;
    benchmark.verdict = SpeedVerdict::inconclusive;
    benchmark.reason = fmt::format("interrupted after {} blocks", benchmark.blocks);
  }
}

}  // namespace phytobench
