// SPDX-License-Identifier: MIT
#include "experiments/brzoska2019/paired_trees.hpp"

#include <fmt/format.h>

#include "core/contract/check.hpp"
#include "core/nearest_node/engine_registry.hpp"
#include "experiments/alsweis/paired_runs.hpp"

namespace phytobench::experiments::brzoska2019 {

TreeParameters tree_of_trend(TreeParameters parameters, const ExperimentContext& context,
                             std::size_t number) {
  constexpr std::uint64_t seeds_of_a_run = 1000;
  PHYTOBENCH_EXPECT(number < seeds_of_a_run);
  parameters.random = StreamKind::counter;
  parameters.seed = context.seed() * seeds_of_a_run + number;
  return parameters;
}

GrowthResult grow_seedling(const Seedling& seedling, const ExperimentContext& context) {
  const auto engine = engine_named("node_driven").create();
  return grow_crown(seedling, *engine, {.options = {}, .threads = context.threads()});
}

GrownTree FullTrees::next() {
  for (;; ++left_out_) {
    const TreeParameters own = tree_of_trend(parameters_, context_, number_++);
    GrownTree tree{make_seedling(own)};
    GrowthResult result = grow_seedling(tree.seedling, context_);
    if (result.stop_reason != StopReason::iteration_limit) continue;
    tree.skeleton = std::move(result.skeleton);
    seeds_.push_back(own.seed);
    return tree;
  }
}

std::uint64_t FullTrees::seed(std::size_t number) const {
  PHYTOBENCH_EXPECT(number < seeds_.size());
  return seeds_[number];
}

ByTree record_trees(ExperimentContext& context, const std::string& name, const std::string& unit,
                    const std::function<double(std::size_t)>& value_of_tree, std::size_t trees,
                    const SeedOfTree& seed_of_tree) {
  context.progress(name);
  ByTree values;
  for (std::size_t number = 0; number < trees; ++number) {
    values.push_back(value_of_tree(number));
    context.record(
        {.experiment = {},
         .measurement = fmt::format("{}/tree-{:02}", name, number),
         .value = values.back(),
         .unit = unit,
         .seed = seed_of_tree ? seed_of_tree(number) : tree_of_trend({}, context, number).seed});
  }
  alsweis::record_mean(context, name + "/mean", values, unit);
  return values;
}

void record_trend(ExperimentContext& context, const std::string& name, const ByTree& more,
                  const ByTree& less) {
  alsweis::record_paired(context, name, more, less);
}

void record_falling(ExperimentContext& context, const std::string& name,
                    const std::vector<std::string>& settings, const std::vector<ByTree>& values) {
  PHYTOBENCH_EXPECT(settings.size() == values.size());
  for (std::size_t i = 0; i + 1 < values.size(); ++i)
    record_trend(context, fmt::format("{}/{}-to-{}", name, settings[i], settings[i + 1]), values[i],
                 values[i + 1]);
}

}  // namespace phytobench::experiments::brzoska2019
