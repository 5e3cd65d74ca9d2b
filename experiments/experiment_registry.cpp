// SPDX-License-Identifier: MIT
#include "experiments/experiment_registry.hpp"

#include <fnmatch.h>

#include <algorithm>
#include <array>

#include "core/contract/errors.hpp"
#include "core/contract/suggestion.hpp"

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

bool matches(const std::string& pattern, const ExperimentDescriptor& experiment) {
  return ::fnmatch(pattern.c_str(), std::string(experiment.id).c_str(), 0) == 0;
}

[[noreturn]] void fail_to_match(const std::string& pattern) {
  if (pattern.find_first_of("*?[") != std::string::npos)
    throw NothingSelected("no experiment matches '" + pattern +
                          "'; see phytobench list experiments");
  std::vector<std::string> ids;
  for (const ExperimentDescriptor* experiment : table) ids.emplace_back(experiment->id);
  throw InputError("unknown experiment '" + pattern + "'" + did_you_mean(pattern, ids) +
                   " (phytobench list experiments)");
}

}  // namespace

std::span<const ExperimentDescriptor* const> all_experiments() {
  return table;
}

std::vector<const ExperimentDescriptor*> selected_experiments(
    const std::vector<std::string>& patterns) {
  std::vector<const ExperimentDescriptor*> selected;
  for (const std::string& pattern : patterns)
    if (std::none_of(table.begin(), table.end(),
                     [&](const auto* e) { return matches(pattern, *e); }))
      fail_to_match(pattern);
  for (const ExperimentDescriptor* experiment : table)
    if (patterns.empty() ||
        std::any_of(patterns.begin(), patterns.end(),
                    [&](const std::string& pattern) { return matches(pattern, *experiment); }))
      selected.push_back(experiment);
  return selected;
}

}  // namespace phytobench
