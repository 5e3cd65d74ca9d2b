// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
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
      const double squared = squared_distance(query, boxes_[sibling]);
      if (squared < reach()) visit_below(sibling, squared, query, reach, visit);
      node = (node - 1) / 2;
    }
  }

  /// The same from the root downwards, for queries that are no points of the tree.
  template <class Reach, class Visit>
  void visit_all(const Point2& query, const Reach& reach, const Visit& visit) const {
    visit_below(0, squared_distance(query, boxes_[0]), query, reach, visit);
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
  void visit_below(std::size_t node, double squared, const Point2& query, const Reach& reach,
                   const Visit& visit) const {
    struct Waiting {
      std::size_t node;
      double squared;
    };
    Waiting stack[64];
    int waiting = 0;
    for (;;) {
      // Down to the nearest leaf, leaving the other halves for later.
      while (squared < reach() && node < first_leaf_) {
        std::size_t near = 2 * node + 1, far = near + 1;
        double near_squared = squared_distance(query, boxes_[near]);
        double far_squared = squared_distance(query, boxes_[far]);
        if (far_squared < near_squared) {
          std::swap(near, far);
          std::swap(near_squared, far_squared);
        }
        if (far_squared < reach()) stack[waiting++] = {far, far_squared};
        node = near;
        squared = near_squared;
      }
      if (squared < reach()) visit_leaf(boxes_[node], visit);
      if (waiting == 0) return;
      node = stack[--waiting].node;
      squared = stack[waiting].squared;
    }
  }

  struct Numbered {
    Point2 point;
    std::uint32_t index;
  };
  void build(std::size_t node, std::span<Numbered> part, std::size_t begin);

  std::vector<Point2> points_;
  std::vector<std::uint32_t> index_;
  std::vector<Box> boxes_;  ///< the children of node k are 2 k + 1 and 2 k + 2
  std::size_t leaves_ = 1;
  std::size_t first_leaf_ = 0;
};

}  // namespace phytobench
