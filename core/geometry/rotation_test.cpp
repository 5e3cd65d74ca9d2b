// SPDX-License-Identifier: MIT
#include "core/geometry/rotation.hpp"

#include <gtest/gtest.h>

#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

constexpr Vector3 up{0.0, 1.0, 0.0};

Vector3 random_direction(CounterStream& stream) {
  for (;;) {
    const double x = stream.next_between(-1, 1), y = stream.next_between(-1, 1);
    const Vector3 v{x, y, stream.next_between(-1, 1)};
    if (squared_norm(v) <= 1.0 && squared_norm(v) > 0.01) return v / norm(v);
  }
}

void expect_near(const Vector3& a, const Vector3& b, double tolerance) {
  EXPECT_LE(norm(a - b), tolerance) << a.x << " " << a.y << " " << a.z;
}

TEST(Rotation, IsTheIdentityByDefault) {
  const Vector3 v{1.5, -2.0, 3.0};
  EXPECT_EQ(Rotation()(v), v);
}

TEST(Rotation, TurnsCounterClockwiseSeenFromTheTipOfTheAxis) {
  const Rotation quarter = Rotation::about(up, 0.5 * std::numbers::pi);
  expect_near(quarter({0, 0, 1}), {1, 0, 0}, 1e-15);
  expect_near(quarter({1, 0, 0}), {0, 0, -1}, 1e-15);
}

TEST(RotationLaw, BetweenTakesAnyDirectionToAnyOther) {
  CounterStream stream(1, 0);
  for (int i = 0; i < 100000; ++i) {
    const Vector3 from = i % 2 == 0 ? up : random_direction(stream), to = random_direction(stream);
    EXPECT_LE(norm(Rotation::between(from, to)(from) - to), 1e-14);
  }
}

TEST(RotationLaw, BetweenTurnsNoMoreThanItMust) {
  CounterStream stream(2, 0);
  for (int i = 0; i < 1000; ++i) {
    const Vector3 to = random_direction(stream);
    const Rotation rotation = Rotation::between(up, to);
    EXPECT_NEAR(2.0 * std::acos(rotation.w()), std::acos(to.y), 1e-7);
  }
}

TEST(Rotation, BetweenEqualAndOppositeDirectionsIsDefined) {
  EXPECT_EQ(Rotation::between(up, up), Rotation());
  for (const Vector3& v : {up, Vector3{1, 0, 0}, Vector3{0, 0, -1}, Vector3{0.6, 0, 0.8}})
    expect_near(Rotation::between(v, -1.0 * v)(v), -1.0 * v, 1e-15);
}

TEST(Rotation, BetweenNearlyOppositeDirectionsStaysAccurate) {
  for (const double tilt : {1e-3, 1e-6, 1e-9, 1e-11, 1e-13, 1e-16}) {
    const Vector3 to{std::sin(tilt), -std::cos(tilt), 0.0};
    expect_near(Rotation::between(up, to)(up), to, 1e-11);
  }
}

TEST(RotationLaw, KeepsLengthsAndAnglesHoweverManyAreChained) {
  CounterStream stream(3, 0);
  Rotation chain;
  for (int i = 0; i < 1000; ++i)
    chain = Rotation::about(random_direction(stream), stream.next_unit()) * chain;
  const Vector3 a{1, 2, 3}, b{-2, 0.5, 1};
  EXPECT_NEAR(dot(chain(a), chain(b)), dot(a, b), 1e-13);
  expect_near(cross(chain(a), chain(b)), chain(cross(a, b)), 1e-12);
}

TEST(RotationLaw, AProductAppliesTheRightFactorFirst) {
  const Rotation a = Rotation::about(up, 1.0), b = Rotation::about({1, 0, 0}, 0.7);
  const Vector3 v{0.3, -1.0, 2.0};
  expect_near((a * b)(v), a(b(v)), 1e-15);
}

// The mean over all rotations of a rotated vector is zero, and its height is uniform (Archimedes).
TEST(RotationLaw, UniformRotationsPreferNoDirection) {
  CounterStream stream(4, 0);
  Vector3 sum;
  int upper_tenth = 0;
  constexpr int count = 20000;
  for (int i = 0; i < count; ++i) {
    const double u1 = stream.next_unit(), u2 = stream.next_unit();
    const Vector3 v = Rotation::uniform(u1, u2, stream.next_unit())(up);
    EXPECT_NEAR(norm(v), 1.0, 1e-14);
    sum = sum + v;
    upper_tenth += v.y > 0.8;
  }
  EXPECT_LE(norm(sum / count), 4.0 / std::sqrt(count));
  EXPECT_NEAR(upper_tenth, 0.1 * count, 4.0 * std::sqrt(0.09 * count));
}

}  // namespace
}  // namespace phytobench
