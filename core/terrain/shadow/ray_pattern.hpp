// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/terrain/height_field.hpp"
#include "core/terrain/sun/sun_direction.hpp"

namespace phytobench {

/// Where a ray from a vertex meets a grid line, seen from that vertex. The terrain there lies
/// between two vertices.
struct RayCrossing {
  std::ptrdiff_t near = 0;  ///< index of one of them, relative to the vertex
  std::ptrdiff_t far = 0;   ///< of the other; the same where the ray meets a vertex
  double fraction = 0.0;    ///< of the way from `near` to `far`, in [0, 1)
  double rise = 0.0;        ///< m that the ray has gained
  int columns = 0;          ///< how many columns away the vertices are at most
  int rows = 0;             ///< how many rows
};

/// The terrain's height at a crossing, `at` pointing to the vertex that the ray comes from. Never
/// above the higher of both vertices, whatever is rounded: whoever knows a bound of heights may
/// rely on it. NaN beside a vertex without data, which is above nothing.
inline double height_at(const RayCrossing& crossing, const double* at) {
  const double a = at[crossing.near], b = at[crossing.far];
  const double height = a + crossing.fraction * (b - a);
  const double bound = a < b ? b : a;
  return height > bound ? bound : height;
}

/// Every crossing of a ray towards the sun with the lines of a grid, in the order of distance: the
/// same for every vertex. What a ray sees of the terrain is its grid lines, straight between
/// vertices - the mesh of [Lesser2019] sec. 8.3 without its diagonals, so that no direction is
/// preferred. A vertex is dark iff height_at() > its height + rise at some crossing on the map.
/// All engines that are exact decide by these numbers, and so alike to the last bit.
class RayPattern {
 public:
  /// The sun must not stand below the horizon, nor in the zenith.
  RayPattern(const HeightField& field, const SunDirection& sun);

  std::span<const RayCrossing> crossings() const { return crossings_; }
  /// How many crossings from the start lie within so many columns and rows.
  std::size_t within(int columns, int rows) const {
    const std::size_t by_columns = within_columns_[static_cast<std::size_t>(columns)];
    const std::size_t by_rows = within_rows_[static_cast<std::size_t>(rows)];
    return by_columns < by_rows ? by_columns : by_rows;
  }
  /// How many lie on the map for a ray from this vertex.
  std::size_t on_map(int column, int row) const {
    return within(goes_east_ ? columns_ - 1 - column : column, goes_south_ ? rows_ - 1 - row : row);
  }
  bool goes_east() const { return goes_east_; }
  bool goes_south() const { return goes_south_; }

 private:
  void add_crossings(double columns_per_metre, double rows_per_metre, double rise_per_metre);
  void count_within();

  int columns_;
  int rows_;
  bool goes_east_;
  bool goes_south_;
  std::vector<RayCrossing> crossings_;
  std::vector<std::size_t> within_columns_;
  std::vector<std::size_t> within_rows_;
};

}  // namespace phytobench
