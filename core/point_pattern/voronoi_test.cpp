// SPDX-License-Identifier: MIT
#include "core/point_pattern/voronoi.hpp"

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "core/point_pattern/lattices.hpp"
#include "core/point_pattern/nearest_distances.hpp"
#include "core/point_pattern/random_patterns.hpp"
#include "core/point_pattern/test_patterns.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

using test_patterns::Points;

CellIntegrals total(const std::vector<CellIntegrals>& cells) {
  CellIntegrals sum;
  for (const CellIntegrals& cell : cells) {
    sum.area += cell.area;
    sum.distance += cell.distance;
    sum.squared_distance += cell.squared_distance;
  }
  return sum;
}

TEST(VoronoiLaw, CellsFillTheWindowWhateverThePattern) {
  for (const auto& [name, window, points] : test_patterns::assorted_patterns()) {
    if (points.empty()) continue;
    const auto cells = voronoi_integrals(points, window);
    EXPECT_NEAR(total(cells).area / window.area(), 1.0, 1e-12) << name;
    for (const CellIntegrals& cell : cells) EXPECT_GE(cell.area, -1e-12 * window.area()) << name;
  }
}

/// The definition of empty space, at places that fill the window evenly and in no direction's line.
TEST(VoronoiOracle, MomentsAreThoseOfPlacesEverywhere) {
  for (const auto& [name, window, points] : test_patterns::assorted_patterns()) {
    if (points.empty()) continue;
    const Rectangle& box = window.bounding_box();
    Points places;
    for (int i = 0; i < 60'000; ++i) {
      const double u = 0.7548776662466927 * i, v = 0.5698402909980532 * i;
      const Point2 p{box.low.x + (u - std::floor(u)) * box.width(),
                     box.low.y + (v - std::floor(v)) * box.height()};
      if (window.contains(p)) places.push_back(p);
    }
    double mean = 0.0, squares = 0.0;
    for (const double d : nearest_distances_from(places, points, window)) {
      mean += d / static_cast<double>(places.size());
      squares += d * d / static_cast<double>(places.size());
    }
    const EmptySpaceMoments exact = empty_space_moments(points, window);
    EXPECT_NEAR(exact.mean_distance / mean, 1.0, 2e-3) << name;
    EXPECT_NEAR(exact.mean_squared_distance / squares, 1.0, 2e-3) << name;
  }
}

TEST(Voronoi, LatticesHaveTheirClosedForms) {
  const double s2 = std::sqrt(2.0), s3 = std::sqrt(3.0);
  for (const int size : {1, 2, 3, 20, 31}) {
    const auto n = static_cast<std::size_t>(size);
    const Rectangle box{{0, 0}, {1.0 * size, 1.0 * size}};
    const EmptySpaceMoments m = empty_space_moments(square_lattice(box, n, n), Window::torus(box));
    EXPECT_NEAR(m.mean_distance, (s2 + std::asinh(1.0)) / 6, 1e-13) << size;
    EXPECT_NEAR(m.mean_squared_distance, 1.0 / 6, 1e-13) << size;
  }
  for (const std::size_t rows : {2u, 4u, 14u}) {
    const Rectangle box{{0, 0}, {12, static_cast<double>(rows) * s3 / 2}};
    const EmptySpaceMoments m =
        empty_space_moments(triangular_lattice(box, 12, rows), Window::torus(box));
    EXPECT_NEAR(m.mean_distance, (1.0 / 3 + std::log(3.0) / 4) / s3, 1e-13) << rows;
    EXPECT_NEAR(m.mean_squared_distance, 5.0 / 36, 1e-13) << rows;
  }
}

TEST(Voronoi, OnePointHasTheWholeWindow) {
  const Window square = Window::rectangle({{0, 0}, {2, 2}});
  const EmptySpaceMoments m = empty_space_moments(Points{{1, 1}}, square);
  EXPECT_NEAR(m.mean_distance, (std::sqrt(2.0) + std::asinh(1.0)) / 3, 1e-14);
  EXPECT_NEAR(m.mean_squared_distance, 2.0 / 3, 1e-14);
  EXPECT_NEAR(empty_space_moments(Points{{0, 0}}, square).mean_squared_distance, 8.0 / 3, 1e-14);
}

TEST(Voronoi, TheFirstOfTwinsHasTheCell) {
  const Window square = Window::rectangle({{0, 0}, {2, 1}});
  const Points points{{0.5, 0.5}, {1.5, 0.5}, {0.5, 0.5}};
  const auto cells = voronoi_integrals(points, square);
  EXPECT_NEAR(cells[0].area, 1.0, 1e-14);
  EXPECT_NEAR(cells[1].area, 1.0, 1e-14);
  EXPECT_EQ(cells[2].area, 0.0);
  EXPECT_TRUE(voronoi_cells(points, square)[2].empty());
}

TEST(Voronoi, CellsOfAPolygonStayInsideIt) {
  const Window l = test_patterns::l_shape();
  const Points points{{0.5, 1.9}, {1.9, 0.5}};
  const auto cells = voronoi_integrals(points, l);
  EXPECT_NEAR(cells[0].area, 1.5, 1e-14);
  EXPECT_NEAR(cells[1].area, 1.5, 1e-14);
}

TEST(VoronoiLaw, SimilarPatternsHaveSimilarCells) {
  const Window periodic_window = Window::torus({{0, 0}, {4, 3}});
  const Points points = test_patterns::random_points(periodic_window, 200, 3);
  const double mean = empty_space_moments(points, periodic_window).mean_distance;
  Points moved, turned;
  for (const Point2& p : points) {
    moved.push_back({0x1p-20 * p.x + 4, 0x1p-20 * p.y - 8});
    turned.push_back({3 - p.y, p.x});
  }
  const Window small = Window::torus({{4, -8}, {4 + 0x1p-18, -8 + 3 * 0x1p-20}});
  EXPECT_NEAR(empty_space_moments(moved, small).mean_distance * 0x1p20 / mean, 1.0, 1e-8);
  const Window upright = Window::torus({{0, 0}, {3, 4}});
  EXPECT_NEAR(empty_space_moments(turned, upright).mean_distance / mean, 1.0, 1e-13);
}

TEST(VoronoiLaw, ShiftsOnATorusAndThreadsChangeNothing) {
  const Window periodic_window = Window::torus(test_patterns::unit_square);
  const Points points = test_patterns::clustered_points(periodic_window, 5000, 0.1, 4);
  const EmptySpaceMoments first = empty_space_moments(points, periodic_window);
  Points shifted;
  for (const Point2& p : points)
    shifted.push_back(periodic_window.wrapped({p.x + 0.375, p.y - 0.625}));
  const EmptySpaceMoments second = empty_space_moments(shifted, periodic_window);
  EXPECT_NEAR(second.mean_distance / first.mean_distance, 1.0, 1e-12);
  const auto one = voronoi_integrals(points, periodic_window),
             three = voronoi_integrals(points, periodic_window, 3);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(one[i].distance, three[i].distance);
    EXPECT_EQ(one[i].area, three[i].area);
  }
}

}  // namespace
}  // namespace phytobench
