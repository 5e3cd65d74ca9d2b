// SPDX-License-Identifier: MIT
#include "core/nearest_node/node_driven/tree_search.hpp"

#include <algorithm>

#include "core/nearest_node/perception.hpp"
#include "core/parallel/for_blocks.hpp"

namespace phytobench {

namespace {

constexpr double no_live_point = -1.0;

/// Squared distance to a box. Rounding is monotone and the order of operations that of
/// squared_distance(), so no point in the box is nearer than this, to the last bit.
double squared_distance_to_box(const Vector3& node, const Vector3& low, const Vector3& high) {
  const auto gap = [](double value, double from, double to) {
    return std::max({from - value, value - to, 0.0});
  };
  return squared_norm(
      Vector3{gap(node.x, low.x, high.x), gap(node.y, low.y, high.y), gap(node.z, low.z, high.z)});
}

}  // namespace

/// One node that looks for points.
struct TreeSearch::Visit {
  const SearchableNode& node;
  NodeIndex number;
  const Perception& perception;
  std::span<NodeIndex> node_of_point;
};

void TreeSearch::reset(std::span<const Vector3> points, const EngineSetup& setup) {
  setup_ = setup;
  work_ = {};
  const double unset =
      Perception(setup.influence_distance, setup.perception_half_angle_rad).beyond_reach();
  points_.clear();
  points_.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    points_.push_back({points[i], unset, static_cast<PointIndex>(i)});
  branches_.clear();
  if (!points_.empty()) build(0, static_cast<std::int32_t>(points_.size()));
  parts_.clear();
  parts_depth_ = 0;
  for (int parts = 1; setup.threads > 1 && parts < 8 * setup.threads; parts *= 2) ++parts_depth_;
  if (!branches_.empty()) choose_parts(0, parts_depth_);
}

std::int32_t TreeSearch::build(std::int32_t begin, std::int32_t end) {
  BoundingBox box;
  for (std::int32_t i = begin; i < end; ++i)
    box.extend(points_[static_cast<std::size_t>(i)].position);
  const auto branch = static_cast<std::int32_t>(branches_.size());
  branches_.push_back(
      {box.low(), box.high(), points_[static_cast<std::size_t>(begin)].best, begin, end, 0});
  if (end - begin <= static_cast<std::int32_t>(leaf_size_)) return branch;
  const Vector3 extent = box.extent();
  const auto axis = extent.x >= extent.y && extent.x >= extent.z ? &Vector3::x
                    : extent.y >= extent.z                       ? &Vector3::y
                                                                 : &Vector3::z;
  const std::int32_t middle = begin + (end - begin) / 2;
  // Equal coordinates are told apart by index: the tree must not depend on the library's selection.
  std::nth_element(points_.begin() + begin, points_.begin() + middle, points_.begin() + end,
                   [axis](const Point& a, const Point& b) {
                     return a.position.*axis < b.position.*axis ||
                            (a.position.*axis == b.position.*axis && a.index < b.index);
                   });
  build(begin, middle);
  const std::int32_t right = build(middle, end);
  branches_[static_cast<std::size_t>(branch)].right = right;
  return branch;
}

void TreeSearch::choose_parts(std::int32_t branch, int depth) {
  const std::int32_t right = branches_[static_cast<std::size_t>(branch)].right;
  if (depth == 0 || right == 0) {
    parts_.push_back({.branch = branch});
    return;
  }
  choose_parts(branch + 1, depth - 1);
  choose_parts(right, depth - 1);
}

/// What the parts have changed, passed on to the branches above them.
void TreeSearch::update_above(std::int32_t branch, int depth) {
  Branch& b = branches_[static_cast<std::size_t>(branch)];
  if (depth == 0 || b.right == 0) return;
  update_above(branch + 1, depth - 1);
  update_above(b.right, depth - 1);
  b.worst = std::max(branches_[static_cast<std::size_t>(branch) + 1].worst,
                     branches_[static_cast<std::size_t>(b.right)].worst);
}

template <class Body>
void TreeSearch::for_each_part(const Body& body) {
  for_tasks(parts_.size(), setup_.threads, [&](std::size_t i) {
    parts_[i].reached.clear();
    parts_[i].removed.clear();
    parts_[i].work = {};
    body(parts_[i]);
  });
  for (const Part& part : parts_) work_ += part.work;
  if (!branches_.empty()) update_above(0, parts_depth_);
}

void TreeSearch::associate(std::span<const SearchableNode> nodes, NodeIndex first,
                           std::span<NodeIndex> node_of_point, std::vector<PointIndex>& reached) {
  const Perception perception(setup_.influence_distance, setup_.perception_half_angle_rad);
  for_each_part([&](Part& part) {
    NodeIndex number = first;
    for (const SearchableNode& node : nodes)
      associate_in(part.branch, {node, number++, perception, node_of_point}, part);
  });
  for (const Part& part : parts_)
    reached.insert(reached.end(), part.reached.begin(), part.reached.end());
}

void TreeSearch::associate_in(std::int32_t branch, const Visit& visit, Part& part) {
  Branch& b = branches_[static_cast<std::size_t>(branch)];
  if (squared_distance_to_box(visit.node.position, b.low, b.high) >= b.worst) return;
  ++part.work.cells_visited;
  if (b.right == 0) {
    associate_leaf(b, visit, part);
    return;
  }
  associate_in(branch + 1, visit, part);
  associate_in(b.right, visit, part);
  b.worst = std::max(branches_[static_cast<std::size_t>(branch) + 1].worst,
                     branches_[static_cast<std::size_t>(b.right)].worst);
}

void TreeSearch::associate_leaf(Branch& leaf, const Visit& visit, Part& part) {
  const SearchableNode& node = visit.node;
  double worst = no_live_point;
  for (std::int32_t i = leaf.begin; i < leaf.end; ++i) {
    Point& point = points_[static_cast<std::size_t>(i)];
    const double squared = squared_distance(point.position, node.position);
    if (squared < point.best &&
        visit.perception.within_angle(node.position, node.direction, point.position, squared)) {
      point.best = squared;
      NodeIndex& nearest = visit.node_of_point[static_cast<std::size_t>(point.index)];
      if (nearest == no_node) part.reached.push_back(point.index);
      nearest = visit.number;
    }
    worst = std::max(worst, point.best);
  }
  part.work.search_evaluations += static_cast<std::uint64_t>(leaf.end - leaf.begin);
  leaf.worst = worst;
}

void TreeSearch::remove(std::span<const SearchableNode> killers, double squared_kill,
                        std::vector<PointIndex>& removed) {
  for_each_part([&](Part& part) {
    for (const SearchableNode& killer : killers)
      remove_in(part.branch, killer.position, squared_kill, part);
  });
  for (const Part& part : parts_)
    removed.insert(removed.end(), part.removed.begin(), part.removed.end());
}

void TreeSearch::remove_in(std::int32_t branch, const Vector3& killer, double squared_kill,
                           Part& part) {
  Branch& b = branches_[static_cast<std::size_t>(branch)];
  if (b.worst < 0.0 || squared_distance_to_box(killer, b.low, b.high) > squared_kill) return;
  ++part.work.cells_visited;
  if (b.right == 0) {
    remove_from_leaf(b, killer, squared_kill, part);
    return;
  }
  remove_in(branch + 1, killer, squared_kill, part);
  remove_in(b.right, killer, squared_kill, part);
  b.worst = std::max(branches_[static_cast<std::size_t>(branch) + 1].worst,
                     branches_[static_cast<std::size_t>(b.right)].worst);
}

/// The live points of a leaf stay together at its front.
void TreeSearch::remove_from_leaf(Branch& leaf, const Vector3& killer, double squared_kill,
                                  Part& part) {
  part.work.kill_evaluations += static_cast<std::uint64_t>(leaf.end - leaf.begin);
  double worst = no_live_point;
  std::int32_t kept = leaf.begin;
  for (std::int32_t i = leaf.begin; i < leaf.end; ++i) {
    const Point point = points_[static_cast<std::size_t>(i)];
    if (squared_distance(point.position, killer) <= squared_kill) {
      part.removed.push_back(point.index);
      continue;
    }
    worst = std::max(worst, point.best);
    points_[static_cast<std::size_t>(kept++)] = point;
  }
  leaf.end = kept;
  leaf.worst = worst;
}

std::size_t TreeSearch::bytes() const {
  return points_.capacity() * sizeof(Point) + branches_.capacity() * sizeof(Branch);
}

}  // namespace phytobench
