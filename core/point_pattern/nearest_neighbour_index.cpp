// SPDX-License-Identifier: MIT
#include "core/point_pattern/nearest_neighbour_index.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <vector>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/special_functions/erf.hpp>

#include "core/contract/check.hpp"
#include "core/point_pattern/nearest_distances.hpp"

namespace phytobench {

namespace {

/// Area of a disc that reaches beyond one side of the rectangle around it, on that side.
double segment_beyond(double radius, double half_side) {
  if (radius <= half_side) return 0.0;
  return radius * radius * std::acos(half_side / radius) -
         half_side * std::sqrt((radius - half_side) * (radius + half_side));
}

/// Area of the torus within `radius` of a point: the disc inside a period around it. Both half
/// sides; where the disc holds a corner, what lies beyond both sides counts once.
double area_within(double radius, double half_width, double half_height) {
  if (radius * radius >= half_width * half_width + half_height * half_height)
    return 4.0 * half_width * half_height;
  return std::numbers::pi * radius * radius - 2.0 * segment_beyond(radius, half_width) -
         2.0 * segment_beyond(radius, half_height);
}

/// Pieces end where discs begin to go round, and get shorter where the integrand falls steeply.
double expected_on_torus(const Rectangle& box, std::size_t count) {
  const double a = 0.5 * std::min(box.width(), box.height());
  const double b = 0.5 * std::max(box.width(), box.height());
  const auto n = static_cast<double>(count);
  const auto beyond = [&](double r) {
    const double share = area_within(r, a, b) / box.area();
    return share >= 1.0 ? 0.0 : std::exp(n * std::log1p(-share));
  };
  const double scale = std::sqrt(box.area() / n);
  std::vector<double> ends{0.0, a, b, std::sqrt(a * a + b * b)};
  for (double end = 0.5 * scale; end < ends.back() && end < 8.0 * scale; end += 0.5 * scale)
    ends.push_back(end);
  std::sort(ends.begin(), ends.end());
  double sum = 0.0;
  for (std::size_t k = 0; k + 1 < ends.size(); ++k)
    if (ends[k + 1] > ends[k])
      sum += boost::math::quadrature::gauss_kronrod<double, 31>::integrate(beyond, ends[k],
                                                                           ends[k + 1], 8, 1e-13);
  return sum;
}

double donnelly_expectation(const Window& window, double n) {
  return 0.5 * std::sqrt(window.area() / n) +
         (0.0514 + 0.0412 / std::sqrt(n)) * window.perimeter() / n;
}

double standard_error(const Window& window, double n) {
  const double area = window.area();
  double variance = 0.0703 * area / (n * n);
  if (window.kind() != WindowKind::torus)
    variance += 0.037 * window.perimeter() * std::sqrt(area / std::pow(n, 5.0));
  return std::sqrt(variance);
}

/// Whether a strip along the edge as wide as points are apart leaves most of the window free; on a
/// torus, whether several points fit into its shorter side.
bool is_compact(const Window& window, double n) {
  const double spacing = std::sqrt(window.area() / n);
  const Rectangle& box = window.bounding_box();
  if (window.kind() == WindowKind::torus)
    return std::min(box.width(), box.height()) > 4.0 * spacing;
  return window.perimeter() * spacing < window.area();
}

}  // namespace

double expected_nearest_distance(const Window& window, std::size_t count) {
  PHYTOBENCH_EXPECT(count >= 1);
  if (window.kind() == WindowKind::torus) return expected_on_torus(window.bounding_box(), count);
  return donnelly_expectation(window, static_cast<double>(count) + 1.0);
}

ClarkEvansIndex clark_evans(std::span<const Point2> points, const Window& window, int threads) {
  ClarkEvansIndex index;
  if (points.size() < 2) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    return {nan, nan, nan, nan, nan, nan};
  }
  const std::vector<double> distances = nearest_distances(points, window, threads);
  const auto n = static_cast<double>(points.size());
  index.mean_distance = std::accumulate(distances.begin(), distances.end(), 0.0) / n;
  index.expected_distance = expected_nearest_distance(window, points.size() - 1);
  index.ratio = index.mean_distance / index.expected_distance;
  index.naive_ratio = index.mean_distance / (0.5 * std::sqrt(window.area() / n));
  if (!is_compact(window, n)) {
    index.z = index.p_value = std::numeric_limits<double>::quiet_NaN();
    return index;
  }
  index.z = (index.mean_distance - index.expected_distance) / standard_error(window, n);
  index.p_value = boost::math::erfc(std::abs(index.z) / std::numbers::sqrt2);
  return index;
}

}  // namespace phytobench
