// SPDX-License-Identifier: MIT
#include "core/geometry/bounding_box.hpp"

#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Vector3 random_point(UnitStream& stream) {
  return {stream.next_between(-5.0, 5.0), stream.next_between(-5.0, 5.0),
          stream.next_between(-5.0, 5.0)};
}

BoundingBox box_around(const std::vector<Vector3>& points) {
  BoundingBox box;
  for (const Vector3& point : points) box.extend(point);
  return box;
}

TEST(BoundingBox, EmptyContainsNothing) {
  const BoundingBox box;
  EXPECT_TRUE(box.empty());
  EXPECT_EQ(box.extent(), Vector3{});
  const std::vector<Vector3> points{{0, 0, 0}, {1e300, -1e300, 1e300}, {-1.5, 2.5, 0.1}};
  for (const Vector3& point : points) {
    EXPECT_FALSE(box.contains(point));
    // However far an empty box is widened, there is nothing to be near to.
    for (const double margin : {0.0, 1.0, 1e300, infinity})
      EXPECT_FALSE(box.widened(margin).contains(point)) << "margin " << margin;
  }
}

TEST(BoundingBox, OfOnePointContainsItAlone) {
  const BoundingBox box = box_around({{1, 2, 3}});
  EXPECT_FALSE(box.empty());
  EXPECT_EQ(box.extent(), Vector3{});
  EXPECT_TRUE(box.contains({1, 2, 3}));
  EXPECT_FALSE(box.contains({std::nextafter(1.0, 2.0), 2, 3}));
  EXPECT_FALSE(box.contains({1, std::nextafter(2.0, 1.0), 3}));
  EXPECT_FALSE(box.contains({1, 2, std::nextafter(3.0, 4.0)}));
}

TEST(BoundingBox, KeepsSixExtrema) {
  const BoundingBox box = box_around({{1, -2, 3}, {-4, 5, 0}, {0, 0, -6}});
  EXPECT_EQ(box.low(), (Vector3{-4, -2, -6}));
  EXPECT_EQ(box.high(), (Vector3{1, 5, 3}));
  EXPECT_EQ(box.extent(), (Vector3{5, 7, 9}));
  EXPECT_TRUE(box.contains({1, 5, 3}));
  EXPECT_TRUE(box.contains({-4, -2, -6}));
}

TEST(BoundingBox, WidenedKeepsPointsExactlyAtTheMargin) {
  CounterStream stream(1, 0);
  for (int i = 0; i < 2000; ++i) {
    const Vector3 first = random_point(stream);
    const BoundingBox box = box_around({first, random_point(stream)});
    const double margin = stream.next_between(0.0, 3.0);
    const BoundingBox wide = box.widened(margin);
    const Vector3 reach{margin, margin, margin};
    ASSERT_TRUE(wide.contains(box.low() - reach)) << "box " << i;
    ASSERT_TRUE(wide.contains(box.high() + reach)) << "box " << i;
  }
}

TEST(BoundingBox, WidenedEndsAtTheMarginOnEverySide) {
  CounterStream stream(2, 0);
  constexpr double rounding = 1e-14;  // a few units in the last place of coordinates up to 8
  for (int i = 0; i < 200; ++i) {
    const Vector3 first = random_point(stream);
    const BoundingBox box = box_around({first, random_point(stream)});
    const double margin = stream.next_between(0.0, 3.0);
    const BoundingBox wide = box.widened(margin);
    const double beyond = margin * (1.0 + 0x1p-40) + rounding;  // as the header promises
    for (const Vector3& side :
         {Vector3{beyond, 0, 0}, Vector3{0, beyond, 0}, Vector3{0, 0, beyond}}) {
      ASSERT_FALSE(wide.contains(box.high() + side)) << "box " << i;
      ASSERT_FALSE(wide.contains(box.low() - side)) << "box " << i;
    }
  }
}

TEST(BoundingBox, WidenedWithoutBoundContainsAll) {
  const BoundingBox wide = box_around({{1, 2, 3}}).widened(infinity);
  EXPECT_TRUE(wide.contains({1e308, -1e308, 0}));
}

TEST(BoundingBoxLaw, UpdatedBoxEqualsRecomputation) {
  CounterStream stream(3, 0);
  std::vector<Vector3> points;
  BoundingBox running;
  for (int i = 0; i < 200; ++i) {
    points.push_back(random_point(stream));
    running.extend(points.back());
    const BoundingBox recomputed = box_around(points);
    ASSERT_EQ(running.low(), recomputed.low()) << "after " << i;
    ASSERT_EQ(running.high(), recomputed.high()) << "after " << i;
    ASSERT_TRUE(running.contains(points[points.size() / 2])) << "after " << i;
  }
}

TEST(BoundingBoxLaw, OrderOfPointsDoesNotMatter) {
  CounterStream stream(4, 0);
  std::vector<Vector3> points;
  for (int i = 0; i < 50; ++i) points.push_back(random_point(stream));
  const BoundingBox box = box_around(points);
  std::vector<Vector3> shuffled;
  for (const std::size_t i : random_order(points.size(), stream)) shuffled.push_back(points[i]);
  ASSERT_NE(points, shuffled);
  EXPECT_EQ(box_around(shuffled).low(), box.low());
  EXPECT_EQ(box_around(shuffled).high(), box.high());
}

// The squared distance still rounds to the squared margin, but the coordinates alone do not reach
// it.
TEST(BoundingBox, KeepsAPointThatOnlyTheSquaredDistanceAdmits) {
  const Vector3 node{-0.7532032949255694, 0, 0};
  const Vector3 point{-0.0932032949255693, 0, 0};
  ASSERT_LE(squared_distance(node, point), 0.66 * 0.66);
  BoundingBox box;
  box.extend(node);
  EXPECT_TRUE(box.widened(0.66).contains(point));
}

}  // namespace
}  // namespace phytobench
