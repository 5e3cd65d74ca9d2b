// SPDX-License-Identifier: MIT
// The condition max_NG of sec. 3.5 in the loop as printed: nodes that have not grown for a while
// are not looked at any more. S(v) never gets a point back that it has lost to another node, so a
// node that did not grow once never will: whatever max_NG is, the tree must stay as it is.
#include "experiments/liebemann2017/limited_growth.hpp"
#include "experiments/liebemann2017/path_lengths.hpp"

namespace phytobench::experiments::liebemann2017 {

namespace {

/// One point ahead: only the newest node grows, and all nodes more than max_NG behind it rest.
void measure_one_point(ExperimentContext& context) {
  const Seedling seedling = scene({{0, 100, 0}}, {});
  const auto record = [&](const std::string& name, const Seedling& limited) {
    const GrowthResult result = grow(limited);
    context.record(name + "/distances", static_cast<std::int64_t>(result.work.search_evaluations));
    context.record(name + "/nodes", nodes_of(result));
  };
  record("one-point/unlimited", seedling);
  for (const std::int32_t max_NG : {1, 2, 3, 5})
    record(fmt::format("one-point/max_NG-{}", max_NG), resting(seedling, max_NG));
}

double all_distances(const oracles::liebemann2017::ColonizedTree& tree) {
  return static_cast<double>(tree.distances_of_step_1 + tree.distances_of_step_3);
}

/// Over the clouds, for one max_NG.
void measure_clouds(ExperimentContext& context, std::int32_t max_NG) {
  Range share, share_of_all;  // of the distances without a limit: of step 1, of steps 1 and 3
  std::int64_t other_trees = 0, resting_were_searched = 0, different = 0;
  for (std::uint64_t i = 0; i < clouds_of(context); ++i) {
    Seedling seedling = quarter_scene(context.seed(), i);
    seedling.growth.variant.repeat_guard = RepeatGuard::off;
    seedling.growth.iterations = 60;
    const Seedling limited = resting(seedling, max_NG);
    const GrowthResult free = grow(seedling), result = grow(limited);
    share.extend(share_of_distances(result, free));
    share_of_all.extend(all_distances(literal_tree(limited)) /
                        all_distances(literal_tree(seedling)));
    other_trees += tree_hash(result.skeleton) != tree_hash(free.skeleton);
    different += differs_from_literal(limited, result);
    for (const PassStatistics& pass : result.passes)
      resting_were_searched +=
          pass.search_evaluations != pass.queried_points * pass.searchable_nodes;
  }
  const std::string name = fmt::format("clouds/max_NG-{}/", max_NG);
  record_seeded(context, name + "share_of_distances/least", share.least);
  record_seeded(context, name + "share_of_distances/greatest", share.greatest);
  record_seeded(context, name + "share_of_all_distances/least", share_of_all.least);
  record_seeded(context, name + "other_trees", other_trees);
  record_seeded(context, name + "resting_were_searched", resting_were_searched);
  record_seeded(context, name + "differs_from_oracle", different);
}

/// Nodes of the literal loop whose counter is not the number of iterations since the last successor
/// or since they were made. Without repeats, as nodes then pause and grow again.
void measure_counter(ExperimentContext& context) {
  std::int64_t wrong = 0, grew_again = 0;
  constexpr int max_NG = 7;
  for (std::uint64_t i = 0; i < 10; ++i) {
    Seedling seedling = resting(quarter_scene(context.seed(), i), max_NG);
    seedling.growth.iterations = 40;
    const auto tree = literal_tree(seedling);
    std::vector<int> last = tree.born;
    for (std::size_t v = 1; v < tree.nodes.size(); ++v) {
      int& before = last[static_cast<std::size_t>(tree.predecessors[v])];
      grew_again += tree.born[v] > before + 1;
      before = tree.born[v];
    }
    for (std::size_t v = 0; v < tree.nodes.size(); ++v)
      wrong += tree.no_grow[v] != std::min(max_NG, tree.iterations - last[v]);
  }
  record_seeded(context, "counter/other_than_iterations_since_growth", wrong);
  record_seeded(context, "counter/nodes_that_grew_again", grew_again);
}

void run(ExperimentContext& context) {
  measure_one_point(context);
  for (const std::int32_t max_NG : {1, 2, 5, 20}) measure_clouds(context, max_NG);
  measure_counter(context);
}

}  // namespace

extern const ExperimentDescriptor nodes_without_growth;
constinit const ExperimentDescriptor nodes_without_growth{
    .id = "liebemann2017/nodes-without-growth",
    .question = "What does it save, and change, to forget nodes that have not grown for a while?",
    .source = "[Liebemann2017] sec. 3.5",
    .seconds = {0.4, 1.0, 2.5},
    .run = run,
};

}  // namespace phytobench::experiments::liebemann2017
