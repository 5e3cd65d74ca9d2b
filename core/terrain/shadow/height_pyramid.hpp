// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "core/terrain/height_field.hpp"

namespace phytobench {

/// The greatest height in square windows of vertices, which overlap such that any box finds one
/// that holds it and is not much larger.
class HeightPyramid {
 public:
  explicit HeightPyramid(const HeightField& field);

  /// Windows of one size. Window (i, j) begins at vertex (i << shift, j << shift) and has four
  /// times as many vertices a side, cut off at the border of the field.
  struct Level {
    int shift = 0;
    int columns = 0;  ///< windows
    int rows = 0;
    /// Never less than the height it stands for, and otherwise as near to it as single precision
    /// goes. -infinity where no vertex has data.
    std::vector<float> highest;

    /// Boxes of so many vertices a side lie within the window in whose first quarter they begin.
    int side() const { return 3 * (1 << shift) + 1; }
    int vertices_a_side() const { return 4 << shift; }
  };
  /// From the smallest windows to those that hold all of the field.
  const std::vector<Level>& levels() const { return levels_; }
  /// That of the smallest windows which hold any box of so many vertices. The last level's windows
  /// reach the border of the field, and so hold all.
  const Level& level_for(int columns, int rows) const;

  double highest() const { return highest_; }  ///< of all
  std::size_t bytes() const;

 private:
  double highest_;
  std::vector<Level> levels_;
};

}  // namespace phytobench
