// SPDX-License-Identifier: MIT
#include <cmath>

#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "cli/option_values.hpp"
#include "cli/race_lsystem_output.hpp"
#include "cli/terminal.hpp"
#include "core/contract/errors.hpp"
#include "core/memory/keep_freed_memory.hpp"

namespace phytobench::cli {

namespace {

std::vector<const DerivationEngine*> chosen_engines(const LSystemRaceOptions& options) {
  std::vector<const DerivationEngine*> chosen;
  for (const std::string& name : options.engines) {
    if (name != "all") {
      chosen.push_back(&derivation_engine_named(name));
      continue;
    }
    for (const DerivationEngine* engine : all_derivation_engines()) chosen.push_back(engine);
  }
  return chosen;
}

std::vector<LSystemWorkload> chosen_workloads(const LSystemRaceOptions& options) {
  if (!std::isfinite(options.segments) || !std::isfinite(options.modules))
    throw InputError("--segments and --modules are numbers, such as 1e7");
  std::vector<LSystemWorkload> chosen;
  for (const std::string& name : options.systems) {
    if (name != "all" && name != "published") {
      chosen.push_back(lsystem_workload(name, options.segments));
      continue;
    }
    for (const BenchSystem& system : name == "all" ? bench_systems() : published_systems())
      chosen.push_back(lsystem_workload(std::string(system.name), options.segments));
  }
  return chosen;
}

}  // namespace

int race_lsystem(const LSystemRaceOptions& options) {
  keep_freed_memory();
  LSystemRaceResults results;
  const auto contestants = drawing_contestants(chosen_engines(options), options.threads);
  results.workloads = chosen_workloads(options);
  catch_interrupts();
  for (const LSystemWorkload& workload : results.workloads)
    results.drawings.push_back(race_drawings({.workload = &workload,
                                              .contestants = contestants,
                                              .rounds = options.rounds,
                                              .order_seed = options.seed,
                                              .show_progress = show_progress,
                                              .is_interrupted = is_interrupted}));
  if (options.modules > 0.0)
    results.derivations =
        race_derivations({.cases = derivation_cases(static_cast<std::uint64_t>(options.modules)),
                          .threads = options.threads,
                          .rounds = options.rounds,
                          .order_seed = options.seed,
                          .show_progress = show_progress,
                          .is_interrupted = is_interrupted});
  print(options.json ? json_text(lsystem_document(results, options)) + "\n"
                     : lsystem_tables(results, options));
  return results.all_right() ? 0 : 1;
}

}  // namespace phytobench::cli
