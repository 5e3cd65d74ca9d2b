// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/record/run_writer.hpp"
#include "experiments/cost_meter.hpp"
#include "experiments/experiment.hpp"
#include "experiments/run_plan.hpp"

namespace phytobench {

struct RunRequest {
  std::vector<const ExperimentDescriptor*> experiments;
  RunHeader header;
  RunMode mode = RunMode::fresh;
  int threads = 1;
  std::filesystem::path folder;
  std::string command_line;
  std::function<void(const RunPlan&)> announce = {};           ///< before the first; may be empty
  std::function<void(const std::string&)> show_progress = {};  ///< one line; may be empty
  std::function<bool()> is_interrupted = {};                   ///< may be empty
};

struct FinishedExperiment {
  const ExperimentDescriptor* experiment = nullptr;
  ExperimentCost cost;
};

/// What one start of a run has done.
struct RunSummary {
  std::size_t skipped = 0;  ///< that were complete before
  std::vector<FinishedExperiment> finished;
  double seconds = 0.0;
};

/// Runs the experiments that are not complete yet and appends each one's records when it is done,
/// so that a broken run loses at most the running one. What each has cost becomes its timings
/// "cost/seconds" and, where the system tells, "cost/peak_memory" in MiB. Throws Interrupted when
/// asked to stop.
RunSummary run_experiments(const RunRequest& request);

}  // namespace phytobench
