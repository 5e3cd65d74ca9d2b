// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "cli/option_values.hpp"
#include "cli/race_lsystem_output.hpp"
#include "cli/race_numbers.hpp"

namespace phytobench::cli {

namespace {

using DrawingState = DrawingEntry::State;

std::string held_text(std::uint64_t bytes) {
  const double kib = static_cast<double>(bytes) / 1024.0;
  return kib < 1024.0 ? fmt::format("{:.0f} KiB", kib) : fmt::format("{:.0f} MiB", kib / 1024.0);
}

std::string drawing_row(const DrawingEntry& entry, const LSystemWorkload& workload,
                        const DrawingRaceResult& result) {
  const std::string head =
      fmt::format("{:<7}{:<29}", phytobench::name_of(entry.lane), full_name(entry));
  if (entry.state == DrawingState::not_built)
    return fmt::format("{}not built: {} was not found\n", head, entry.engine->missing_package);
  if (entry.state == DrawingState::refused)
    return fmt::format("{}left out: {}\n", head, entry.objection);
  if (entry.state == DrawingState::wrong)
    return fmt::format("{}WRONG, no time: {}\n", head, entry.objection);
  const MedianOfRounds s = median_of_rounds(entry.seconds);
  std::string ratio = "-";
  if (const DrawingEntry* base = baseline_of(result, entry); base != nullptr && base != &entry) {
    const MedianOfRounds r = ratio_of_rounds(base->seconds, entry.seconds);
    ratio = fmt::format("{:.2f}x [{:.2f}, {:.2f}]", r.value, r.low, r.high);
  }
  return fmt::format(
      "{}{:>11}{:>11}{:>11}{:>10.1f}{:>10.1f}{:>10}  {}\n", head, with_unit(s.value),
      with_unit(s.low), with_unit(s.high), static_cast<double>(workload.segments) / s.value / 1e6,
      static_cast<double>(workload.modules) / s.value / 1e6, held_text(entry.bytes_held), ratio);
}

std::string drawing_table(const LSystemWorkload& workload, const DrawingRaceResult& result,
                          const EndsInWords& ends) {
  std::string text = fmt::format(
      "{}: {} derivations, {} segments of {} bytes, {} modules; {}\n\n"
      "{:<7}{:<29}{:>11}{:>11}{:>11}{:>10}{:>10}{:>10}  {}\n"
      "{:<7}{:<29}{:>11}{:>11}{:>11}{:>10}{:>10}\n",
      workload.name, workload.steps, workload.segments, segment_bytes(result), workload.modules,
      result.bound == 0.0 ? "judged to the last bit"
                          : fmt::format("judged to {:.1e} of a coordinate", result.bound),
      "lane", "engine", "median", ends.from, "to", "million", "million", "held",
      fmt::format("faster than {}, {}", baseline_engine, ends.ratio), "", "", "", "", "",
      "segments/s", "modules/s");
  for (const DrawingEntry& entry : result.entries) text += drawing_row(entry, workload, result);
  return text + "\n";
}

std::string mean_table(const LSystemRaceResults& results) {
  if (results.drawings.size() < 2) return "";
  std::string text = "geometric mean over the systems\n\n";
  const std::vector<DrawingEntry>& entries = results.drawings.front().entries;
  for (std::size_t e = 0; e < entries.size(); ++e)
    if (const auto ns = mean_ns(results, e))
      text +=
          fmt::format("{:<7}{:<29}{:>9.3f} ns a segment{:>10.1f} million segments/s\n",
                      phytobench::name_of(entries[e].lane), full_name(entries[e]), *ns, 1e3 / *ns);
  return text + "\n";
}

std::string derivation_table(const std::vector<DerivationEntry>& entries, const EndsInWords& ends) {
  if (entries.empty()) return "";
  std::string text = fmt::format(
      "derivation alone; modules of all words count that are made on the way\n\n"
      "{:<28}{:>6}{:>9}{:>12}{:>11}{:>11}{:>11}{:>11}{:>9}\n"
      "{:<28}{:>6}{:>9}{:>12}{:>11}{:>11}{:>11}{:>11}{:>9}\n",
      "system", "steps", "threads", "last word", "median", ends.from, "to", "million", "bytes", "",
      "", "", "modules", "", "", "", "modules/s", "a module");
  for (const DerivationEntry& entry : entries) {
    text += fmt::format("{:<28}{:>6}{:>9}{:>12}", entry.name, entry.steps, entry.threads,
                        entry.modules);
    if (!entry.objection.empty()) {
      text += fmt::format("  WRONG, no time: {}\n", entry.objection);
      continue;
    }
    const MedianOfRounds s = median_of_rounds(entry.seconds);
    text +=
        fmt::format("{:>11}{:>11}{:>11}{:>11.1f}{:>9.2f}\n", with_unit(s.value), with_unit(s.low),
                    with_unit(s.high), static_cast<double>(entry.modules_made) / s.value / 1e6,
                    entry.bytes_per_module);
  }
  return text;
}

}  // namespace

std::string lsystem_tables(const LSystemRaceResults& results, const LSystemRaceOptions& options) {
  const EndsInWords ends = ends_in_words(static_cast<std::size_t>(options.rounds));
  std::string text;
  for (std::size_t s = 0; s < results.drawings.size(); ++s)
    text += drawing_table(results.workloads[s], results.drawings[s], ends);
  return text + mean_table(results) + derivation_table(results.derivations, ends) + ends.note;
}

}  // namespace phytobench::cli
