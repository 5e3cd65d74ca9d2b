// SPDX-License-Identifier: MIT
#include "core/component_graph/frame.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace phytobench {
namespace {

Frame some_frame() {
  Frame frame = Frame{}.turned(Rotation::uniform(0.3, 0.7, 0.1));
  frame.origin = {1.0, -2.0, 3.0};
  frame.scale = 2.5;
  return frame;
}

TEST(FrameLaw, PlacesGoThereAndBack) {
  const Frame frame = some_frame();
  const Vector3 local{0.3, 0.8, -1.7};
  EXPECT_LT(norm(frame.local_place(frame.place(local)) - local), 1e-15);
  EXPECT_LT(norm(frame.local_direction(frame.direction(local)) - local), 1e-15);
  EXPECT_EQ(frame.place({}), frame.origin);
}

TEST(FrameLaw, AFrameInAFrameIsOneAfterTheOther) {
  const Frame outer = some_frame();
  Frame inner = Frame{}.turned(Rotation::about({0.0, 1.0, 0.0}, 1.0));
  inner.origin = {0.0, 4.0, 0.0};
  inner.scale = 0.5;
  const Vector3 local{0.1, 0.2, 0.3};
  EXPECT_LT(norm((outer * inner).place(local) - outer.place(inner.place(local))), 1e-14);
  EXPECT_EQ(outer * Frame{}, outer);
}

TEST(FrameLaw, AxesAreRightAgainAfterMakingThemOrthonormal) {
  Frame skew = some_frame();
  skew.x = skew.x + 1e-3 * skew.y;
  skew.y = 1.01 * skew.y;
  const Frame right = orthonormal(skew);
  EXPECT_NEAR(norm(right.x), 1.0, 1e-15);
  EXPECT_NEAR(dot(right.x, right.y), 0.0, 1e-15);
  EXPECT_LT(norm(cross(right.x, right.y) - right.z), 1e-15);
  EXPECT_LT(norm(right.y - some_frame().y), 1e-15);
  EXPECT_EQ(orthonormal(Frame{}), Frame{});
}

}  // namespace
}  // namespace phytobench
