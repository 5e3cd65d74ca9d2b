// SPDX-License-Identifier: MIT
#include "core/statistics/reduced_major_axis.hpp"

#include <cmath>
#include <vector>

#include "core/contract/check.hpp"
#include "core/statistics/moments.hpp"

namespace phytobench {

namespace {

bool all_equal(std::span<const double> values) {
  for (const double value : values)
    if (value != values[0]) return false;
  return true;
}

struct Moments {
  CentredValues x, y;
  double xx, yy, xy;  ///< sums of products of deviations
  double scatter;     ///< sum of squared vertical distances from the line of least squares
};

std::optional<Moments> moments(std::span<const double> x, std::span<const double> y) {
  PHYTOBENCH_EXPECT(x.size() == y.size());
  if (x.size() < 3) return std::nullopt;
  Moments m{centred(x), centred(y), 0.0, 0.0, 0.0, 0.0};
  if (all_equal(x) || all_equal(y)) return std::nullopt;
  m.xx = product_sum(m.x.deviations, m.x.deviations);
  m.yy = product_sum(m.y.deviations, m.y.deviations);
  m.xy = product_sum(m.x.deviations, m.y.deviations);
  // Residuals one by one: 1 - r^2 would cancel where points lie close to a line.
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double residual = m.y.deviations[i] - m.xy / m.xx * m.x.deviations[i];
    m.scatter += residual * residual;
  }
  return m;
}

StraightLine line_of(const Moments& m, double slope) {
  const std::size_t points = m.x.deviations.size();
  return {.slope = slope,
          .slope_error = std::sqrt(m.scatter / static_cast<double>(points - 2) / m.xx),
          .intercept = m.y.mean - slope * m.x.mean,
          .r_squared = 1.0 - m.scatter / m.yy,
          .points = points};
}

}  // namespace

std::optional<StraightLine> least_squares_line(std::span<const double> x,
                                               std::span<const double> y) {
  const auto m = moments(x, y);
  if (!m) return std::nullopt;
  return line_of(*m, m->xy / m->xx);
}

std::optional<StraightLine> reduced_major_axis(std::span<const double> x,
                                               std::span<const double> y) {
  const auto m = moments(x, y);
  if (!m || m->xy == 0.0) return std::nullopt;
  return line_of(*m, std::copysign(std::sqrt(m->yy / m->xx), m->xy));
}

}  // namespace phytobench
