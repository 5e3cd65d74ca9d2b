// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

namespace phytobench {

/// How discs share ground that several of them cover: each has its area^exponent over the sum of
/// that of all who cover the place (the influence functions of Garcia 2014, siplab).
struct SharingLaw {
  /// 0: equal shares; 1: by size; infinity: all to the largest. >= 0.
  double exponent = 0.0;
  /// Of discs with equal areas and an infinite exponent the one with the lowest number has all; by
  /// index where numbers are equal. Empty: they share. Not read for finite exponents.
  std::span<const std::uint64_t> tie_order = {};

  bool is_fit(std::size_t discs) const {
    return exponent >= 0.0 && (tie_order.empty() || tie_order.size() == discs);
  }

  bool breaks_ties() const { return std::isinf(exponent) && !tie_order.empty(); }

  /// Whether disc i comes before j in the order from large to small, ties by index.
  bool is_before(std::span<const double> radius, std::size_t i, std::size_t j) const {
    if (radius[i] != radius[j]) return radius[i] > radius[j];
    if (breaks_ties() && tie_order[i] != tie_order[j]) return tie_order[i] < tie_order[j];
    return i < j;
  }

  /// Weight of disc i over that of disc j; 0 or infinite where a double cannot hold it. Radii > 0.
  double weight_ratio(std::span<const double> radius, std::size_t i, std::size_t j) const {
    if (i == j) return 1.0;
    if (std::isinf(exponent) && (breaks_ties() || radius[i] != radius[j]))
      return is_before(radius, i, j) ? std::numeric_limits<double>::infinity() : 0.0;
    if (radius[i] == radius[j]) return 1.0;
    // Near 1 a quotient would lose what a large exponent brings to light.
    const double more = (radius[i] - radius[j]) / radius[j];
    const double logarithm =
        std::abs(more) < 0.5 ? std::log1p(more) : std::log(radius[i] / radius[j]);
    return std::exp(2.0 * exponent * logarithm);
  }
};

}  // namespace phytobench
