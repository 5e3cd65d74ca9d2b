// SPDX-License-Identifier: MIT
#include "core/point_pattern/nearest_distances.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/point_pattern/test_patterns.hpp"

namespace phytobench {
namespace {

using namespace test_patterns;

constexpr std::size_t nobody = std::numeric_limits<std::size_t>::max();

double nearest_by_loop(const Point2& query, const Points& points, const Window& window,
                       std::size_t self = nobody) {
  double least = infinity;
  for (std::size_t j = 0; j < points.size(); ++j) {
    if (j == self) continue;
    const Point2 d = window.difference(query, points[j]);
    least = std::min(least, std::sqrt(d.x * d.x + d.y * d.y));
  }
  return least;
}

TEST(NearestDistancesOracle, AreThoseOfADoubleLoop) {
  for (const auto& [name, window, points] : assorted_patterns()) {
    const std::vector<double> distances = nearest_distances(points, window);
    ASSERT_EQ(distances.size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
      EXPECT_EQ(distances[i], nearest_by_loop(points[i], points, window, i)) << name << " " << i;
  }
}

TEST(NearestDistancesOracle, FromQueriesAreThoseOfADoubleLoop) {
  for (const auto& [name, window, points] : assorted_patterns()) {
    Points queries = random_points(window, 3000, 17);
    queries.insert(queries.end(), points.begin(), points.end());
    queries.insert(queries.end(), window.corners().begin(), window.corners().end());
    const std::vector<double> distances = nearest_distances_from(queries, points, window);
    for (std::size_t i = 0; i < queries.size(); ++i)
      EXPECT_EQ(distances[i], nearest_by_loop(queries[i], points, window)) << name << " " << i;
  }
}

TEST(NearestDistancesOracle, HoldOnSmallToriAndPlotsOfAnyShape) {
  for (std::uint64_t set = 0; set < 400; ++set) {
    CounterStream stream(8, set);
    const Rectangle box{{-1.0, 2.0},
                        {stream.next_between(-0.9, 3.0), stream.next_between(2.1, 6.0)}};
    const Window window = set % 2 == 0 ? Window::torus(box) : Window::rectangle(box);
    const Points points =
        random_points(window, static_cast<std::size_t>(stream.next_between(1.0, 40.0)), set);
    const std::vector<double> distances = nearest_distances(points, window);
    for (std::size_t i = 0; i < points.size(); ++i)
      EXPECT_EQ(distances[i], nearest_by_loop(points[i], points, window, i)) << "set " << set;
  }
}

TEST(NearestDistances, OfFewPointsAreDefined) {
  const Window square = Window::rectangle(unit_square);
  EXPECT_TRUE(nearest_distances({}, square).empty());
  EXPECT_EQ(nearest_distances(Points{{0.5, 0.5}}, square), std::vector{infinity});
  EXPECT_EQ(nearest_distances_from(Points{{0.0, 1.0}}, {}, square), std::vector{infinity});
  EXPECT_EQ(nearest_distances(Points{{0.0, 0.0}, {0.0, 1.0}}, Window::torus(unit_square)),
            (std::vector{0.0, 0.0}));  // the same place on a torus
}

TEST(NearestDistances, OfAHeapTakeNoQuadraticTime) {
  Points heap(200000, Point2{0.5, 0.5});
  heap.push_back({1.0, 1.0});
  const std::vector<double> distances = nearest_distances(heap, Window::rectangle(unit_square));
  EXPECT_EQ(distances.front(), 0.0);
  EXPECT_EQ(distances.back(), std::sqrt(0.5));
}

TEST(NearestDistancesLaw, ThreadsDoNotMatter) {
  for (const Window& window : {l_shape(), Window::torus(unit_square)}) {
    const Points points = random_points(window, 20000, 6), queries = random_points(window, 5000, 7);
    EXPECT_EQ(nearest_distances(points, window, 4), nearest_distances(points, window));
    EXPECT_EQ(nearest_distances_from(queries, points, window, 3),
              nearest_distances_from(queries, points, window));
  }
}

TEST(NearestDistancesLaw, ScaleWithThePattern) {
  const Points points = random_points(Window::rectangle(unit_square), 500, 8);
  const std::vector<double> distances = nearest_distances(points, Window::rectangle(unit_square));
  for (const double factor : {0x1p-20, 0x1p20}) {  // exact in binary
    Points scaled;
    for (const Point2& p : points) scaled.push_back(factor * p);
    const Window window = Window::rectangle({{0.0, 0.0}, {factor, factor}});
    const std::vector<double> found = nearest_distances(scaled, window);
    for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(found[i], factor * distances[i]);
  }
}

TEST(NearestDistances, RefusePointsOutside) {
  const Window square = Window::rectangle(unit_square);
  const Points outside{{1.5, 0.5}}, unknown{{NAN, 0.5}};
  EXPECT_THROW(nearest_distances(outside, square), ContractViolation);
  EXPECT_THROW(nearest_distances(unknown, square), ContractViolation);
  EXPECT_THROW(nearest_distances_from(outside, {}, square), ContractViolation);
}

}  // namespace
}  // namespace phytobench
