// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/component_graph/shapes/component_fixture.hpp"
#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

using namespace component_fixture;

Tried sized(std::string_view shape) {
  Tried simple("simple");
  simple.set_word("shape", shape).set("size_x", 2.0).set("size_y", 3.0).set("size_z", 0.5);
  return simple;
}

TEST(SimpleLaw, BodiesAreClosedAndLookOutwards) {
  for (const char* shape : {"sphere", "cylinder", "box"}) {
    for (const double corners : {3.0, 4.0, 7.0, 24.0}) {
      Tried simple = sized(shape);
      const TriangleMesh mesh = simple.set("corners", corners).mesh();
      const SurfaceEdges edges(mesh);
      EXPECT_TRUE(edges.is_closed()) << shape << ' ' << corners;
      EXPECT_EQ(edges.euler_characteristic(), 2) << shape << ' ' << corners;
      EXPECT_GT(enclosed_volume(mesh), 0.0);
      for (const Vector3& normal : mesh.normals) EXPECT_NEAR(norm(normal), 1.0, 1e-12);
    }
    EXPECT_TRUE(normals_fit(sized(shape).mesh())) << shape;
  }
}

TEST(SimpleLaw, TheyHaveTheVolumesOfTheirFormulas) {
  EXPECT_NEAR(enclosed_volume(sized("box").mesh()), 3.0, 1e-12);
  Tried cylinder = sized("cylinder");
  const double polygon = 6.0 * std::sin(2.0 * std::numbers::pi / 12.0);
  EXPECT_NEAR(enclosed_volume(cylinder.set("corners", 12.0).mesh()), polygon * 1.0 * 0.25 * 3.0,
              1e-12);
  // A mesh within the ellipsoid comes nearer with every corner.
  Tried sphere = sized("sphere");
  const double full = 4.0 / 3.0 * std::numbers::pi * 1.0 * 1.5 * 0.25;
  double missing = full;
  for (const double corners : {8.0, 16.0, 32.0, 64.0}) {
    const double now = full - enclosed_volume(sphere.set("corners", corners).mesh());
    EXPECT_GT(now, 0.0);
    EXPECT_LT(now, 0.3 * missing);
    missing = now;
  }
}

TEST(Simple, StandsOnItsOriginOrAboutIt) {
  for (const char* shape : {"sphere", "cylinder", "box"}) {
    for (const char* stands : {"on", "about"}) {
      Tried simple = sized(shape);
      double lowest = 10.0, highest = -10.0;
      for (const Vector3& place : simple.set_word("stands", stands).mesh().positions) {
        lowest = std::min(lowest, place.y);
        highest = std::max(highest, place.y);
      }
      EXPECT_NEAR(lowest, stands == std::string_view("on") ? 0.0 : -1.5, 1e-12);
      EXPECT_NEAR(highest - lowest, 3.0, 1e-12);
    }
  }
}

TEST(Simple, RefusesAMeshThatWouldFillTheMemory) {
  Tried sphere = sized("sphere");
  sphere.context.resolution = 100.0;
  EXPECT_THROW(sphere.mesh(), InputError);
}

TEST(Simple, MayBeNothing) {
  EXPECT_TRUE(sized("none").parts().empty());
  EXPECT_EQ(sized("none").child(), Frame{});
}

TEST(Simple, TransformsWhatFollowsButNotItself) {
  Tried simple("simple");
  const TriangleMesh before = simple.mesh();
  simple.set("move_x", 1.0).set("move_y", 2.0).set("move_z", 3.0).set("scale", 0.5);
  simple.set("turn_x", 90.0).set("turn_y", 90.0);
  const Frame child = simple.child();
  EXPECT_EQ(simple.mesh().positions, before.positions);
  EXPECT_EQ(child.origin, (Vector3{1.0, 2.0, 3.0}));
  EXPECT_EQ(child.scale, 0.5);
  // About x first: y to z; then about y: z to x.
  EXPECT_LT(norm(child.y - Vector3{1.0, 0.0, 0.0}), 1e-12);
  EXPECT_LT(norm(child.x - Vector3{0.0, 0.0, -1.0}), 1e-12);
}

TEST(SimpleLaw, OppositeTurnsAboutOneAxisCancel) {
  for (const char* axis : {"turn_x", "turn_y", "turn_z"}) {
    Tried one("simple"), back("simple");
    const Frame both = one.set(axis, 37.0).child() * back.set(axis, -37.0).child();
    EXPECT_LT(norm(both.x - Vector3{1.0, 0.0, 0.0}), 1e-12);
    EXPECT_LT(norm(both.y - Vector3{0.0, 1.0, 0.0}), 1e-12);
  }
}

/// The checkers of these tests see a hole, a turned face, and normals that look inwards.
TEST(ComponentFixture, ItsMeasuresCanFail) {
  TriangleMesh hole = sized("box").mesh();
  hole.triangles.pop_back();
  EXPECT_FALSE(SurfaceEdges(hole).is_closed());
  EXPECT_EQ(SurfaceEdges(hole).open_edges(), 3u);
  TriangleMesh turned = sized("sphere").mesh();
  std::swap(turned.triangles[0][0], turned.triangles[0][1]);
  EXPECT_FALSE(SurfaceEdges(turned).is_closed());
  EXPECT_FALSE(normals_fit(turned));
}

}  // namespace
}  // namespace phytobench
