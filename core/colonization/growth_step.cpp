// SPDX-License-Identifier: MIT
#include "core/colonization/growth_step.hpp"

#include <algorithm>

#include "core/parallel/for_blocks.hpp"

namespace phytobench {

namespace {

constexpr std::int32_t not_growing = -1;

/// Points and nodes lie anywhere in memory: asked for so many steps before they are needed.
constexpr std::size_t steps_ahead = 16;

/// Every share reads the list of all points.
constexpr int most_shares = 16;

/// Points that have a node lie unevenly.
constexpr std::size_t parts_per_share = 4;

/// Nodes that share cache lines stay together; new nodes, which have most of the points, do not.
constexpr NodeIndex nodes_together = 64;

}  // namespace

GrowthStep::GrowthStep(const GrowthParameters& parameters, int threads)
    : parameters_(parameters),
      threads_(threads),
      limit_(0.5 * parameters.perception_angle_rad),
      perception_(parameters.influence_distance, 0.5 * parameters.perception_angle_rad),
      limits_(parameters),
      shares_(static_cast<std::size_t>(std::clamp(threads, 1, most_shares))) {
  associated_.resize(shares_.size() == 1 ? 1 : parts_per_share * shares_.size());
}

void GrowthStep::reserve(std::size_t node_count) {
  place_.reserve(node_count);
  last_step_.reserve(node_count);
}

GrowthStep::Counts GrowthStep::grow(std::span<const Vector3> points, const Assignment& assignment,
                                    std::int32_t first, LargeVector<SearchableNode>& nodes,
                                    Skeleton& skeleton) {
  find_nodes(assignment);
  limits_.follow(skeleton);
  place_.resize(nodes.size(), not_growing);
  last_step_.resize(nodes.size());
  for_tasks(shares_.size(), threads_, [&](std::size_t number) {
    Share& share = shares_[number];
    grow_share(share, associated_of(share, number), points, first, nodes, skeleton);
  });
  Counts counts;
  for (const Associated& part : associated_) counts.assigned_points += part.points.size();
  for (const Share& share : shares_) {
    counts.associated_points += share.counts.associated_points;
    counts.suppressed_repeats += share.counts.suppressed_repeats;
    counts.refused_children += share.counts.refused_children;
  }
  append_children(first, nodes, skeleton);
  return counts;
}

void GrowthStep::find_nodes(const Assignment& assignment) {
  for_tasks(associated_.size(), threads_, [&](std::size_t part) {
    auto& [points, nodes] = associated_[part];
    points.clear();
    assignment.associated.append_part_to(points, part, associated_.size());
    nodes.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const PointIndex soon = points[std::min(i + steps_ahead, points.size() - 1)];
      __builtin_prefetch(&assignment.node[static_cast<std::size_t>(soon)]);
      nodes[i] = assignment.node[static_cast<std::size_t>(points[i])];
    }
  });
}

const GrowthStep::Associated& GrowthStep::associated_of(Share& share, std::size_t number) const {
  if (shares_.size() == 1) return associated_.front();
  const auto count = static_cast<NodeIndex>(shares_.size());
  auto& [points, nodes] = share.associated;
  std::size_t chosen = 0;
  for (const Associated& part : associated_) {
    points.resize(chosen + part.points.size());
    nodes.resize(points.size());
    for (std::size_t i = 0; i < part.points.size(); ++i) {
      points[chosen] = part.points[i];  // in any case: whose node comes next is anybody's guess
      nodes[chosen] = part.nodes[i];
      chosen += static_cast<std::size_t>(part.nodes[i] / nodes_together % count) == number;
    }
  }
  points.resize(chosen);
  nodes.resize(chosen);
  return share.associated;
}

void GrowthStep::grow_share(Share& share, const Associated& associated,
                            std::span<const Vector3> points, std::int32_t first,
                            std::span<const SearchableNode> nodes, const Skeleton& skeleton) {
  share.counts = {};
  find_growing(share, associated, points, nodes);
  note_changes(share);
  sum_pulls(share, points, nodes);
  find_children(share, first, nodes, skeleton);
}

bool GrowthStep::is_given_up(const Vector3& point, const SearchableNode& node) const {
  return parameters_.variant.perception_test == PerceptionTest::after_search &&
         !perception_.within_angle(node.position, node.direction, point,
                                   squared_distance(node.position, point));
}

/// Lists the nodes with points in the order of their lowest point.
void GrowthStep::find_growing(Share& share, const Associated& associated,
                              std::span<const Vector3> points,
                              std::span<const SearchableNode> nodes) {
  const auto& [own_points, own_nodes] = associated;
  share.attracting.clear();
  share.growing.clear();
  for (std::size_t i = 0; i < own_points.size(); ++i) {
    const NodeIndex soon = own_nodes[std::min(i + steps_ahead, own_nodes.size() - 1)];
    __builtin_prefetch(&place_[static_cast<std::size_t>(soon)], 1);
    const PointIndex point = own_points[i];
    const NodeIndex node = own_nodes[i];
    if (is_given_up(points[static_cast<std::size_t>(point)], nodes[static_cast<std::size_t>(node)]))
      continue;
    std::int32_t& place = place_[static_cast<std::size_t>(node)];
    if (place == not_growing) {
      place = static_cast<std::int32_t>(share.growing.size());
      share.growing.push_back({{}, node, point, 0, true});
    }
    ++share.growing[static_cast<std::size_t>(place)].points;
    share.attracting.push_back({point, place});
  }
  share.counts.associated_points = share.attracting.size();
  for (const GrowingNode& growing : share.growing)
    place_[static_cast<std::size_t>(growing.node)] = not_growing;
}

/// A node gets points only when it is new; later it loses some to newer nodes or to removal. So if
/// it has as many as at its last step, it has the same, would grow the same child, and that stands
/// there already. Where nodes rest that does not hold: theirs go to others.
void GrowthStep::note_changes(Share& share) const {
  if (parameters_.variant.repeat_guard == RepeatGuard::off) return;
  if (parameters_.limits.rest_iterations != GrowthLimits::unlimited) return;
  std::vector<GrowingNode>& growing = share.growing;
  for (std::size_t i = 0; i < growing.size(); ++i) {
    const NodeIndex soon = growing[std::min(i + steps_ahead, growing.size() - 1)].node;
    __builtin_prefetch(&last_step_[static_cast<std::size_t>(soon)], 1);
    growing[i].changed =
        growing[i].points != last_step_[static_cast<std::size_t>(growing[i].node)].points;
  }
  std::erase_if(share.attracting, [&growing](const Attracting& attracting) {
    return !growing[static_cast<std::size_t>(attracting.place)].changed;
  });
}

/// In the order of the points: rounding must not depend on how many threads there are.
void GrowthStep::sum_pulls(Share& share, std::span<const Vector3> points,
                           std::span<const SearchableNode> nodes) const {
  const AttractionSum kind = parameters_.variant.attraction_sum;
  const std::vector<Attracting>& attracting = share.attracting;
  for (std::size_t i = 0; i < attracting.size(); ++i) {
    const Attracting& soon = attracting[std::min(i + steps_ahead, attracting.size() - 1)];
    __builtin_prefetch(&points[static_cast<std::size_t>(soon.point)]);
    const NodeIndex its_node = share.growing[static_cast<std::size_t>(soon.place)].node;
    __builtin_prefetch(&nodes[static_cast<std::size_t>(its_node)]);
    GrowingNode& growing = share.growing[static_cast<std::size_t>(attracting[i].place)];
    growing.sum =
        growing.sum + attraction(nodes[static_cast<std::size_t>(growing.node)].position,
                                 points[static_cast<std::size_t>(attracting[i].point)], kind);
  }
}

void GrowthStep::find_children(Share& share, std::int32_t first,
                               std::span<const SearchableNode> nodes, const Skeleton& skeleton) {
  share.children.clear();
  for (std::size_t i = 0; i < share.growing.size(); ++i) {
    const GrowingNode& soon = share.growing[std::min(i + steps_ahead, share.growing.size() - 1)];
    if (soon.changed) {
      __builtin_prefetch(&nodes[static_cast<std::size_t>(soon.node)]);
      skeleton.prefetch_children(first + soon.node);
    }
    const GrowingNode& parent = share.growing[i];
    const auto node = static_cast<std::size_t>(parent.node);
    const Fate fate = grow_child(parent, first, nodes[node], skeleton, share.children);
    share.counts.suppressed_repeats += fate == Fate::repeat;
    share.counts.refused_children += fate == Fate::refused;
    last_step_[node] = {parent.points, fate};
  }
}

GrowthStep::Fate GrowthStep::grow_child(const GrowingNode& parent, std::int32_t first,
                                        const SearchableNode& node, const Skeleton& skeleton,
                                        std::vector<Child>& children) const {
  const std::int32_t grows_on = first + parent.node;
  if (limits_.any() && !limits_.allow_child(grows_on)) return Fate::refused;
  if (!parent.changed) {
    const Fate last = last_step_[static_cast<std::size_t>(parent.node)].fate;
    return last == Fate::no_direction ? last : Fate::repeat;
  }
  const GrowthVariant& variant = parameters_.variant;
  const auto direction = growth_direction(parent.sum, parameters_.tropism, variant.tropism_order);
  if (!direction) return Fate::no_direction;
  const Vector3 limited = limit_(*direction, node.direction);
  const double step = limits_.any() ? limits_.step_length(grows_on) : parameters_.step_length;
  const Vector3 position = node.position + step * limited;
  if (variant.repeat_guard == RepeatGuard::on && skeleton.has_child_at(grows_on, position))
    return Fate::repeat;
  children.push_back({{position, limited}, parent.node, parent.first_point});
  return Fate::grows;
}

/// The children of all shares, in the order of their parents' first points.
void GrowthStep::append_children(std::int32_t first, LargeVector<SearchableNode>& nodes,
                                 Skeleton& skeleton) {
  next_child_.assign(shares_.size(), 0);
  for (;;) {
    const Child* next = nullptr;
    std::size_t from = 0;
    for (std::size_t i = 0; i < shares_.size(); ++i) {
      if (next_child_[i] == shares_[i].children.size()) continue;
      const Child& child = shares_[i].children[next_child_[i]];
      if (next && next->first_point < child.first_point) continue;
      next = &child;
      from = i;
    }
    if (!next) return;
    ++next_child_[from];
    skeleton.append(first + next->parent, next->node.position);
    nodes.push_back(next->node);
  }
}

}  // namespace phytobench
