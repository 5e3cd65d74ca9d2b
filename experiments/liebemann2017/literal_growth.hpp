// SPDX-License-Identifier: MIT
// A scene for the literal loop, and whether that grows the same tree.
#pragma once

#include <cstdint>
#include <vector>

#include "core/tree/branches.hpp"
#include "experiments/liebemann2017/influence_scenes.hpp"
#include "reference/oracles/liebemann2017_space_colonization.hpp"

namespace phytobench::experiments::liebemann2017 {

/// The same scene for the literal loop.
inline oracles::liebemann2017::ColonizationProblem literal_scene(const Seedling& seedling) {
  namespace literal = oracles::liebemann2017;
  const GrowthParameters& growth = seedling.growth;
  const auto boundary_of = [](Boundary boundary) {
    return boundary == Boundary::inclusive ? literal::Boundary::within : literal::Boundary::outside;
  };
  literal::ColonizationProblem problem;
  for (const Vector3& s : seedling.attraction_points) problem.S.push_back({s.x, s.y, s.z});
  const Vector3 root = seedling.skeleton.position(0);
  problem.root = {root.x, root.y, root.z};
  problem.d_i = growth.influence_distance;
  problem.d_k = growth.kill_distance.begin;
  problem.D = growth.step_length;
  problem.T = {growth.tropism.x, growth.tropism.y, growth.tropism.z};
  problem.most_iterations = growth.iterations;
  problem.boundary = boundary_of(growth.variant.kill_boundary);
  if (growth.variant.tropism_order == TropismOrder::after_normalising)
    problem.tropism = literal::Tropism::added_to_the_unit_vector;
  problem.max_grad = growth.limits.most_children;
  problem.max_Z = growth.limits.most_branch_depth;
  if (growth.variant.repeat_guard == RepeatGuard::off) return problem;
  problem.same_successor_again = literal::SameSuccessorAgain::rejected;
  problem.zero_over_zero = literal::ZeroOverZero::skipped;
  problem.stop_at_standstill = true;
  return problem;
}

inline StopReason core_reason(oracles::liebemann2017::Stop stop, StopReason standstill) {
  using oracles::liebemann2017::Stop;
  if (stop == Stop::all_points_removed) return StopReason::no_points_left;
  if (stop == Stop::no_node_in_reach) return StopReason::no_point_in_range;
  if (stop == Stop::most_iterations) return StopReason::iteration_limit;
  return standstill;
}

/// Nodes of the literal tree that have no counterpart: a successor of their predecessor's
/// counterpart, at their place. Within one iteration the two make nodes in different orders, and
/// they sum up S(v) in different orders, so that places differ by rounding.
inline std::int64_t without_counterpart(const oracles::liebemann2017::ColonizedTree& literal,
                                        const Skeleton& skeleton) {
  const ChildLists children(skeleton);
  std::vector<std::int32_t> counterparts(literal.nodes.size(), Skeleton::no_parent);
  std::vector<bool> taken(skeleton.node_count(), false);
  counterparts[0] = 0;
  std::int64_t missing = literal.nodes[0] != oracles::liebemann2017::Point{skeleton.position(0).x,
                                                                           skeleton.position(0).y,
                                                                           skeleton.position(0).z};
  for (std::size_t v = 1; v < literal.nodes.size(); ++v) {
    const Vector3 place{literal.nodes[v].x, literal.nodes[v].y, literal.nodes[v].z};
    const auto predecessor = counterparts[static_cast<std::size_t>(literal.predecessors[v])];
    if (predecessor == Skeleton::no_parent) continue;
    for (const std::int32_t child : children.of(predecessor)) {
      if (taken[static_cast<std::size_t>(child)] || !same_place(skeleton.position(child), place))
        continue;
      taken[static_cast<std::size_t>(child)] = true;
      counterparts[v] = child;
      break;
    }
  }
  for (const std::int32_t counterpart : counterparts) missing += counterpart == Skeleton::no_parent;
  return missing;
}

/// The same, and one each for other points left, another number of nodes or another reason of
/// stopping.
inline std::int64_t differs_from_oracle(const Seedling& seedling, const GrowthResult& result) {
  const auto literal = oracles::liebemann2017::colonize(literal_scene(seedling));
  const bool refused = result.stop_reason == StopReason::no_child_allowed;
  const StopReason standstill = refused ? StopReason::no_child_allowed : StopReason::no_new_node;
  std::int64_t different = without_counterpart(literal, result.skeleton);
  different += literal.nodes.size() != result.skeleton.node_count();
  different += core_reason(literal.stop, standstill) != result.stop_reason;
  return different + (literal.left.size() != result.live_points);
}

}  // namespace phytobench::experiments::liebemann2017
