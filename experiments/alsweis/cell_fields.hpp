// SPDX-License-Identifier: MIT
// What cells are filled with, and what is asked of their counts.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>

#include "core/population/cell_population.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench::experiments::alsweis {

inline void fill(CellPopulation& cells,
                 const std::function<double(std::size_t, std::size_t)>& field) {
  const std::size_t width = cells.grid().width;
  for (std::size_t i = 0; i < cells.counts().size(); ++i)
    cells.counts()[i] = field(i % width, i / width);
}

inline auto checkerboard(double even, double odd) {
  return [=](std::size_t x, std::size_t y) { return (x + y) % 2 == 0 ? even : odd; };
}

inline auto random_field(std::uint64_t seed, double low, double high) {
  return [=](std::size_t x, std::size_t y) { return low + (high - low) * random_unit(seed, y, x); };
}

inline void run_years(CellPopulation& cells, int years) {
  for (int t = 0; t < years; ++t) cells.step();
}

inline double largest_of(const CellPopulation& cells) {
  return *std::max_element(cells.counts().begin(), cells.counts().end());
}

inline double least_of(const CellPopulation& cells) {
  return *std::min_element(cells.counts().begin(), cells.counts().end());
}

}  // namespace phytobench::experiments::alsweis
