// SPDX-License-Identifier: MIT
#include <cmath>

#include <gtest/gtest.h>

#include "core/point_pattern/cluster_patterns.hpp"
#include "core/point_pattern/random_patterns.hpp"
#include "core/point_pattern/test_patterns.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

using test_patterns::standard_errors;
using test_patterns::unit_torus;

/// [Alsweis] eq. 2.8 without i = j: mean distance from random places to the nearest point over that
/// from point to point.
double hopkins(const std::vector<Point2>& points, std::uint64_t seed) {
  const auto nearest = [&](const Point2& from) {
    double best = 2.0;
    for (const Point2& p : points)
      if (const double d = squared_norm(unit_torus.difference(from, p)); d > 0.0 && d < best)
        best = d;
    return std::sqrt(best);
  };
  CounterStream stream(seed, 1);
  double from_places = 0.0, from_points = 0.0;
  for (const Point2& place : uniform_points(unit_torus, points.size(), stream))
    from_places += nearest(place);
  for (const Point2& p : points) from_points += nearest(p);
  return from_places / from_points;
}

// The ledger's bound for [Alsweis] sec. 2.4.1: above 1.5 for all of 20 seeds. Its 2.49 is a
// sample's mean too; 1000 seeds gave 2.442 here, with a deviation of 0.42 from seed to seed.
TEST(ThomasPointsOracle, AreAsClusteredAsTheDissertationsExample) {
  const ThomasOptions options{.numbers = {.parents = 20,
                                          .parents_law = NumberLaw::fixed,
                                          .offspring = 20,
                                          .offspring_law = NumberLaw::fixed},
                              .sigma = 0.05};
  double sum = 0.0, squares = 0.0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    CounterStream stream(seed, 0);
    const double index = hopkins(thomas_points(unit_torus, options, stream), seed);
    EXPECT_GT(index, 1.5) << seed;
    sum += index;
    squares += index * index;
  }
  const double deviation = std::sqrt(squares / 20.0 - sum * sum / 400.0);
  EXPECT_NEAR(sum / 20.0, 2.49, standard_errors * deviation / std::sqrt(20.0));
}

}  // namespace
}  // namespace phytobench
