// SPDX-License-Identifier: MIT
#include "core/point_pattern/close_pairs.hpp"

#include <tuple>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/point_pattern/test_patterns.hpp"

namespace phytobench {
namespace {

using namespace test_patterns;

using Pair = std::tuple<std::size_t, std::size_t, double, double, double>;

Pair ordered(std::size_t i, std::size_t j, const Point2& d, double square) {
  return i < j ? Pair{i, j, d.x, d.y, square} : Pair{j, i, -d.x, -d.y, square};
}

std::vector<Pair> pairs_of(const ClosePairs& pairs) {
  std::vector<Pair> found;
  for (std::size_t block = 0; block < pairs.block_count(); ++block)
    pairs.visit_block(block, [&](std::size_t i, std::size_t j, const Point2& d, double square) {
      found.push_back(ordered(i, j, d, square));
    });
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<Pair> pairs_by_double_loop(const Points& points, const Window& window, double reach) {
  std::vector<Pair> found;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      const Point2 d = window.difference(points[i], points[j]);
      if (std::sqrt(d.x * d.x + d.y * d.y) <= reach)
        found.push_back(ordered(i, j, d, d.x * d.x + d.y * d.y));
    }
  std::sort(found.begin(), found.end());
  return found;
}

TEST(ClosePairsOracle, AreThoseOfADoubleLoop) {
  for (const auto& [name, window, points] : assorted_patterns()) {
    const Rectangle& box = window.bounding_box();
    const double half = 0.5 * std::min(box.width(), box.height());
    for (const double share : {0.0, 1e-9, 0.01, 0.1, 0.3, 0.5, 2.0 / 3.0, 0.9, 0.999999})
      EXPECT_EQ(pairs_of(ClosePairs(points, window, share * half)),
                pairs_by_double_loop(points, window, share * half))
          << name << ", reach " << share;
    if (window.kind() == WindowKind::torus) continue;
    EXPECT_EQ(pairs_of(ClosePairs(points, window, 9.0 * half)),
              pairs_by_double_loop(points, window, 9.0 * half))
        << name;
  }
}

// Few cells on a torus: each pair must still be met once.
TEST(ClosePairsOracle, MeetEachPairOnceOnSmallTori) {
  for (std::uint64_t set = 0; set < 300; ++set) {
    CounterStream stream(5, set);
    const Window window =
        Window::torus({{0.0, 0.0}, {stream.next_between(0.5, 4.0), stream.next_between(0.5, 4.0)}});
    const Points points =
        random_points(window, static_cast<std::size_t>(stream.next_between(2.0, 60.0)), set);
    const double half =
        0.5 * std::min(window.bounding_box().width(), window.bounding_box().height());
    const double reach = half * stream.next_unit();
    EXPECT_EQ(pairs_of(ClosePairs(points, window, reach)),
              pairs_by_double_loop(points, window, reach))
        << "set " << set;
  }
}

TEST(ClosePairCounts, CountAPairAtItsOwnDistance) {
  const Points lattice = square_lattice(8, 6);
  const Window torus = Window::torus(lattice_box(8, 6));
  const std::vector<double> distances{0.0, std::nextafter(1.0, 0.0), 1.0, std::sqrt(2.0), 2.0};
  EXPECT_EQ(close_pair_counts(lattice, torus, distances),
            (std::vector<std::int64_t>{0, 0, 2 * 48, 4 * 48, 6 * 48}));
}

TEST(ClosePairCounts, OfEqualPointsAreAllPairs) {
  const Points points(100, Point2{0.25, 1.0});
  const auto counts = close_pair_counts(points, Window::rectangle(unit_square), std::vector{0.0});
  EXPECT_EQ(counts, std::vector<std::int64_t>{4950});
}

TEST(ClosePairCountsLaw, ThreadsAndOrderDoNotMatter) {
  for (const Window& window : {Window::rectangle(unit_square), Window::torus(unit_square)}) {
    Points points = random_points(window, 20000, 4);
    const std::vector<double> distances{1e-4, 0.003, 0.01, 0.02};
    const auto counts = close_pair_counts(points, window, distances);
    EXPECT_EQ(close_pair_counts(points, window, distances, 4), counts);
    std::reverse(points.begin(), points.end());
    EXPECT_EQ(close_pair_counts(points, window, distances, 3), counts);
  }
}

TEST(ClosePairSums, AddBlocksInOrder) {
  const Window window = Window::torus(unit_square);
  const Points points = random_points(window, 30000, 5);
  const ClosePairs pairs(points, window, 0.01);
  EXPECT_GT(pairs.block_count(), 8U);
  const auto roots = [](double* sums, std::size_t, std::size_t, const Point2&, double square) {
    sums[0] += std::sqrt(square);
  };
  const double alone = close_pair_sums<double>(pairs, 1, 1, roots)[0];
  for (int round = 0; round < 5; ++round)
    EXPECT_EQ(close_pair_sums<double>(pairs, 1, 4, roots)[0], alone);
}

TEST(LargestSquare, DecidesAsTheDistanceDoes) {
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const double distance =
        std::pow(10.0, 300.0 * random_unit(6, 0, i) - 150.0) * (1.0 + random_unit(6, 1, i));
    const double square = largest_square(distance);
    EXPECT_LE(std::sqrt(square), distance);
    EXPECT_GT(std::sqrt(std::nextafter(square, 1e308)), distance);
  }
  EXPECT_EQ(largest_square(0.0), 0.0);
}

TEST(DistanceBinsOracle, AreThoseOfASearch) {
  const std::vector<std::vector<double>> grids{
      {0.0}, {1.0}, {0.0, 1e-12, 1e-6, 1.0, 1e6}, {0.1, 0.2, 0.30000000000000004, 0.4, 0.5}};
  for (const auto& grid : grids) {
    const DistanceBins bins(grid);
    for (std::uint64_t i = 0; i < 3000; ++i) {
      double distance =
          grid.back() * std::pow(random_unit(7, 0, i), 1.0 + static_cast<double>(i % 9));
      if (i < grid.size()) distance = grid[i];
      const double square = std::min(distance * distance, bins.last_square());
      const auto expected = std::lower_bound(grid.begin(), grid.end(), std::sqrt(square));
      EXPECT_EQ(bins.bin_of(square), static_cast<std::size_t>(expected - grid.begin()));
    }
  }
}

TEST(ClosePairs, RefuseWhatHasNoMeaning) {
  const Window square = Window::rectangle(unit_square), torus = Window::torus(unit_square);
  const Points two{{0.0, 0.0}, {1.0, 1.0}}, outside{{0.5, 1.5}}, unknown{{0.5, NAN}};
  EXPECT_THROW(ClosePairs(two, square, -1.0), ContractViolation);
  EXPECT_THROW(ClosePairs(two, square, NAN), ContractViolation);
  EXPECT_THROW(ClosePairs(two, torus, 0.5), ContractViolation);
  EXPECT_THROW(ClosePairs(outside, square, 0.1), ContractViolation);
  EXPECT_THROW(ClosePairs(unknown, square, 0.1), ContractViolation);
  EXPECT_THROW(DistanceBins(std::vector<double>{}), ContractViolation);
  EXPECT_THROW(DistanceBins(std::vector{0.1, 0.1}), ContractViolation);
  EXPECT_THROW(DistanceBins(std::vector{-0.1, 0.1}), ContractViolation);
}

}  // namespace
}  // namespace phytobench
