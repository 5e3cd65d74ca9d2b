// SPDX-License-Identifier: MIT
// The conditions max_grad and max_Z of sec. 3.5.
#include "experiments/liebemann2017/limited_growth.hpp"

namespace phytobench::experiments::liebemann2017 {

namespace {

/// What the trees of all clouds under one limit add up to.
struct Limited {
  std::int64_t greatest = 0, refused = 0, forbidden_nodes = 0, different = 0,
               refused_at_the_end = 0;

  void add(const Seedling& seedling, const GrowthResult& result) {
    for (const PassStatistics& pass : result.passes)
      refused += static_cast<std::int64_t>(pass.refused_children);
    different += differs_from_literal(seedling, result);
    refused_at_the_end += result.stop_reason == StopReason::no_child_allowed;
  }
  void record(ExperimentContext& context, const std::string& name, bool always_binds) const {
    record_seeded(context, name + "/greatest", greatest);
    record_seeded(context, name + "/forbidden_nodes", forbidden_nodes);
    record_seeded(context, name + "/differs_from_oracle", different);
    if (!always_binds) return;
    record_seeded(context, name + "/refused", refused);
    record_seeded(context, name + "/refused_at_the_end", refused_at_the_end);
  }
};

void measure_max_grad(ExperimentContext& context, std::int32_t max_grad) {
  Limited limited;
  for (std::uint64_t i = 0; i < clouds_of(context); ++i) {
    Seedling seedling = quarter_scene(context.seed(), i);
    seedling.growth.limits.most_children = max_grad;
    const GrowthResult result = grow(seedling);
    const ChildLists successors(result.skeleton);
    for (std::int32_t v = 0; v < static_cast<std::int32_t>(result.skeleton.node_count()); ++v)
      limited.forbidden_nodes += static_cast<std::int32_t>(successors.of(v).size()) > max_grad;
    limited.greatest = std::max(limited.greatest, greatest_degree(result.skeleton));
    limited.add(seedling, result);
  }
  limited.record(context, fmt::format("max_grad-{}", max_grad), max_grad <= 2);
}

void measure_max_Z(ExperimentContext& context, std::int32_t max_Z) {
  Limited limited;
  std::int64_t other_than_one_branch = 0;
  for (std::uint64_t i = 0; i < clouds_of(context); ++i) {
    Seedling seedling = quarter_scene(context.seed(), i);
    Seedling one_branch = seedling;
    seedling.growth.limits.most_branch_depth = max_Z;
    const GrowthResult result = grow(seedling);
    for (const std::int32_t Z : depths_at_creation(result.skeleton))
      limited.forbidden_nodes += Z > max_Z;
    limited.greatest = std::max(limited.greatest, greatest_Z(result.skeleton));
    limited.add(seedling, result);
    one_branch.growth.limits.most_children = 1;
    other_than_one_branch += tree_hash(result.skeleton) != tree_hash(grow(one_branch).skeleton);
  }
  limited.record(context, fmt::format("max_Z-{}", max_Z), max_Z <= 1);
  if (max_Z == 0) record_seeded(context, "max_Z-0/other_than_max_grad-1", other_than_one_branch);
}

/// A limit that a free tree just keeps changes nothing.
void measure_kept_limits(ExperimentContext& context) {
  std::int64_t other_degree = 0, other_Z = 0, degree = 0, Z = 0;
  for (std::uint64_t i = 0; i < clouds_of(context); ++i) {
    Seedling seedling = quarter_scene(context.seed(), i);
    const Skeleton free = grow(seedling).skeleton;
    degree = std::max(degree, greatest_degree(free));
    Z = std::max(Z, greatest_Z(free));
    seedling.growth.limits.most_children = static_cast<std::int32_t>(greatest_degree(free));
    other_degree += tree_hash(grow(seedling).skeleton) != tree_hash(free);
    seedling.growth.limits = {};
    seedling.growth.limits.most_branch_depth = static_cast<std::int32_t>(greatest_Z(free));
    other_Z += tree_hash(grow(seedling).skeleton) != tree_hash(free);
  }
  record_seeded(context, "clouds", static_cast<std::int64_t>(clouds_of(context)));
  record_seeded(context, "free/greatest_degree", degree);
  record_seeded(context, "free/greatest_Z", Z);
  record_seeded(context, "limit-of-the-free-tree/max_grad/other_trees", other_degree);
  record_seeded(context, "limit-of-the-free-tree/max_Z/other_trees", other_Z);
}

/// The root grows towards two points above; it is nearest to the one below, and may not grow again.
void measure_refused_node(ExperimentContext& context) {
  Seedling seedling = without_repeats(scene({{0, 60, 0}, {0, 61, 0}, {0, -30, 0}}, {}));
  for (const std::int32_t max_grad : {1, 2}) {
    seedling.growth.limits.most_children = max_grad;
    const GrowthResult result = grow(seedling);
    const std::string name = fmt::format("refused-node/max_grad-{}/", max_grad);
    context.record(name + "points_left", static_cast<std::int64_t>(result.live_points));
    context.record(name + "stop", stop_of(result));
  }
}

/// The literal loop with a greatest degree of 1: none of the three reasons of sec. 3.3 is that
/// nothing may grow, so it goes on until its limit of iterations.
void measure_idle_iterations(ExperimentContext& context) {
  Seedling seedling = quarter_scene(context.seed(), 0);
  seedling.growth.limits.most_children = 1;
  const GrowthResult result = grow(seedling);
  auto problem = literal_scene(seedling);
  problem.stop_at_standstill = false;
  const auto literal = oracles::liebemann2017::colonize(problem);
  record_seeded(context, "idle/iterations_as_printed", std::int64_t{literal.iterations});
  record_seeded(context, "idle/last_iteration_that_grew", iterations_that_grew(result));
  record_seeded(context, "idle/more_nodes",
                static_cast<std::int64_t>(literal.nodes.size()) - nodes_of(result));
}

/// With repeated successors, which growth as printed rarely ends with: does a limit end it?
void measure_printed_growth(ExperimentContext& context) {
  std::int64_t limited_ends = 0, greatest = 0;
  for (std::uint64_t i = 0; i < clouds_of(context); ++i) {
    Seedling seedling = quarter_scene(context.seed(), i);
    seedling.growth.variant.repeat_guard = RepeatGuard::off;
    seedling.growth.limits.most_children = 3;
    const GrowthResult result = grow(seedling);
    limited_ends += result.stop_reason != StopReason::iteration_limit;
    greatest = std::max(greatest, greatest_degree(result.skeleton));
  }
  record_seeded(context, "printed-max_grad-3/ends", limited_ends);
  record_seeded(context, "printed-max_grad-3/greatest_degree", greatest);
}

void run(ExperimentContext& context) {
  for (const std::int32_t max_grad : {1, 2, 3}) measure_max_grad(context, max_grad);
  for (const std::int32_t max_Z : {0, 1, 2}) measure_max_Z(context, max_Z);
  measure_kept_limits(context);
  measure_refused_node(context);
  measure_idle_iterations(context);
  measure_printed_growth(context);
}

}  // namespace

extern const ExperimentDescriptor limits_of_growth;
constinit const ExperimentDescriptor limits_of_growth{
    .id = "liebemann2017/limits-of-growth",
    .question =
        "Do a greatest degree and a greatest branch depth hold, and what do they do to a tree?",
    .source = "[Liebemann2017] sec. 3.5",
    .seconds = {0.3, 0.8, 2.0},
    .run = run,
};

}  // namespace phytobench::experiments::liebemann2017
