// SPDX-License-Identifier: MIT
// The condition max_NG of sec. 3.5 where another condition keeps nodes with influence points from
// growing: a greatest degree, or no second successor at the same place. Such nodes come to rest,
// and their points go to other nodes, which grow.
#include "experiments/liebemann2017/limited_growth.hpp"
#include "experiments/liebemann2017/path_lengths.hpp"

namespace phytobench::experiments::liebemann2017 {

namespace {

/// Of the values that are tried one by one.
constexpr std::int32_t most_max_NG = 40;

/// What is left and what grows with the least value of max_NG that is of interest, and how many
/// values from there on keep the tree.
void record_resting(ExperimentContext& context, const std::string& name, const Seedling& seedling,
                    std::int32_t least_max_NG) {
  const GrowthResult free = grow(seedling), released = grow(resting(seedling, least_max_NG));
  const std::string rested = fmt::format("{}/max_NG-{}/", name, least_max_NG);
  context.record(name + "/unlimited/points_left", whole(free.live_points));
  context.record(rested + "points_left", whole(released.live_points));
  context.record(rested + "more_nodes", nodes_of(released) - nodes_of(free));
  std::int64_t same = 0;
  for (std::int32_t max_NG = least_max_NG; max_NG <= most_max_NG; ++max_NG)
    same += tree_hash(grow(resting(seedling, max_NG)).skeleton) == tree_hash(free.skeleton);
  context.record(name + "/values_that_keep_the_tree", same);
}

/// Two points beside the nodes that grow between them, and a branch that passes them, after three
/// points of its own.
Seedling two_points_and_a_branch(double root_y) {
  Seedling seedling =
      scene({{-40, 0, 0}, {40, 0, 0}, {90, 0, 0}, {90, 60, 0}, {90, 120, 0}}, {0, root_y, 0}, 100);
  seedling.skeleton.append(0, {90, -50, 0});
  return seedling;
}

/// The nodes between the points never reach them, and the branch is always a little farther away
/// than those nodes are. The node between them comes to rest some day, whatever max_NG is.
void measure_released_points(ExperimentContext& context) {
  record_resting(context, "passing-branch", without_repeats(two_points_and_a_branch(-50)), 2);
}

/// The loop as printed but for its missing case: a node in the middle between two points has no
/// direction, so it keeps its points and makes no node, until it comes to rest.
void measure_balanced_node(ExperimentContext& context) {
  record_resting(context, "balanced-node", two_points_and_a_branch(-45), 1);
}

/// Over the clouds, for one max_NG beside another condition.
struct Changes {
  std::int64_t other_trees = 0, fewer_points_left = 0, different = 0;
  Range share;  // of the distances of step 1 without max_NG
};

Changes changes(ExperimentContext& context, std::int32_t max_children, std::int32_t max_NG) {
  Changes sum;
  for (std::uint64_t i = 0; i < clouds_of(context); ++i) {
    Seedling seedling = quarter_scene(context.seed(), i);
    seedling.growth.limits.most_children = max_children;
    const Seedling limited = resting(seedling, max_NG);
    const GrowthResult free = grow(seedling), result = grow(limited);
    sum.other_trees += tree_hash(free.skeleton) != tree_hash(result.skeleton);
    sum.fewer_points_left += result.live_points < free.live_points;
    sum.share.extend(share_of_distances(result, free));
    sum.different += differs_from_literal(limited, result);
  }
  return sum;
}

void measure_clouds(ExperimentContext& context, const std::string& condition,
                    std::int32_t max_children, std::int32_t max_NG) {
  const Changes sum = changes(context, max_children, max_NG);
  const std::string name = fmt::format("{}/max_NG-{}/", condition, max_NG);
  record_seeded(context, name + "differs_from_oracle", sum.different);
  if (condition == "once" && max_NG > 1)
    record_seeded(context, name + "share_of_distances/least", sum.share.least);
  if (condition == "once" && max_NG < 20)
    record_seeded(context, name + "share_of_distances/greatest", sum.share.greatest);
  record_seeded(context, name + "other_trees", sum.other_trees);
  record_seeded(context, name + "fewer_points_left", sum.fewer_points_left);
}

/// Clouds for which some value keeps the tree without repeats, and values that do so for all.
void measure_choices(ExperimentContext& context) {
  std::int64_t with_a_choice = 0;
  const std::uint64_t clouds = clouds_of(context);
  std::vector<std::uint64_t> safe_for(most_max_NG + 1, 0);
  for (std::uint64_t i = 0; i < clouds; ++i) {
    context.progress(fmt::format("cloud {} of {}", i + 1, clouds));
    const Seedling seedling = quarter_scene(context.seed(), i);
    const std::string hash = tree_hash(grow(seedling).skeleton);
    bool any = false;
    for (std::int32_t max_NG = 1; max_NG <= most_max_NG; ++max_NG) {
      const bool same = tree_hash(grow(resting(seedling, max_NG)).skeleton) == hash;
      any = any || same;
      safe_for[static_cast<std::size_t>(max_NG)] += same;
    }
    with_a_choice += any;
  }
  record_seeded(context, "choices/clouds", static_cast<std::int64_t>(clouds));
  record_seeded(context, "choices/clouds_with_a_safe_one", with_a_choice);
  record_seeded(context, "choices/safe_for_all_clouds",
                static_cast<std::int64_t>(std::count(safe_for.begin(), safe_for.end(), clouds)));
}

void run(ExperimentContext& context) {
  measure_released_points(context);
  measure_balanced_node(context);
  for (const std::int32_t max_NG : {1, 2, 3, 5, 10, 20})
    measure_clouds(context, "once", GrowthLimits::unlimited, max_NG);
  for (const std::int32_t max_NG : {1, 20}) measure_clouds(context, "max_grad-2", 2, max_NG);
  if (context.tier() == Tier::full) measure_choices(context);
}

}  // namespace

extern const ExperimentDescriptor released_points;
constinit const ExperimentDescriptor released_points{
    .id = "liebemann2017/released-points",
    .question = "Does the tree stay the same if nodes come to rest that still have points?",
    .source = "[Liebemann2017] sec. 3.5",
    .seconds = {0.3, 0.7, 3.0},
    .run = run,
};

}  // namespace phytobench::experiments::liebemann2017
