// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/geometry/point2.hpp"

namespace phytobench {

/// Points of one type, or of two types in one list; says which ordered pairs a summary function is
/// about. Shared by the second-order functions, not meant for others.
class PairTypes {
 public:
  /// All points are of one type: both orders of each pair count.
  explicit PairTypes(std::span<const Point2> points) : points_(points.begin(), points.end()) {
    pairs_ = static_cast<double>(points.size()) * (static_cast<double>(points.size()) - 1.0);
    partners_ = static_cast<double>(points.size()) - 1.0;
  }
  /// Pairs from the first type to the second.
  PairTypes(std::span<const Point2> first, std::span<const Point2> second) : PairTypes(first) {
    firsts_ = first.size();
    is_cross_ = true;
    points_.insert(points_.end(), second.begin(), second.end());
    partners_ = static_cast<double>(second.size());
    pairs_ = static_cast<double>(first.size()) * partners_;
  }

  const std::vector<Point2>& points() const { return points_; }
  /// Those that pairs start from come first in points().
  std::size_t starts() const { return is_cross_ ? firsts_ : points_.size(); }
  bool is_cross() const { return is_cross_; }
  double ordered_pairs() const { return pairs_; }  ///< of all distances
  double partners() const { return partners_; }    ///< of each start

  /// Calls body(start) for each order of the unordered pair that counts.
  template <class Body>
  void for_orders(std::size_t i, std::size_t j, const Body& body) const {
    if (!is_cross_) {
      body(i);
      body(j);
    } else if ((i < firsts_) != (j < firsts_)) {
      body(i < firsts_ ? i : j);
    }
  }

 private:
  std::vector<Point2> points_;
  std::size_t firsts_ = 0;
  bool is_cross_ = false;
  double pairs_ = 0.0;
  double partners_ = 0.0;
};

}  // namespace phytobench
