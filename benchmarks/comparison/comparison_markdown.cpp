// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/comparison_markdown.hpp"

#include <vector>

#include <fmt/format.h>

#include "benchmarks/comparison/effects_table.hpp"
#include "benchmarks/comparison/plain_text.hpp"
#include "benchmarks/comparison/verdict_reason.hpp"
#include "core/contract/check.hpp"

namespace phytobench {

namespace {

/// Bytes of the parts with a line for each benchmark, and of each list of sentences. The rest
/// suffices for what names both sides and for headings.
constexpr std::size_t most_changes_bytes = 14 * 1024;
constexpr std::size_t most_table_bytes = 20 * 1024;
constexpr std::size_t most_details_bytes = 14 * 1024;
constexpr std::size_t most_bullets_bytes = 5 * 512;

/// Rows as far as they fit, and how many do not.
std::string fitting(const std::vector<std::string>& rows, std::size_t most_bytes) {
  std::string text;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (text.size() + rows[i].size() > most_bytes)
      return text + fmt::format("{} more in the JSON document\n", rows.size() - i);
    text += rows[i];
  }
  return text;
}

bool is_worth_a_line(SpeedVerdict verdict) {
  return verdict == SpeedVerdict::wrong_answer || verdict == SpeedVerdict::slower ||
         verdict == SpeedVerdict::nothing_measured || verdict == SpeedVerdict::faster;
}

std::string change(const ConcludedBenchmark& benchmark) {
  return fmt::format("- **{}** {}: {}\n", name_of(benchmark.verdict), markdown_text(benchmark.name),
                     markdown_text(benchmark.reason));
}

std::string changes(const ComparisonReport& report) {
  std::vector<std::string> rows;
  for (const ConcludedBenchmark* benchmark : by_weight(report))
    if (is_worth_a_line(benchmark->verdict)) rows.push_back(change(*benchmark));
  if (rows.empty()) return "";
  return "### What changed\n\n" + fitting(rows, most_changes_bytes) + "\n";
}

std::string effects(const ComparisonReport& report) {
  const EffectsTable table = effects_table(report);
  if (table.rows.empty()) return "";
  return "### Time of new over base\n\n```text\n" + table.heading +
         fitting(table.rows, most_table_bytes) + "```\n\n";
}

std::string detail(const ConcludedBenchmark& benchmark) {
  const std::string control =
      benchmark.control ? "; base against itself " + change_text(*benchmark.control) : "";
  return fmt::format("- {}: {}, {}{}; p = {:.2g}, {} blocks\n", markdown_text(benchmark.name),
                     name_of(benchmark.verdict), markdown_text(benchmark.reason), control,
                     benchmark.p, benchmark.blocks);
}

std::string details(const ComparisonReport& report) {
  std::vector<std::string> rows;
  for (const ConcludedBenchmark* benchmark : by_weight(report)) rows.push_back(detail(*benchmark));
  if (rows.empty()) return "";
  return "<details><summary>Details</summary>\n\n" + fitting(rows, most_details_bytes) +
         "\n</details>\n\n";
}

std::string bullets(const std::vector<std::string>& sentences) {
  std::vector<std::string> rows;
  for (const std::string& sentence : sentences)
    rows.push_back("- " + markdown_text(sentence, 600) + "\n");
  return fitting(rows, most_bullets_bytes);
}

std::string compared(const ComparisonReport& report) {
  const Measured& measured = report.timing.measured;
  return fmt::format("- {}\n- {}\n{}{}\n", markdown_text(side_in_words("base", measured.base)),
                     markdown_text(side_in_words("new", measured.other)),
                     bullets(differences_of_sides(measured)), bullets(report.notes));
}

std::string failed_trials(const ComparisonReport& report) {
  std::vector<std::string> sentences;
  for (const FailedTrial& failed : report.failed_trials) sentences.push_back(in_words(failed));
  return sentences.empty() ? "" : "### Failed trials\n\n" + bullets(sentences) + "\n";
}

std::string facts(const ComparisonReport& report) {
  const PairTiming& timing = report.timing;
  if (!(timing.seconds > 0.0)) return bullets(advice(report));
  return bullets(advice(report)) +
         fmt::format(
             "- Timed for {:.0f} s; blocks thrown away because the machine was busy: {}, "
             "kept although it was: {}. Tolerance {:.1f} %, seed {}.\n",
             timing.seconds, timing.redone_blocks, timing.busy_blocks,
             100.0 * report.verdict_settings.tolerance, timing.measured.seed);
}

}  // namespace

std::string comparison_markdown(const ComparisonReport& report) {
  const std::string text =
      fmt::format("**phytobench compare: {}**\n\n{}", summary_in_words(report), compared(report)) +
      failed_trials(report) + changes(report) + effects(report) + details(report) + facts(report);
  PHYTOBENCH_ENSURE(text.size() <= most_markdown_bytes);
  return text;
}

}  // namespace phytobench
