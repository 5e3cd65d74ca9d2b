// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace phytobench {

/// Heights at the vertices of a grid: columns from west to east, rows from north to south. x points
/// east, y south (as rows are counted), z up; all in metres. A vertex without data holds NaN: it
/// casts no shadow and gets no result.
class HeightField {
 public:
  HeightField() = default;
  /// At least one column and row; cells larger than 0.
  HeightField(int columns, int rows, double cell_width, double cell_depth, double height = 0.0);
  /// Of these heights, row by row: as many as vertices.
  HeightField(int columns, int rows, double cell_width, double cell_depth,
              std::vector<double> heights);

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  std::size_t size() const { return heights_.size(); }
  double cell_width() const { return cell_width_; }  ///< m between columns
  double cell_depth() const { return cell_depth_; }  ///< m between rows

  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }
  double& at(int column, int row) { return heights_[index(column, row)]; }
  double at(int column, int row) const { return heights_[index(column, row)]; }
  bool has_data(int column, int row) const { return !std::isnan(at(column, row)); }

  std::span<double> heights() { return heights_; }
  std::span<const double> heights() const { return heights_; }
  const double* row(int row) const { return heights_.data() + index(0, row); }

  static constexpr double no_data = std::numeric_limits<double>::quiet_NaN();

 private:
  int columns_ = 0;
  int rows_ = 0;
  double cell_width_ = 1.0;
  double cell_depth_ = 1.0;
  std::vector<double> heights_;
};

/// The range of the heights that are there; lowest > highest where there are none.
struct HeightRange {
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -std::numeric_limits<double>::infinity();
  std::size_t vertices = 0;  ///< with data

  bool empty() const { return vertices == 0; }
};
HeightRange height_range(const HeightField& field);

/// Rows become columns: what was seen from the north-west corner along x lies along y.
HeightField transposed(const HeightField& field);

}  // namespace phytobench
