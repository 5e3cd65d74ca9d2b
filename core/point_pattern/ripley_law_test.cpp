// SPDX-License-Identifier: MIT
// Laws of K: what its mean over random patterns is, and what must not change it.
#include <gtest/gtest.h>

#include "core/point_pattern/null_models.hpp"
#include "core/point_pattern/ripley.hpp"
#include "core/point_pattern/test_patterns.hpp"

namespace phytobench {
namespace {

using namespace test_patterns;

using Values = std::vector<double>;
using enum EdgeCorrection;

/// Standard errors by which the mean K of random patterns lies above pi r^2, per distance.
Values errors_above_disc(const Window& window, const Values& distances, EdgeCorrection correction,
                         std::size_t points, std::uint64_t runs) {
  std::vector<Sample> samples(distances.size());
  for (std::uint64_t run = 0; run < runs; ++run) {
    const Values k =
        ripley_k(random_pattern(window, points, 61, run), window, distances, correction);
    for (std::size_t i = 0; i < k.size(); ++i) samples[i].add(k[i]);
  }
  Values errors;
  for (std::size_t i = 0; i < distances.size(); ++i)
    errors.push_back(samples[i].errors_above(std::numbers::pi * distances[i] * distances[i]));
  return errors;
}

const Values law_distances{0.02, 0.05, 0.1, 0.2, 0.3, 0.45};

TEST(RipleyKLaw, OnATorusTheMeanIsTheDisc) {
  for (const std::size_t points : {2U, 10U, 100U})
    for (const double errors : errors_above_disc(Window::torus(unit_square), law_distances, torus,
                                                 points, points == 2 ? 20000 : 400))
      EXPECT_LT(std::abs(errors), chance) << points << " points";
}

TEST(RipleyKLaw, CorrectedMeanIsTheDiscInARectangle) {
  const Window plot = Window::rectangle({{0.0, 0.0}, {1.5, 0.8}});
  for (const EdgeCorrection correction : {translation, isotropic})
    for (const double errors : errors_above_disc(plot, law_distances, correction, 60, 400))
      EXPECT_LT(std::abs(errors), chance) << name_of(correction);
}

TEST(RipleyKLaw, CorrectedMeanIsTheDiscInAPolygon) {
  for (const double errors : errors_above_disc(l_shape(), law_distances, isotropic, 60, 400))
    EXPECT_LT(std::abs(errors), chance);
}

TEST(RipleyKLaw, BorderCorrectedMeanIsTheDisc) {
  for (const Window& window : {Window::rectangle(unit_square), l_shape()})
    for (const double errors :
         errors_above_disc(window, {0.02, 0.05, 0.1, 0.2, 0.3}, border, 150, 400))
      EXPECT_LT(std::abs(errors), chance);
}

// The laws above must be able to fail.
TEST(RipleyKLaw, UncorrectedMeanIsFarBelow) {
  for (const Window& window : {Window::rectangle(unit_square), l_shape()}) {
    const Values errors = errors_above_disc(window, law_distances, none, 100, 200);
    EXPECT_LT(errors.back(), -10.0 * chance);
    EXPECT_LT(errors[2], -chance);
  }
}

TEST(CrossRipleyKLaw, OfIndependentTypesIsTheDisc) {
  for (const Window& window :
       {Window::rectangle(unit_square), Window::torus(unit_square), l_shape()}) {
    const EdgeCorrection correction = usual_correction(window.kind());
    std::vector<Sample> samples(law_distances.size());
    for (std::uint64_t run = 0; run < 300; ++run) {
      const Points first = clustered_points(window, 40, 0.1, run);
      const Points second = random_pattern(window, 70, 62, run);
      const Values k = cross_ripley_k(first, second, window, law_distances, correction);
      for (std::size_t i = 0; i < k.size(); ++i) samples[i].add(k[i]);
    }
    for (std::size_t i = 0; i < law_distances.size(); ++i)
      EXPECT_LT(
          std::abs(samples[i].errors_above(std::numbers::pi * law_distances[i] * law_distances[i])),
          chance)
          << name_of(window.kind()) << " " << law_distances[i];
  }
}

struct Case {
  Window window;
  EdgeCorrection correction;
  bool is_counted;  ///< whole numbers inside: equal bits, whatever the order
};

std::vector<Case> cases() {
  const Window plot = Window::rectangle(unit_square);
  return {{plot, none, true},
          {plot, border, true},
          {plot, translation, false},
          {plot, isotropic, false},
          {Window::torus(unit_square), torus, true},
          {l_shape(), none, true},
          {l_shape(), border, true},
          {l_shape(), isotropic, false}};
}

Points mapped(const Points& points, const auto& map) {
  Points result;
  for (const Point2& p : points) result.push_back(map(p));
  return result;
}

Window mapped(const Window& window, const auto& map) {
  const Points corners = mapped(window.corners(), map);
  if (window.kind() == WindowKind::polygon) return Window::polygon(corners);
  Rectangle box{corners[0], corners[0]};
  for (const Point2& p : corners) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return window.kind() == WindowKind::torus ? Window::torus(box) : Window::rectangle(box);
}

void expect_similar(const Case& c, const auto& map, double factor, double tolerance) {
  const Points points = random_points(c.window, 200, 8);
  Values scaled;
  for (const double distance : law_distances) scaled.push_back(factor * distance);
  const Values k = ripley_k(points, c.window, law_distances, c.correction);
  const Values image = ripley_k(mapped(points, map), mapped(c.window, map), scaled, c.correction);
  for (std::size_t i = 0; i < k.size(); ++i)
    EXPECT_NEAR(image[i], factor * factor * k[i], tolerance * factor * factor * k[i])
        << name_of(c.window.kind()) << " " << name_of(c.correction);
}

TEST(RipleyKLaw, ScalesWithTheSquareOfLength) {
  for (const Case& c : cases())
    for (const double factor : {1e-6, 1e6})
      expect_similar(
          c, [factor](const Point2& p) { return factor * p; }, factor, 1e-9);
}

TEST(RipleyKLaw, IgnoresWhereThePlotLies) {
  for (const Case& c : cases())
    expect_similar(
        c,
        [](const Point2& p) {
          return p + Point2{-64.0, 1000.0};
        },
        1.0, 1e-9);
}

TEST(RipleyKLaw, IgnoresQuarterTurns) {
  for (const Case& c : cases())
    expect_similar(
        c,
        [](const Point2& p) {
          return Point2{-p.y, p.x};
        },
        1.0, c.is_counted ? 0.0 : 1e-9);
}

TEST(RipleyKLaw, IgnoresTheOrderOfPointsAndTheNumberOfThreads) {
  for (const Case& c : cases()) {
    Points points = random_points(c.window, 5000, 9);
    const Values near{0.01, 0.02, 0.03};
    const Values k = ripley_k(points, c.window, near, c.correction);
    EXPECT_EQ(ripley_k(points, c.window, near, c.correction, 4), k);
    std::reverse(points.begin(), points.end());
    std::rotate(points.begin(), points.begin() + 1234, points.end());
    const Values shuffled = ripley_k(points, c.window, near, c.correction);
    for (std::size_t i = 0; i < k.size(); ++i)
      EXPECT_NEAR(shuffled[i], k[i], c.is_counted ? 0.0 : 1e-12 * k[i]);
  }
}

}  // namespace
}  // namespace phytobench
