// SPDX-License-Identifier: MIT
// Sec. 2.2: strands that run from the root to every tip, on the skeleton of the bush.
// Cross-sections are those of the pipe model with exponent 2, da Vinci's rule.
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/lsystem/drawing_plant.hpp"
#include "core/tree/branches.hpp"
#include "experiments/experiment.hpp"
#include "experiments/lintermann1997/bush.hpp"

namespace phytobench::experiments::lintermann1997 {

namespace {

/// Tips above each node, one for a tip itself: the strands that pass it.
std::vector<double> strands_of(const Skeleton& skeleton) {
  const ChildLists children(skeleton);
  std::vector<double> strands(skeleton.node_count(), 0.0);
  for (std::size_t node = skeleton.node_count(); node-- > 0;) {
    if (children.of(static_cast<std::int32_t>(node)).empty()) strands[node] = 1.0;
    const std::int32_t parent = skeleton.parents()[node];
    if (parent != Skeleton::no_parent) strands[static_cast<std::size_t>(parent)] += strands[node];
  }
  return strands;
}

void run(ExperimentContext& context) {
  const LSystem system = bush_system(bush_of_the_book());
  const TurtleTree tree = turtle_tree(system, derived(system, 5));
  const Skeleton& skeleton = tree.skeleton;
  DrawingPlantOptions options;
  options.radii = BranchRadii::pipe_model;
  options.radius_exponent = 2.0;
  options.tip_radius = 1.0;
  const std::vector<double> radii = drawing_radii(tree, options);
  const std::vector<double> strands = strands_of(skeleton);
  const ChildLists children(skeleton);
  double lost_at_forks = 0.0, from_strands = 0.0;
  std::int64_t forks = 0;
  for (std::size_t node = 0; node < radii.size(); ++node) {
    const double section = radii[node] * radii[node];
    from_strands = std::max(from_strands, std::abs(section / strands[node] - 1.0));
    double above = 0.0;
    const auto& above_nodes = children.of(static_cast<std::int32_t>(node));
    for (const std::int32_t child : above_nodes)
      above += radii[static_cast<std::size_t>(child)] * radii[static_cast<std::size_t>(child)];
    if (above_nodes.size() > 1) ++forks;
    if (!above_nodes.empty())
      lost_at_forks = std::max(lost_at_forks, std::abs(above / section - 1));
  }
  context.record("tips", static_cast<std::int64_t>(tip_count(skeleton)));
  context.record("forks", forks);
  context.record("strands_at_the_root", strands.at(0));
  context.record("section_of_the_root", radii.at(0) * radii.at(0));
  context.record("largest_share_of_section_lost_at_a_fork", lost_at_forks);
  context.record("largest_difference_of_section_per_strand", from_strands);
}

}  // namespace

extern const ExperimentDescriptor strands;
constinit const ExperimentDescriptor strands{
    .id = "lintermann1997/strands",
    .question = "Does a branch's cross-section follow the number of strands in it?",
    .source = "[Lintermann1997] sec. 2.2",
    .seconds = {0.1, 0.1, 0.1},
    .run = run,
};

}  // namespace phytobench::experiments::lintermann1997
