// SPDX-License-Identifier: MIT
// Landscapes that tests of cells share.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>

#include "core/population/cell_population.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench::test_cells {

inline constexpr LogisticMap no_growth{};
inline constexpr CellBorder borders[] = {CellBorder::torus, CellBorder::reflecting,
                                         CellBorder::absorbing};
inline constexpr CellStep steps[] = {CellStep::unclipped, CellStep::positive_part,
                                     CellStep::conserving};

/// alpha = 0.3 and K = 1 unless said otherwise.
inline LogisticMap map_of(double fertility = 0.3, double capacity = 1.0) {
  return LogisticMap::of_rate(1.0 + fertility, capacity);
}

using Field = std::function<double(std::size_t x, std::size_t y)>;

inline void fill(CellPopulation& cells, const Field& field) {
  const std::size_t width = cells.grid().width;
  for (std::size_t i = 0; i < cells.counts().size(); ++i)
    cells.counts()[i] = field(i % width, i / width);
}

inline Field random_field(double low, double high, std::uint64_t stream) {
  return [=](std::size_t x, std::size_t y) {
    return low + (high - low) * random_unit(7, stream, 100'000 * y + x);
  };
}

inline Field checkerboard(double even, double odd) {
  return [=](std::size_t x, std::size_t y) { return (x + y) % 2 == 0 ? even : odd; };
}

inline void run(CellPopulation& cells, int years) {
  for (int t = 0; t < years; ++t) cells.step();
}

inline double largest_of(const CellPopulation& cells) {
  return *std::max_element(cells.counts().begin(), cells.counts().end());
}

inline double least_of(const CellPopulation& cells) {
  return *std::min_element(cells.counts().begin(), cells.counts().end());
}

}  // namespace phytobench::test_cells
