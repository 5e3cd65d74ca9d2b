// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/terminal.hpp"
#include "core/contract/errors.hpp"
#include "core/memory/keep_freed_memory.hpp"
#include "experiments/experiment_registry.hpp"
#include "experiments/run_experiments.hpp"

namespace phytobench::cli {

namespace {

void print_plan(const std::vector<const ExperimentDescriptor*>& experiments, Tier tier) {
  for (const ExperimentDescriptor* experiment : experiments)
    print(fmt::format("{:<32} about {:4.0f} s  {}\n", experiment->id,
                      experiment->seconds[static_cast<std::size_t>(tier)], experiment->question));
  print(fmt::format("{} experiments, tier {}, about {:.0f} s\n", experiments.size(), name_of(tier),
                    expected_seconds(experiments, tier)));
}

}  // namespace

int run(const RunOptions& options) {
  keep_freed_memory();
  const Tier tier = tier_named(options.tier);
  const auto experiments = selected_experiments(options.experiments);
  if (options.dry_run) {
    print_plan(experiments, tier);
    return 0;
  }
  if (options.out.empty()) throw InputError("--out needs the name of a folder");
  catch_interrupts();
  run_experiments({.experiments = experiments,
                   .header = {tier, options.seed},
                   .mode = options.resume ? RunMode::resume : RunMode::fresh,
                   .threads = options.threads,
                   .folder = options.out,
                   .command_line = options.command_line,
                   .show_progress = show_progress,
                   .is_interrupted = is_interrupted});
  print(fmt::format("{} experiments in {}; next: phytobench report {}\n", experiments.size(),
                    options.out, options.out));
  return 0;
}

}  // namespace phytobench::cli
