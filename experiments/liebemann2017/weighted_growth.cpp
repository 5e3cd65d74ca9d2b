// SPDX-License-Identifier: MIT
// Weighted growth of sec. 3.5: steps from twice D at branch depth 0 to D at the greatest one.
#include "core/colonization/branching_limits.hpp"
#include "core/contract/errors.hpp"
#include "experiments/liebemann2017/limited_growth.hpp"

namespace phytobench::experiments::liebemann2017 {

namespace {

Seedling weighted(Seedling seedling, std::int32_t max_Z) {
  seedling.growth.limits.most_branch_depth = max_Z;
  seedling.growth.limits.step_weighting = StepWeighting::by_branch_depth;
  return seedling;
}

/// A comb in which each node gets a successor that keeps its branch depth and one a level deeper.
void measure_steps(ExperimentContext& context, std::int32_t max_Z) {
  const GrowthParameters growth = weighted(scene({}, {}), max_Z).growth;
  BranchingLimits limits(growth);
  Skeleton comb{Vector3{}};
  std::vector<std::int32_t> of_depth{0};
  for (std::int32_t Z = 0; Z < max_Z; ++Z) {
    comb.append(of_depth.back(), {1, 0, 0});
    of_depth.push_back(comb.append(of_depth.back(), {0, 1, 0}));
  }
  limits.follow(comb);
  for (std::int32_t Z = 0; Z <= max_Z; ++Z)
    context.record(fmt::format("steps/max_Z-{}/Z-{}", max_Z, Z),
                   limits.step_length(of_depth[static_cast<std::size_t>(Z)]), "length");
}

/// Without a greatest branch depth above 0 there is nothing to interpolate between.
void measure_undefined(ExperimentContext& context) {
  for (const auto& [max_Z, name] :
       {std::pair{0, "max_Z-0"}, std::pair{GrowthLimits::unlimited, "unlimited"}}) {
    bool refused = false;
    try {
      grow(weighted(without_repeats(scene({{0, 60, 0}}, {})), max_Z));
    } catch (const ContractViolation&) {
      refused = true;
    }
    context.record(fmt::format("undefined/{}/refused", name), std::int64_t{refused});
    const double literal = oracles::liebemann2017::weighted_step(step_length, 0, max_Z);
    context.record(fmt::format("undefined/{}/printed_is_no_number", name),
                   std::int64_t{literal != literal});
  }
}

/// Trees: every step against the formula, by the branch depth of the node it starts from.
void measure_trees(ExperimentContext& context) {
  constexpr std::int32_t max_Z = 2;
  double off = 0.0, off_by_own_depth = 0.0;
  std::int64_t different = 0, not_fewer = 0, shorter = 0, edges[max_Z + 1] = {};
  for (std::uint64_t i = 0; i < clouds_of(context); ++i) {
    const Seedling plain = quarter_scene(context.seed(), i), seedling = weighted(plain, max_Z);
    const GrowthResult result = grow(seedling);
    const Skeleton& skeleton = result.skeleton;
    different += differs_from_literal(seedling, result);
    const std::vector<std::int32_t> Z = depths_at_creation(skeleton);
    for (std::size_t v = 1; v < skeleton.node_count(); ++v) {
      const std::int32_t parent = skeleton.parents()[v];
      const std::int32_t depth = Z[static_cast<std::size_t>(parent)];
      const double step = norm(skeleton.positions()[v] - skeleton.position(parent));
      const auto expected = [&](std::int32_t at) { return step_length * (2.0 - 0.5 * at); };
      off = std::max(off, std::abs(step - expected(depth)));
      off_by_own_depth = std::max(off_by_own_depth, std::abs(step - expected(Z[v])));
      shorter += step < step_length - 1e-9;
      ++edges[depth];
    }
    Seedling unweighted = seedling;
    unweighted.growth.limits.step_weighting = StepWeighting::none;
    not_fewer += nodes_of(result) >= nodes_of(grow(unweighted));
  }
  for (std::int32_t Z = 0; Z <= max_Z; ++Z)
    record_seeded(context, fmt::format("trees/steps_from/Z-{}", Z), edges[Z]);
  record_seeded(context, "trees/step_off", off, "length");
  record_seeded(context, "trees/step_off_by_own_depth", off_by_own_depth, "length");
  record_seeded(context, "trees/steps_shorter_than_D", shorter);
  record_seeded(context, "trees/not_fewer_nodes", not_fewer);
  record_seeded(context, "trees/differs_from_oracle", different);
}

/// A step of D ends on the point; one of 2 D jumps over it, and no node comes within d_k any more.
void measure_jump(ExperimentContext& context) {
  Seedling seedling = scene({{0, 45, 0}}, {}, 50);
  seedling.growth.step_length = 45.0;
  const Seedling far = weighted(seedling, 1);
  for (const auto& [name, made] : {std::pair{"plain", seedling}, std::pair{"weighted", far},
                                   std::pair{"weighted-without-repeats", without_repeats(far)}}) {
    const GrowthResult result = grow(made);
    context.record(fmt::format("jump/{}/nodes", name), nodes_of(result));
    context.record(fmt::format("jump/{}/points_left", name),
                   static_cast<std::int64_t>(result.live_points));
  }
}

void run(ExperimentContext& context) {
  for (const std::int32_t max_Z : {1, 4}) measure_steps(context, max_Z);
  measure_undefined(context);
  measure_trees(context);
  measure_jump(context);
}

}  // namespace

extern const ExperimentDescriptor weighted_growth;
constinit const ExperimentDescriptor weighted_growth{
    .id = "liebemann2017/weighted-growth",
    .question = "How long are the steps of weighted growth, and when are they undefined?",
    .source = "[Liebemann2017] sec. 3.5",
    .seconds = {0.2, 0.4, 0.8},
    .run = run,
};

}  // namespace phytobench::experiments::liebemann2017
