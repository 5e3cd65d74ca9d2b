// SPDX-License-Identifier: MIT
#include "reports/document_costs.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "reports/document_numbers.hpp"

namespace phytobench {

ExperimentCosts::ExperimentCosts(const RunContents& run,
                                 std::map<std::string, ExperimentFacts> facts, bool without_varying)
    : tier_(run.header.tier), facts_(std::move(facts)) {
  if (without_varying) return;
  for (const TimingSample& sample : run.timings) {
    if (sample.measurement == sample.experiment + "/cost/seconds")
      seconds_[sample.experiment] = sample.value;
    if (sample.measurement == sample.experiment + "/cost/peak_memory")
      peak_mib_[sample.experiment] = sample.value;
  }
}

CostOfRepeat ExperimentCosts::of(const std::vector<std::string>& experiments, Tier tier) const {
  double seconds = 0.0, peak_mib = 0.0;
  bool varies = false;
  for (const std::string& experiment : experiments) {
    const auto measured = seconds_.find(experiment);
    const auto expected = facts_.find(experiment);
    if (tier == tier_ && measured != seconds_.end()) {
      seconds += measured->second;
      varies = true;
      const auto memory = peak_mib_.find(experiment);
      if (memory != peak_mib_.end()) peak_mib = std::max(peak_mib, memory->second);
    } else if (expected != facts_.end()) {
      seconds += expected->second.seconds[static_cast<std::size_t>(tier)];
    } else {
      return {};
    }
  }
  if (experiments.empty()) return {};
  return {.time = rough_seconds(seconds),
          .memory = peak_mib > 0.0 ? fmt::format("{:.0f} MiB", peak_mib) : "",
          .varies = varies};
}

double ExperimentCosts::measured_seconds() const {
  double total = 0.0;
  for (const auto& [experiment, seconds] : seconds_) total += seconds;
  return total;
}

bool is_cost(const TimingSample& sample) {
  return sample.measurement.starts_with(sample.experiment + "/cost/");
}

}  // namespace phytobench
