// SPDX-License-Identifier: MIT
#include "core/component_graph/placed_part.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace phytobench {
namespace {

/// Bends a stem along y into a circle of the given radius, about the axis x = radius, y = 0.
class Bow final : public Deformation {
 public:
  explicit Bow(double radius, bool bends_leaves = true)
      : radius_(radius), bends_leaves_(bends_leaves) {}
  Vector3 moved(const Vector3& p) const override {
    const double angle = p.y / radius_, r = radius_ - p.x;
    return {radius_ - r * std::cos(angle), r * std::sin(angle), p.z};
  }
  bool bends(Surface surface) const override { return bends_leaves_ || surface != Surface::leaf; }

 private:
  double radius_;
  bool bends_leaves_;
};

class Flatten final : public Deformation {
 public:
  Vector3 moved(const Vector3& p) const override { return {p.x, 7.0, p.z}; }
  bool bends(Surface surface) const override { return surface != Surface::leaf; }
};

MeshPart square(Surface surface) {
  MeshPart part;
  part.material.surface = surface;
  part.mesh.positions = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {1.0, 1.0, 0.0}, {0.0, 1.0, 0.0}};
  part.mesh.normals.assign(4, {0.0, 0.0, 1.0});
  part.mesh.texture_points.assign(4, {});
  part.mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return part;
}

using Deformations = std::vector<std::shared_ptr<const Deformation>>;

TEST(PlacedPart, GoesWhereTheFrameIs) {
  Frame frame = Frame{}.turned(Rotation::uniform(0.1, 0.5, 0.9));
  frame.origin = {3.0, 4.0, 5.0};
  frame.scale = 2.0;
  MeshPart part = square(Surface::bark);
  ASSERT_TRUE(place_part(part, frame, {}));
  EXPECT_LT(norm(part.mesh.positions[2] - frame.place({1.0, 1.0, 0.0})), 1e-15);
  EXPECT_LT(norm(part.mesh.normals[2] - frame.z), 1e-15);
}

TEST(PlacedPartLaw, NormalsStayAtRightAnglesToTheBentSurface) {
  const Bow bow(2.0);
  for (const double tilt : {0.0, 0.4, 1.1}) {
    const Frame frame = Frame{}.turned(Rotation::about({0.0, 1.0, 0.0}, tilt));
    MeshPart part = square(Surface::bark);
    const Deformations bows{std::make_shared<Bow>(2.0)};
    ASSERT_TRUE(place_part(part, frame, bows));
    // Two ways along the surface from its second corner, bent.
    constexpr double step = 1e-5;
    const Vector3 at = bow.moved(frame.place({1.0, 0.0, 0.0}));
    const Vector3 along_x = bow.moved(frame.place({1.0 + step, 0.0, 0.0})) - at;
    const Vector3 along_y = bow.moved(frame.place({1.0, step, 0.0})) - at;
    const Vector3 across = cross(along_x, along_y);
    EXPECT_LT(norm(part.mesh.normals[1] - across / norm(across)), 1e-4) << tilt;
    EXPECT_NEAR(norm(part.mesh.normals[1]), 1.0, 1e-12);
  }
}

TEST(PlacedPartLaw, WhatIsNotBentKeepsItsShapeAndGoesWithItsOrigin) {
  const auto bow = std::make_shared<Bow>(2.0, false);
  Frame frame;
  frame.origin = {0.0, 1.0, 0.0};
  MeshPart leaf = square(Surface::leaf), bark = square(Surface::bark);
  ASSERT_TRUE(place_part(leaf, frame, Deformations{bow}));
  ASSERT_TRUE(place_part(bark, frame, Deformations{bow}));
  EXPECT_LT(norm(leaf.mesh.positions[0] - bow->moved(frame.origin)), 1e-12);
  EXPECT_EQ(bark.mesh.positions[0], bow->moved(frame.origin));
  EXPECT_NEAR(norm(leaf.mesh.positions[2] - leaf.mesh.positions[0]), std::sqrt(2.0), 1e-12);
  EXPECT_GT(std::abs(norm(bark.mesh.positions[2] - bark.mesh.positions[0]) - std::sqrt(2.0)), 0.05);
  // The stem is turned by 1/2 there: clockwise, towards +x.
  const Vector3 along = leaf.mesh.positions[3] - leaf.mesh.positions[0];
  EXPECT_LT(norm(along - Vector3{std::sin(0.5), std::cos(0.5), 0.0}), 1e-9);
}

TEST(PlacedPart, TheLastDeformationIsAppliedFirst) {
  const Deformations both{std::make_shared<Bow>(2.0), std::make_shared<Flatten>()};
  MeshPart part = square(Surface::bark);
  ASSERT_TRUE(place_part(part, Frame{}, both));
  EXPECT_EQ(part.mesh.positions[2], Bow(2.0).moved({1.0, 7.0, 0.0}));
}

TEST(PlacedPart, WhereAnAxisIsFlattenedOnlyThePlaceMoves) {
  MeshPart leaf = square(Surface::leaf);
  ASSERT_TRUE(place_part(leaf, Frame{}, Deformations{std::make_shared<Flatten>()}));
  EXPECT_EQ(leaf.mesh.positions[2], (Vector3{1.0, 8.0, 0.0}));
}

TEST(PlacedPart, SaysWhatIsOutOfReach) {
  Frame frame;
  frame.scale = 2e15;
  MeshPart part = square(Surface::bark);
  EXPECT_FALSE(place_part(part, frame, {}));
  frame.scale = std::nan("");
  EXPECT_FALSE(place_part(part, frame, {}));
}

}  // namespace
}  // namespace phytobench
