// SPDX-License-Identifier: MIT
#include "cli/compare_output.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "benchmarks/comparison/comparison_json.hpp"
#include "benchmarks/comparison/comparison_junit.hpp"
#include "benchmarks/comparison/comparison_markdown.hpp"
#include "benchmarks/comparison/effects_table.hpp"
#include "benchmarks/comparison/plain_text.hpp"
#include "cli/terminal.hpp"
#include "core/contract/text_file.hpp"

namespace phytobench::cli {

namespace {

std::string line_of(const std::string& text) {
  return one_line(text, 1000) + "\n";
}

int exit_code_of(const ComparisonReport& report, bool is_strict) {
  if (!report.failed_trials.empty()) return 1;
  const auto count = [&](SpeedVerdict verdict) { return count_of(report, verdict); };
  if (count(SpeedVerdict::slower) + count(SpeedVerdict::wrong_answer) > 0) return 1;
  // What base has and was not measured is no pass.
  const bool is_lost = std::any_of(
      report.concluded.begin(), report.concluded.end(), [](const ConcludedBenchmark& benchmark) {
        return benchmark.verdict == SpeedVerdict::nothing_measured && !is_base_to_blame(benchmark);
      });
  if (is_lost || count(SpeedVerdict::nothing_measured) == report.concluded.size()) return 4;
  return is_strict && count(SpeedVerdict::inconclusive) > 0 ? 5 : 0;
}

}  // namespace

std::string comparison_text(const ComparisonReport& report) {
  const Measured& measured = report.timing.measured;
  std::string text =
      line_of(side_in_words("base", measured.base)) + line_of(side_in_words("new", measured.other));
  for (const std::string& sentence : differences_of_sides(measured)) text += line_of(sentence);
  for (const std::string& note : report.notes) text += line_of(note);
  if (!report.failed_trials.empty()) {
    text += "\n" + summary_in_words(report) + "\n";
    for (const FailedTrial& failed : report.failed_trials) text += line_of(in_words(failed));
    return text;
  }
  const EffectsTable table = effects_table(report);
  text += "\n" + table.heading;
  for (const std::string& row : table.rows) text += row;
  text += "\n" + counts_in_words(report) + "\n";
  for (const ConcludedBenchmark* benchmark : by_weight(report))
    if (benchmark->verdict != SpeedVerdict::same && benchmark->verdict != SpeedVerdict::same_binary)
      text += line_of(fmt::format("{}: {}: {}", benchmark->name, name_of(benchmark->verdict),
                                  benchmark->reason));
  for (const std::string& sentence : advice(report)) text += line_of(sentence);
  return text;
}

int show_comparison(const ComparisonReport& report, const CompareOptions& options) {
  std::vector<FileContent> files;
  if (!options.out.empty()) files.push_back({options.out, comparison_json(report)});
  if (!options.markdown.empty()) files.push_back({options.markdown, comparison_markdown(report)});
  if (!options.junit.empty()) files.push_back({options.junit, comparison_junit(report)});
  if (!files.empty()) write_files_atomically(files);
  print(options.json ? comparison_json(report) : comparison_text(report));
  return exit_code_of(report, options.strict);
}

}  // namespace phytobench::cli
