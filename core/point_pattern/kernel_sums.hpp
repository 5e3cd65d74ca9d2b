// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace phytobench {

/// Spreads values at single distances over the neighbouring distances of a grid with the
/// Epanechnikov kernel 0.75 / b (1 - (t / b)^2), |t| <= b, of half-width b. Shared by the functions
/// that smooth over distance, not meant for others.
class KernelGrid {
 public:
  KernelGrid(std::span<const double> distances, double half_width)
      : distances_(distances.begin(), distances.end()), half_width_(half_width) {}

  /// Beyond this no value reaches any distance of the grid.
  double reach() const { return distances_.back() + half_width_; }

  /// Calls body(k, kernel) for the grid distances with number k that the value reaches.
  template <class Body>
  void spread(double distance, const Body& body) const {
    const auto first =
        std::upper_bound(distances_.begin(), distances_.end(), distance - half_width_);
    for (auto k = static_cast<std::size_t>(first - distances_.begin()); k < distances_.size();
         ++k) {
      const double t = (distances_[k] - distance) / half_width_;
      if (t >= 1.0) return;
      body(k, 0.75 / half_width_ * (1.0 - t * t));
    }
  }

 private:
  std::vector<double> distances_;
  double half_width_;
};

}  // namespace phytobench
