// SPDX-License-Identifier: MIT
#include "core/terrain/shadow/height_pyramid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace phytobench {

namespace {

using Level = HeightPyramid::Level;

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr int smallest_shift = 2;

float not_below(double height) {
  const float nearest = static_cast<float>(height);
  return static_cast<double>(nearest) < height ? std::nextafterf(nearest, infinity) : nearest;
}

std::size_t place(const Level& level, int column, int row) {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(level.columns) +
         static_cast<std::size_t>(column);
}

Level empty_level(int shift, int columns, int rows) {
  Level level{shift, columns, rows, {}};
  level.highest.assign(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows),
                       -infinity);
  return level;
}

void raise(float& to, float value) {
  to = value > to ? value : to;
}

/// The greatest heights in squares that do not overlap. NaN is greater than nothing.
Level squares_of(const HeightField& field) {
  constexpr int side = 1 << smallest_shift;
  Level level = empty_level(smallest_shift, (field.columns() + side - 1) / side,
                            (field.rows() + side - 1) / side);
  for (int row = 0; row < field.rows(); ++row) {
    const double* heights = field.row(row);
    float* squares = level.highest.data() + place(level, 0, row / side);
    for (int column = 0; column < field.columns(); column += side) {
      double highest = -std::numeric_limits<double>::infinity();
      for (int c = column; c < std::min(column + side, field.columns()); ++c)
        highest = heights[c] > highest ? heights[c] : highest;
      raise(squares[column / side], not_below(highest));
    }
  }
  return level;
}

Level squares_above(const Level& below) {
  Level level = empty_level(below.shift + 1, (below.columns + 1) / 2, (below.rows + 1) / 2);
  for (int row = 0; row < below.rows; ++row)
    for (int column = 0; column < below.columns; ++column)
      raise(level.highest[place(level, column / 2, row / 2)],
            below.highest[place(below, column, row)]);
  return level;
}

/// Each square becomes a window of four by four of them, itself in the corner.
void widen(Level& level) {
  const auto reach = [](int from, int end) { return std::min(from + 4, end); };
  for (int row = 0; row < level.rows; ++row)
    for (int column = 0; column < level.columns; ++column)
      for (int c = column + 1; c < reach(column, level.columns); ++c)
        raise(level.highest[place(level, column, row)], level.highest[place(level, c, row)]);
  for (int row = 0; row < level.rows; ++row)
    for (int r = row + 1; r < reach(row, level.rows); ++r)
      for (int column = 0; column < level.columns; ++column)
        raise(level.highest[place(level, column, row)], level.highest[place(level, column, r)]);
}

}  // namespace

HeightPyramid::HeightPyramid(const HeightField& field) : highest_(height_range(field).highest) {
  Level squares = squares_of(field);
  for (;;) {
    levels_.push_back(squares);
    widen(levels_.back());
    if (squares.columns <= 4 && squares.rows <= 4) break;
    squares = squares_above(squares);
  }
}

const HeightPyramid::Level& HeightPyramid::level_for(int columns, int rows) const {
  for (const Level& level : levels_)
    if (std::max(columns, rows) <= level.side()) return level;
  return levels_.back();
}

std::size_t HeightPyramid::bytes() const {
  std::size_t sum = 0;
  for (const Level& level : levels_) sum += level.highest.capacity() * sizeof(float);
  return sum;
}

}  // namespace phytobench
