// SPDX-License-Identifier: MIT
// Listing 1: how many segments and leaves the recursive definition of a tree gives.
#include "core/tree/recursive_tree.hpp"

#include <cmath>

#include <fmt/format.h>

#include "core/tree/branches.hpp"
#include "experiments/experiment.hpp"

namespace phytobench::experiments::brzoska2019 {

namespace {

/// Stem and branches shrink alike, so that all segments of level k are the first too small ones.
RecursiveTree tree_of_levels(int branches, int levels) {
  return grow_recursive_tree({.smallest = std::pow(0.5, levels - 0.5),
                              .branches = branches,
                              .stem_ratio = 0.5,
                              .branch_ratio = 0.5});
}

void run(ExperimentContext& context) {
  std::int64_t leaves_with_children = 0, ends_without_leaf = 0;
  for (int n = 1; n <= 4; ++n)
    for (int k = 0; k <= 6; ++k) {
      const RecursiveTree tree = tree_of_levels(n, k);
      const std::string name = fmt::format("n-{}/k-{}/", n, k);
      context.record(name + "segments", static_cast<std::int64_t>(tree.skeleton.edge_count()));
      context.record(name + "leaves", static_cast<std::int64_t>(tree.leaf_nodes.size()));
      const ChildLists children(tree.skeleton);
      for (const std::int32_t node : tree.leaf_nodes)
        leaves_with_children += !children.of(node).empty();
      ends_without_leaf += static_cast<std::int64_t>(tip_count(tree.skeleton)) -
                           static_cast<std::int64_t>(tree.leaf_nodes.size());
    }
  context.record("leaves_with_children", leaves_with_children);
  context.record("ends_without_leaf", ends_without_leaf);
}

}  // namespace

extern const ExperimentDescriptor recursive_tree;
constinit const ExperimentDescriptor recursive_tree{
    .id = "brzoska2019/recursive-tree",
    .question = "How many segments and leaves does the recursive definition of a tree give?",
    .source = "[Brzoska2019] sec. 3.4.1, listing 1",
    .seconds = {1, 1, 1},
    .run = run,
};

}  // namespace phytobench::experiments::brzoska2019
