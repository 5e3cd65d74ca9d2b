// SPDX-License-Identifier: MIT
// Hydra, Ring and PhiBall ([Lintermann1997] fig. 4).
#include <limits>

#include <gtest/gtest.h>

#include "core/component_graph/shapes/component_fixture.hpp"
#include "core/component_graph/shapes/outward_frame.hpp"

namespace phytobench {
namespace {

using namespace component_fixture;

/// From one child to the next about the axis, [0, 360).
double azimuth_step(const Vector3& from, const Vector3& to) {
  const auto azimuth = [](const Vector3& v) { return degrees(std::atan2(v.x, v.z)); };
  const double step = azimuth(to) - azimuth(from);
  return step < 0.0 ? step + 360.0 : step;
}

std::vector<Frame> ball_of(Tried& ball, std::size_t n) {
  return ball.set("count", static_cast<double>(n)).frames(LinkKind::child, n);
}

TEST(HydraLaw, EighteenHairsStandTwentyDegreesApart) {
  Tried hydra("hydra");
  hydra.set("count", 18.0).set("tilt", 70.0);
  EXPECT_EQ(hydra.children(), 18u);
  const auto hairs = hydra.frames(LinkKind::child, 18);
  Vector3 sum;
  for (std::size_t i = 0; i < 18; ++i) {
    EXPECT_NEAR(azimuth_step(hairs[i].y, hairs[(i + 1) % 18].y), 20.0, 1e-9);
    EXPECT_NEAR(angle_deg(hairs[i].y, {0, 1, 0}), 70.0, 1e-9);
    EXPECT_EQ(hairs[i].origin, Vector3{});
    sum = sum + hairs[i].y;
  }
  EXPECT_NEAR(std::hypot(sum.x, sum.z), 0.0, 1e-12);
}

TEST(Hydra, RangesGoOverItsChildren) {
  Tried hydra("hydra");
  hydra.set("count", 5.0).set("sweep", 0.0).set_range("azimuth", 10.0, 90.0);
  hydra.set_range("tilt", 20.0, 60.0).set_range("scale", 1.0, 0.5).set_range("roll", 0.0, 0.0);
  const auto children = hydra.frames(LinkKind::child, 5);
  for (std::size_t i = 0; i < 5; ++i) {
    const double k = static_cast<double>(i);
    EXPECT_NEAR(degrees(std::atan2(children[i].y.x, children[i].y.z)), 10.0 + 20.0 * k, 1e-9);
    EXPECT_NEAR(angle_deg(children[i].y, {0, 1, 0}), 20.0 + 10.0 * k, 1e-9);
    EXPECT_NEAR(children[i].scale, 1.0 - 0.125 * k, 1e-12);
  }
}

TEST(Hydra, AChildLooksAwayFromTheAxisAndRollsAboutItself) {
  Tried hydra("hydra");
  const auto plain = hydra.frames(LinkKind::child, 6);
  const auto rolled = hydra.set("roll", 90.0).frames(LinkKind::child, 6);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_NEAR(plain[i].x.y, 0.0, 1e-15);
    EXPECT_LT(plain[i].z.y, 0.0);
    EXPECT_NEAR(azimuth_step(plain[0].z, plain[i].z), 60.0 * static_cast<double>(i), 1e-9);
    EXPECT_LT(norm(rolled[i].y - plain[i].y), 1e-12);
    EXPECT_LT(norm(rolled[i].x + plain[i].z), 1e-12);
  }
}

TEST(RingLaw, ChildrenStandOnACircleAndLookOutwards) {
  Tried ring("ring");
  ring.set("count", 7.0).set("radius", 0.3);
  EXPECT_EQ(ring.children(), 7u);
  const auto children = ring.frames(LinkKind::child, 7);
  for (std::size_t i = 0; i < 7; ++i) {
    EXPECT_NEAR(norm(children[i].origin), 0.3, 1e-12);
    EXPECT_EQ(children[i].origin.y, 0.0);
    EXPECT_LT(norm(children[i].origin - 0.3 * children[i].y), 1e-12);
    EXPECT_NEAR(azimuth_step(children[i].y, children[(i + 1) % 7].y), 360.0 / 7.0, 1e-9);
  }
}

TEST(Ring, ATiltOfZeroStandsUpright) {
  Tried ring("ring");
  for (const Frame& child : ring.set("tilt", 0.0).frames(LinkKind::child, 3))
    EXPECT_EQ(child.y, (Vector3{0.0, 1.0, 0.0}));
}

TEST(PhiballLaw, AzimuthsGrowByTheGoldenAngle) {
  // 360 degrees divided by the square of the golden number.
  EXPECT_NEAR(golden_angle_deg, 360.0 / (std::numbers::phi * std::numbers::phi), 1e-12);
  Tried ball("phiball");
  const auto children = ball_of(ball, 200);
  for (std::size_t i = 1; i < 200; ++i)
    EXPECT_NEAR(azimuth_step(children[i - 1].y, children[i].y), 137.507764, 1e-6) << i;
}

TEST(PhiballLaw, EveryChildIsInTheMiddleOfABandOfEqualArea) {
  for (const auto& [first, last] : {std::pair{0.0, 180.0}, {0.0, 60.0}, {150.0, 20.0}}) {
    Tried ball("phiball");
    ball.set("polar_first", first).set("polar_last", last).set("radius", 2.0);
    const auto children = ball_of(ball, 50);
    const double top = std::cos(radians(first)), bottom = std::cos(radians(last));
    for (std::size_t i = 0; i < 50; ++i) {
      // The area of a band is 2 pi r times its height.
      const double middle = top + (static_cast<double>(i) + 0.5) / 50.0 * (bottom - top);
      EXPECT_NEAR(children[i].origin.y, 2.0 * middle, 1e-12);
      EXPECT_NEAR(norm(children[i].origin), 2.0, 1e-12);
      EXPECT_LT(norm(children[i].origin - 2.0 * children[i].y), 1e-12);
    }
  }
}

TEST(PhiballLaw, KeepsItsChildrenApart) {
  for (const auto& [n, apart] :
       {std::pair<std::size_t, double>{100, 3.0904}, {300, 3.0915}, {1000, 3.0919}}) {
    Tried ball("phiball");
    const auto children = ball_of(ball, n);
    double nearest = std::numeric_limits<double>::infinity();
    Vector3 sum;
    for (std::size_t i = 0; i < n; ++i) {
      sum = sum + children[i].origin;
      for (std::size_t j = 0; j < i; ++j)
        nearest = std::min(nearest, norm(children[i].origin - children[j].origin));
    }
    constexpr double printed_to = 0.5e-4;
    EXPECT_NEAR(nearest * std::sqrt(static_cast<double>(n)), apart, printed_to) << n;
    EXPECT_LT(norm(sum) / static_cast<double>(n), 2.5e-4) << n;
  }
}

TEST(Phiball, TiltsItsChildrenAwayFromItsAxis) {
  Tried ball("phiball");
  ball.set("polar_last", 90.0);
  const auto straight = ball_of(ball, 20), tilted = ball_of(ball.set("tilt", 25.0), 20);
  for (std::size_t i = 0; i < 20; ++i) {
    EXPECT_EQ(straight[i].origin, tilted[i].origin);
    EXPECT_NEAR(angle_deg(tilted[i].y, {0, 1, 0}) - angle_deg(straight[i].y, {0, 1, 0}), 25.0,
                1e-9);
  }
}

TEST(Phiball, WithoutARadiusAllBeginAtOnePoint) {
  Tried ball("phiball");
  ball.set("radius", 0.0).set_range("scale", 0.9, 0.7);
  const auto children = ball_of(ball, 3);
  for (const Frame& child : children) EXPECT_EQ(norm(child.origin), 0.0);
  EXPECT_EQ(children[0].scale, 0.9);
  EXPECT_EQ(children[2].scale, 0.7);
}

TEST(PhiballLaw, TwiceTheRadiusIsTwiceThePlaces) {
  Tried small("phiball"), large("phiball");
  small.set("radius", 0.7);
  large.set("radius", 1.4);
  const auto a = ball_of(small, 30), b = ball_of(large, 30);
  for (std::size_t i = 0; i < 30; ++i) EXPECT_EQ(2.0 * a[i].origin, b[i].origin);
}

}  // namespace
}  // namespace phytobench
