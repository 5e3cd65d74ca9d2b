// SPDX-License-Identifier: MIT
#include "core/competition/cell_rows.hpp"

#include <fmt/format.h>

#include "core/contract/errors.hpp"

namespace phytobench {

namespace {

/// From the corner at which cells begin.
constexpr double most_cells = 5e7;

[[noreturn]] void refuse_side(double side, const char* why) {
  throw InputError(fmt::format("cells of side {} {}", side, why));
}

[[noreturn]] void refuse_small_side(double side) {
  refuse_side(side, "are too small for this ground: choose at most 5e7 of them in a row");
}

/// How many cells make up this side of a torus.
std::int64_t cells_along(double length, double side) {
  const double count = std::round(length / side);
  if (count > most_cells) refuse_small_side(side);
  if (count < 1.0 || std::abs(count * side - length) > 1e-9 * length)
    refuse_side(side, "do not fill the torus: choose a side that divides both of its sides");
  return static_cast<std::int64_t>(count);
}

}  // namespace

CellRows::CellRows(const Discs& discs, const Ground& ground, double side) {
  if (!(side > 0.0 && std::isfinite(side)))
    refuse_side(side, "cannot be: choose a positive length");
  lay_out(ground, side);
  for (const DiscEntry& entry : entries_with_images(discs, ground)) add(entry, side);
  if (reaches_.empty()) return;
  std::int64_t last_column = reaches_.front().high_column;
  first_column_ = reaches_.front().low_column;
  for (const CellReach& reach : reaches_) {
    first_column_ = std::min(first_column_, reach.low_column);
    last_column = std::max(last_column, reach.high_column);
  }
  columns_ = static_cast<std::size_t>(last_column - first_column_ + 1);
}

void CellRows::lay_out(const Ground& ground, double side) {
  step_ = {side, side};
  if (!ground.torus) return;
  torus_columns_ = cells_along(ground.period_x(), side);
  torus_rows_ = cells_along(ground.period_y(), side);
  low_ = ground.torus->low;
  step_ = {ground.period_x() / static_cast<double>(torus_columns_),
           ground.period_y() / static_cast<double>(torus_rows_)};
}

void CellRows::add(const DiscEntry& entry, double side) {
  CellReach reach{entry, 0, 0, 0, 0};
  const auto range = [&](double middle, double low, double step, std::int64_t cells_of_torus,
                         std::int64_t& first, std::int64_t& last) {
    const double begin = std::floor((middle - entry.radius - low) / step - 0.5);
    const double end = std::ceil((middle + entry.radius - low) / step - 0.5);
    if (cells_of_torus == 0 && std::max(std::abs(begin), std::abs(end)) > most_cells)
      refuse_small_side(side);
    first = static_cast<std::int64_t>(begin);
    last = static_cast<std::int64_t>(end);
    if (cells_of_torus == 0) return;
    first = std::max(first, std::int64_t{0});
    last = std::min(last, cells_of_torus - 1);
  };
  range(entry.x, low_.x, step_.x, torus_columns_, reach.low_column, reach.high_column);
  range(entry.y, low_.y, step_.y, torus_rows_, reach.low_row, reach.high_row);
  if (reach.low_column <= reach.high_column && reach.low_row <= reach.high_row)
    reaches_.push_back(reach);
}

}  // namespace phytobench
