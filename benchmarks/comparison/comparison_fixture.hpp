// SPDX-License-Identifier: MIT
// Measurements made up for tests of what is concluded from them.
#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "benchmarks/comparison/comparison.hpp"

namespace phytobench {

/// Blocks of which the log ratios are these, but for rounding.
inline std::vector<BlockTimes> blocks_of(const std::vector<double>& log_ratios) {
  std::vector<BlockTimes> blocks;
  for (const double log_ratio : log_ratios) {
    const double other_s = 0.5 * std::exp(log_ratio);
    blocks.push_back({.block = static_cast<int>(blocks.size()),
                      .order = "ABBA",
                      .base = {0.5, 0.5},
                      .other = {other_s, other_s}});
  }
  return blocks;
}

/// Evenly spread log ratios around that of `ratio`, up to `reach` away.
inline std::vector<BlockTimes> even_blocks(int count, double ratio, double reach) {
  std::vector<double> log_ratios;
  for (int i = 0; i < count; ++i)
    log_ratios.push_back(std::log(ratio) + reach * (2.0 * i / (count - 1.0) - 1.0));
  return blocks_of(log_ratios);
}

inline MeasuredBenchmark measured_benchmark(std::string name, std::vector<BlockTimes> control,
                                            std::vector<BlockTimes> blocks) {
  return {.name = std::move(name), .control = std::move(control), .blocks = std::move(blocks)};
}

}  // namespace phytobench
