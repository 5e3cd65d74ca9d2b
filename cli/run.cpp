// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/terminal.hpp"
#include "core/contract/errors.hpp"
#include "core/memory/keep_freed_memory.hpp"
#include "experiments/experiment_registry.hpp"
#include "experiments/run_experiments.hpp"

namespace phytobench::cli {

namespace {

void print_plan(const RunPlan& plan, Tier tier) {
  for (const ExperimentDescriptor* experiment : plan.complete)
    print(fmt::format("{:<32} complete      {}\n", experiment->id, experiment->question));
  for (const ExperimentDescriptor* experiment : plan.open)
    print(fmt::format("{:<32} about {:4.0f} s  {}\n", experiment->id,
                      plan.estimate.seconds_of(*experiment), experiment->question));
  if (!plan.complete.empty())
    print(fmt::format("{} experiments are complete and skipped\n", plan.complete.size()));
  print(fmt::format("{} experiments, tier {}, about {:.0f} s\n", plan.open.size(), name_of(tier),
                    plan.estimate.seconds_of(plan.open)));
}

/// What a resumed run need not do again.
void print_skipped(const RunPlan& plan) {
  if (plan.complete.empty()) return;
  print(fmt::format("{} experiments are complete and skipped; left: {}, about {}\n",
                    plan.complete.size(), plan.open.size(),
                    shown_duration(std::ceil(plan.estimate.seconds_of(plan.open)))));
}

bool takes_longer(const FinishedExperiment& a, const FinishedExperiment& b) {
  return a.cost.seconds > b.cost.seconds;
}

bool needs_less_memory(const FinishedExperiment& a, const FinishedExperiment& b) {
  return a.cost.peak_memory_mib < b.cost.peak_memory_mib;
}

/// Where the time and the memory went.
void print_costs(RunSummary summary) {
  if (summary.finished.empty()) return;
  const auto largest =
      *std::max_element(summary.finished.begin(), summary.finished.end(), needs_less_memory);
  std::stable_sort(summary.finished.begin(), summary.finished.end(), takes_longer);
  constexpr std::size_t most = 5;
  std::string line = fmt::format("{} in all; slowest:", shown_duration(summary.seconds));
  for (std::size_t i = 0; i < std::min(most, summary.finished.size()); ++i)
    line += fmt::format("{} {} {}", i > 0 ? "," : "", summary.finished[i].experiment->id,
                        shown_duration(summary.finished[i].cost.seconds));
  print(line + "\n");
  if (largest.cost.peak_memory_mib)
    print(fmt::format("most memory: {} {:.0f} MiB\n", largest.experiment->id,
                      *largest.cost.peak_memory_mib));
}

}  // namespace

int run(const RunOptions& options) {
  keep_freed_memory();
  const RunHeader header{tier_named(options.tier), options.seed};
  const auto experiments = selected_experiments(options.experiments);
  if (options.dry_run) {
    print_plan(options.resume ? plan_run_in(options.out, experiments, header)
                              : plan_run(experiments, header.tier),
               header.tier);
    return 0;
  }
  if (options.out.empty()) throw InputError("--out needs the name of a folder");
  catch_interrupts();
  const RunSummary summary =
      run_experiments({.experiments = experiments,
                       .header = header,
                       .mode = options.resume ? RunMode::resume : RunMode::fresh,
                       .threads = options.threads,
                       .folder = options.out,
                       .command_line = options.command_line,
                       .announce = print_skipped,
                       .show_progress = show_progress,
                       .is_interrupted = is_interrupted});
  print_costs(summary);
  print(fmt::format("{} experiments in {}; next: phytobench report {}\n", experiments.size(),
                    options.out, options.out));
  return 0;
}

}  // namespace phytobench::cli
