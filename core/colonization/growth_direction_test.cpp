// SPDX-License-Identifier: MIT
#include "core/colonization/growth_direction.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/colonization/test_growth.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

using enum AttractionSum;
using enum TropismOrder;

constexpr double direction_rounding =
    1e-12;  // a few floating-point operations; directions stay 0.02 rad apart

Vector3 random_unit_vector(UnitStream& stream) {
  const double x = stream.next_between(-1.0, 1.0);
  const double y = stream.next_between(-1.0, 1.0);
  const double z = stream.next_between(-1.0, 1.0);
  const Vector3 v{x, y, z};
  return v / norm(v);
}

TEST(Attraction, IsAUnitVectorToThePointOrTheWholeWay) {
  const Vector3 unit = attraction({1, 1, 1}, {1, 4, 5}, unit_vectors);
  EXPECT_NEAR(unit.x, 0.0, direction_rounding);
  EXPECT_NEAR(unit.y, 0.6, direction_rounding);
  EXPECT_NEAR(unit.z, 0.8, direction_rounding);
  EXPECT_EQ(attraction({1, 1, 1}, {1, 4, 5}, raw_vectors), (Vector3{0, 3, 4}));
}

TEST(Attraction, OfAPointAtTheNodeIsNothing) {
  EXPECT_EQ(attraction({1, 2, 3}, {1, 2, 3}, unit_vectors), Vector3{});
  EXPECT_EQ(attraction({1, 2, 3}, {1, 2, 3}, raw_vectors), Vector3{});
}

TEST(GrowthDirection, AddsTropismBeforeOrAfterNormalising) {
  const Vector3 sum{3, 0, 0}, tropism{0, 1, 0};
  const auto before = growth_direction(sum, tropism, before_normalising);
  ASSERT_TRUE(before.has_value());
  EXPECT_NEAR(before->x, 3.0 / std::sqrt(10.0), direction_rounding);
  EXPECT_NEAR(before->y, 1.0 / std::sqrt(10.0), direction_rounding);
  const auto after = growth_direction(sum, tropism, after_normalising);
  ASSERT_TRUE(after.has_value());
  EXPECT_NEAR(after->x, std::sqrt(0.5), direction_rounding);
  EXPECT_NEAR(after->y, std::sqrt(0.5), direction_rounding);
}

TEST(GrowthDirection, OfNothingIsNone) {
  for (const TropismOrder order : {before_normalising, after_normalising})
    EXPECT_FALSE(growth_direction({0, 0, 0}, {0, 0, 0}, order).has_value());
}

TEST(GrowthDirection, OfOppositeTropismIsNone) {
  EXPECT_FALSE(growth_direction({0, 2, 0}, {0, -2, 0}, before_normalising).has_value());
  EXPECT_FALSE(growth_direction({0, 2, 0}, {0, -1, 0}, after_normalising).has_value());
  // What cancels in one order does not in the other.
  EXPECT_TRUE(growth_direction({0, 2, 0}, {0, -2, 0}, after_normalising).has_value());
  EXPECT_TRUE(growth_direction({0, 2, 0}, {0, -1, 0}, before_normalising).has_value());
}

TEST(GrowthDirection, OfZeroSumIsTropismOnlyIfThatIsAddedFirst) {
  const auto direction = growth_direction({0, 0, 0}, {0, 0, -2}, before_normalising);
  ASSERT_TRUE(direction.has_value());
  EXPECT_EQ(*direction, (Vector3{0, 0, -1}));
  EXPECT_FALSE(growth_direction({0, 0, 0}, {0, 0, -2}, after_normalising).has_value());
}

TEST(GrowthDirectionLaw, HasUnitLength) {
  CounterStream stream(1, 0);
  for (int i = 0; i < 500; ++i) {
    const Vector3 sum = stream.next_between(0.0, 100.0) * random_unit_vector(stream);
    const Vector3 tropism = stream.next_between(0.0, 3.0) * random_unit_vector(stream);
    for (const TropismOrder order : {before_normalising, after_normalising}) {
      const auto direction = growth_direction(sum, tropism, order);
      ASSERT_TRUE(direction.has_value());
      ASSERT_NEAR(norm(*direction), 1.0, direction_rounding);
    }
  }
}

TEST(DirectionLimit, ByHalfATurnLimitsNothing) {
  const DirectionLimit limit(std::numbers::pi);
  const Vector3 backwards{0, -1, 0};
  EXPECT_EQ(limit(backwards, {0, 1, 0}), backwards);
}

TEST(DirectionLimit, TurnsABackwardDirectionToTheEdge) {
  const DirectionLimit limit(half_angle_rad);
  const double angle_rad = 120.0 * std::numbers::pi / 180.0;
  const Vector3 turned = limit({0.0, std::cos(angle_rad), std::sin(angle_rad)}, {0, 1, 0});
  EXPECT_NEAR(turned.x, 0.0, direction_rounding);
  EXPECT_NEAR(turned.y, std::cos(half_angle_rad), direction_rounding);
  EXPECT_NEAR(turned.z, std::sin(half_angle_rad), direction_rounding);
}

TEST(DirectionLimit, TurnsTheOppositeDirectionToSomeEdge) {
  const DirectionLimit limit(half_angle_rad);
  for (const Vector3& node : {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1},
                              Vector3{-1, 0, 0}, Vector3{0, -1, 0}, Vector3{0, 0, -1}}) {
    const Vector3 turned = limit(-1.0 * node, node);
    EXPECT_NEAR(norm(turned), 1.0, direction_rounding);
    EXPECT_NEAR(dot(turned, node), std::cos(half_angle_rad), direction_rounding);
  }
}

TEST(DirectionLimitLaw, KeepsWhatIsInsideAndTurnsTheRestToTheEdgeInTheSamePlane) {
  const DirectionLimit limit(half_angle_rad);
  const double edge = std::cos(half_angle_rad);
  CounterStream stream(11, 0);
  int kept = 0, turned = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vector3 direction = random_unit_vector(stream);
    const Vector3 node = random_unit_vector(stream);
    const Vector3 limited = limit(direction, node);
    if (dot(direction, node) >= edge) {
      ++kept;
      ASSERT_EQ(limited, direction) << "pair " << i;
      continue;
    }
    ++turned;
    ASSERT_NEAR(dot(limited, node), edge, direction_rounding) << "pair " << i;
    ASSERT_NEAR(norm(limited), 1.0, direction_rounding) << "pair " << i;
    ASSERT_NEAR(dot(limited, cross(direction, node)), 0.0, direction_rounding) << "pair " << i;
    // On the same side of the node's direction: turned as little as possible.
    ASSERT_GT(dot(limited - edge * node, direction), 0.0) << "pair " << i;
  }
  EXPECT_GT(kept, 500);
  EXPECT_GT(turned, 500);
}

// Straight backwards, "sideways" is rounding noise that may even point along the node.
TEST(DirectionLimitLaw, TurnsAnyBackwardDirectionToTheEdgeOfTheCone) {
  constexpr double half_angle = 80.0 * std::numbers::pi / 180.0;
  const DirectionLimit limit(half_angle);
  CounterStream stream(5, 0);
  for (int i = 0; i < 2000; ++i) {
    const double x = stream.next_between(-1.0, 1.0);
    const double y = stream.next_between(-1.0, 1.0);
    const double z = stream.next_between(-1.0, 1.0);
    const Vector3 node = Vector3{x, y, z} / norm({x, y, z});
    const Vector3 turned = limit(-1.0 * node, node);
    // 1e-7: what is left of a plane just above the noise limit of 1e-8 is good to about eight
    // digits.
    ASSERT_NEAR(norm(turned), 1.0, 1e-7) << i;
    ASSERT_NEAR(dot(turned, node), std::cos(half_angle), 1e-7) << i;
  }
}

}  // namespace
}  // namespace phytobench
