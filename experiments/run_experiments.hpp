// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/record/run_files.hpp"
#include "experiments/experiment.hpp"

namespace phytobench {

struct RunRequest {
  std::vector<const ExperimentDescriptor*> experiments;
  RunHeader header;
  RunMode mode = RunMode::fresh;
  int threads = 1;
  std::filesystem::path folder;
  std::string command_line;
  std::function<void(const std::string&)> show_progress = {};  ///< may be empty
  std::function<bool()> is_interrupted = {};                   ///< may be empty
};

/// Runs the experiments that are not complete yet and appends each one's records when it is done,
/// so a broken run loses at most the running one. Throws Interrupted when asked to stop.
void run_experiments(const RunRequest& request);

/// Rough duration in seconds on a two-core machine.
double expected_seconds(const std::vector<const ExperimentDescriptor*>& experiments, Tier tier);

}  // namespace phytobench
