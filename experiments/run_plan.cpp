// SPDX-License-Identifier: MIT
#include "experiments/run_plan.hpp"

#include <map>
#include <string>

#include "core/record/records_file.hpp"
#include "core/record/run_writer.hpp"

namespace phytobench {

RunPlan plan_run(const std::vector<const ExperimentDescriptor*>& experiments, Tier tier,
                 const RunContents& before) {
  std::map<std::string, double> seconds;
  for (const TimingSample& sample : before.timings)
    if (sample.measurement == sample.experiment + "/cost/seconds")
      seconds[sample.experiment] = sample.value;
  RunPlan plan{.complete = {}, .open = {}, .estimate = TimeEstimate(tier)};
  for (const ExperimentDescriptor* experiment : experiments) {
    const std::string id(experiment->id);
    const bool is_complete = before.complete_experiments.contains(id);
    (is_complete ? plan.complete : plan.open).push_back(experiment);
    if (const auto known = seconds.find(id); known != seconds.end())
      plan.estimate.learn(*experiment, known->second);
  }
  return plan;
}

RunPlan plan_run_in(const std::filesystem::path& folder,
                    const std::vector<const ExperimentDescriptor*>& experiments,
                    const RunHeader& header) {
  std::error_code ignored;
  if (!std::filesystem::exists(folder / records_name, ignored))
    return plan_run(experiments, header.tier);
  const RunContents before = read_run(folder);
  refuse_other_header(folder, before.header, header);
  return plan_run(experiments, header.tier, before);
}

}  // namespace phytobench
