// SPDX-License-Identifier: MIT
#include "reference/oracles/alsweis_overlap.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/overlap/lens.hpp"
#include "core/random/counter_stream.hpp"
#include "reference/oracles/alsweis_exact_lens.hpp"

namespace phytobench::oracles::alsweis {
namespace {

// Counter-examples of the ledger: printed and true area.
TEST(PrintedOverlapOracle, IsTwiceTooLargeOrAWholeDisc) {
  struct Case {
    double r, s, d, printed, corrected;
  };
  const Case cases[] = {{1, 1, 1 + 1e-12, 2.456739, 1.228370}, {3, 5, 4, 36.449389, 18.224695},
                        {2, 5, 4, 19.398312, 9.699156},        {1, 1.2, 0.9, 3.141593, 1.856252},
                        {1, 1.5, 0.75, 3.141593, 2.807244},    {1, 1, 1, 3.141593, 1.228370}};
  for (const Case& c : cases) {
    EXPECT_NEAR(equation_a4_as_printed(c.r, c.s, c.d), c.printed, 1e-6);
    EXPECT_NEAR(equation_a4_corrected(c.r, c.s, c.d), c.corrected, 1e-6);
    EXPECT_NEAR(phytobench::lens_area(c.r, c.s, c.d), c.corrected, 1e-6);
  }
}

TEST(PrintedOverlapOracle, HasNoAngleForADiscInsideAnother) {
  EXPECT_TRUE(std::isnan(equation_a4_as_printed(1, 3, 1.5)));
  EXPECT_EQ(equation_a4_corrected(1, 3, 1.5), std::numbers::pi);
}

TEST(LensAreaOracle, FindsFourteenDigitsRightEverywhere) {
  CounterStream stream(5, 0);
  double worst = 0.0;
  for (int i = 0; i < 4'000; ++i) {
    const double r = std::pow(10.0, 18.0 * stream.next_unit() - 9.0);
    constexpr double spreads[] = {1e-10, 1e-3, 1.0, 18.0};
    const double spread = spreads[i / 6 % 4];
    const double ratio = std::pow(10.0, spread * (stream.next_unit() - 0.5));
    const double s = std::clamp(r * ratio, 1e-9, 1e9);
    const double d = hard_distance(r, s, i, stream.next_unit());
    const double error = lens_relative_error(r, s, d, phytobench::lens_area(r, s, d));
    worst = std::max(worst, error);
    ASSERT_LE(error, 1e-14) << "r " << r << ", s " << s << ", d " << d;
  }
  EXPECT_GT(worst, 0.0);  // or nothing was compared
}

TEST(LensAreaOracle, SeesAWrongLastDigit) {
  const double right = phytobench::lens_area(1, 1, 1);
  EXPECT_LE(lens_relative_error(1, 1, 1, right), 1e-15);
  EXPECT_GE(lens_relative_error(1, 1, 1, right * (1 + 1e-13)), 9e-14);
  EXPECT_EQ(lens_relative_error(1, 1, 2, 0.0), 0.0);
  EXPECT_TRUE(std::isinf(lens_relative_error(1, 1, 2, 1e-300)));
}

// Away from contact the textbook's form is as good as ours.
TEST(CorrectedOverlapOracle, AgreesWithTheLensArea) {
  CounterStream stream(7, 0);
  for (int i = 0; i < 10'000; ++i) {
    const double r = 0.1 + stream.next_unit(), s = 0.1 + stream.next_unit();
    const double low = std::abs(r - s), high = r + s;
    const double d = low + (0.05 + 0.9 * stream.next_unit()) * (high - low);
    EXPECT_NEAR(phytobench::lens_area(r, s, d) / equation_a4_corrected(r, s, d), 1.0, 1e-11);
  }
}

}  // namespace
}  // namespace phytobench::oracles::alsweis
