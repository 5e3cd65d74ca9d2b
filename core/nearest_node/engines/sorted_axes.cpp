// SPDX-License-Identifier: MIT
// Three lists of the nodes, sorted by x, y and z. A binary search in each finds the window of nodes
// within the influence distance along that axis; the smallest window is scanned. [Brzoska2019]
// sec. 5.2.2 names the lists and the binary search and leaves the rest open.
#include <algorithm>
#include <array>
#include <vector>

#include "core/nearest_node/point_driven_engine.hpp"

namespace phytobench::engines {

namespace {

struct ListedNode {
  SearchableNode node;
  NodeIndex index;
};

class SortedAxes {
 public:
  void reset(std::span<const Vector3>, double influence_distance) {
    for (auto& list : lists_) list.clear();
    count_ = 0;
    // Widened by one part in 2^40, so that rounding of coordinate +- distance cannot lose a node
    // that the squared distance still admits.
    reach_ = influence_distance * (1.0 + 0x1p-40);
  }

  std::uint64_t insert(std::span<const SearchableNode> nodes) {
    std::uint64_t moves = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) moves += merge_into(lists_[axis], nodes, axis);
    count_ += static_cast<NodeIndex>(nodes.size());
    return moves;
  }

  NearestHit nearest(PointIndex, const Vector3& point, const Perception& perception,
                     WorkCounters& work) const {
    std::span<const ListedNode> smallest = window(0, point);
    for (std::size_t axis = 1; axis < 3; ++axis) {
      const auto other = window(axis, point);
      if (other.size() < smallest.size()) smallest = other;
    }
    NearestHit best{no_node, perception.beyond_reach()};
    for (const ListedNode& listed : smallest) {
      const double squared = squared_distance(point, listed.node.position);
      if (!best.beaten_by(squared, listed.index)) continue;
      if constexpr (counts_inner_loop) ++work.angle_tests;
      if (!perception.within_angle(listed.node.position, listed.node.direction, point, squared))
        continue;
      best = {listed.index, squared};
    }
    work.cells_visited += 3;
    work.search_evaluations += smallest.size();
    return best;
  }

 private:
  static double coordinate(const Vector3& v, std::size_t axis) {
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
  }

  std::uint64_t merge_into(std::vector<ListedNode>& list, std::span<const SearchableNode> nodes,
                           std::size_t axis) const {
    const auto before = [axis](const ListedNode& a, const ListedNode& b) {
      return coordinate(a.node.position, axis) < coordinate(b.node.position, axis);
    };
    const auto old_size = static_cast<std::ptrdiff_t>(list.size());
    NodeIndex index = count_;
    for (const SearchableNode& node : nodes) list.push_back({node, index++});
    const auto middle = list.begin() + old_size;
    std::stable_sort(middle, list.end(), before);
    std::inplace_merge(list.begin(), middle, list.end(), before);
    return nodes.size();
  }

  std::span<const ListedNode> window(std::size_t axis, const Vector3& point) const {
    const std::vector<ListedNode>& list = lists_[axis];
    const double centre = coordinate(point, axis);
    // The margin of one part in 2^40 of the coordinate itself covers huge coordinates.
    const double margin = reach_ + std::abs(centre) * 0x1p-40;
    const auto key = [axis](const ListedNode& listed) {
      return coordinate(listed.node.position, axis);
    };
    const auto first = std::partition_point(
        list.begin(), list.end(), [&](const ListedNode& n) { return key(n) < centre - margin; });
    const auto last = std::partition_point(
        first, list.end(), [&](const ListedNode& n) { return key(n) <= centre + margin; });
    return {first, last};
  }

  std::array<std::vector<ListedNode>, 3> lists_;
  NodeIndex count_ = 0;
  double reach_ = 0.0;
};

}  // namespace

extern const EngineDescriptor sorted_axes;
constinit const EngineDescriptor sorted_axes{
    .name = "sorted_axes",
    .summary =
        "Keeps the nodes sorted along each axis and scans the smallest window found by binary "
        "search.",
    .source = "[Brzoska2019] sec. 5.2.2, binary search (idea attributed to Heywood)",
    .create = make_point_driven_engine<SortedAxes>,
};

}  // namespace phytobench::engines
