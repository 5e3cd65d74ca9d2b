// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "core/geometry/point2.hpp"

namespace phytobench {

/// How much of a resource the ground offers, in cells over a rectangle: 0 poor to 1 rich
/// ([Alsweis] fig. 4.6: grey levels).
class ResourceMap {
 public:
  /// 1 everywhere.
  ResourceMap() = default;

  /// `values` holds columns * rows numbers from 0 to 1, row by row, the top row (high y) first, as
  /// pictures are stored. ContractViolation for another size or values out of range.
  ResourceMap(int columns, int rows, std::vector<double> values, const Rectangle& ground);

  bool is_uniform() const { return values_.empty(); }
  int columns() const { return columns_; }
  int rows() const { return rows_; }
  const std::vector<double>& values() const { return values_; }

  /// The value of the cell that holds `place`; places beyond the ground take that of the nearest
  /// cell.
  double at(const Point2& place) const {
    if (values_.empty()) return 1.0;
    return values_[index_of(place)];
  }

 private:
  std::size_t index_of(const Point2& place) const;

  int columns_ = 0, rows_ = 0;
  std::vector<double> values_;
  Rectangle ground_;
};

/// A PNG as a map: black is 0, white is 1 (mean of red, green and blue; opacity is ignored). Throws
/// InputError with the file for a picture that cannot be read, is larger than 16 million pixels, or
/// whose sides are not in the proportion of the ground's, to one pixel: a map of another place.
ResourceMap read_resource_map(const std::filesystem::path& file, const Rectangle& ground);

}  // namespace phytobench
