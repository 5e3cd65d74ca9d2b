// SPDX-License-Identifier: MIT
#include "core/picture/camera.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace phytobench {
namespace {

TEST(CameraLaw, StandsAtItsDistanceAndLooksAtItsTarget) {
  for (double azimuth = -360; azimuth <= 360; azimuth += 15)
    for (double elevation = -90; elevation <= 90; elevation += 15) {
      const Camera camera{
          .target = {1, 2, 3}, .azimuth_deg = azimuth, .elevation_deg = elevation, .distance = 7.0};
      const Vector3 to_target = camera.target - camera.position();
      EXPECT_NEAR(norm(to_target), 7.0, 1e-12);
      const ViewFrame frame = view_frame(camera);
      EXPECT_LE(norm(to_target / 7.0 - frame.forward), 1e-12);
      EXPECT_NEAR(dot(frame.right, frame.forward), 0.0, 1e-12);
      EXPECT_NEAR(norm(frame.up), 1.0, 1e-12);
      EXPECT_GE(frame.up.y, -1e-12);
    }
}

TEST(Camera, FollowsTheSphericalCoordinatesOfTheThesis) {
  EXPECT_LE(norm(Camera{.azimuth_deg = 0, .elevation_deg = 0, .distance = 2}.position() -
                 Vector3{2, 0, 0}),
            1e-15);
  EXPECT_LE(norm(Camera{.azimuth_deg = 90, .elevation_deg = 0, .distance = 2}.position() -
                 Vector3{0, 0, 2}),
            1e-15);
  EXPECT_LE(norm(Camera{.elevation_deg = 90, .distance = 2}.position() - Vector3{0, 2, 0}), 1e-15);
}

TEST(Camera, ReachesEveryDirection) {
  for (const Vector3& d : {Vector3{0.6, 0.0, -0.8}, Vector3{0.48, -0.6, 0.64}, Vector3{0, -1, 0}}) {
    const double degree = 180.0 / std::acos(-1.0);
    const Camera camera{.azimuth_deg = degree * std::atan2(d.z, d.x),
                        .elevation_deg = degree * std::asin(d.y),
                        .distance = 1.0};
    EXPECT_LE(norm(camera.position() - d), 1e-12);
  }
}

TEST(Camera, ShiftMovesCameraAndTargetAlike) {
  const Camera camera{.target = {0, 1, 0}};
  const Camera moved = camera.shifted({0, 2, 0});
  EXPECT_EQ(moved.target, (Vector3{0, 3, 0}));
  EXPECT_LE(norm(moved.position() - camera.position() - Vector3{0, 2, 0}), 1e-12);
}

TEST(CameraLaw, AFittedBoxIsInThePictureFromEverySide) {
  BoundingBox box;
  box.extend({-1, 0, -2});
  box.extend({3, 9, 2});
  for (double azimuth = 0; azimuth < 360; azimuth += 30)
    for (const double elevation : {-80.0, -10.0, 0.0, 20.0, 90.0}) {
      const Camera camera = fitted({.azimuth_deg = azimuth, .elevation_deg = elevation}, box, 0.8);
      const ViewFrame frame = view_frame(camera);
      const double half = std::tan(0.5 * camera.view_angle_deg * std::acos(-1.0) / 180.0);
      double largest = 0.0;
      for (const double x : {-1.0, 3.0})
        for (const double y : {0.0, 9.0})
          for (const double z : {-2.0, 2.0}) {
            const Vector3 v = Vector3{x, y, z} - camera.position();
            const double depth = dot(v, frame.forward);
            ASSERT_GT(depth, 0.0);
            largest = std::max({largest, std::abs(dot(v, frame.up)) / (half * depth),
                                std::abs(dot(v, frame.right)) / (0.8 * half * depth)});
          }
      EXPECT_LE(largest, 1.0);
      EXPECT_GE(largest, 0.8) << "needlessly small";
    }
}

}  // namespace
}  // namespace phytobench
