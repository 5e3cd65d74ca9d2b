// SPDX-License-Identifier: MIT
#include "core/terrain/shadow/line_sweep.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/contract/check.hpp"

namespace phytobench {

bool is_sideways(const HeightField& field, const SunDirection& sun) {
  return std::abs(sun.east) * field.cell_depth() > std::abs(sun.south) * field.cell_width();
}

SweptField::SweptField(const HeightField& field, std::span<const SunDirection> suns)
    : field_(field) {
  const auto needs = [&](const SunDirection& sun) {
    return sun.up >= 0.0 && is_sideways(field, sun);
  };
  if (std::any_of(suns.begin(), suns.end(), needs)) sideways_ = transposed(field);
}

SweepRows::SweepRows(const HeightField& field, const SunDirection& sun)
    : field_(&field), goes_south_(sun.south >= 0.0) {
  PHYTOBENCH_EXPECT(sun.south != 0.0 && sun.up >= 0.0);
  const double horizontal = std::hypot(sun.east, sun.south);
  const double rise_per_metre = sun.up / horizontal / horizontal;
  lag_per_row_ = (sun.east / field.cell_width()) / (std::abs(sun.south) / field.cell_depth());
  rise_per_row_ = field.cell_depth() * sun.south * rise_per_metre;
  column_rise_.reserve(static_cast<std::size_t>(field.columns()));
  for (int column = 0; column < field.columns(); ++column)
    column_rise_.push_back(column * (field.cell_width() * sun.east * rise_per_metre));
  const double farthest = lag(field.rows() - 1);
  first_line_ = farthest < 0.0 ? static_cast<std::ptrdiff_t>(std::ceil(-farthest)) : 0;
  // One more on either side, for what is rounded and for the line after the last.
  first_line_ += 1;
  lines_ = static_cast<std::size_t>(field.columns()) +
           static_cast<std::size_t>(std::ceil(std::abs(farthest))) + 3;
}

SweepRow SweepRows::row(int swept) const {
  const int row = place(swept);
  return {field_->row(row), column_rise_.data(), row * rise_per_row_, column_rise_.size()};
}

double SweepRows::rounding() const {
  const HeightRange range = height_range(*field_);
  if (range.empty()) return 0.0;
  const double farthest = std::abs(column_rise_.back()) + field_->rows() * std::abs(rise_per_row_);
  const double largest = std::max(std::abs(range.lowest), std::abs(range.highest)) + farthest;
  return 64.0 * std::numeric_limits<double>::epsilon() * largest;
}

namespace {

/// Rows and columns of 64 x 64 bits exchanged in place (Warren 2012, sec. 7-3).
void transpose_block(std::uint64_t (&block)[64]) {
  std::uint64_t mask = 0x00000000FFFFFFFFull;
  for (unsigned width = 32; width != 0; width >>= 1, mask ^= mask << width)
    for (unsigned k = 0; k < 64; k = ((k | width) + 1) & ~width) {
      const std::uint64_t moved = ((block[k] >> width) ^ block[k | width]) & mask;
      block[k] ^= moved << width;
      block[k | width] ^= moved;
    }
}

}  // namespace

void transpose_bits(const LitMaps& from, std::size_t from_position, LitMaps& to,
                    std::size_t to_position) {
  PHYTOBENCH_EXPECT(from.columns() == to.rows() && from.rows() == to.columns());
  std::uint64_t block[64];
  for (int top = 0; top < from.rows(); top += 64)
    for (int left = 0; left < from.columns(); left += 64) {
      for (int row = 0; row < 64; ++row)
        block[row] = top + row < from.rows() ? from.row(from_position, top + row)[left / 64] : 0;
      transpose_block(block);
      for (int column = 0; column < std::min(64, from.columns() - left); ++column)
        to.row(to_position, left + column)[top / 64] = block[column];
    }
}

}  // namespace phytobench
