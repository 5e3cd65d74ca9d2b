// SPDX-License-Identifier: MIT
#include "core/overlap/lens.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include "core/parallel/vector_targets.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

using Exact = boost::multiprecision::cpp_bin_float_100;

/// With a hundred digits cancellation does no harm: the textbook's formula.
Exact exact_lens(double r, double s, double d) {
  const Exact R = r, S = s, D = d;
  if (D >= R + S) return 0;
  const Exact pi = boost::math::constants::pi<Exact>();
  const Exact small = R < S ? R : S;
  if (D <= abs(R - S)) return pi * small * small;
  const auto part = [&](const Exact& a, const Exact& b) -> Exact {
    Exact cosine = (a * a + D * D - b * b) / (2 * a * D);
    const Exact angle = 2 * acos(cosine);
    return a * a * (angle - sin(angle)) / 2;
  };
  return part(R, S) + part(S, R);
}

double relative_error(double r, double s, double d) {
  const Exact exact = exact_lens(r, s, d);
  const double area = lens_area(r, s, d);
  if (exact == 0) return area == 0.0 ? 0.0 : std::numeric_limits<double>::infinity();
  return static_cast<double>(Exact(abs(Exact(area) - exact) / exact));
}

TEST(LensArea, HasTheKnownValues) {
  const double pi = std::numbers::pi, root3 = std::numbers::sqrt3, root2 = std::numbers::sqrt2;
  EXPECT_NEAR(lens_area(1, 1, 1), 2 * pi / 3 - root3 / 2, 1e-15);
  EXPECT_NEAR(lens_area(1, 1, root2), pi / 2 - 1, 1e-15);
  EXPECT_NEAR(lens_area(1, root2, 1), pi - 1, 1e-15);  // neither of the printed slips survives this
  EXPECT_NEAR(lens_area(1, 1, 0.5), 2 * std::acos(0.25) - std::sqrt(3.75) / 4, 1e-15);
  EXPECT_NEAR(lens_area(1, 1, 2 - 1e-12), 1.33351113844951358908e-18, 1e-32);
}

TEST(LensArea, EndsWhereCirclesTouch) {
  const double pi = std::numbers::pi;
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

/// A distance where formulas go wrong: just inside outer contact, just outside inner contact, near
/// a radius, or anywhere.
double hard_distance(double r, double s, int kind, double unit) {
  const double gap = std::pow(10.0, -17.0 * unit);
  switch (kind % 5) {
    case 0:
      return (r + s) * (1.0 - gap);
    case 1:
      return std::abs(r - s) + std::min(r, s) * gap;
    case 2:
      return std::max(r, s) * (1.0 + (unit < 0.5 ? gap : -gap));
    case 3:
      return std::min(r, s) * (1.0 + (unit < 0.5 ? gap : -gap));
    default:
      return std::abs(r - s) + unit * (r + s - std::abs(r - s));
  }
}

TEST(LensAreaLaw, IsRightToFourteenDigitsEverywhere) {
  CounterStream stream(5, 0);
  double worst = 0.0;
  for (int i = 0; i < 5'000; ++i) {
    const double r = std::pow(10.0, 18.0 * stream.next_unit() - 9.0);
    const double ratio = std::pow(10.0, (i % 3 == 0   ? 1e-3
                                         : i % 3 == 1 ? 1.0
                                                      : 9.0) *
                                            (stream.next_unit() - 0.5));
    const double s = std::clamp(r * ratio, 1e-9, 1e9);
    const double d = hard_distance(r, s, i, stream.next_unit());
    const double error = relative_error(r, s, d);
    if (error > worst) worst = error;
    ASSERT_LE(error, 1e-14) << "r " << r << ", s " << s << ", d " << d;
  }
  EXPECT_GT(worst, 0.0);  // or nothing was compared
}

TEST(LensAreaLaw, IsSymmetricScalesWithTheSquareAndFallsWithDistance) {
  CounterStream stream(6, 0);
  for (int i = 0; i < 20'000; ++i) {
    const double r = stream.next_unit() + 1e-3, s = stream.next_unit() + 1e-3;
    const double d = (r + s) * stream.next_unit();
    const double area = lens_area(r, s, d);
    EXPECT_EQ(area, lens_area(s, r, d));
    EXPECT_EQ(4.0 * area, lens_area(2 * r, 2 * s, 2 * d));
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
    d.push_back(hard_distance(r[i], s[i], static_cast<int>(i), stream.next_unit()));
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
