// SPDX-License-Identifier: MIT
#include "core/nearest_node/node_driven/row_stencil.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace phytobench {

namespace {

/// Far more than single precision loses on distances of a few row edges.
constexpr double float_slack = 1e-5;

/// A row that is outside every grid, to fill up a list.
constexpr std::int32_t no_row = 1 << 29;

}  // namespace

void RowStencil::reset(const RowShape& shape, double reach) {
  for (std::vector<std::int32_t>* list : {&y_, &z_, &row_, &entry_}) list->clear();
  begins_.assign(1, 0);
  places_ = shape.places;
  span_ = 0;
  const double in_row_edges = (reach + shape.margin) / shape.row_edge + float_slack;
  squared_reach_ = static_cast<float>(in_row_edges * in_row_edges * (1.0 + float_slack));
  cells_per_row_edge_ = static_cast<float>(shape.row_edge / shape.cell_x);
  span_x_ = static_cast<std::int32_t>(in_row_edges * shape.row_edge / shape.cell_x) + 2;
  for (std::int32_t z = 0; z < places_; ++z)
    for (std::int32_t y = 0; y < places_; ++y) list_place(shape, in_row_edges, y, z);
}

/// `reach` in row edges.
void RowStencil::list_place(const RowShape& shape, double reach, std::int32_t place_y,
                            std::int32_t place_z) {
  // The smallest distance between anything in the place and anything in the cell `away` from it.
  const auto gap = [this](std::int32_t away, std::int32_t place) {
    const double low = static_cast<double>(place) / places_ - float_slack;
    const double high = static_cast<double>(place + 1) / places_ + float_slack;
    return std::max({0.0, away - high, low - (away + 1)});
  };
  const auto furthest = static_cast<std::int32_t>(std::ceil(reach)) + 1;
  for (std::int32_t z = -furthest; z <= furthest; ++z)
    for (std::int32_t y = -furthest; y <= furthest; ++y) {
      const double gap_y = gap(y, place_y), gap_z = gap(z, place_z);
      if (gap_y * gap_y + gap_z * gap_z > reach * reach) continue;
      const std::int32_t row = z * shape.rows_y + y;
      add(y, z, row, row * shape.row_entries());
      span_ = std::max({span_, std::abs(y), std::abs(z)});
    }
  while (row_.size() % lanes != 0) add(no_row, 0, 0, 0);
  begins_.push_back(row_.size());
}

void RowStencil::add(std::int32_t y, std::int32_t z, std::int32_t row, std::int32_t entry) {
  y_.push_back(y);
  z_.push_back(z);
  row_.push_back(row);
  entry_.push_back(entry);
}

}  // namespace phytobench
