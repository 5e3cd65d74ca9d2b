// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/overlap/candidate_pairs.hpp"

namespace phytobench {

/// A disc or its image on a grid: the box of cells around it.
struct CellReach {
  DiscEntry entry;
  std::int64_t low_row, high_row, low_column, high_column;

  std::size_t disc() const { return static_cast<std::size_t>(entry.disc); }
};

/// Square cells of a plane or torus, row by row, with the discs that reach into each row. One row
/// is in memory at a time, whatever the size of the ground.
class CellRows {
 public:
  /// Errors as cell_shares() says.
  CellRows(const Discs& discs, const Ground& ground, double side);

  std::size_t columns() const { return columns_; }
  double cell_area() const { return step_.x * step_.y; }

  /// Calls work(reaches of the row, row) for every row that a disc reaches. Reaches come in the
  /// order of is_before(disc i, disc j).
  template <class IsBefore, class Work>
  void each_row(const IsBefore& is_before, const Work& work) {
    std::sort(reaches_.begin(), reaches_.end(),
              [](const CellReach& a, const CellReach& b) { return a.low_row < b.low_row; });
    const auto before = [&](const CellReach& a, const CellReach& b) {
      return is_before(a.disc(), b.disc());
    };
    std::vector<CellReach> active;
    std::size_t next = 0;
    for (std::int64_t row = 0; next < reaches_.size() || !active.empty(); ++row) {
      if (active.empty()) row = reaches_[next].low_row;
      for (; next < reaches_.size() && reaches_[next].low_row == row; ++next)
        active.insert(std::upper_bound(active.begin(), active.end(), reaches_[next], before),
                      reaches_[next]);
      work(active, row);
      std::erase_if(active, [row](const CellReach& a) { return a.high_row == row; });
    }
  }

  /// Calls visit(column from 0, squared distance from the disc's center) for all cells of a row
  /// whose centers lie in the disc.
  template <class Visit>
  void each_cell(const CellReach& reach, std::int64_t row, const Visit& visit) const {
    const double dy = center_of(row, low_.y, step_.y) - reach.entry.y;
    const double within = reach.entry.radius * reach.entry.radius;
    for (std::int64_t column = reach.low_column; column <= reach.high_column; ++column) {
      const double dx = center_of(column, low_.x, step_.x) - reach.entry.x;
      const double squared = dx * dx + dy * dy;
      if (squared <= within) visit(static_cast<std::size_t>(column - first_column_), squared);
    }
  }

 private:
  static double center_of(std::int64_t place, double low, double step) {
    return low + (static_cast<double>(place) + 0.5) * step;
  }
  void lay_out(const Ground& ground, double side);
  void add(const DiscEntry& entry, double side);

  Point2 low_, step_;
  std::int64_t torus_columns_ = 0, torus_rows_ = 0;  ///< 0 on the plane
  std::vector<CellReach> reaches_;
  std::int64_t first_column_ = 0;
  std::size_t columns_ = 0;
};

}  // namespace phytobench
