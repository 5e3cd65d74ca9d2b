// SPDX-License-Identifier: MIT
#include "core/point_pattern/envelope_tests.hpp"

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/point_pattern/close_pairs.hpp"
#include "core/point_pattern/null_models.hpp"
#include "core/point_pattern/test_patterns.hpp"

namespace phytobench {
namespace {

using namespace test_patterns;

using Curve = std::vector<double>;
using Test = EnvelopeTest (*)(const Curves&, double);

/// A smooth random curve; `tilt` is what the null model does not know.
Curve random_curve(std::uint64_t stream_index, double tilt = 0.0) {
  CounterStream stream(41, stream_index);
  const double a = stream.next_unit(), b = stream.next_unit(), c = stream.next_unit();
  Curve curve;
  for (int k = 0; k < 15; ++k)
    curve.push_back(a + b * k + c * std::sin(k) + tilt * k + 0.1 * stream.next_unit());
  return curve;
}

Curves random_curves(std::uint64_t set, std::size_t simulations, double tilt = 0.0) {
  return curves_with_simulations(
      random_curve(1000 * set, tilt), simulations,
      [set](std::uint64_t i) { return random_curve(1000 * set + 1 + i); });
}

bool leaves(const Curve& curve, const EnvelopeTest& test) {
  for (std::size_t k = 0; k < curve.size(); ++k)
    if (curve[k] < test.low[k] || curve[k] > test.high[k]) return true;
  return false;
}

class EnvelopeTestLaw : public testing::TestWithParam<Test> {};

TEST_P(EnvelopeTestLaw, KeepsItsLevel) {
  int alarms = 0;
  constexpr int runs = 2000;
  for (std::uint64_t set = 0; set < runs; ++set)
    alarms += GetParam()(random_curves(set, 39), 0.05).p_value <= 0.05;
  const double error = std::sqrt(0.05 * 0.95 * runs);
  // Ranks of few simulations tie at times, which costs level but never gains any.
  EXPECT_LE(alarms, 0.05 * runs + chance * error);
  EXPECT_GE(alarms, 0.03 * runs);
}

TEST_P(EnvelopeTestLaw, GivesEveryCurveTheSameChance) {
  const Curves curves = random_curves(7, 59);
  std::vector<Curve> all = curves.simulated;
  all.push_back(curves.observed);
  int alarms = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    Curves others{all[i], all};
    others.simulated.erase(others.simulated.begin() + static_cast<std::ptrdiff_t>(i));
    alarms += GetParam()(others, 0.1).p_value <= 0.1;
  }
  EXPECT_EQ(alarms, 6);  // of 60; exactly, as long as the extreme ones do not tie
}

TEST_P(EnvelopeTestLaw, CurveLeavesTheEnvelopeIffSignificant) {
  int significant = 0;
  for (std::uint64_t set = 0; set < 300; ++set) {
    const Curves curves = random_curves(set, 99, set % 3 == 0 ? 0.6 : 0.0);
    for (const double level : {0.01, 0.05, 0.2}) {
      const EnvelopeTest test = GetParam()(curves, level);
      EXPECT_EQ(leaves(curves.observed, test), test.p_value <= level) << set << " " << level;
      significant += test.p_value <= level;
    }
  }
  EXPECT_GT(significant, 100);
}

TEST_P(EnvelopeTestLaw, ThreadsAndOrderOfSimulationsDoNotMatter) {
  Curves curves = random_curves(3, 99, 0.3);
  const EnvelopeTest test = GetParam()(curves, 0.05);
  const Curves again = curves_with_simulations(
      curves.observed, 99, [](std::uint64_t i) { return random_curve(3001 + i); }, 4);
  EXPECT_EQ(again.simulated, curves.simulated);
  std::reverse(curves.simulated.begin(), curves.simulated.end());
  const EnvelopeTest reversed = GetParam()(curves, 0.05);
  EXPECT_EQ(reversed.p_value, test.p_value);
  EXPECT_EQ(reversed.low, test.low);
  EXPECT_EQ(reversed.high, test.high);
}

TEST_P(EnvelopeTestLaw, LeavesOutDistancesWithoutValues) {
  const Curves curves = random_curves(4, 39, 0.4);
  Curves holed = curves;
  holed.observed.insert(holed.observed.begin(), 1e9);
  for (Curve& curve : holed.simulated) curve.insert(curve.begin(), 0.0);
  holed.simulated[5][0] = NAN;
  const EnvelopeTest test = GetParam()(curves, 0.05), other = GetParam()(holed, 0.05);
  EXPECT_EQ(other.p_value, test.p_value);
  EXPECT_TRUE(std::isnan(other.low[0]) && std::isnan(other.high[0]) && std::isnan(other.centre[0]));
  EXPECT_EQ(other.high[1], test.high[0]);
}

TEST_P(EnvelopeTestLaw, FindsNothingWhereAllCurvesAreEqual) {
  const Curves curves{Curve(5, 0.1), std::vector<Curve>(19, Curve(5, 0.1))};
  EXPECT_EQ(GetParam()(curves, 0.05).p_value, 1.0);
  EXPECT_EQ(GetParam()({{}, std::vector<Curve>(19)}, 0.05).p_value, 1.0);
  EXPECT_EQ(GetParam()({{1.0}, {}}, 0.05).p_value, 1.0);
}

TEST_P(EnvelopeTestLaw, RefusesCurvesOfUnequalLengthAndImpossibleLevels) {
  EXPECT_THROW(GetParam()({{1.0, 2.0}, {{1.0}}}, 0.05), ContractViolation);
  EXPECT_THROW(GetParam()({{1.0}, {{1.0}}}, 0.0), ContractViolation);
  EXPECT_THROW(GetParam()({{1.0}, {{1.0}}}, 1.0), ContractViolation);
}

/// Pair counts by distance: a summary function that needs no more than close_pairs.hpp.
Curve square_roots_of_counts(const Points& points, const Window& window) {
  Curve curve;
  for (const std::int64_t count :
       close_pair_counts(points, window, Curve{0.02, 0.05, 0.08, 0.11, 0.14, 0.17, 0.2}))
    curve.push_back(std::sqrt(static_cast<double>(count)));
  return curve;
}

double p_value_of(Test test, const Points& points, const Window& window, std::uint64_t seed) {
  return test(curves_with_simulations(square_roots_of_counts(points, window), 39,
                                      [&](std::uint64_t index) {
                                        return square_roots_of_counts(
                                            random_pattern(window, points.size(), seed, index),
                                            window);
                                      }),
              0.05)
      .p_value;
}

TEST_P(EnvelopeTestLaw, HoldsItsLevelOnRandomPatternsAndSeesClusters) {
  const Window window = Window::rectangle(unit_square);
  constexpr int runs = 400;
  int alarms = 0, found = 0;
  for (std::uint64_t run = 0; run < runs; ++run)
    alarms += p_value_of(GetParam(), random_points(window, 50, run), window, 500 + run) <= 0.05;
  EXPECT_LE(alarms, 0.05 * runs + chance * std::sqrt(0.05 * 0.95 * runs));
  for (std::uint64_t run = 0; run < 20; ++run)
    found +=
        p_value_of(GetParam(), clustered_points(window, 50, 0.1, run), window, 900 + run) <= 0.05;
  EXPECT_GE(found, 19);
}

INSTANTIATE_TEST_SUITE_P(Tests, EnvelopeTestLaw,
                         testing::Values(&mad_test, &extreme_rank_length_test),
                         [](const auto& test) { return test.index == 0 ? "Mad" : "RankLength"; });

TEST(MadTest, IsTheOneByHand) {
  // Means 1 and 2; largest deviations 3, 1, 2, 0.
  const Curves curves{{4.0, 2.0}, {{0.0, 2.0}, {-1.0, 2.0}, {1.0, 2.0}}};
  const EnvelopeTest test = mad_test(curves, 0.25);
  EXPECT_EQ(test.p_value, 0.25);
  EXPECT_EQ(test.centre, (Curve{1.0, 2.0}));
  EXPECT_EQ(test.low, (Curve{-1.0, 0.0}));
  EXPECT_EQ(test.high, (Curve{3.0, 4.0}));
}

TEST(ExtremeRankLengthTest, IsTheOneByHand) {
  // Two-sided ranks: observed 1 1, then 2 1, 1 2 (longer list of ones wins), 2.5 2.5, 2.5 2.5.
  const Curves curves{{9.0, 0.0}, {{8.0, 9.0}, {0.0, 8.0}, {5.0, 5.0}, {5.0, 5.0}}};
  EXPECT_EQ(extreme_rank_length_test(curves, 0.2).p_value, 0.2);
  const EnvelopeTest test = extreme_rank_length_test(curves, 0.2);
  EXPECT_EQ(test.low, (Curve{0.0, 5.0}));
  EXPECT_EQ(test.high, (Curve{8.0, 9.0}));
}

}  // namespace
}  // namespace phytobench
