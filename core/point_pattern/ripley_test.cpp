// SPDX-License-Identifier: MIT
#include "core/point_pattern/ripley.hpp"

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/point_pattern/edge_distance.hpp"
#include "core/point_pattern/test_patterns.hpp"

namespace phytobench {
namespace {

using namespace test_patterns;

using Values = std::vector<double>;
using enum EdgeCorrection;

constexpr double weight_rounding = 1e-12;  // relative; sums of some thousand weights

void expect_close(const Values& values, const Values& expected, const std::string& what) {
  ASSERT_EQ(values.size(), expected.size());
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (std::isnan(expected[k]))
      EXPECT_TRUE(std::isnan(values[k])) << what << ", distance " << k;
    else
      EXPECT_NEAR(values[k], expected[k], weight_rounding * std::abs(expected[k]))
          << what << ", " << k;
  }
}

/// Straight from the definitions.
Values k_by_double_loop(const Points& first, const Points& second, bool is_cross,
                        const Window& window, const Values& distances, EdgeCorrection correction) {
  Values values;
  for (const double r : distances) {
    double sum = 0.0, starts = 0.0;
    for (std::size_t i = 0; i < first.size(); ++i) {
      if (correction == border && distance_to_edge(window, first[i]) < r) continue;
      starts += 1.0;
      for (std::size_t j = 0; j < second.size(); ++j) {
        if (!is_cross && i == j) continue;
        const Point2 d = window.difference(first[i], second[j]);
        const double distance = norm(d);
        if (distance > r) continue;
        const Rectangle& box = window.bounding_box();
        double weight = 1.0;
        if (correction == translation)
          weight = box.area() / ((box.width() - std::abs(d.x)) * (box.height() - std::abs(d.y)));
        if (correction == isotropic)
          weight = 1.0 / share_of_circle_inside(window, first[i], distance);
        sum += weight;
      }
    }
    const double partners = static_cast<double>(second.size()) - (is_cross ? 0.0 : 1.0);
    const double pairs =
        (correction == border ? starts : static_cast<double>(first.size())) * partners;
    values.push_back(pairs > 0.0 ? window.area() * sum / pairs : NAN);
  }
  return values;
}

const std::vector<EdgeCorrection> all_edge_corrections{none, border, translation, isotropic, torus};

TEST(RipleyKOracle, IsThatOfADoubleLoop) {
  const Values distances{0.0, 0.03, 0.1, 0.1000001, 0.2};
  for (const auto& [name, window, points] : assorted_patterns())
    for (const EdgeCorrection correction : all_edge_corrections)
      if (is_defined(correction, window.kind()))
        expect_close(ripley_k(points, window, distances, correction),
                     k_by_double_loop(points, points, false, window, distances, correction),
                     name + " " + std::string(name_of(correction)));
}

TEST(CrossRipleyKOracle, IsThatOfADoubleLoop) {
  const Values distances{0.0, 0.05, 0.15, 0.24};
  for (const Window& window :
       {Window::rectangle(unit_square), Window::torus(unit_square), l_shape()})
    for (const EdgeCorrection correction : all_edge_corrections) {
      if (!is_defined(correction, window.kind())) continue;
      for (const std::size_t count : {0U, 1U, 100U}) {
        const Points first = random_points(window, count, 1), second = random_points(window, 60, 2);
        expect_close(cross_ripley_k(first, second, window, distances, correction),
                     k_by_double_loop(first, second, true, window, distances, correction),
                     std::string(name_of(correction)));
      }
    }
}

// 4 neighbours at 1, 4 more at sqrt(2), 4 more at 2: K = neighbours * area / (n - 1).
TEST(RipleyK, OfASquareLatticeStepsExactlyAtItsDistances) {
  const Points lattice = square_lattice(12, 10);
  const Values distances{std::nextafter(1.0, 0.0), 1.0, std::nextafter(std::sqrt(2.0), 0.0),
                         std::sqrt(2.0), 2.0};
  const Values k = ripley_k(lattice, Window::torus(lattice_box(12, 10)), distances, torus);
  const Values neighbours{0.0, 4.0, 4.0, 8.0, 12.0};
  for (std::size_t i = 0; i < k.size(); ++i)
    EXPECT_NEAR(k[i], neighbours[i] * 120.0 / 119.0, weight_rounding * 20.0);
}

// A step of 0.1 is not exact in binary: differences straddle it, and all of them are decided by the
// computed distance, whatever the grid of distances (spatstat issue 170).
TEST(RipleyK, DecidesTiesByTheComputedDistanceOnAnyGrid) {
  Points lattice;
  for (const Point2& p : square_lattice(10, 10)) lattice.push_back(0.1 * p);
  const Window window = Window::rectangle(unit_square);
  Values coarse, fine;
  for (int k = 1; k <= 4; ++k) coarse.push_back(0.1 * k);
  for (int k = 1; k <= 400; ++k) fine.push_back(0.1 * (k / 100.0));
  for (const EdgeCorrection correction : {none, border, translation, isotropic}) {
    const Values expected = k_by_double_loop(lattice, lattice, false, window, coarse, correction);
    expect_close(ripley_k(lattice, window, coarse, correction), expected, "coarse");
    expect_close(ripley_k(lattice, window, fine, correction),
                 k_by_double_loop(lattice, lattice, false, window, fine, correction), "fine");
  }
}

TEST(RipleyK, OfTooFewPointsIsUnknown) {
  for (const EdgeCorrection correction : {none, border, translation, isotropic})
    for (const Points& points : {Points{}, Points{{0.5, 0.5}}})
      EXPECT_TRUE(
          std::isnan(ripley_k(points, Window::rectangle(unit_square), Values{0.1}, correction)[0]));
}

TEST(RipleyK, OfEqualPointsIsTheArea) {
  const Points points(30, Point2{0.5, 0.25});
  for (const EdgeCorrection correction : {none, border, translation, isotropic})
    EXPECT_EQ(ripley_k(points, Window::rectangle(unit_square), Values{0.0, 0.2}, correction),
              (Values{1.0, 1.0}));
}

TEST(RipleyK, OfPointsOnTheBorderIsDefined) {
  const Window plot = Window::rectangle(unit_square);
  const Points corners = plot.corners();
  EXPECT_TRUE(std::isnan(ripley_k(corners, plot, Values{0.1}, border)[0]));
  // 8 of 12 ordered pairs are one side apart; a quarter of their circles is inside.
  EXPECT_NEAR(ripley_k(corners, plot, Values{1.0}, isotropic)[0], 4.0 * 8.0 / 12.0, 1e-7);
  EXPECT_EQ(ripley_k(corners, plot, Values{1.0}, none)[0], 8.0 / 12.0);
}

TEST(LFromK, IsRForARandomPattern) {
  const Values l = l_from_k(Values{0.0, std::numbers::pi, 4.0 * std::numbers::pi});
  EXPECT_EQ(l, (Values{0.0, 1.0, 2.0}));
  EXPECT_TRUE(std::isnan(l_from_k(Values{NAN})[0]));
}

TEST(DefaultDistances, FollowSizeAndDensity) {
  const Window plot = Window::rectangle({{0.0, 0.0}, {2.0, 1.0}});
  EXPECT_EQ(default_distances(10, plot, 4), (Values{0.0625, 0.125, 0.1875, 0.25}));
  EXPECT_EQ(default_distances(0, plot, 1), Values{0.25});
  const auto partners = [&](std::size_t n) {
    const double r = default_distances(n, plot).back();
    return std::numbers::pi * r * r * static_cast<double>(n) / plot.area();
  };
  EXPECT_NEAR(partners(50000), 1000.0, 1e-9);
  EXPECT_NEAR(partners(500000), 100.0, 1e-9);
  EXPECT_NEAR(partners(1000000), 50.0, 1e-9);
  EXPECT_NEAR(partners(100000000), 50.0, 1e-9);
}

TEST(RipleyK, RefusesWhatHasNoMeaning) {
  const Window plot = Window::rectangle(unit_square), ring = Window::torus(unit_square);
  const Points points{{0.1, 0.1}, {0.2, 0.2}}, outside{{0.1, 0.1}, {1.2, 0.2}};
  EXPECT_THROW(ripley_k(points, plot, Values{0.2, 0.1}, none), ContractViolation);
  EXPECT_THROW(ripley_k(points, plot, Values{}, none), ContractViolation);
  EXPECT_THROW(ripley_k(points, plot, Values{0.1}, torus), ContractViolation);
  EXPECT_THROW(ripley_k(points, ring, Values{0.1}, none), ContractViolation);
  EXPECT_THROW(ripley_k(points, ring, Values{0.5}, torus), ContractViolation);
  EXPECT_THROW(ripley_k(points, l_shape(), Values{0.1}, translation), ContractViolation);
  EXPECT_THROW(ripley_k(outside, plot, Values{0.1}, none), ContractViolation);
  EXPECT_THROW(default_distances(10, plot, 0), ContractViolation);
}

}  // namespace
}  // namespace phytobench
