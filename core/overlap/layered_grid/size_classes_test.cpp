// SPDX-License-Identifier: MIT
#include "core/overlap/layered_grid/size_classes.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

TEST(SizeClasses, HoldEveryRadiusOnceFromLargeToSmall) {
  std::vector<double> radii{0.0, 0.0};
  for (std::size_t i = 0; i < 5000; ++i)
    radii.push_back(std::pow(10.0, 40 * random_unit(1, 0, i) - 20));
  for (const double area : {0.0, 1e-30, 1.0, 1e30}) {
    const auto classes = size_classes(radii, area);
    std::size_t sum = 0;
    for (std::size_t c = 0; c < classes.size(); ++c) {
      sum += classes[c].count;
      EXPECT_LE(classes[c].first_exponent, classes[c].last_exponent);
      if (c > 0) {
        EXPECT_GT(classes[c - 1].first_exponent, classes[c].last_exponent);
      }
      std::size_t count = 0;
      double largest = 0.0;
      for (const double r : radii) {
        const std::size_t e = exponent_of(r);
        if (r <= 0.0 || e < classes[c].first_exponent || e > classes[c].last_exponent) continue;
        ++count;
        largest = std::max(largest, r);
      }
      EXPECT_EQ(count, classes[c].count);
      EXPECT_EQ(largest, classes[c].largest);
    }
    EXPECT_EQ(sum, 5000u);
  }
}

TEST(SizeClasses, LikeSizesShareOneAndWorldsApartDoNot) {
  std::vector<double> radii(10'000, 1.1);
  for (std::size_t i = 0; i < radii.size(); i += 2) radii[i] = 0.9;
  EXPECT_EQ(size_classes(radii, 40'000).size(), 1u);
  radii.push_back(100.0);
  EXPECT_EQ(size_classes(radii, 40'000).size(), 2u);
  EXPECT_TRUE(size_classes(std::vector<double>{0.0}, 1.0).empty());
}

}  // namespace
}  // namespace phytobench
