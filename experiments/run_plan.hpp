// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "core/record/run_files.hpp"
#include "experiments/time_estimate.hpp"

namespace phytobench {

/// Which of the chosen experiments are done, and which are to be run.
struct RunPlan {
  std::vector<const ExperimentDescriptor*> complete;
  std::vector<const ExperimentDescriptor*> open;
  TimeEstimate estimate;  ///< has learned from those that are complete
};

/// `before` is what a run has left that is to be resumed.
RunPlan plan_run(const std::vector<const ExperimentDescriptor*>& experiments, Tier tier,
                 const RunContents& before = {});

/// The same for a folder, in which there may be no run yet. Throws InputError if there is a damaged
/// run, or one with another tier or seed.
RunPlan plan_run_in(const std::filesystem::path& folder,
                    const std::vector<const ExperimentDescriptor*>& experiments,
                    const RunHeader& header);

}  // namespace phytobench
