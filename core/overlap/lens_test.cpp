// SPDX-License-Identifier: MIT
#include "core/overlap/lens.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "core/overlap/test_discs.hpp"
#include "core/parallel/vector_targets.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

using testing_discs::pi;

TEST(LensArea, HasTheKnownValues) {
  const double root3 = std::numbers::sqrt3, root2 = std::numbers::sqrt2;
  EXPECT_NEAR(lens_area(1, 1, 1), 2 * pi / 3 - root3 / 2, 1e-15);
  EXPECT_NEAR(lens_area(1, 1, root2), pi / 2 - 1, 1e-15);
  EXPECT_NEAR(lens_area(1, root2, 1), pi - 1, 1e-15);  // neither of the printed slips survives this
  EXPECT_NEAR(lens_area(1, 1, 0.5), 2 * std::acos(0.25) - std::sqrt(3.75) / 4, 1e-15);
  EXPECT_NEAR(lens_area(1, 1, 2 - 1e-12), 1.33351113844951358908e-18, 1e-32);
}

TEST(LensArea, EndsWhereCirclesTouch) {
  EXPECT_EQ(lens_area(1, 2, 3), 0.0);
  EXPECT_EQ(lens_area(1, 2, 4), 0.0);
  EXPECT_GT(lens_area(1, 2, std::nextafter(3.0, 0.0)), 0.0);
  EXPECT_EQ(lens_area(1, 2, 1), pi);
  EXPECT_EQ(lens_area(1, 2, 0), pi);
  EXPECT_LE(lens_area(1, 2, std::nextafter(1.0, 2.0)), pi);
  EXPECT_EQ(lens_area(0, 2, 1), 0.0);
  EXPECT_EQ(lens_area(0, 0, 0), 0.0);
  EXPECT_EQ(lens_area(3, 3, 0), pi * 9);
  EXPECT_TRUE(std::isnan(lens_area(std::nan(""), 1, 1)));
  EXPECT_TRUE(std::isnan(lens_area(1, 1, std::nan(""))));
}

TEST(LensAreaLaw, IsSymmetricScalesWithTheSquareAndFallsWithDistance) {
  CounterStream stream(6, 0);
  for (int i = 0; i < 20'000; ++i) {
    const double r = stream.next_unit() + 1e-3, s = stream.next_unit() + 1e-3;
    const double d = (r + s) * stream.next_unit();
    const double area = lens_area(r, s, d);
    EXPECT_EQ(area, lens_area(s, r, d));
    for (const double k : {2.0, 0x1p230, 0x1p-230})
      EXPECT_EQ(k * k * area, lens_area(k * r, k * s, k * d));
    EXPECT_LE(area, std::numbers::pi * std::min(r, s) * std::min(r, s) * (1 + 1e-15));
    EXPECT_GE(area, 0.0);
    EXPECT_LE(lens_area(r, s, d * (1 + 1e-6)), area);
    EXPECT_GE(lens_area(r * (1 + 1e-6), s, d), area);
  }
}

/// Integrated over all relative positions, two discs have the product of their areas in common.
TEST(LensAreaLaw, IntegralOverPositionsIsTheProductOfTheAreas) {
  for (const auto& [r, s] : {std::pair{1.0, 1.0}, std::pair{0.3, 2.0}, std::pair{1.0, 1.7}}) {
    constexpr int steps = 200'000;
    const double step = (r + s) / steps;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
      const double d = (i + 0.5) * step;
      sum += lens_area(r, s, d) * 2 * std::numbers::pi * d * step;
    }
    const double product = std::numbers::pi * r * r * std::numbers::pi * s * s;
    EXPECT_NEAR(sum / product, 1.0, 1e-9);
  }
}

TEST(LensAreas, HaveTheSameBitsOnEveryVectorTarget) {
  CounterStream stream(8, 0);
  constexpr std::size_t count = 10'007;  // no whole number of vectors
  std::vector<double> r, s, d, expected, area(count);
  for (std::size_t i = 0; i < count; ++i) {
    r.push_back(std::pow(10.0, 4.0 * stream.next_unit() - 2.0));
    s.push_back(i % 7 == 0 ? r.back() : std::pow(10.0, 4.0 * stream.next_unit() - 2.0));
    d.push_back((r[i] + s[i]) *
                (i % 2 == 0 ? stream.next_unit() : 1.0 - 1e-12 * stream.next_unit()));
    if (i % 100 == 0) d.back() = i % 200 == 0 ? 0.0 : 2.0 * (r[i] + s[i]);
    expected.push_back(lens_area(r[i], s[i], d[i]));
  }
  ASSERT_GE(vector_targets().size(), 2u);
  for (const std::int64_t target : vector_targets()) {
    const ForcedTarget forced(target);
    std::fill(area.begin(), area.end(), -1.0);
    lens_areas(r, s, d, area);
    EXPECT_EQ(area, expected) << hwy::TargetName(target);
  }
}

}  // namespace
}  // namespace phytobench
