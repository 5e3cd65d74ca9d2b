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

void GrowthStep::reserve(std::size_t node_count) {
  place_.reserve(node_count);
  last_step_.reserve(node_count);
}

GrowthStep::Counts GrowthStep::grow(std::span<const Vector3> points, const Assignment& assignment,
                                    std::int32_t first, LargeVector<SearchableNode>& nodes,
                                    Skeleton& skeleton) {
  Counts counts{.associated_points = find_growing(points, assignment, nodes)};
  note_changes();
  sum_pulls(points, nodes);
  find_children(first, nodes, skeleton);
  for (std::size_t i = 0; i < growing_.size(); ++i) {
    const Child& child = children_[i];
    last_step_[static_cast<std::size_t>(growing_[i].node)] = {growing_[i].points, child.fate};
    counts.suppressed_repeats += child.fate == Fate::repeat;
    if (child.fate != Fate::grows) continue;
    skeleton.append(first + growing_[i].node, child.node.position);
    nodes.push_back(child.node);
  }
  return counts;
}

bool GrowthStep::is_given_up(const Vector3& point, const SearchableNode& node) const {
  return parameters_.variant.perception_test == PerceptionTest::after_search &&
         !perception_.within_angle(node.position, node.direction, point,
                                   squared_distance(node.position, point));
}

/// Lists the nodes with points in the order of their lowest point. Returns the number of points.
std::size_t GrowthStep::find_growing(std::span<const Vector3> points, const Assignment& assignment,
                                     std::span<const SearchableNode> nodes) {
  associated_.clear();
  assignment.associated.append_to(associated_);
  find_nodes(assignment);
  attracting_.clear();
  growing_.clear();
  place_.resize(nodes.size(), not_growing);
  last_step_.resize(nodes.size());
  for (std::size_t i = 0; i < associated_.size(); ++i) {
    const NodeIndex soon = node_of_associated_[std::min(i + steps_ahead, associated_.size() - 1)];
    __builtin_prefetch(&place_[static_cast<std::size_t>(soon)], 1);
    const PointIndex point = associated_[i];
    const NodeIndex node = node_of_associated_[i];
    if (is_given_up(points[static_cast<std::size_t>(point)], nodes[static_cast<std::size_t>(node)]))
      continue;
    std::int32_t& place = place_[static_cast<std::size_t>(node)];
    if (place == not_growing) {
      place = static_cast<std::int32_t>(growing_.size());
      growing_.push_back({{}, node, 0, true});
    }
    ++growing_[static_cast<std::size_t>(place)].points;
    attracting_.push_back({point, place});
  }
  for (const GrowingNode& growing : growing_)
    place_[static_cast<std::size_t>(growing.node)] = not_growing;
  return attracting_.size();
}

void GrowthStep::find_nodes(const Assignment& assignment) {
  node_of_associated_.resize(associated_.size());
  for_blocks(associated_.size(), threads_, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const PointIndex soon = associated_[std::min(i + steps_ahead, end - 1)];
      __builtin_prefetch(&assignment.node[static_cast<std::size_t>(soon)]);
      node_of_associated_[i] = assignment.node[static_cast<std::size_t>(associated_[i])];
    }
  });
}

/// A node gets points only when it is new; later it loses some to newer nodes or to removal. So if
/// it has as many as at its last step, it has the same, would grow the same child, and that stands
/// there already.
void GrowthStep::note_changes() {
  if (parameters_.variant.repeat_guard == RepeatGuard::off) return;
  for (std::size_t i = 0; i < growing_.size(); ++i) {
    const NodeIndex soon = growing_[std::min(i + steps_ahead, growing_.size() - 1)].node;
    __builtin_prefetch(&last_step_[static_cast<std::size_t>(soon)], 1);
    GrowingNode& growing = growing_[i];
    growing.changed = growing.points != last_step_[static_cast<std::size_t>(growing.node)].points;
  }
  std::erase_if(attracting_, [this](const Attracting& attracting) {
    return !growing_[static_cast<std::size_t>(attracting.place)].changed;
  });
}

void GrowthStep::sum_pulls(std::span<const Vector3> points, std::span<const SearchableNode> nodes) {
  const AttractionSum kind = parameters_.variant.attraction_sum;
  pulls_.resize(attracting_.size());
  for_blocks(attracting_.size(), threads_, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const PointIndex soon = attracting_[std::min(i + steps_ahead, end - 1)].point;
      __builtin_prefetch(&points[static_cast<std::size_t>(soon)]);
      const Attracting& attracting = attracting_[i];
      const NodeIndex node = growing_[static_cast<std::size_t>(attracting.place)].node;
      pulls_[i] = attraction(nodes[static_cast<std::size_t>(node)].position,
                             points[static_cast<std::size_t>(attracting.point)], kind);
    }
  });
  // One thread, in the order of the points: rounding must not depend on how many there are.
  for (std::size_t i = 0; i < attracting_.size(); ++i) {
    Vector3& sum = growing_[static_cast<std::size_t>(attracting_[i].place)].sum;
    sum = sum + pulls_[i];
  }
}

void GrowthStep::find_children(std::int32_t first, std::span<const SearchableNode> nodes,
                               const Skeleton& skeleton) {
  children_.resize(growing_.size());
  for_blocks(growing_.size(), threads_, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const GrowingNode& soon = growing_[std::min(i + steps_ahead, end - 1)];
      if (soon.changed) {
        __builtin_prefetch(&nodes[static_cast<std::size_t>(soon.node)]);
        skeleton.prefetch_children(first + soon.node);
      }
      children_[i] = child_of(growing_[i], first, nodes, skeleton);
    }
  });
}

GrowthStep::Child GrowthStep::child_of(const GrowingNode& parent, std::int32_t first,
                                       std::span<const SearchableNode> nodes,
                                       const Skeleton& skeleton) const {
  if (!parent.changed) {
    const Fate last = last_step_[static_cast<std::size_t>(parent.node)].fate;
    return {{}, last == Fate::no_direction ? last : Fate::repeat};
  }
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
