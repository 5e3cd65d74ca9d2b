// SPDX-License-Identifier: MIT
#include "benchmarks/regression/checks/pattern_checks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "benchmarks/point_pattern/hopkins_race.hpp"
#include "benchmarks/regression/checks/empty_space.hpp"
#include "core/contract/check.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {

namespace {

constexpr std::size_t nobody = std::numeric_limits<std::size_t>::max();

/// To the nearest of all points but number `left_out`.
double nearest(const Point2& place, std::span<const Point2> points, std::size_t left_out = nobody) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t j = 0; j < points.size(); ++j) {
    const double dx = points[j].x - place.x, dy = points[j].y - place.y;
    if (j != left_out) least = std::min(least, dx * dx + dy * dy);
  }
  return std::sqrt(least);
}

}  // namespace

std::string objection_to_hopkins(const HopkinsIndex& found, std::span<const Point2> points,
                                 const Rectangle& window) {
  PHYTOBENCH_EXPECT(points.size() >= 2);
  double sum = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double distance = nearest(points[i], points, i);
    sum += distance;
    squares += distance * distance;
  }
  const auto n = static_cast<double>(points.size());
  const EmptySpaceMoments empty = empty_space_by_all_bisectors(points, window);
  constexpr double rounding = 1e-11;  // of sums over thousands of cells
  return objection_to(
      found, {empty.mean_distance * n / sum, empty.mean_squared_distance * n / squares}, rounding);
}

std::string objection_to_ripley_k(std::span<const double> found, std::span<const Point2> points,
                                  const Rectangle& window, std::span<const double> distances) {
  if (found.size() != distances.size())
    return fmt::format("{} values for {} distances", found.size(), distances.size());
  std::vector<double> sums(distances.size(), 0.0);
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < points.size(); ++j) {
      const double dx = points[j].x - points[i].x, dy = points[j].y - points[i].y;
      const double apart = std::sqrt(dx * dx + dy * dy);
      if (i == j || apart > distances.back()) continue;
      const double common = (window.width() - std::abs(dx)) * (window.height() - std::abs(dy));
      for (std::size_t k = distances.size(); k-- > 0 && apart <= distances[k];)
        sums[k] += window.area() / common;
    }
  const auto n = static_cast<double>(points.size());
  constexpr double rounding = 1e-11;  // of sums of some hundred thousand weights
  for (std::size_t k = 0; k < sums.size(); ++k) {
    const double expected = window.area() * sums[k] / (n * (n - 1.0));
    if (!(std::abs(found[k] - expected) <= rounding * expected))
      return fmt::format("K({:.6g}) is {:.17g}, by a double loop {:.17g}", distances[k], found[k],
                         expected);
  }
  return {};
}

std::string objection_to_nearest_distances(std::span<const double> found,
                                           std::span<const Point2> points) {
  if (found.size() != points.size())
    return fmt::format("{} distances of {} points", found.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double expected = nearest(points[i], points, i);
    if (found[i] != expected)
      return fmt::format("point {}: nearest at {:.17g}, by a double loop {:.17g}", i, found[i],
                         expected);
  }
  return {};
}

std::string objection_to_darts(std::span<const Point2> found, const Window& window, double distance,
                               std::uint64_t seed) {
  PHYTOBENCH_EXPECT(window.kind() != WindowKind::torus);
  constexpr double rounding = 1e-12;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (!window.contains(found[i])) return fmt::format("dart {} lies outside the window", i);
    const double apart = nearest(found[i], found, i);
    if (!(apart >= distance * (1.0 - rounding)))
      return fmt::format("dart {} is {:.17g} from another, less than {:.17g}", i, apart, distance);
  }
  constexpr int places = 20'000;
  CounterStream stream(seed, 2);
  for (int k = 0; k < places; ++k) {
    const Point2 place = window.random_point(stream);
    if (nearest(place, found) > distance * (1.0 + rounding))
      return fmt::format("there is room for one more at ({:.6g}, {:.6g})", place.x, place.y);
  }
  return {};
}

}  // namespace phytobench
