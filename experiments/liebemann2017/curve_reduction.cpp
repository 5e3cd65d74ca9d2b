// SPDX-License-Identifier: MIT
// Curve reduction of sec. 3.5, eq. 3.6, on grown trees.
#include "core/tree/habit.hpp"
#include "experiments/liebemann2017/limited_growth.hpp"
#include "experiments/liebemann2017/reduction_orders.hpp"

namespace phytobench::experiments::liebemann2017 {

namespace {

namespace literal = oracles::liebemann2017;

/// What must not happen to a tree, and how much of it goes.
struct Sums {
  std::int64_t forks = 0, tips = 0, roots = 0, removed_others = 0, moved = 0,
               wrong_predecessors = 0, different = 0, nodes = 0, left = 0;
};

void add(const Skeleton& tree, double cosine, ReductionOrder order, Sums& sums) {
  const ReducedSkeleton less = reduced(tree, cosine, order);
  const ChildLists successors(tree);
  sums.forks += branching_count(tree) != branching_count(less.skeleton);
  sums.tips += tip_count(tree) != tip_count(less.skeleton);
  sums.roots += less.node_after[0] != 0;
  for (std::size_t v = 0; v < tree.node_count(); ++v) {
    const std::int32_t now = less.node_after[v];
    if (now == ReducedSkeleton::removed) {
      sums.removed_others += v == 0 || successors.of(static_cast<std::int32_t>(v)).size() != 1;
      continue;
    }
    sums.moved += less.skeleton.position(now) != tree.positions()[v];
    std::int32_t ancestor = tree.parents()[v];
    while (ancestor >= 0 && less.node_after[static_cast<std::size_t>(ancestor)] < 0)
      ancestor = tree.parents()[static_cast<std::size_t>(ancestor)];
    const std::int32_t parent = less.skeleton.parents()[static_cast<std::size_t>(now)];
    sums.wrong_predecessors +=
        (parent < 0 ? parent : less.node_before[static_cast<std::size_t>(parent)]) != ancestor;
  }
  literal::PlacedTree placed;
  for (const Vector3& p : tree.positions()) placed.nodes.push_back({p.x, p.y, p.z});
  placed.predecessors.assign(tree.parents().begin(), tree.parents().end());
  const auto kept = literal::kept_nodes(placed, cosine, literal_order(order));
  sums.different += std::vector<std::int32_t>(kept.begin(), kept.end()) != less.node_before;
  sums.nodes += static_cast<std::int64_t>(tree.node_count());
  sums.left += static_cast<std::int64_t>(less.skeleton.node_count());
}

void measure_trees(ExperimentContext& context) {
  std::int64_t more_at_smaller_cosine = 0;
  for (const auto& [order, name] : orders) {
    Sums sums;
    for (std::uint64_t i = 0; i < clouds_of(context); ++i) {
      const Skeleton tree = grow(quarter_scene(context.seed(), i)).skeleton;
      std::int64_t last = 0;
      for (const double cosine : {0.7, 0.9, 0.95, 0.99}) {
        add(tree, cosine, order, sums);
        const std::int64_t left = nodes_left(tree, cosine, order);
        more_at_smaller_cosine += order == ReductionOrder::simultaneous && left < last;
        last = left;
      }
    }
    const std::string tree = fmt::format("trees/{}/", name);
    record_seeded(context, tree + "forks_changed", sums.forks);
    record_seeded(context, tree + "tips_changed", sums.tips);
    record_seeded(context, tree + "roots_removed", sums.roots);
    record_seeded(context, tree + "removed_without_one_successor", sums.removed_others);
    record_seeded(context, tree + "moved", sums.moved);
    record_seeded(context, tree + "wrong_predecessors", sums.wrong_predecessors);
    record_seeded(context, tree + "differs_from_oracle", sums.different);
    record_seeded(context, tree + "share_of_nodes_left",
                  static_cast<double>(sums.left) / static_cast<double>(sums.nodes));
  }
  record_seeded(context, "trees/at_once/more_left_at_smaller_cosine", more_at_smaller_cosine);
}

void run(ExperimentContext& context) {
  measure_trees(context);
}

}  // namespace

extern const ExperimentDescriptor curve_reduction;
constinit const ExperimentDescriptor curve_reduction{
    .id = "liebemann2017/curve-reduction",
    .question = "What does curve reduction leave of a tree?",
    .source = "[Liebemann2017] sec. 3.5, eq. 3.6",
    .seconds = {0.2, 0.4, 0.8},
    .run = run,
};

}  // namespace phytobench::experiments::liebemann2017
