// SPDX-License-Identifier: MIT
// phytobench bench measure: times of one build, to be kept and compared later.
#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "benchmarks/comparison/instrument_check.hpp"
#include "benchmarks/comparison/measured_result.hpp"
#include "benchmarks/comparison/processor_split.hpp"
#include "benchmarks/comparison/revision_build.hpp"
#include "benchmarks/comparison/side.hpp"
#include "benchmarks/comparison/worker_client.hpp"
#include "cli/commands.hpp"
#include "cli/option_values.hpp"
#include "cli/output_files.hpp"
#include "cli/plugin_sides.hpp"
#include "cli/terminal.hpp"
#include "core/contract/errors.hpp"
#include "core/contract/name_selection.hpp"
#include "core/contract/text_file.hpp"
#include "core/statistics/order_statistics.hpp"

namespace phytobench::cli {

namespace {

/// Arithmetic that never changes: what other times are divided by, so that those of two machines
/// or days mean anything beside each other.
constexpr const char* reference_kernel = "selftest/steady";

Side named_side(const BenchMeasureOptions& options) {
  const SideContext context = side_context();
  const Side side = options.side.empty()
                        ? side_of_build(context.program.parent_path(), "this build", context)
                        : resolve_side(options.side, context);
  if (side.origin.kind == "result")
    throw InputError(options.side + ": is a result; name a build, a revision or a plugin");
  return built_side(
      side, context,
      {.show_progress = show_progress, .tell = tell, .is_interrupted = is_interrupted});
}

std::vector<std::string> chosen_names(const std::vector<std::string>& all,
                                      const std::vector<std::string>& globs) {
  std::vector<std::string> known, chosen;
  for (const std::string& name : all)
    if (!name.starts_with("selftest/")) known.push_back(name);
  for (const std::size_t place :
       selected_names(known, globs, {.kind = "benchmark", .listing = "phytobench bench list"}))
    chosen.push_back(known[place]);
  return chosen;
}

StoredResult measured(const BenchMeasureOptions& options, Side side) {
  side.worker_options.push_back("--selftest");
  const std::optional<ProcessorSplit> split = processor_split(allowed_processors());
  const PinnedThread runner(split ? std::optional<int>(split->runner) : std::nullopt);
  WorkerClientOptions client_options{.is_interrupted = is_interrupted,
                                     .sample_ms = options.sample_ms};
  if (split) client_options.processor = split->worker;
  WorkerClient client(side, client_options);
  refuse_to_time_counters(client.describe(), title_of(side));
  std::vector<std::string> names = chosen_names(names_of(client), options.benchmarks);
  names.push_back(reference_kernel);
  return measure_result({.side = &client,
                         .origin = side.origin,
                         .machine = this_result_machine(),
                         .names = names,
                         .reference = reference_kernel,
                         .seed = options.seed,
                         .processes = options.processes,
                         .samples = options.samples,
                         .sample_ms = options.sample_ms,
                         .show_progress = show_progress,
                         .is_interrupted = is_interrupted});
}

std::string table(const StoredResult& result) {
  std::string text = fmt::format("{:>10}  {:>10}  {}\n", "median", "reference", "benchmark");
  for (const StoredBenchmark& benchmark : result.benchmarks) {
    const std::vector<double> seconds = benchmark.repetitions();
    if (seconds.empty())
      text += fmt::format("{:>10}  {:>10}  {}: {}\n", "no time", "", benchmark.name,
                          benchmark.objection);
    else
      text += fmt::format("{:>10}  {:>10}  {}\n", with_unit(median(seconds)),
                          result.reference
                              ? fmt::format("{:.4g}", median(seconds) / result.reference->seconds)
                              : "?",
                          benchmark.name);
  }
  return text + "reference: the time divided by that of " + reference_kernel +
         " in the same run; seconds of other runs mean nothing beside these\n";
}

}  // namespace

int bench_measure(const BenchMeasureOptions& options) {
  catch_interrupts();
  refuse_unwritable_files({options.out});
  const Side side = named_side(options);
  if (const std::string failure = failed_trial(side); !failure.empty()) {
    print(failure);
    return 1;
  }
  const StoredResult result = measured(options, side);
  if (!options.out.empty()) write_file_atomically(options.out, to_json(result));
  print(options.json ? to_json(result) : table(result));
  const auto is_timed = [](const StoredBenchmark& benchmark) {
    return !benchmark.repetitions().empty() && benchmark.name != reference_kernel;
  };
  if (std::none_of(result.benchmarks.begin(), result.benchmarks.end(), is_timed)) return 4;
  const auto is_refused = [](const StoredBenchmark& benchmark) {
    return !benchmark.objection.empty();
  };
  return std::any_of(result.benchmarks.begin(), result.benchmarks.end(), is_refused) ? 1 : 0;
}

}  // namespace phytobench::cli
