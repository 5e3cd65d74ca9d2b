// SPDX-License-Identifier: MIT
#include "core/geometry/segment_distance.hpp"

#include <gtest/gtest.h>

#include "core/geometry/rotation.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

Vector3 random_end(UnitStream& stream) {
  const double x = stream.next_between(-1.0, 1.0), y = stream.next_between(-1.0, 1.0);
  return {x, y, stream.next_between(-1.0, 1.0)};
}

Segment random_segment(UnitStream& stream) {
  const Vector3 from = random_end(stream);
  return {from, random_end(stream)};
}

/// The least distance between places in steps of one hundredth of either length.
double searched(const Segment& a, const Segment& b) {
  constexpr int steps = 100;
  double least = squared_distance(a.from, b.from);
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; j <= steps; ++j) {
      const Vector3 on_a = a.from + i / double{steps} * (a.to - a.from);
      const Vector3 on_b = b.from + j / double{steps} * (b.to - b.from);
      least = std::min(least, squared_distance(on_a, on_b));
    }
  return least;
}

TEST(SegmentDistanceLaw, IsTheLeastOfAllPairsOfPlaces) {
  CounterStream stream(0, 1);
  for (int i = 0; i < 300; ++i) {
    const Segment a = random_segment(stream), b = random_segment(stream);
    const double exact = std::sqrt(squared_distance(a, b)), near = std::sqrt(searched(a, b));
    EXPECT_LE(exact, near + 1e-12);
    EXPECT_GE(exact, near - 0.03);  // half a step of either segment, at most 2 sqrt(3) long
  }
}

TEST(SegmentDistanceLaw, ForgetsOrderAndDirection) {
  CounterStream stream(0, 2);
  for (int i = 0; i < 300; ++i) {
    const Segment a = random_segment(stream), b = random_segment(stream);
    const double distance = squared_distance(a, b);
    EXPECT_NEAR(squared_distance(b, a), distance, 1e-12);
    EXPECT_NEAR(squared_distance({a.to, a.from}, b), distance, 1e-12);
  }
}

TEST(SegmentDistanceLaw, IsKeptByRotations) {
  CounterStream stream(0, 3);
  for (int i = 0; i < 100; ++i) {
    const Segment a = random_segment(stream), b = random_segment(stream);
    const double u1 = stream.next_unit(), u2 = stream.next_unit();
    const Rotation turn = Rotation::uniform(u1, u2, stream.next_unit());
    EXPECT_NEAR(
        squared_distance(Segment{turn(a.from), turn(a.to)}, Segment{turn(b.from), turn(b.to)}),
        squared_distance(a, b), 1e-12);
  }
}

TEST(SegmentDistance, KnowsCrossingParallelAndPointlikeSegments) {
  const Segment x{{-1, 0, 0}, {1, 0, 0}};
  EXPECT_EQ(squared_distance(x, Segment{{0, -1, 0}, {0, 1, 0}}), 0.0) << "crossing";
  EXPECT_EQ(squared_distance(x, Segment{{0, -1, 2}, {0, 1, 2}}), 4.0) << "skew";
  EXPECT_EQ(squared_distance(x, Segment{{-3, 3, 0}, {3, 3, 0}}), 9.0) << "parallel, side by side";
  EXPECT_EQ(squared_distance(x, Segment{{4, 4, 0}, {9, 4, 0}}), 25.0) << "parallel, end to end";
  EXPECT_EQ(squared_distance(x, Segment{{3, 0, 0}, {2, 0, 0}}), 1.0) << "in one line";
  EXPECT_EQ(squared_distance(x, Segment{{1, 2, 0}, {1, 2, 0}}), 4.0) << "one is a point";
  EXPECT_EQ(squared_distance(Segment{{1, 2, 0}, {1, 2, 0}}, Segment{{1, 5, 0}, {1, 5, 0}}), 9.0)
      << "both are";
}

}  // namespace
}  // namespace phytobench
