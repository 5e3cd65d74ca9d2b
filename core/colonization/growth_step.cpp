// SPDX-License-Identifier: MIT
#include "core/colonization/growth_step.hpp"

namespace phytobench {

GrowthStep::GrowthStep(const GrowthParameters& parameters)
    : parameters_(parameters),
      limit_(0.5 * parameters.perception_angle_rad),
      perception_(parameters.influence_distance, 0.5 * parameters.perception_angle_rad) {}

GrowthStep::Counts GrowthStep::grow(std::span<const Vector3> points, const Assignment& assignment,
                                    std::int32_t first, std::vector<SearchableNode>& nodes,
                                    Skeleton& skeleton) {
  Counts counts = sum_attractions(points, assignment, nodes);
  const GrowthVariant& variant = parameters_.variant;
  for (const NodeIndex parent : growing_) {
    const auto i = static_cast<std::size_t>(parent);
    is_growing_[i] = 0;
    const auto direction = growth_direction(sum_[i], parameters_.tropism, variant.tropism_order);
    if (!direction) continue;
    const Vector3 limited = limit_(*direction, nodes[i].direction);
    const Vector3 position = nodes[i].position + parameters_.step_length * limited;
    if (variant.repeat_guard == RepeatGuard::on &&
        skeleton.has_child_at(first + parent, position)) {
      ++counts.suppressed_repeats;
      continue;
    }
    skeleton.append(first + parent, position);
    nodes.push_back({position, limited});
  }
  return counts;
}

GrowthStep::Counts GrowthStep::sum_attractions(std::span<const Vector3> points,
                                               const Assignment& assignment,
                                               const std::vector<SearchableNode>& nodes) {
  Counts counts;
  const bool test_angle = parameters_.variant.perception_test == PerceptionTest::after_search;
  growing_.clear();
  sum_.resize(nodes.size());
  is_growing_.resize(nodes.size(), 0);
  for (std::size_t point = 0; point < points.size(); ++point) {
    const NodeIndex node = assignment.node[point];
    if (node == no_node) continue;
    const auto i = static_cast<std::size_t>(node);
    if (test_angle && !perception_.within_angle(nodes[i].position, nodes[i].direction,
                                                points[point], assignment.squared_distance[point]))
      continue;
    ++counts.associated_points;
    if (!is_growing_[i]) {
      is_growing_[i] = 1;
      sum_[i] = {};
      growing_.push_back(node);
    }
    sum_[i] =
        sum_[i] + attraction(nodes[i].position, points[point], parameters_.variant.attraction_sum);
  }
  return counts;
}

}  // namespace phytobench
