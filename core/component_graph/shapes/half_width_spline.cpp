// SPDX-License-Identifier: MIT
#include "core/component_graph/shapes/half_width_spline.hpp"

#include <algorithm>

#include "core/contract/check.hpp"

namespace phytobench {

double half_width_at(std::span<const double> half_widths, double share) {
  PHYTOBENCH_EXPECT(half_widths.size() >= 2);
  PHYTOBENCH_EXPECT(share >= 0.0 && share <= 1.0);
  const std::size_t spans = half_widths.size() - 1;
  const double along = share * static_cast<double>(spans);
  const std::size_t i = std::min(static_cast<std::size_t>(along), spans - 1);
  const double t = along - static_cast<double>(i);
  const double p1 = half_widths[i], p2 = half_widths[i + 1];
  const double p0 = i > 0 ? half_widths[i - 1] : 2.0 * p1 - p2;
  const double p3 = i + 2 <= spans ? half_widths[i + 2] : 2.0 * p2 - p1;
  const double m1 = 0.5 * (p2 - p0), m2 = 0.5 * (p3 - p1);  // slopes
  // Hermite's form, exact at both ends.
  const double rest = 1.0 - t;
  const double value = p1 * (1.0 + 2.0 * t) * rest * rest + p2 * t * t * (3.0 - 2.0 * t) +
                       m1 * t * rest * rest - m2 * t * t * rest;
  return std::max(0.0, value);
}

}  // namespace phytobench
