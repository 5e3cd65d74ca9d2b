// SPDX-License-Identifier: MIT
// phytobench bench counters: the gate on work counters.
#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "benchmarks/comparison/counter_gate.hpp"
#include "benchmarks/comparison/gate_junit.hpp"
#include "benchmarks/comparison/result_document.hpp"
#include "benchmarks/comparison/worker_client.hpp"
#include "cli/commands.hpp"
#include "cli/counting_worker.hpp"
#include "cli/option_values.hpp"
#include "cli/output_files.hpp"
#include "cli/source_tree.hpp"
#include "cli/terminal.hpp"
#include "core/contract/errors.hpp"
#include "core/contract/name_selection.hpp"
#include "core/contract/text_file.hpp"

namespace phytobench::cli {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

std::string baseline_file(const BenchCountersOptions& options) {
  if (!options.baseline.empty()) return options.baseline;
  return (source_tree() / "benchmarks" / "baselines" / "counters.json").string();
}

/// Empty where it is to be written for the first time.
CounterBaseline read_baseline(const std::string& file, bool may_be_missing) {
  if (fs::exists(file)) return counter_baseline_from(read_text_file(file), file);
  if (may_be_missing) return {};
  throw InputError(file + ": no such file; write it with phytobench bench counters --accept");
}

/// What was found, beside what was expected of the same benchmarks.
struct Found {
  SideOrigin origin;           ///< of the worker
  std::size_t benchmarks = 0;  ///< that were run
  std::vector<std::string> wrong;
  CounterBaseline before;
  CounterBaseline after;
  std::vector<CounterChange> changes;
};

Found find(const BenchCountersOptions& options, const CounterBaseline& baseline) {
  WorkerClient client(counting_worker(options.worker), {.is_interrupted = is_interrupted});
  const std::vector<std::string> there = client.names();
  std::set<std::string> all(there.begin(), there.end());
  for (const auto& [name, benchmark] : baseline) all.insert(name);
  const std::vector<std::string> names(all.begin(), all.end());
  std::vector<std::string> asked;
  Found found{.origin = client.side().origin};
  for (const std::size_t i :
       selected_names(names, options.benchmarks, {"benchmark", "phytobench bench list"})) {
    if (const auto known = baseline.find(names[i]); known != baseline.end())
      found.before.insert(*known);
    if (std::find(there.begin(), there.end(), names[i]) != there.end()) asked.push_back(names[i]);
  }
  show_progress(fmt::format("counting the work of {} benchmarks", asked.size()));
  // Without names a worker runs everything.
  const std::vector<VerifiedBenchmark> verified =
      asked.empty() ? std::vector<VerifiedBenchmark>() : client.counters(asked);
  found.benchmarks = verified.size();
  found.wrong = wrong_answers(verified);
  if (!found.wrong.empty()) return found;
  found.after = counted(verified, title_of(client.side()));
  found.changes = counter_changes(found.before, found.after);
  return found;
}

/// The whole file with what was found in the place of what was chosen.
void accept(const std::string& file, CounterBaseline baseline, const Found& found) {
  for (const auto& [name, benchmark] : found.before) baseline.erase(name);
  baseline.insert(found.after.begin(), found.after.end());
  write_file_atomically(file, to_json(baseline));
}

std::string_view kind_name(CounterChangeKind kind) {
  switch (kind) {
    case CounterChangeKind::other_value:
      return "other value";
    case CounterChangeKind::counter_appeared:
      return "counter appeared";
    case CounterChangeKind::counter_gone:
      return "counter gone";
    case CounterChangeKind::inputs_changed:
      return "inputs changed";
    case CounterChangeKind::benchmark_appeared:
      return "benchmark appeared";
    case CounterChangeKind::benchmark_gone:
      return "benchmark gone";
  }
  return "";
}

ordered_json change_json(const CounterChange& change) {
  ordered_json json{{"kind", kind_name(change.kind)}, {"benchmark", change.benchmark}};
  if (change.counter.empty()) return json;
  json["counter"] = change.counter;
  const bool is_new = change.kind == CounterChangeKind::counter_appeared;
  const bool is_gone = change.kind == CounterChangeKind::counter_gone;
  json["before"] = is_new ? ordered_json(nullptr) : ordered_json(change.before);
  json["after"] = is_gone ? ordered_json(nullptr) : ordered_json(change.after);
  return json;
}

std::string document(const BenchCountersOptions& options, const std::string& file,
                     const Found& found) {
  ordered_json json{{"schema", "phytobench/bench-counters-1"},
                    {"baseline", file},
                    {"origin", origin_json(found.origin)},
                    {"benchmarks", found.benchmarks},
                    {"accepted", options.accept && found.wrong.empty()},
                    {"wrong_answers", found.wrong},
                    {"changes", ordered_json::array()}};
  for (const CounterChange& change : found.changes) json["changes"].push_back(change_json(change));
  return json_text(json) + "\n";
}

std::string plain(const BenchCountersOptions& options, const std::string& file,
                  const Found& found) {
  std::string text;
  for (const std::string& answer : found.wrong)
    text += "wrong answer, not counted: " + answer + "\n";
  if (!found.wrong.empty()) return text;
  for (const CounterChange& change : found.changes) text += text_of(change) + "\n";
  const std::size_t count = found.changes.size();
  const std::string changes = fmt::format("{} change{}", count, count == 1 ? "" : "s");
  if (options.accept) return text + fmt::format("{}: written with {}\n", file, changes);
  if (count == 0)
    return fmt::format("{} benchmarks: right answers, counters as in {}\n", found.benchmarks, file);
  return text + fmt::format("{} from {}; if wanted, run this with --accept and commit the file\n",
                            changes, file);
}

std::string junit(const Found& found) {
  std::map<std::string, GateCase> cases;
  for (const auto& [name, benchmark] : found.after) cases[name] = {.name = name};
  for (const CounterChange& change : found.changes) {
    GateCase& one = cases[change.benchmark];
    one.name = change.benchmark;
    one.outcome = GateOutcome::failed;
    one.message += (one.message.empty() ? "" : "; ") + text_of(change);
  }
  std::vector<GateCase> list;
  for (const std::string& answer : found.wrong)
    list.push_back(
        {answer.substr(0, answer.find(": ")), GateOutcome::failed, "wrong answer: " + answer});
  for (auto& [name, one] : cases) list.push_back(std::move(one));
  return gate_junit("bench counters", list);
}

}  // namespace

int bench_counters(const BenchCountersOptions& options) {
  catch_interrupts();
  const std::string file = baseline_file(options);
  const CounterBaseline baseline = read_baseline(file, options.accept);
  refuse_unwritable_files({options.out, options.junit, options.accept ? file : ""});
  const Found found = find(options, baseline);
  clear_progress();
  const bool is_right = found.wrong.empty();
  if (options.accept && is_right) accept(file, baseline, found);
  if (!options.out.empty() && is_right)
    write_file_atomically(options.out, to_json(CounterDocument{found.origin, found.after}));
  if (!options.junit.empty()) write_file_atomically(options.junit, junit(found));
  print(options.json ? document(options, file, found) : plain(options, file, found));
  return is_right && (options.accept || found.changes.empty()) ? 0 : 1;
}

}  // namespace phytobench::cli
