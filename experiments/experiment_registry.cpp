// SPDX-License-Identifier: MIT
#include "experiments/experiment_registry.hpp"

#include <array>

#include "core/contract/name_selection.hpp"

namespace phytobench {

namespace experiments {
#define EXPERIMENT(paper, name, dependency) \
  namespace paper {                         \
  extern const ExperimentDescriptor name;   \
  }
#include "experiments/experiments.def"
#undef EXPERIMENT
}  // namespace experiments

namespace {

constexpr auto table = std::to_array<const ExperimentDescriptor*>({
#define EXPERIMENT(paper, name, dependency) &experiments::paper::name,
#include "experiments/experiments.def"
#undef EXPERIMENT
});

}  // namespace

std::span<const ExperimentDescriptor* const> all_experiments() {
  return table;
}

std::vector<const ExperimentDescriptor*> selected_experiments(
    const std::vector<std::string>& patterns) {
  std::vector<std::string> ids;
  for (const ExperimentDescriptor* experiment : table) ids.emplace_back(experiment->id);
  std::vector<const ExperimentDescriptor*> selected;
  for (const std::size_t i :
       selected_names(ids, patterns, {"experiment", "phytobench list experiments"}))
    selected.push_back(table[i]);
  return selected;
}

}  // namespace phytobench
