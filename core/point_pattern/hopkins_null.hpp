// SPDX-License-Identifier: MIT
// What the Hopkins index is for random patterns in the same window, and how often one would look
// like the observed pattern.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/point_pattern/hopkins.hpp"

namespace phytobench {

/// hopkins_exact() of patterns that are completely random, with fixed numbers of points.
struct HopkinsNull {
  std::vector<double> mean_ratio;
  std::vector<double> squared_ratio;
  std::size_t points_per_pattern = 0;  ///< fewer than asked about: then the spread is scaled
};

struct HopkinsNullOptions {
  std::size_t simulations = 999;
  std::uint64_t seed = 0;  ///< simulation k draws from CounterStream(seed, k)
  int threads = 1;         ///< never change the result
  /// Larger patterns are simulated with so many points of the same density, in a window cut at its
  /// longer side, so that a strip stays a strip; deviations from the mean are then multiplied by
  /// the root of the ratio of numbers, the mean's from 1 by the ratio, as both fall for large
  /// patterns. Exact tests need it to be at least the number of points.
  std::size_t most_points = 2000;
  /// The window is the bounding box of the pattern: see box_filling_pattern().
  bool fills_box = false;
  /// Called before each simulation, on any thread; may throw to give up. May be empty.
  std::function<void()> checkpoint = {};
};

HopkinsNull hopkins_null(const Window& window, std::size_t points,
                         const HopkinsNullOptions& options);

/// 2.5 % and 97.5 % quantiles.
std::array<double, 2> central_95(const std::vector<double>& values);

}  // namespace phytobench
