// SPDX-License-Identifier: MIT
#include "core/statistics/kolmogorov_smirnov.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

using Values = std::vector<double>;

TEST(KolmogorovDistance, IsTheOneByHand) {
  EXPECT_EQ(kolmogorov_distance(Values{0.5}), 0.5);
  EXPECT_EQ(kolmogorov_distance(Values{0.75, 0.25}), 0.25);
  EXPECT_EQ(kolmogorov_distance(Values{0.0, 0.0, 0.0, 0.0}), 1.0);
  EXPECT_EQ(kolmogorov_distance(Values{0.125, 0.375, 0.625, 0.875}), 0.125);
  EXPECT_EQ(kolmogorov_distance(Values{-3.0, 7.0}), 0.5);
}

// Exact critical values of D (Miller 1956, J. Am. Stat. Assoc. 51, table 1).
TEST(KolmogorovPValue, MeetsTheExactTable) {
  constexpr double small_sample = 0.002;  // what Stephens' argument leaves
  EXPECT_NEAR(kolmogorov_p_value(0.56328, 5), 0.05, small_sample);
  EXPECT_NEAR(kolmogorov_p_value(0.40925, 10), 0.05, small_sample);
  EXPECT_NEAR(kolmogorov_p_value(0.48893, 10), 0.01, small_sample);
  EXPECT_NEAR(kolmogorov_p_value(0.29408, 20), 0.05, small_sample);
  EXPECT_NEAR(kolmogorov_p_value(0.13403, 100), 0.05, small_sample);
  // Marsaglia, Tsang and Wang 2003, J. Stat. Softw. 8: 0.628480 up to 0.274. The header's bound.
  EXPECT_NEAR(kolmogorov_p_value(0.274, 10), 1.0 - 0.628480, 0.023);
}

TEST(KolmogorovPValue, FallsFromOneToZeroWithoutAStep) {
  EXPECT_EQ(kolmogorov_p_value(0.0, 10), 1.0);
  double before = 1.0;
  for (int i = 1; i <= 1000; ++i) {
    const double p_value = kolmogorov_p_value(i / 1000.0, 30);
    EXPECT_LE(p_value, before + 1e-12);
    EXPECT_GE(p_value, 0.0);
    EXPECT_LT(before - p_value, 0.02);
    before = p_value;
  }
  EXPECT_LT(before, 1e-20);
}

TEST(KolmogorovUniformityPValueLaw, OfUniformValuesIsItselfUniform) {
  int alarms = 0;
  constexpr int runs = 4000;
  for (std::uint64_t set = 0; set < runs; ++set) {
    CounterStream stream(12, set);
    Values values(25);
    for (double& value : values) value = stream.next_unit();
    alarms += kolmogorov_uniformity_p_value(values) <= 0.1;
  }
  // Four standard deviations of 400 expected; the approximation itself is off by less.
  EXPECT_NEAR(alarms, 400.0, 4.0 * std::sqrt(360.0));
}

TEST(KolmogorovUniformityPValue, SeesWhatIsNotUniform) {
  Values low;
  for (int i = 0; i < 100; ++i) low.push_back(std::pow((i + 0.5) / 100.0, 2.0));
  EXPECT_LT(kolmogorov_uniformity_p_value(low), 1e-4);
  EXPECT_LT(kolmogorov_uniformity_p_value(Values(100, 0.5)), 1e-10);
}

TEST(KolmogorovUniformityPValue, RefusesWhatHasNoMeaning) {
  EXPECT_THROW(kolmogorov_uniformity_p_value({}), ContractViolation);
  EXPECT_THROW(kolmogorov_uniformity_p_value(Values{NAN}), ContractViolation);
  EXPECT_THROW(kolmogorov_p_value(1.5, 10), ContractViolation);
  EXPECT_THROW(kolmogorov_p_value(0.5, 0), ContractViolation);
}

}  // namespace
}  // namespace phytobench
