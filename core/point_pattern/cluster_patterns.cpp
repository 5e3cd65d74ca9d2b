// SPDX-License-Identifier: MIT
#include "core/point_pattern/cluster_patterns.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string_view>

#include "core/contract/check.hpp"
#include "core/point_pattern/point_limit.hpp"
#include "core/random/distributions.hpp"

namespace phytobench {

namespace {

void expect_number(double number, NumberLaw law) {
  PHYTOBENCH_EXPECT(std::isfinite(number) && number >= 0.0);
  PHYTOBENCH_EXPECT(law == NumberLaw::poisson || number == std::floor(number));
}

/// Where parents stand: all of a torus; elsewhere also beyond the edges.
Rectangle parent_region(const Window& window, double margin) {
  Rectangle region = window.bounding_box();
  if (window.kind() == WindowKind::torus) return region;
  region.low = region.low - Point2{margin, margin};
  region.high = region.high + Point2{margin, margin};
  return region;
}

std::uint64_t number_of(double mean, NumberLaw law, UnitStream& stream) {
  if (law == NumberLaw::poisson) return random_poisson(mean, stream);
  if (mean == std::floor(mean)) return static_cast<std::uint64_t>(mean);
  return static_cast<std::uint64_t>(std::floor(mean + stream.next_unit()));
}

/// `displacement` draws the way from a parent to one of its points.
template <typename Displacement>
std::vector<Point2> cluster_points(const Window& window, const ClusterNumbers& numbers,
                                   double margin, UnitStream& stream,
                                   const Displacement& displacement) {
  expect_number(numbers.parents, numbers.parents_law);
  expect_number(numbers.offspring, numbers.offspring_law);
  const bool goes_round = window.kind() == WindowKind::torus;
  const Rectangle region = parent_region(window, margin);
  const double parents =
      goes_round ? numbers.parents : numbers.parents * region.area() / window.area();
  constexpr std::string_view advice =
      "lower the number of parents or points, or how far points go from their parents";
  refuse_too_many_points(numbers.offspring, advice);
  // A parent without points is a draw all the same.
  refuse_too_many_points(parents * (1.0 + numbers.offspring), advice);

  std::vector<Point2> points;
  for (std::uint64_t left = number_of(parents, numbers.parents_law, stream); left > 0; --left) {
    const double x = stream.next_between(region.low.x, region.high.x);
    const Point2 parent{x, stream.next_between(region.low.y, region.high.y)};
    std::uint64_t offspring = number_of(numbers.offspring, numbers.offspring_law, stream);
    for (; offspring > 0; --offspring) {
      const Point2 p = window.wrapped(parent + displacement());
      if (window.contains(p)) points.push_back(p);
    }
  }
  return points;
}

}  // namespace

std::vector<Point2> thomas_points(const Window& window, const ThomasOptions& options,
                                  UnitStream& stream) {
  PHYTOBENCH_EXPECT(std::isfinite(options.sigma) && options.sigma >= 0.0);
  const double margin = thomas_margin_in_sigmas * options.sigma;
  return cluster_points(window, options.numbers, margin, stream, [&] {
    const auto [x, y] = random_normal_pair(stream);
    return Point2{options.sigma * x, options.sigma * y};
  });
}

std::vector<Point2> matern_cluster_points(const Window& window, const MaternOptions& options,
                                          UnitStream& stream) {
  PHYTOBENCH_EXPECT(std::isfinite(options.radius) && options.radius >= 0.0);
  return cluster_points(window, options.numbers, options.radius, stream, [&] {
    // The square root makes equal areas equally likely.
    const double distance = options.radius * std::sqrt(stream.next_unit());
    const double angle = 2.0 * std::numbers::pi * stream.next_unit();
    return Point2{distance * std::cos(angle), distance * std::sin(angle)};
  });
}

}  // namespace phytobench
