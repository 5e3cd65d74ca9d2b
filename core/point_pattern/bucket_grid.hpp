// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/geometry/point2.hpp"
#include "core/point_pattern/window.hpp"

namespace phytobench {

/// Growing set of points in the window's bounding box, sorted into equal buckets, so that the
/// neighbours within a fixed distance are found without looking at the others. Fewer than 2^32
/// points and buckets. The window must outlive it.
class BucketGrid {
 public:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  /// `side` is the longest a bucket's sides may be; `distance` is how far neighbours may be off.
  BucketGrid(const Window& window, double side, double distance);

  std::uint32_t columns() const { return columns_; }
  std::uint32_t rows() const { return rows_; }
  /// Width and height of a bucket; at most `side`.
  const Point2& bucket_size() const { return size_; }
  const std::vector<Point2>& points() const { return points_; }
  std::vector<Point2> take_points() { return std::move(points_); }

  /// `bucket` is row * columns + column of the bucket that holds the point.
  void add(const Point2& point, std::uint32_t bucket);

  /// The first point for which `wanted(point)` holds among those in reach of a bucket, or `none`:
  /// all points within `distance` of any place in the bucket are asked, and some others.
  template <typename Wanted>
  std::uint32_t find_near(std::uint32_t bucket, const Wanted& wanted) const {
    const Span across = span(bucket % columns_, columns_, reach_across_);
    const Span up = span(bucket / columns_, rows_, reach_up_);
    for (std::uint32_t i = 0, row = up.first; i < up.count; ++i, row = next(row, rows_))
      for (std::uint32_t j = 0, column = across.first; j < across.count;
           ++j, column = next(column, columns_))
        for (std::uint32_t p = newest_[std::size_t{row} * columns_ + column]; p != none;
             p = older_[p])
          if (wanted(points_[p])) return p;
    return none;
  }

 private:
  struct Span {
    std::uint32_t first;
    std::uint32_t count;
  };

  static std::uint32_t next(std::uint32_t i, std::uint32_t count) {
    return i + 1 == count ? 0 : i + 1;
  }
  /// Columns or rows within reach of one; round the border on a torus.
  Span span(std::uint32_t middle, std::uint32_t count, std::uint32_t reach) const;

  bool goes_round_;
  std::uint32_t columns_;
  std::uint32_t rows_;
  Point2 size_;
  std::uint32_t reach_across_;
  std::uint32_t reach_up_;
  std::vector<Point2> points_;
  std::vector<std::uint32_t> older_;   // per point: the one before it in its bucket
  std::vector<std::uint32_t> newest_;  // per bucket
};

}  // namespace phytobench
