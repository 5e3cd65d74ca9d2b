// SPDX-License-Identifier: MIT
#include "cli/history_comparison.hpp"

#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "benchmarks/history/history_file.hpp"
#include "benchmarks/history/run_changes.hpp"
#include "cli/option_values.hpp"
#include "cli/terminal.hpp"
#include "core/contract/errors.hpp"
#include "core/contract/suggestion.hpp"

namespace phytobench::cli {

namespace {

using nlohmann::ordered_json;

bool is_number(const std::string& name) {
  return !name.empty() && name.size() <= 18 &&
         name.find_first_not_of("0123456789") == std::string::npos;
}

HistoryRun run_named(const HistoryFile& file, const std::string& name) {
  if (!is_number(name)) return file.baseline(name);
  for (const HistoryRun& run : file.runs())
    if (run.id == std::stoll(name)) return run;
  throw InputError("there is no run " + name + "; see phytobench history list");
}

bool is_wanted(const HistoryOptions& options, const HistoryValue& value) {
  return options.quantity.empty() || value.quantity().text() == options.quantity;
}

/// Of a run: those of the quantity that was asked for.
std::vector<HistoryValue> wanted_values(const HistoryOptions& options, const HistoryFile& file,
                                        const HistoryRun& run) {
  std::vector<HistoryValue> values = file.values(run.id);
  std::erase_if(values, [&](const HistoryValue& value) { return !is_wanted(options, value); });
  return values;
}

/// The run that all others are compared with must have it.
void refuse_unknown_quantity(const HistoryOptions& options, const HistoryFile& file,
                             const HistoryRun& run) {
  std::set<std::string> known;
  for (const HistoryValue& value : file.values(run.id)) known.insert(value.quantity().text());
  if (options.quantity.empty() || known.contains(options.quantity)) return;
  HistoryQuantity::named(options.quantity);  // says what a quantity can be
  const std::vector<std::string> all(known.begin(), known.end());
  throw InputError(fmt::format("'{}' has no {}{}; it has {}", options.names.front(),
                               options.quantity, did_you_mean(options.quantity, all),
                               fmt::join(all, ", ")));
}

struct Compared {
  HistoryRun before;
  HistoryRun after;
  HistoryChanges changes;
};

std::optional<Compared> compared(const HistoryOptions& options, const HistoryFile& file,
                                 const HistoryRun& before, const HistoryRun& after) {
  HistoryChanges changes = changes_between(before, wanted_values(options, file, before), after,
                                           wanted_values(options, file, after));
  if (changes.values.empty()) return std::nullopt;
  return Compared{before, after, std::move(changes)};
}

Compared compared(const HistoryOptions& options) {
  const HistoryFile file(options.file, HistoryAccess::read);
  const HistoryRun before = run_named(file, options.names.front());
  refuse_unknown_quantity(options, file, before);
  if (options.names.size() > 1) {
    if (auto result = compared(options, file, before, run_named(file, options.names[1])))
      return *result;
  } else {
    const std::vector<HistoryRun> runs = file.runs();
    for (auto run = runs.rbegin(); run != runs.rend(); ++run)
      if (run->id != before.id)
        if (auto result = compared(options, file, before, *run)) return *result;
  }
  throw NothingSelected(
      fmt::format("{} has no {} in common with {}; ratios count within one kind of machine only",
                  options.names.front(), options.quantity.empty() ? "value" : options.quantity,
                  options.names.size() > 1 ? options.names[1] : "any other run"));
}

std::string run_text(const HistoryRun& run) {
  std::string names;
  for (const std::string& name : run.baselines) names += name + ", ";
  return fmt::format("{}run {}, {}, {}{}", names, run.id, run.utc, run.commit,
                     run.changed ? " changed" : "");
}

std::string change_text(const HistoryChange& change) {
  const double relative = change.relative();
  return fmt::format("{:<44}  {:<28}  {:>16}  {:>16}  {}{}\n", change.before.benchmark(),
                     change.before.quantity().text(), change.before.text(), change.after.text(),
                     std::isfinite(relative) ? fmt::format("{:+.2f} %", 100.0 * relative) : "was 0",
                     change.has_same_inputs ? "" : ", other inputs");
}

std::string plain(const Compared& all) {
  std::string text =
      fmt::format("before: {}\nafter:  {}\n", run_text(all.before), run_text(all.after));
  std::size_t changed = 0;
  for (const HistoryChange& change : all.changes.values)
    if (!change.is_equal()) {
      text += changed == 0 ? "\n" : "";
      text += change_text(change);
      ++changed;
    }
  text += fmt::format("\n{} of {} values differ", changed, all.changes.values.size());
  if (all.changes.only_before + all.changes.only_after > 0)
    text += fmt::format("; {} only before, {} only after", all.changes.only_before,
                        all.changes.only_after);
  if (all.changes.ratios_left_out > 0)
    text += fmt::format("; {} ratios left out: they are of different machines",
                        all.changes.ratios_left_out);
  if (!all.changes.caution.empty()) text += "\nnote: " + all.changes.caution;
  return text + "\n";
}

ordered_json value_json(const HistoryValue& value) {
  if (value.quantity().is_ratio()) return value.number();
  return value.count();
}

ordered_json document_of(const Compared& all) {
  ordered_json json{{"schema", "phytobench/history-1"},
                    {"kind", "comparison"},
                    {"before", {{"run", all.before.id}, {"commit", all.before.commit}}},
                    {"after", {{"run", all.after.id}, {"commit", all.after.commit}}},
                    {"only_before", all.changes.only_before},
                    {"only_after", all.changes.only_after},
                    {"ratios_left_out", all.changes.ratios_left_out},
                    {"caution", all.changes.caution}};
  json["entries"] = ordered_json::array();
  for (const HistoryChange& change : all.changes.values) {
    ordered_json entry{{"benchmark", change.before.benchmark()},
                       {"quantity", change.before.quantity().text()},
                       {"before", value_json(change.before)},
                       {"after", value_json(change.after)},
                       {"change", nullptr},
                       {"same_inputs", change.has_same_inputs}};
    if (std::isfinite(change.relative())) entry["change"] = change.relative();
    json["entries"].push_back(std::move(entry));
  }
  return json;
}

}  // namespace

int compare_history(const HistoryOptions& options) {
  const Compared all = compared(options);
  print(options.json ? json_text(document_of(all)) + "\n" : plain(all));
  return 0;
}

}  // namespace phytobench::cli
