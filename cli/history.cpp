// SPDX-License-Identifier: MIT
// phytobench history: list, append and save runs; series and comparisons are in files of their own.
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "benchmarks/history/history_file.hpp"
#include "benchmarks/history/history_input.hpp"
#include "build_information.hpp"
#include "cli/commands.hpp"
#include "cli/history_comparison.hpp"
#include "cli/history_series.hpp"
#include "cli/option_values.hpp"
#include "cli/terminal.hpp"
#include "core/contract/errors.hpp"
#include "core/contract/suggestion.hpp"
#include "core/record/environment.hpp"

namespace phytobench::cli {

namespace {

using nlohmann::ordered_json;

constexpr const char* usage =
    "use history list, show BENCHMARK, plot BENCHMARK, append RESULT.json..., save NAME or "
    "compare NAME [NAME2]";

/// What a file that does not say it is about: this program on this machine.
HistoryRun this_build(const HistoryOptions& options) {
  const Machine machine = this_machine();
  return {.commit = build_information::commit,
          .changed = build_information::source_changed,
          .compiler = build_information::compiler,
          .flags = build_information::flags,
          .processor = machine.processor,
          .logical_processors = machine.logical_processors,
          .command = options.command_line};
}

ordered_json run_json(const HistoryRun& run) {
  return {{"run", run.id},
          {"date_utc", run.utc},
          {"commit", run.commit},
          {"source_changed", run.changed},
          {"compiler", run.compiler},
          {"flags", run.flags},
          {"processor", run.processor},
          {"logical_processors", run.logical_processors},
          {"values", run.values},
          {"baselines", run.baselines}};
}

std::string list_text(const std::vector<HistoryRun>& runs) {
  std::string text = fmt::format("{:>5}  {:<20}  {:<21}  {:>6}  {}\n", "run", "date", "commit",
                                 "values", "baselines");
  for (const HistoryRun& run : runs)
    text += fmt::format(
        "{:>5}  {:<20}  {:<21}  {:>6}  {}\n", run.id, run.utc,
        run.commit + (run.changed ? " changed" : ""), run.values,
        run.baselines.empty() ? "-" : fmt::format("{}", fmt::join(run.baselines, ", ")));
  return text;
}

int list_runs(const HistoryOptions& options) {
  const HistoryFile file(options.file, HistoryAccess::read);
  const std::vector<HistoryRun> runs = file.runs();
  if (!options.json) {
    print(list_text(runs));
    return 0;
  }
  ordered_json document{{"schema", "phytobench/history-1"}, {"kind", "runs"}};
  document["entries"] = ordered_json::array();
  for (const HistoryRun& run : runs) document["entries"].push_back(run_json(run));
  print(json_text(document) + "\n");
  return 0;
}

int append_run(const HistoryOptions& options) {
  const HistoryEntry entry = history_entry_of(options.names, this_build(options));
  HistoryFile file(options.file, HistoryAccess::append);
  const std::int64_t id = file.append(entry.run, entry.values);
  if (options.json)
    print(json_text(ordered_json{{"schema", "phytobench/history-1"},
                                 {"kind", "appended"},
                                 {"run", id},
                                 {"commit", entry.run.commit},
                                 {"values", entry.values.size()}}) +
          "\n");
  else
    print(fmt::format("run {}: {} values of commit {}{} in {}\n", id, entry.values.size(),
                      entry.run.commit.empty() ? "unknown" : entry.run.commit,
                      entry.run.changed ? ", changed" : "", options.file));
  return 0;
}

int save_run(const HistoryOptions& options) {
  HistoryFile file(options.file, HistoryAccess::read);
  const std::vector<HistoryRun> runs = file.runs();
  if (runs.empty())
    throw NothingSelected(options.file + ": has no run yet; phytobench history append RESULT.json");
  file.save_baseline(options.names.front(), runs.back().id);
  if (options.json)
    print(json_text(ordered_json{{"schema", "phytobench/history-1"},
                                 {"kind", "saved"},
                                 {"baseline", options.names.front()},
                                 {"run", runs.back().id}}) +
          "\n");
  else
    print(fmt::format("{} is run {} now, of commit {}\n", options.names.front(), runs.back().id,
                      runs.back().commit));
  return 0;
}

enum class Quantities { all, can_be_chosen };

struct Action {
  const char* name;
  std::size_t fewest_names;
  std::size_t most_names;
  Quantities quantities;
  int (*run)(const HistoryOptions&);
};
constexpr Action actions[] = {{"list", 0, 0, Quantities::all, list_runs},
                              {"show", 1, 1, Quantities::can_be_chosen, show_history},
                              {"plot", 1, 1, Quantities::can_be_chosen, plot_history},
                              {"append", 1, 100, Quantities::all, append_run},
                              {"save", 1, 1, Quantities::all, save_run},
                              {"compare", 1, 2, Quantities::can_be_chosen, compare_history}};

/// Options of other actions, which this one would pass over in silence.
void refuse_idle_options(const HistoryOptions& options, const Action& action) {
  if (!options.out.empty() && options.action != "plot")
    throw InputError("--out goes with history plot only");
  if (!options.quantity.empty() && action.quantities == Quantities::all)
    throw InputError("--quantity " + options.quantity +
                     ": goes with history show, plot and compare only");
}

}  // namespace

int history(const HistoryOptions& options) {
  std::vector<std::string> known;
  for (const Action& action : actions) {
    known.emplace_back(action.name);
    if (options.action != action.name) continue;
    const std::size_t names = options.names.size();
    if (names < action.fewest_names || names > action.most_names)
      throw InputError(fmt::format("history {} with {} more word{}; {}", action.name, names,
                                   names == 1 ? "" : "s", usage));
    refuse_idle_options(options, action);
    return action.run(options);
  }
  throw InputError("history cannot '" + options.action + "'" + did_you_mean(options.action, known) +
                   "; " + usage);
}

}  // namespace phytobench::cli
