// SPDX-License-Identifier: MIT
// CGAL's kd-tree, asked for one neighbour after the other in order of distance, because its search
// for the k nearest knows no filter. Its insert() throws the whole tree away, so every iteration
// with new nodes builds one. This part of CGAL is GPL: so is a program that contains this file.
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include <CGAL/Euclidean_distance.h>
#include <CGAL/Kd_tree.h>
#include <CGAL/Orthogonal_incremental_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Splitters.h>
#include <CGAL/property_map.h>
#include <CGAL/version.h>
#include <boost/iterator/counting_iterator.hpp>

#include "core/nearest_node/node_list.hpp"
#include "core/nearest_node/point_driven_engine.hpp"

namespace phytobench::engines {

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using PointOfRow = CGAL::Pointer_property_map<Point>::const_type;
using PointTraits = CGAL::Search_traits_3<Kernel>;
using Traits = CGAL::Search_traits_adapter<std::size_t, PointOfRow, PointTraits>;
using Distance =
    CGAL::Distance_adapter<std::size_t, PointOfRow, CGAL::Euclidean_distance<PointTraits>>;
using Splitter = CGAL::Sliding_midpoint<Traits>;
/// With tight bounds in its inner nodes and the coordinates of a leaf side by side.
using Tree = CGAL::Kd_tree<Traits, Splitter, CGAL::Tag_true, CGAL::Tag_true>;
using Search = CGAL::Orthogonal_incremental_neighbor_search<Traits, Distance, Splitter, Tree>;

/// Once CGAL reports more than this, no node to come is as near as `squared`. One part in 10^12
/// more, because it bounds subtrees by sums that round otherwise than squared_distance(), and a
/// margin for where squares underflow.
double stop_distance(double squared) {
  return squared * (1.0 + 1e-12) + std::numeric_limits<double>::min();
}

class CgalKdTree : public NodeList {
 public:
  static constexpr unsigned leaf_size = 10;  ///< nodes in a leaf at most; CGAL's default

  void reset(std::span<const Vector3> points, double influence_distance) {
    NodeList::reset(points, influence_distance);
    tree_.reset();
    positions_.clear();
  }

  /// Nodes at one and the same place are split off one by one: time grows with the square of their
  /// number, and tens of thousands overflow the stack inside CGAL.
  std::uint64_t insert(std::span<const SearchableNode> nodes) {
    if (nodes.empty()) return 0;
    NodeList::insert(nodes);
    for (const SearchableNode& node : nodes)
      positions_.emplace_back(node.position.x, node.position.y, node.position.z);
    // A new tree, not insert() into the old one: that would leave the old nodes' coordinates at the
    // front of its cache, where the leaves then read.
    tree_.emplace(boost::counting_iterator<std::size_t>(0),
                  boost::counting_iterator<std::size_t>(positions_.size()), Splitter(leaf_size),
                  Traits(PointOfRow(positions_.data())));
    tree_->build();  // else the first query would do it, with the others waiting
    return nodes_.size();
  }

  NearestHit nearest(PointIndex, const Vector3& point, const Perception& perception,
                     WorkCounters& work) const {
    NearestHit best{no_node, perception.beyond_reach()};
    if (!tree_) return best;
    const Search in_order(*tree_, Point(point.x, point.y, point.z), 0.0, true,
                          Distance(PointOfRow(positions_.data())));
    for (const auto& [row, reported] : in_order) {
      if (reported > stop_distance(best.squared_distance)) break;
      const SearchableNode& node = nodes_[row];
      const auto index = static_cast<NodeIndex>(row);
      const double squared = squared_distance(point, node.position);
      ++work.search_evaluations;
      if (!best.beaten_by(squared, index)) continue;
      if constexpr (counts_inner_loop) ++work.angle_tests;
      if (!perception.within_angle(node.position, node.direction, point, squared)) continue;
      best = {index, squared};
    }
    return best;
  }

 private:
  std::vector<Point> positions_;  ///< of the nodes; the tree holds rows of this
  std::optional<Tree> tree_;
};

}  // namespace

extern const EngineDescriptor cgal_kdtree;
constinit const EngineDescriptor cgal_kdtree{
    .name = "cgal_kdtree",
    .summary =
        "Takes neighbours in order of distance from CGAL's kd-tree, rebuilt in every iteration "
        "that brings nodes.",
    .source = "CGAL, Kd_tree and Orthogonal_incremental_neighbor_search",
    .library = "CGAL " CGAL_VERSION_STR,
    .create = make_point_driven_engine<CgalKdTree, KillBy::grid>,
};

}  // namespace phytobench::engines
