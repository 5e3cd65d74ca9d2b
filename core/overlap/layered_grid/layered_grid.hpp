// SPDX-License-Identifier: MIT
// Discs sorted by size into layers and within a layer into cells, so that a disc's neighbours stand
// side by side in memory whatever their sizes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/overlap/discs.hpp"

namespace phytobench {

/// Discs of like radii in a grid of cells at least as wide as the largest of them.
struct DiscLayer {
  double largest_radius = 0.0;
  double cells_per_x = 0.0;  ///< cells in a unit of length
  double cells_per_y = 0.0;
  std::int32_t columns = 1;
  std::int32_t rows = 1;
  std::size_t first_row = 0;   ///< of this layer among the rows of all layers
  std::size_t first_cell = 0;  ///< the same for cells
  std::size_t disc_count = 0;
  /// Cells are much wider than discs: else there would be more of them than discs.
  bool is_crowded_by_space = false;
};

class LayeredGrid {
 public:
  /// Discs as an engine gets them. Radii of 0 are left out. The same for any number of threads.
  void build(const Discs& discs, const Ground& ground, int threads);

  /// Whether cells that are wide for want of memory hold hundreds of discs each: a few lumps in
  /// much empty space. A tree is faster then.
  bool is_clumped() const;

  /// From the largest discs to the smallest.
  const std::vector<DiscLayer>& layers() const { return layers_; }
  Point2 low() const { return low_; }
  Point2 period() const { return period_; }  ///< 0, 0 on the open plane

  /// Row by row, cell by cell; readable for a vector's width beyond the last. `disc` is a
  /// DiscIndex: as a double it goes through the same vectors as the rest.
  const double* x() const { return numbers_.data(); }
  const double* y() const { return numbers_.data() + stride_; }
  const double* radius() const { return numbers_.data() + 2 * stride_; }
  const double* disc() const { return numbers_.data() + 3 * stride_; }

  /// Where a cell begins; the next cell's begin is its end.
  const std::uint32_t* cell_begin() const { return cell_begin_.data(); }

 private:
  struct Entry {
    double x, y, radius, disc;
  };

  void find_layers(const Discs& discs, const Ground& ground);
  void find_box(const Discs& discs, const Ground& ground);
  void lay_out(DiscLayer& layer) const;
  std::size_t row_of(const DiscLayer& layer, double y) const;
  std::size_t layer_of(double radius) const;
  void sort_into_rows(const Discs& discs, int threads);
  void sort_into_cells(int threads);
  void sort_row_into_cells(const DiscLayer& layer, std::size_t row);

  std::vector<DiscLayer> layers_;
  std::vector<std::uint16_t> layer_of_exponent_;
  Point2 low_, high_, period_;
  LargeArray<Entry> in_rows_;
  std::vector<std::uint32_t> row_begin_;  ///< of all layers
  std::vector<std::uint32_t> next_;       ///< place for the next disc of each row and block
  LargeArray<double> numbers_;            ///< all x, all y, all radii, all discs
  std::size_t stride_ = 0;
  LargeArray<std::uint32_t> cell_begin_;
  std::size_t cells_ = 0;
};

}  // namespace phytobench
