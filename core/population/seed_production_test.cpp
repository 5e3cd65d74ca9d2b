// SPDX-License-Identifier: MIT
#include "core/population/seed_production.hpp"

#include <gtest/gtest.h>

namespace phytobench {
namespace {

// A radius in metres: one seed for each 0.05 m above 0.25 m.
constexpr SeedProduction woody{.threshold = 0.25, .seeds_per_size = 20.0, .largest_size = 0.5};

TEST(SeedProduction, IsZeroThenLinearThenConstant) {
  EXPECT_EQ(woody.expected_seeds(0.0), 0.0);
  EXPECT_EQ(woody.expected_seeds(0.25), 0.0);
  EXPECT_DOUBLE_EQ(woody.expected_seeds(0.3), 1.0);
  EXPECT_DOUBLE_EQ(woody.expected_seeds(0.5), 5.0);
  EXPECT_EQ(woody.expected_seeds(0.8), woody.expected_seeds(0.5));
}

TEST(SeedProduction, HasNoJumpAndOneSlope) {
  constexpr double step = 1e-3;
  for (int i = 0; i < 700; ++i) {
    const double size = i * step;
    const double rise = woody.expected_seeds(size + step) - woody.expected_seeds(size);
    const bool grows = size >= 0.25 - 0.1 * step && size < 0.5 - 0.1 * step;
    EXPECT_NEAR(rise, grows ? 20.0 * step : 0.0, 1e-12) << size;
  }
}

TEST(SeedProduction, OfAPlantThatIsGrownUpAtTheThresholdIsZero) {
  constexpr SeedProduction barren{.threshold = 1.0, .seeds_per_size = 5.0, .largest_size = 1.0};
  EXPECT_EQ(barren.expected_seeds(2.0), 0.0);
}

}  // namespace
}  // namespace phytobench
