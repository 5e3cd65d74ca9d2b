// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "core/nearest_node/node_driven/row_index.hpp"

namespace phytobench {

/// Which rows a node may reach, seen from its own row: worked out once for each of the places
/// (RowShape::places) that it can have within its row's cross-section. A list may name a row too
/// many, never one too few.
class RowStencil {
 public:
  static constexpr std::size_t lanes = 8;  ///< lists are padded to a multiple of this

  struct List {
    std::size_t begin, end;
  };

  void reset(const RowShape& shape, double reach);

  /// Rows for a node at (place_y, place_z), each 0 ... places() - 1.
  List rows(std::int32_t place_y, std::int32_t place_z) const {
    const auto place = static_cast<std::size_t>(place_z * places_ + place_y);
    return {begins_[place], begins_[place + 1]};
  }

  const std::int32_t* y() const { return y_.data(); }          ///< rows away along y
  const std::int32_t* z() const { return z_.data(); }          ///< rows away along z
  const std::int32_t* row() const { return row_.data(); }      ///< row numbers away
  const std::int32_t* entry() const { return entry_.data(); }  ///< entries away

  std::int32_t places() const { return places_; }         ///< along y and along z
  std::int32_t span() const { return span_; }             ///< largest |y| or |z|
  std::int32_t span_x() const { return span_x_; }         ///< cells away along x, at most
  float squared_reach() const { return squared_reach_; }  ///< in row edges, rounded up
  float cells_per_row_edge() const { return cells_per_row_edge_; }

 private:
  void list_place(const RowShape& shape, double reach, std::int32_t place_y, std::int32_t place_z);
  void add(std::int32_t y, std::int32_t z, std::int32_t row, std::int32_t entry);

  std::vector<std::int32_t> y_, z_, row_, entry_;
  std::vector<std::size_t> begins_;
  std::int32_t places_ = 1;
  std::int32_t span_ = 0;
  std::int32_t span_x_ = 0;
  float squared_reach_ = 0.0f;
  float cells_per_row_edge_ = 1.0f;
};

}  // namespace phytobench
