// SPDX-License-Identifier: MIT
#include "core/colonization/growth_step.hpp"

#include <algorithm>

#include "core/parallel/for_blocks.hpp"

namespace phytobench {

namespace {

constexpr std::int32_t not_growing = -1;

/// Points and nodes lie anywhere in memory: asked for so many steps before they are needed.
constexpr std::size_t steps_ahead = 16;

}  // namespace

GrowthStep::GrowthStep(const GrowthParameters& parameters, int threads)
    : parameters_(parameters),
      threads_(threads),
      limit_(0.5 * parameters.perception_angle_rad),
      perception_(parameters.influence_distance, 0.5 * parameters.perception_angle_rad) {}

GrowthStep::Counts GrowthStep::grow(std::span<const Vector3> points, const Assignment& assignment,
                                    std::int32_t first, std::vector<SearchableNode>& nodes,
                                    Skeleton& skeleton) {
  associated_.clear();
  assignment.associated.append_to(associated_);
  find_pulls(points, assignment, nodes);
  Counts counts = sum_pulls(nodes.size());
  find_children(first, nodes, skeleton);
  for (std::size_t i = 0; i < growing_.size(); ++i) {
    const Child& child = children_[i];
    counts.suppressed_repeats += child.fate == Fate::repeat;
    if (child.fate != Fate::grows) continue;
    skeleton.append(first + growing_[i].node, child.node.position);
    nodes.push_back(child.node);
  }
  return counts;
}

void GrowthStep::find_pulls(std::span<const Vector3> points, const Assignment& assignment,
                            const std::vector<SearchableNode>& nodes) {
  const AttractionSum kind = parameters_.variant.attraction_sum;
  const bool test_angle = parameters_.variant.perception_test == PerceptionTest::after_search;
  pulls_.resize(associated_.size());
  for_blocks(associated_.size(), threads_, [&](std::size_t begin, std::size_t end) {
    const auto ahead = [&](std::size_t i) {
      return static_cast<std::size_t>(associated_[std::min(i, end - 1)]);
    };
    for (std::size_t i = begin; i < end; ++i) {
      __builtin_prefetch(&points[ahead(i + 2 * steps_ahead)]);
      __builtin_prefetch(&assignment.node[ahead(i + 2 * steps_ahead)]);
      __builtin_prefetch(&nodes[static_cast<std::size_t>(assignment.node[ahead(i + steps_ahead)])]);
      const auto point = static_cast<std::size_t>(associated_[i]);
      const NodeIndex index = assignment.node[point];
      const SearchableNode& node = nodes[static_cast<std::size_t>(index)];
      const bool given_up =
          test_angle && !perception_.within_angle(node.position, node.direction, points[point],
                                                  squared_distance(node.position, points[point]));
      pulls_[i] = {attraction(node.position, points[point], kind), given_up ? no_node : index};
    }
  });
}

/// One thread, in the order of the points: rounding must not depend on how many threads there are.
GrowthStep::Counts GrowthStep::sum_pulls(std::size_t node_count) {
  Counts counts;
  growing_.clear();
  place_.resize(node_count, not_growing);
  for (const Pull& pull : pulls_) {
    if (pull.node == no_node) continue;
    ++counts.associated_points;
    std::int32_t& place = place_[static_cast<std::size_t>(pull.node)];
    if (place == not_growing) {
      place = static_cast<std::int32_t>(growing_.size());
      growing_.push_back({{}, pull.node});
    }
    Vector3& sum = growing_[static_cast<std::size_t>(place)].sum;
    sum = sum + pull.towards;
  }
  for (const GrowingNode& growing : growing_)
    place_[static_cast<std::size_t>(growing.node)] = not_growing;
  return counts;
}

void GrowthStep::find_children(std::int32_t first, const std::vector<SearchableNode>& nodes,
                               const Skeleton& skeleton) {
  children_.resize(growing_.size());
  for_blocks(growing_.size(), threads_, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const GrowingNode& soon = growing_[std::min(i + steps_ahead, end - 1)];
      __builtin_prefetch(&nodes[static_cast<std::size_t>(soon.node)]);
      skeleton.prefetch_children(first + soon.node);
      children_[i] = child_of(growing_[i], first, nodes, skeleton);
    }
  });
}

GrowthStep::Child GrowthStep::child_of(const GrowingNode& parent, std::int32_t first,
                                       const std::vector<SearchableNode>& nodes,
                                       const Skeleton& skeleton) const {
  const SearchableNode& node = nodes[static_cast<std::size_t>(parent.node)];
  const GrowthVariant& variant = parameters_.variant;
  const auto direction = growth_direction(parent.sum, parameters_.tropism, variant.tropism_order);
  if (!direction) return {{}, Fate::no_direction};
  const Vector3 limited = limit_(*direction, node.direction);
  const Vector3 position = node.position + parameters_.step_length * limited;
  const bool repeats = variant.repeat_guard == RepeatGuard::on &&
                       skeleton.has_child_at(first + parent.node, position);
  return {{position, limited}, repeats ? Fate::repeat : Fate::grows};
}

}  // namespace phytobench
