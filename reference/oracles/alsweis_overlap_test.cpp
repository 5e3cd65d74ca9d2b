// SPDX-License-Identifier: MIT
#include "reference/oracles/alsweis_overlap.hpp"

#include <gtest/gtest.h>

#include "core/overlap/lens.hpp"
#include "core/random/counter_stream.hpp"

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
