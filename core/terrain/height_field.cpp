// SPDX-License-Identifier: MIT
#include "core/terrain/height_field.hpp"

#include <algorithm>
#include <utility>

#include "core/contract/check.hpp"

namespace phytobench {

namespace {

std::size_t vertex_count(int columns, int rows) {
  PHYTOBENCH_EXPECT(columns > 0 && rows > 0);
  return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
}

}  // namespace

HeightField::HeightField(int columns, int rows, double cell_width, double cell_depth, double height)
    : HeightField(columns, rows, cell_width, cell_depth,
                  std::vector<double>(vertex_count(columns, rows), height)) {}

HeightField::HeightField(int columns, int rows, double cell_width, double cell_depth,
                         std::vector<double> heights)
    : columns_(columns),
      rows_(rows),
      cell_width_(cell_width),
      cell_depth_(cell_depth),
      heights_(std::move(heights)) {
  PHYTOBENCH_EXPECT(heights_.size() == vertex_count(columns, rows));
  PHYTOBENCH_EXPECT(cell_width > 0.0 && cell_depth > 0.0);
}

HeightRange height_range(const HeightField& field) {
  HeightRange range;
  for (const double height : field.heights()) {
    if (std::isnan(height)) continue;
    range.lowest = std::min(range.lowest, height);
    range.highest = std::max(range.highest, height);
    ++range.vertices;
  }
  return range;
}

HeightField transposed(const HeightField& field) {
  // In square pieces, so that both sides stay in the cache.
  constexpr int piece = 32;
  HeightField result(field.rows(), field.columns(), field.cell_depth(), field.cell_width());
  for (int top = 0; top < field.rows(); top += piece)
    for (int left = 0; left < field.columns(); left += piece)
      for (int row = top; row < std::min(top + piece, field.rows()); ++row)
        for (int column = left; column < std::min(left + piece, field.columns()); ++column)
          result.at(row, column) = field.at(column, row);
  return result;
}

}  // namespace phytobench
