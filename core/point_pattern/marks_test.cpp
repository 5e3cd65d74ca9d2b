// SPDX-License-Identifier: MIT
#include "core/point_pattern/marks.hpp"

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/point_pattern/null_models.hpp"
#include "core/point_pattern/test_patterns.hpp"

namespace phytobench {
namespace {

using namespace test_patterns;

using Values = std::vector<double>;
using enum EdgeCorrection;

constexpr double mark_rounding = 1e-11;
const Values mark_distances{0.05, 0.1, 0.2, 0.3};

Values random_marks(std::size_t count, std::uint64_t stream_index) {
  CounterStream stream(91, stream_index);
  Values marks(count);
  for (double& mark : marks) mark = 0.2 - std::log(1.0 - stream.next_unit());
  return marks;
}

double mean_of(const Values& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

/// Sum of (m - mean)^2.
double squares_of(const Values& marks) {
  const double mean = mean_of(marks);
  double sum = 0.0;
  for (const double mark : marks) sum += (mark - mean) * (mark - mean);
  return sum;
}

/// Kernel mean of the product of marks, straight from the definition.
double product_mean(const Points& points, const Values& marks, const Window& window, double r,
                    const SmoothingOptions& options) {
  const PairWeights weights(points, window, options.correction);
  double sum = 0.0, all = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < points.size(); ++j) {
      const Point2 d = window.difference(points[i], points[j]);
      const double t = (r - norm(d)) / options.half_width;
      if (i == j || std::abs(t) >= 1.0) continue;
      const double weight = (1.0 - t * t) * weights(i, d, norm(d)) /
                            (options.circle_at == CircleAt::pair ? norm(d) : 1.0);
      sum += weight * marks[i] * marks[j];
      all += weight;
    }
  return sum / all;
}

TEST(MarkCorrelationOracle, IsThatOfADoubleLoop) {
  for (const Window& window :
       {Window::rectangle(unit_square), Window::torus(unit_square), l_shape()})
    for (const EdgeCorrection correction : {none, translation, isotropic, torus})
      for (const CircleAt circle_at : {CircleAt::grid, CircleAt::pair}) {
        if (!is_defined(correction, window.kind())) continue;
        const Points points = random_points(window, 120, 3);
        const Values marks = random_marks(120, 3);
        const SmoothingOptions options{correction, 0.05, circle_at};
        const Values k = mark_correlation(points, marks, window, mark_distances, options);
        for (std::size_t i = 0; i < mark_distances.size(); ++i)
          EXPECT_NEAR(k[i],
                      product_mean(points, marks, window, mark_distances[i], options) /
                          (mean_of(marks) * mean_of(marks)),
                      mark_rounding);
      }
}

TEST(MarkFunctions, OfTwoPointsAreTheirPair) {
  const Window plot = Window::rectangle(unit_square);
  const Points points{{0.25, 0.5}, {0.75, 0.5}};
  const Values marks{1.0, 3.0};
  const SmoothingOptions options{translation, 0.1};
  const Values at{0.2, 0.5};
  EXPECT_NEAR(mark_correlation(points, marks, plot, at, options)[1], 3.0 / 4.0, mark_rounding);
  EXPECT_NEAR(mark_variogram(points, marks, plot, at, options)[1], 2.0, mark_rounding);
  EXPECT_NEAR(mark_moran_index(points, marks, plot, at, options)[1], -1.0, mark_rounding);
  EXPECT_TRUE(std::isnan(mark_correlation(points, marks, plot, at, options)[0]));  // no pair near
}

// Over random labellings the means are known whatever the pattern: here a clustered one.
TEST(MarkFunctionsLaw, MeansOverRandomLabellingsAreExact) {
  for (const Window& window : {Window::rectangle(unit_square), Window::torus(unit_square)}) {
    const SmoothingOptions options{usual_correction(window.kind()), 0.03};
    const Points points = clustered_points(window, 60, 0.3, 2);
    const Values marks = random_marks(60, 5);
    const double mean = mean_of(marks), squares = squares_of(marks);
    // The mean product of two different marks.
    const double product = mean * mean - squares / (60.0 * 59.0);
    std::vector<Sample> correlation(4), variogram(4), moran(4);
    for (std::uint64_t run = 0; run < 500; ++run) {
      const Values labels = relabelled(marks, 92, run);
      const Values k = mark_correlation(points, labels, window, mark_distances, options);
      const Values v = mark_variogram(points, labels, window, mark_distances, options);
      const Values m = mark_moran_index(points, labels, window, mark_distances, options);
      for (std::size_t i = 0; i < 4; ++i)
        correlation[i].add(k[i]), variogram[i].add(v[i]), moran[i].add(m[i]);
    }
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_LT(std::abs(correlation[i].errors_above(product / (mean * mean))), chance);
      EXPECT_LT(std::abs(variogram[i].errors_above(squares / 59.0)), chance);
      EXPECT_LT(std::abs(moran[i].errors_above(-1.0 / 59.0)), chance);
    }
  }
}

TEST(MarkCorrelationLaw, IsOneForIndependentMarks) {
  const Window window = Window::rectangle(unit_square);
  std::vector<Sample> samples(4);
  for (std::uint64_t run = 0; run < 100; ++run) {
    const Values k = mark_correlation(random_points(window, 400, run), random_marks(400, run),
                                      window, mark_distances, {translation, 0.02});
    for (std::size_t i = 0; i < 4; ++i) samples[i].add(k[i]);
  }
  for (const Sample& sample : samples) {
    // The squared mean of 400 marks is too high by their variation / 400.
    EXPECT_NEAR(sample.mean(), 1.0, chance * sample.error() + 1.0 / 400.0);
    EXPECT_LT(sample.error(), 0.01);
  }
}

// The law above must be able to fail: marks that grow from one side of the plot to the other.
TEST(MarkFunctions, SeeNeighboursThatResembleEachOther) {
  const Window window = Window::rectangle(unit_square);
  const Points points = random_points(window, 4000, 6);
  Values marks;
  for (const Point2& p : points) marks.push_back(1.0 + p.x);
  const SmoothingOptions options{translation};
  const double variance = squares_of(marks) / 3999.0;
  EXPECT_GT(mark_correlation(points, marks, window, mark_distances, options)[0], 1.02);
  EXPECT_LT(mark_variogram(points, marks, window, mark_distances, options)[0], 0.1 * variance);
  EXPECT_GT(mark_moran_index(points, marks, window, mark_distances, options)[0], 0.8);
}

TEST(MarkFunctionsLaw, EqualMarksHaveNoStructure) {
  const Window window = Window::torus(unit_square);
  const Points points = random_points(window, 200, 7);
  const Values marks(200, 0.1);
  for (const double k : mark_correlation(points, marks, window, mark_distances, {torus}))
    EXPECT_NEAR(k, 1.0, mark_rounding);
  for (const double v : mark_variogram(points, marks, window, mark_distances, {torus}))
    EXPECT_EQ(v, 0.0);
  for (const double m : mark_moran_index(points, marks, window, mark_distances, {torus}))
    EXPECT_TRUE(std::isnan(m));
}

TEST(MarkFunctionsLaw, UnitsOfMarksAndThreadsDoNotMatter) {
  const Window window = l_shape();
  const Points points = random_points(window, 3000, 8);
  const Values marks = random_marks(3000, 8);
  Values in_other_units;
  for (const double mark : marks) in_other_units.push_back(1024.0 * mark);
  const SmoothingOptions alone{isotropic}, four{isotropic, 0.0, CircleAt::grid, 4};
  const Values near{0.02, 0.05};
  const Values k = mark_correlation(points, marks, window, near, alone);
  EXPECT_EQ(mark_correlation(points, in_other_units, window, near, alone), k);
  EXPECT_EQ(mark_correlation(points, marks, window, near, four), k);
}

TEST(MarkFunctions, OfTooFewPointsAreUnknownAndOtherwiseRefuse) {
  const Window plot = Window::rectangle(unit_square);
  const Points one{{0.5, 0.5}}, two{{0.1, 0.1}, {0.1, 0.1}};
  EXPECT_TRUE(std::isnan(mark_correlation({}, {}, plot, mark_distances, {none})[0]));
  EXPECT_TRUE(std::isnan(mark_moran_index(one, Values{1.0}, plot, mark_distances, {none})[0]));
  EXPECT_TRUE(
      std::isnan(mark_correlation(two, Values{1.0, -1.0}, plot, Values{0.01}, {none, 0.1})[0]));
  EXPECT_EQ(mark_variogram(two, Values{1.0, -1.0}, plot, Values{0.01}, {none, 0.1})[0], 2.0);
  EXPECT_THROW(mark_variogram(two, Values{1.0}, plot, mark_distances, {none}), ContractViolation);
  EXPECT_THROW(mark_variogram(two, Values{1.0, NAN}, plot, mark_distances, {none}),
               ContractViolation);
  EXPECT_THROW(mark_variogram(two, Values{1.0, 2.0}, plot, mark_distances, {border}),
               ContractViolation);
}

}  // namespace
}  // namespace phytobench
