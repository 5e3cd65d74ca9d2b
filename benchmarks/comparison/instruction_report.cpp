// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/instruction_report.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "benchmarks/comparison/comparison_report.hpp"
#include "benchmarks/comparison/counter_gate.hpp"
#include "benchmarks/comparison/gate_junit.hpp"
#include "benchmarks/comparison/plain_text.hpp"
#include "benchmarks/comparison/result_document.hpp"

namespace phytobench {

namespace {

using nlohmann::ordered_json;
using Verdict = InstructionVerdict;

/// The enumeration begins with what matters most.
std::vector<const JudgedInstructions*> by_weight(const InstructionReport& report) {
  std::vector<const JudgedInstructions*> ordered;
  for (const JudgedInstructions& one : report.judged) ordered.push_back(&one);
  std::stable_sort(ordered.begin(), ordered.end(),
                   [](const auto* a, const auto* b) { return a->verdict < b->verdict; });
  return ordered;
}

std::string change_text(const JudgedInstructions& one) {
  return one.change ? fmt::format("{:+.2f} %", 100.0 * *one.change) : "";
}

std::string count_text(const InstructionCount& count) {
  return count.outcome == CountOutcome::counted ? with_thousands(count.totals.instructions) : "";
}

std::string row_of(const JudgedInstructions& one) {
  return fmt::format("{:<14}{:>10}{:>18}{:>18}  {}{}\n", name_of(one.verdict), change_text(one),
                     count_text(one.pair.base), count_text(one.pair.other), one_line(one.benchmark),
                     one.reason.empty() ? "" : ": " + one_line(one.reason));
}

std::string heading() {
  return fmt::format("{:<14}{:>10}{:>18}{:>18}  {}\n", "verdict", "change", "base", "new",
                     "benchmark");
}

std::string misses_text(const InstructionCount& count) {
  if (!count.totals.misses) return fmt::format("{:>14}{:>14}", "-", "-");
  return fmt::format("{:>14}{:>14}", with_thousands(count.totals.misses->first_level_data),
                     with_thousands(count.totals.misses->last_level));
}

/// Empty where no cache was simulated.
std::string misses_table(const InstructionReport& report) {
  std::string rows;
  for (const JudgedInstructions& one : report.judged)
    if (one.pair.base.totals.misses || one.pair.other.totals.misses)
      rows += fmt::format("{}{}  {}\n", misses_text(one.pair.base), misses_text(one.pair.other),
                          one_line(one.benchmark));
  if (rows.empty()) return "";
  return fmt::format(
             "\nMisses of a simulated cache of 32 KiB for data at the first level, and of 8 MiB at "
             "the last\n{:>14}{:>14}{:>14}{:>14}  benchmark\n",
             "base: first", "last", "new: first", "last") +
         rows;
}

GateOutcome outcome_of(Verdict verdict) {
  if (is_failure(verdict)) return GateOutcome::failed;
  switch (verdict) {
    case Verdict::unsupported:
    case Verdict::other_work:
    case Verdict::appeared:
    case Verdict::gone:
      return GateOutcome::skipped;
    default:
      return GateOutcome::passed;
  }
}

std::string message_of(const JudgedInstructions& one) {
  std::string message(name_of(one.verdict));
  if (one.change)
    message += fmt::format(", {} -> {} ({})", count_text(one.pair.base), count_text(one.pair.other),
                           change_text(one));
  return one.reason.empty() ? message : message + ": " + one.reason;
}

ordered_json count_json(const InstructionCount& count) {
  if (count.outcome != CountOutcome::counted) return nullptr;
  ordered_json json{{"instructions", count.totals.instructions}, {"inputs", count.inputs}};
  if (count.totals.misses) {
    json["first_level_data_misses"] = count.totals.misses->first_level_data;
    json["last_level_misses"] = count.totals.misses->last_level;
  }
  return json;
}

ordered_json judged_json(const JudgedInstructions& one) {
  ordered_json json{{"name", one.benchmark}, {"verdict", name_of(one.verdict)}};
  json["change"] = one.change ? ordered_json(*one.change) : ordered_json(nullptr);
  json["limit"] = one.limit;
  if (!one.reason.empty()) json["reason"] = one_line(one.reason, 2000);
  json["base"] = count_json(one.pair.base);
  json["new"] = count_json(one.pair.other);
  return json;
}

}  // namespace

std::string counts_in_words(const InstructionReport& report) {
  std::map<Verdict, std::size_t> counts = {{Verdict::more, 0}};
  for (const JudgedInstructions& one : report.judged) ++counts[one.verdict];
  std::string words;
  for (const auto& [verdict, count] : counts)
    words += fmt::format("{}{} {}", words.empty() ? "" : ", ", count, name_of(verdict));
  const std::size_t all = report.judged.size();
  return fmt::format("{} of {} benchmark{}", words, all, all == 1 ? "" : "s");
}

std::string instruction_table(const InstructionReport& report) {
  std::string text = fmt::format("{}\n{}\n\n{}", side_in_words("base", report.base),
                                 side_in_words("new", report.other), heading());
  for (const JudgedInstructions* one : by_weight(report)) text += row_of(*one);
  return text + misses_table(report) + "\n" + counts_in_words(report) + "\n";
}

std::string instruction_markdown(const InstructionReport& report) {
  constexpr std::size_t most_table_bytes = 50'000;
  std::string table = heading();
  const auto ordered = by_weight(report);
  for (std::size_t i = 0; i < ordered.size(); ++i) {
    std::string row = row_of(*ordered[i]);
    std::replace(row.begin(), row.end(), '`', '\'');  // a fence ends with these
    if (table.size() + row.size() > most_table_bytes) {
      table += fmt::format("{} more in the JSON document\n", ordered.size() - i);
      break;
    }
    table += row;
  }
  return fmt::format("**phytobench bench instructions: {}**\n\n- {}\n- {}\n\n```text\n{}```\n",
                     counts_in_words(report), markdown_text(side_in_words("base", report.base)),
                     markdown_text(side_in_words("new", report.other)), table);
}

std::string instruction_junit(const InstructionReport& report) {
  std::vector<GateCase> cases;
  for (const JudgedInstructions& one : report.judged)
    cases.push_back({one.benchmark, outcome_of(one.verdict), message_of(one)});
  return gate_junit("bench instructions", cases);
}

std::string instruction_json(const InstructionReport& report) {
  ordered_json json;
  json["schema"] = "phytobench/instructions-1";
  json["base"] = origin_json(report.base);
  json["new"] = origin_json(report.other);
  json["benchmarks"] = ordered_json::array();
  for (const JudgedInstructions& one : report.judged)
    json["benchmarks"].push_back(judged_json(one));
  return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace phytobench
