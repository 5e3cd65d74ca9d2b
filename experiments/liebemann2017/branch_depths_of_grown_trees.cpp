// SPDX-License-Identifier: MIT
// Eq. 3.5 on trees that grow among random points: when branch depths are found, and what they are
// not.
#include "experiments/liebemann2017/literal_branch_depths.hpp"

namespace phytobench::experiments::liebemann2017 {

namespace {

using enum BranchDepthReading;

/// Every edge in two: nodes of the tree whose branch depth is another one then.
std::int64_t changed_by_subdivision(const Skeleton& tree) {
  const std::vector<std::int32_t> depths = depths_at_creation(tree);
  Skeleton finer(tree.position(0));
  std::vector<std::int32_t> same{0};
  for (std::size_t v = 1; v < tree.node_count(); ++v) {
    const Vector3 here = tree.positions()[v], below = tree.position(tree.parents()[v]);
    const std::int32_t parent = same[static_cast<std::size_t>(tree.parents()[v])];
    same.push_back(finer.append(finer.append(parent, 0.5 * (here + below)), here));
  }
  const std::vector<std::int32_t> finer_depths = depths_at_creation(finer);
  std::int64_t changed = 0;
  for (std::size_t v = 0; v < depths.size(); ++v)
    changed += finer_depths[static_cast<std::size_t>(same[v])] != depths[v];
  return changed;
}

/// What grown trees add up to.
struct Sums {
  std::int64_t nodes = 0, different = 0, above_depth = 0, not_the_depth = 0, wrong_step = 0,
               created_changed = 0, finished_changed = 0, subdivision = 0;
};

/// Branch depths of the nodes after 20 iterations, and later.
std::int64_t changed_later(const Skeleton& early, const Skeleton& late,
                           BranchDepthReading reading) {
  const std::vector<std::int32_t> before = branch_depths(early, reading),
                                  after = branch_depths(late, reading);
  std::int64_t changed = 0;
  for (std::size_t v = 0; v < before.size(); ++v) changed += before[v] != after.at(v);
  return changed;
}

void add_grown_tree(const Seedling& seedling, Sums& sums) {
  const Skeleton skeleton = grow(seedling).skeleton;
  const std::vector<std::int32_t> Z = depths_at_creation(skeleton), depths = node_depths(skeleton);
  sums.nodes += static_cast<std::int64_t>(skeleton.node_count());
  sums.different += other_branch_depths(skeleton);
  sums.subdivision += changed_by_subdivision(skeleton);
  for (std::size_t v = 0; v < Z.size(); ++v) {
    sums.above_depth += Z[v] > depths[v];
    sums.not_the_depth += Z[v] != depths[v];
    if (v == 0) continue;
    const std::int32_t deeper = Z[v] - Z[static_cast<std::size_t>(skeleton.parents()[v])];
    sums.wrong_step += deeper != 0 && deeper != 1;
  }
  Seedling shorter = seedling;
  shorter.growth.iterations = 20;
  const Skeleton early = grow(shorter).skeleton;
  sums.created_changed += changed_later(early, skeleton, at_creation);
  sums.finished_changed += changed_later(early, skeleton, finished_tree);
}

void run(ExperimentContext& context) {
  Sums sums;
  for (std::uint64_t i = 0; i < clouds_of(context); ++i)
    add_grown_tree(quarter_scene(context.seed(), i), sums);
  record_seeded(context, "nodes", sums.nodes);
  record_seeded(context, "differs_from_oracle", sums.different);
  record_seeded(context, "Z_above_depth", sums.above_depth);
  record_seeded(context, "Z_is_not_the_depth", sums.not_the_depth);
  record_seeded(context, "steps_neither_0_nor_1", sums.wrong_step);
  record_seeded(context, "changed_later/at_creation", sums.created_changed);
  record_seeded(context, "changed_later/finished", sums.finished_changed);
  record_seeded(context, "changed_by_subdivision", sums.subdivision);
}

}  // namespace

extern const ExperimentDescriptor branch_depths_of_grown_trees;
constinit const ExperimentDescriptor branch_depths_of_grown_trees{
    .id = "liebemann2017/branch-depths-of-grown-trees",
    .question = "Does it matter when the branch depth of a node is found?",
    .source = "[Liebemann2017] sec. 3.5, eq. 3.5",
    .seconds = {0.05, 0.1, 0.2},
    .run = run,
};

}  // namespace phytobench::experiments::liebemann2017
