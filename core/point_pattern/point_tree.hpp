// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/geometry/point2.hpp"

namespace phytobench {

/// A balanced tree over points of the plane, halved along the longer side of each part's box: as
/// many levels for clustered points as for even ones. Points stand in the order of its leaves.
class PointTree {
 public:
  static constexpr std::size_t leaf_size = 8;  ///< points in a leaf at most

  explicit PointTree(std::span<const Point2> points);

  std::size_t size() const { return points_.size(); }
  const Point2& point(std::size_t place) const { return points_[place]; }
  std::size_t index(std::size_t place) const { return index_[place]; }  ///< in the given points

  std::size_t leaves() const { return leaves_; }
  std::size_t leaf_begin(std::size_t leaf) const { return boxes_[first_leaf_ + leaf].begin; }
  std::size_t leaf_end(std::size_t leaf) const { return boxes_[first_leaf_ + leaf].end; }

  Rectangle leaf_box(std::size_t leaf) const {
    return {boxes_[first_leaf_ + leaf].low, boxes_[first_leaf_ + leaf].high};
  }

  /// Calls visit(place) for points that may be nearer to `query` than reach() says, which may
  /// shrink meanwhile; begins with leaf `from` and moves away from it. reach() is a squared
  /// distance.
  template <class Reach, class Visit>
  void visit_from(std::size_t from, const Point2& query, const Reach& reach,
                  const Visit& visit) const {
    std::size_t node = first_leaf_ + from;
    visit_leaf(boxes_[node], visit);
    // Up to the root; at every level the half that does not hold the leaf.
    while (node > 0) {
      const std::size_t sibling = node % 2 == 1 ? node + 1 : node - 1;
      visit_below(sibling, query, reach, visit);
      node = (node - 1) / 2;
    }
  }

  /// The same from the root downwards, for queries that are no points of the tree.
  template <class Reach, class Visit>
  void visit_all(const Point2& query, const Reach& reach, const Visit& visit) const {
    visit_below(0, query, reach, visit);
  }

 private:
  struct Box {
    Point2 low, high;
    std::uint32_t begin, end;  ///< places
  };

  static double squared_distance(const Point2& p, const Box& box) {
    const double dx = std::max({0.0, box.low.x - p.x, p.x - box.high.x});
    const double dy = std::max({0.0, box.low.y - p.y, p.y - box.high.y});
    return dx * dx + dy * dy;
  }

  template <class Visit>
  static void visit_leaf(const Box& box, const Visit& visit) {
    for (std::size_t place = box.begin; place < box.end; ++place) visit(place);
  }

  template <class Reach, class Visit>
  void visit_below(std::size_t node, const Point2& query, const Reach& reach,
                   const Visit& visit) const {
    struct Waiting {
      std::size_t node;
      double squared;
    };
    Waiting stack[64];
    int waiting = 0;
    stack[waiting++] = {node, squared_distance(query, boxes_[node])};
    while (waiting > 0) {
      const Waiting next = stack[--waiting];
      if (next.squared >= reach()) continue;
      if (next.node >= first_leaf_) {
        visit_leaf(boxes_[next.node], visit);
        continue;
      }
      const Waiting left{2 * next.node + 1, squared_distance(query, boxes_[2 * next.node + 1])};
      const Waiting right{2 * next.node + 2, squared_distance(query, boxes_[2 * next.node + 2])};
      const bool left_is_nearer = left.squared <= right.squared;
      stack[waiting++] = left_is_nearer ? right : left;
      stack[waiting++] = left_is_nearer ? left : right;
    }
  }

  void build(std::size_t node, std::size_t begin, std::size_t end, std::span<const Point2> points);

  std::vector<Point2> points_;
  std::vector<std::uint32_t> index_;
  std::vector<Box> boxes_;  ///< the children of node k are 2 k + 1 and 2 k + 2
  std::size_t leaves_ = 1;
  std::size_t first_leaf_ = 0;
};

}  // namespace phytobench
