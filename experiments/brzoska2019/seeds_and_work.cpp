// SPDX-License-Identifier: MIT
// Figure 46 shows one tree with three seeds; the smallest is printed with the longest time. Whether
// fewer nodes can mean more work is counted here, in distances that the thesis' fastest search
// computes: the same on any machine.
#include <algorithm>

#include <fmt/format.h>

#include "core/nearest_node/engine_registry.hpp"
#include "experiments/brzoska2019/thesis_tree.hpp"
#include "experiments/experiment.hpp"

namespace phytobench::experiments::brzoska2019 {

namespace {

struct Grown {
  double nodes, evaluations;
};

Grown grow(TreeParameters parameters, std::uint64_t seed, NearestNodeEngine& engine) {
  parameters.seed = seed;
  const GrowthResult result =
      grow_crown(make_seedling(parameters), engine, {.options = loop_options_named("dn")});
  return {static_cast<double>(result.skeleton.node_count()),
          static_cast<double>(result.work.search_evaluations + result.work.kill_evaluations)};
}

void run(ExperimentContext& context) {
  const TreeParameters parameters = thesis_tree("figure-46-left");
  const auto engine = engine_named("voxel_grid").create();
  const std::uint64_t seeds = 12;
  double most_nodes = 0.0, fewest_nodes = 1e18, most_work = 0.0, least_work = 1e18;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    context.progress(fmt::format("seed {} of {}", seed + 1, seeds));
    const Grown grown = grow(parameters, seed, *engine);
    const std::string name = fmt::format("seed-{:02}", seed);
    for (const auto& [what, value] :
         {std::pair{"/nodes", grown.nodes}, std::pair{"/evaluations", grown.evaluations}})
      context.record({.experiment = {},
                      .measurement = name + what,
                      .value = static_cast<std::int64_t>(value),
                      .seed = seed});
    most_nodes = std::max(most_nodes, grown.nodes);
    fewest_nodes = std::min(fewest_nodes, grown.nodes);
    most_work = std::max(most_work, grown.evaluations);
    least_work = std::min(least_work, grown.evaluations);
  }
  context.record("most_over_fewest_nodes", most_nodes / fewest_nodes);
  context.record("most_over_least_work", most_work / least_work);
}

}  // namespace

extern const ExperimentDescriptor seeds_and_work;
constinit const ExperimentDescriptor seeds_and_work{
    .id = "brzoska2019/seeds-and-work",
    .question = "Does a tree with fewer nodes from another seed cost more work?",
    .source = "[Brzoska2019] fig. 46 and appendix table",
    .seconds = {1, 1, 1},
    .run = run,
};

}  // namespace phytobench::experiments::brzoska2019
