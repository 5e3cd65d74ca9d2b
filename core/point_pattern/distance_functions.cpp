// SPDX-License-Identifier: MIT
#include "core/point_pattern/distance_functions.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/contract/check.hpp"
#include "core/point_pattern/edge_distance.hpp"
#include "core/point_pattern/nearest_distances.hpp"
#include "core/point_pattern/special_values.hpp"

namespace phytobench {

namespace {

void expect_increasing(std::span<const double> distances) {
  for (std::size_t k = 0; k < distances.size(); ++k)
    PHYTOBENCH_EXPECT(std::isfinite(distances[k]) &&
                      (k == 0 ? distances[0] >= 0.0 : distances[k] > distances[k - 1]));
}

/// Share of places with measured <= r among those with r <= limit, for each r.
std::vector<double> reduced_sample(std::span<const double> measured, std::span<const double> limits,
                                   std::span<const double> asked) {
  // A place is asked until its limit, and says yes from its measured distance to there.
  std::vector<std::int64_t> places(asked.size() + 1, 0), near(asked.size() + 1, 0);
  for (std::size_t i = 0; i < measured.size(); ++i) {
    const auto first = std::lower_bound(asked.begin(), asked.end(), measured[i]) - asked.begin();
    const auto end = std::upper_bound(asked.begin(), asked.end(), limits[i]) - asked.begin();
    ++places[0], --places[static_cast<std::size_t>(end)];
    if (first < end) ++near[static_cast<std::size_t>(first)], --near[static_cast<std::size_t>(end)];
  }
  std::vector<double> shares;
  std::int64_t all = 0, yes = 0;
  for (std::size_t k = 0; k < asked.size(); ++k) {
    all += places[k], yes += near[k];
    shares.push_back(all > 0 ? static_cast<double>(yes) / static_cast<double>(all) : unknown_value);
  }
  return shares;
}

struct Lifetime {
  double end;
  bool is_known;  ///< the nearest point was met before the border
  friend bool operator<(const Lifetime& a, const Lifetime& b) { return a.end < b.end; }
};

std::vector<double> kaplan_meier(std::span<const double> measured, std::span<const double> to_edge,
                                 std::span<const double> asked) {
  std::vector<Lifetime> lives;
  for (std::size_t i = 0; i < measured.size(); ++i)
    lives.push_back({std::min(measured[i], to_edge[i]), measured[i] <= to_edge[i]});
  std::sort(lives.begin(), lives.end());
  std::vector<double> shares;
  double surviving = 1.0;
  std::size_t begin = 0;
  for (const double r : asked) {
    while (begin < lives.size() && lives[begin].end <= r) {
      // All that end at the same distance at once; those censored there are still at risk.
      std::size_t end = begin, deaths = 0;
      for (; end < lives.size() && lives[end].end == lives[begin].end; ++end)
        deaths += lives[end].is_known;
      surviving *= 1.0 - static_cast<double>(deaths) / static_cast<double>(lives.size() - begin);
      begin = end;
    }
    shares.push_back(lives.empty() ? unknown_value : 1.0 - surviving);
  }
  return shares;
}

}  // namespace

std::vector<double> distance_distribution(std::span<const double> measured,
                                          std::span<const double> to_edge,
                                          std::span<const double> asked,
                                          DistanceCorrection correction) {
  PHYTOBENCH_EXPECT(measured.size() == to_edge.size());
  expect_increasing(asked);
  switch (correction) {
    case DistanceCorrection::kaplan_meier:
      return kaplan_meier(measured, to_edge, asked);
    case DistanceCorrection::border:
      return reduced_sample(measured, to_edge, asked);
    case DistanceCorrection::none:
      break;
  }
  const std::vector<double> nowhere(measured.size(), std::numeric_limits<double>::infinity());
  return reduced_sample(measured, nowhere, asked);
}

std::vector<double> nearest_neighbour_function(std::span<const Point2> points, const Window& window,
                                               std::span<const double> distances,
                                               const DistanceFunctionOptions& options) {
  return distance_distribution(nearest_distances(points, window, options.threads),
                               distances_to_edge(window, points), distances, options.correction);
}

std::vector<double> empty_space_function(std::span<const Point2> points, const Window& window,
                                         std::span<const double> distances,
                                         const DistanceFunctionOptions& options) {
  const std::vector<Point2> places = test_grid(window, options.grid_side);
  return distance_distribution(nearest_distances_from(places, points, window, options.threads),
                               distances_to_edge(window, places), distances, options.correction);
}

std::vector<double> j_function(std::span<const Point2> points, const Window& window,
                               std::span<const double> distances,
                               const DistanceFunctionOptions& options) {
  const std::vector<double> g = nearest_neighbour_function(points, window, distances, options);
  const std::vector<double> f = empty_space_function(points, window, distances, options);
  std::vector<double> values;
  for (std::size_t k = 0; k < g.size(); ++k)
    values.push_back(f[k] < 1.0 ? (1.0 - g[k]) / (1.0 - f[k]) : unknown_value);
  return values;
}

std::vector<Point2> test_grid(const Window& window, std::size_t side) {
  PHYTOBENCH_EXPECT(side > 0);
  const Rectangle& box = window.bounding_box();
  const auto cells = static_cast<double>(side);
  std::vector<Point2> places;
  for (std::size_t row = 0; row < side; ++row) {
    const double y = box.low.y + (static_cast<double>(row) + 0.5) / cells * box.height();
    for (std::size_t column = 0; column < side; ++column) {
      const double x = box.low.x + (static_cast<double>(column) + 0.5) / cells * box.width();
      if (window.contains({x, y})) places.push_back({x, y});
    }
  }
  return places;
}

}  // namespace phytobench
