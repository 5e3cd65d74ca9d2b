// SPDX-License-Identifier: MIT
#include "core/tree/branch_overlaps.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/contract/check.hpp"
#include "core/geometry/bounding_box.hpp"
#include "core/geometry/segment_distance.hpp"
#include "core/tree/branches.hpp"

namespace phytobench {

namespace {

struct Edge {
  std::int32_t node = 0;  ///< upper end
  Segment line;
  BoundingBox box;  ///< of the tube
};

std::vector<Edge> edges_by_lowest_x(const Skeleton& skeleton, std::span<const double> radii) {
  std::vector<Edge> edges;
  for (std::size_t i = 1; i < radii.size(); ++i) {
    Edge edge{static_cast<std::int32_t>(i),
              {skeleton.position(skeleton.parents()[i]), skeleton.positions()[i]},
              {}};
    edge.box.extend(edge.line.from);
    edge.box.extend(edge.line.to);
    edge.box = edge.box.widened(radii[i]);
    edges.push_back(edge);
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return std::pair(a.box.low().x, a.node) < std::pair(b.box.low().x, b.node);
  });
  return edges;
}

bool meet_in_y_and_z(const BoundingBox& a, const BoundingBox& b) {
  return a.low().y <= b.high().y && b.low().y <= a.high().y && a.low().z <= b.high().z &&
         b.low().z <= a.high().z;
}

/// Along the branches, from the nearer ends of two edges; 0 if they have a node in common.
std::int32_t edges_between(const Skeleton& skeleton, const std::vector<std::int32_t>& depths,
                           std::int32_t a, std::int32_t b) {
  const auto parent_of = [&](std::int32_t n) {
    return skeleton.parents()[static_cast<std::size_t>(n)];
  };
  const auto depth_of = [&](std::int32_t n) { return depths[static_cast<std::size_t>(n)]; };
  std::int32_t from = a, to = b, steps = 0;
  for (; from != to; ++steps) {
    std::int32_t& deeper = depth_of(from) >= depth_of(to) ? from : to;
    deeper = parent_of(deeper);
  }
  // One edge of the two lies on this way if one grows on the other, else both do.
  const bool on_each_other = from == a || from == b;
  return steps - (on_each_other ? 1 : 2);
}

}  // namespace

std::vector<BranchOverlap> branch_overlaps(const Skeleton& skeleton,
                                           std::span<const double> radii) {
  PHYTOBENCH_EXPECT(radii.size() == skeleton.node_count());
  const std::vector<std::int32_t> depths = node_depths(skeleton);
  const std::vector<Edge> edges = edges_by_lowest_x(skeleton, radii);
  std::vector<BranchOverlap> overlaps;
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t j = i + 1; j < edges.size() && edges[j].box.low().x <= edges[i].box.high().x;
         ++j) {
      if (!meet_in_y_and_z(edges[i].box, edges[j].box)) continue;
      const auto [low, high] = std::minmax(edges[i].node, edges[j].node);
      const double distance = std::sqrt(squared_distance(edges[i].line, edges[j].line));
      if (!(distance <
            radii[static_cast<std::size_t>(low)] + radii[static_cast<std::size_t>(high)]))
        continue;
      const std::int32_t between = edges_between(skeleton, depths, low, high);
      if (between > 0) overlaps.push_back({low, high, between, distance});
    }
  std::sort(overlaps.begin(), overlaps.end(), [](const BranchOverlap& a, const BranchOverlap& b) {
    return std::tie(a.lower_index, a.higher_index) < std::tie(b.lower_index, b.higher_index);
  });
  return overlaps;
}

}  // namespace phytobench
