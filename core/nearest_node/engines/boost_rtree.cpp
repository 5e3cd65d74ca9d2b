// SPDX-License-Identifier: MIT
// Boost.Geometry's R-tree, the one index here that grows node by node. R* rather than quadratic
// splits: a node is entered once, but found by points in every later iteration. Two queries,
// because nearest() gives any one of equally near nodes and its incremental iterator, which would
// give all, drops some of them (Boost 1.74).
#include <cmath>
#include <limits>
#include <utility>

#define BOOST_ALLOW_DEPRECATED_HEADERS  // Boost includes one itself and then reports that
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <boost/iterator/function_output_iterator.hpp>

#include "core/nearest_node/node_list.hpp"
#include "core/nearest_node/point_driven_engine.hpp"

namespace phytobench::engines {

namespace {

namespace geometry = boost::geometry;
namespace rtree = geometry::index;
using Point = geometry::model::point<double, 3, geometry::cs::cartesian>;
using Box = geometry::model::box<Point>;
using Entry = std::pair<Point, NodeIndex>;

/// Holds every node with a squared distance of at most `squared`, which may be infinite. The margin
/// covers the rounding of that sum and its underflow; the corners need none, because rounding is
/// monotone: no coordinate lies between a corner and its rounded value.
Box box_around(const Vector3& point, double squared) {
  const double half_width = std::sqrt(squared + std::numeric_limits<double>::min()) * (1.0 + 1e-12);
  return {Point(point.x - half_width, point.y - half_width, point.z - half_width),
          Point(point.x + half_width, point.y + half_width, point.z + half_width)};
}

class BoostRTree : public NodeList {
 public:
  void reset(std::span<const Vector3> points, double influence_distance) {
    NodeList::reset(points, influence_distance);
    tree_.clear();
  }

  std::uint64_t insert(std::span<const SearchableNode> nodes) {
    auto index = static_cast<NodeIndex>(nodes_.size());
    for (const SearchableNode& node : nodes)
      tree_.insert(Entry(Point(node.position.x, node.position.y, node.position.z), index++));
    return NodeList::insert(nodes);
  }

  NearestHit nearest(PointIndex, const Vector3& point, const Perception& perception,
                     WorkCounters& work) const {
    NearestHit best{no_node, perception.beyond_reach()};
    const auto improves = [&](const Entry& entry) {
      const NodeIndex index = entry.second;
      const SearchableNode& node = nodes_[static_cast<std::size_t>(index)];
      const double squared = squared_distance(point, node.position);
      ++work.search_evaluations;
      if (!best.beaten_by(squared, index)) return false;
      if constexpr (counts_inner_loop) ++work.angle_tests;
      if (!perception.within_angle(node.position, node.direction, point, squared)) return false;
      best = {index, squared};
      return true;
    };
    // The results themselves are of no use: `improves` has noted the best by our own distance.
    const auto ignored = boost::make_function_output_iterator([](const Entry&) {});

    // Find a nearest node. Without the box a point out of reach would have the whole tree searched.
    tree_.query(rtree::nearest(Point(point.x, point.y, point.z), 1) &&
                    rtree::intersects(box_around(point, best.squared_distance)) &&
                    rtree::satisfies(improves),
                ignored);
    if (best.node == no_node) return best;

    // Find the lowest index of the equally near ones.
    tree_.query(
        rtree::intersects(box_around(point, best.squared_distance)) && rtree::satisfies(improves),
        ignored);
    return best;
  }

 private:
  rtree::rtree<Entry, rtree::rstar<16>> tree_;
};

}  // namespace

extern const EngineDescriptor boost_rtree;
constinit const EngineDescriptor boost_rtree{
    .name = "boost_rtree",
    .summary =
        "Asks an R*-tree, into which nodes are inserted one by one, for a nearest node and then "
        "for its equals.",
    .source = "Boost.Geometry, index::rtree with rstar",
    .library = "Boost " BOOST_LIB_VERSION,
    .create = make_point_driven_engine<BoostRTree, KillBy::grid>,
};

}  // namespace phytobench::engines
