// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/component_graph/shapes/component_fixture.hpp"
#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

using namespace component_fixture;

/// [Lintermann1997] sec. 5.1: relative turns from the first to the last, linear in between.
TEST(HornLaw, TheTurnsOfMJointsAddUpToMTimesTheirMean) {
  for (const int segments : {2, 3, 8, 17}) {
    for (const auto& [first, last] : {std::pair{3.0, 3.0}, {-2.0, 7.5}, {9.0, 0.0}}) {
      Tried horn("horn");
      horn.set("segments", segments).set("bend_first", first).set("bend_last", last);
      const double turn = (segments - 1) * (first + last) / 2.0 * std::numbers::pi / 180.0;
      const Frame end = horn.child();
      EXPECT_NEAR(end.y.y, std::cos(turn), 1e-12) << segments;
      EXPECT_NEAR(end.y.z, std::sin(turn), 1e-12) << segments;
      EXPECT_NEAR(end.x.x, 1.0, 1e-12);
    }
  }
}

TEST(HornLaw, EqualTurnsMakeARegularPolygon) {
  Tried horn("horn");
  horn.set("length", 3.0).set("segments", 12.0).set("bend_first", 5.0).set("bend_last", 5.0);
  const double turn = 5.0 * std::numbers::pi / 180.0;
  const double chord = 3.0 / 12.0 * std::sin(12.0 * turn / 2.0) / std::sin(turn / 2.0);
  EXPECT_NEAR(norm(horn.child().origin), chord, 1e-12);
}

TEST(HornLaw, AStraightOneIsAFrustumWithThatVolume) {
  Tried horn("horn");
  horn.set("length", 2.0).set("radius_first", 0.3).set("radius_last", 0.1).set("corners", 7.0);
  const TriangleMesh mesh = horn.mesh();
  const double polygon = 3.5 * std::sin(2.0 * std::numbers::pi / 7.0);  // of a circle of radius 1
  EXPECT_NEAR(enclosed_volume(mesh), polygon * 2.0 / 3.0 * (0.09 + 0.03 + 0.01), 1e-12);
  EXPECT_EQ(horn.child().origin, (Vector3{0.0, 2.0, 0.0}));
}

TEST(Horn, IsClosedWhereItHasCaps) {
  for (const double last : {0.02, 0.0}) {
    Tried horn("horn");
    horn.set("radius_last", last).set("bend_first", 8.0).set("bend_last", -3.0).set("corners", 5.0);
    const SurfaceEdges both(horn.mesh());
    EXPECT_TRUE(both.is_closed());
    EXPECT_EQ(both.euler_characteristic(), 2);
    EXPECT_GT(enclosed_volume(horn.mesh()), 0.0);
    EXPECT_TRUE(normals_fit(horn.mesh()));
    EXPECT_EQ(SurfaceEdges(horn.set_word("caps", "end").mesh()).open_edges(), 5u);
    EXPECT_EQ(SurfaceEdges(horn.set_word("caps", "none").mesh()).open_edges(),
              last > 0.0 ? 10u : 5u);
  }
}

TEST(Horn, HasItsRadiiAtBothEndsAndItsPowerBetween) {
  Tried horn("horn");
  horn.set("radius_first", 0.4).set("radius_last", 0.1).set("radius_power", 2.0);
  horn.set("segments", 4.0).set("corners", 6.0).set_word("caps", "none");
  const TriangleMesh mesh = horn.mesh();
  ASSERT_EQ(mesh.vertex_count(), 5u * 7u);
  for (std::size_t ring = 0; ring < 5; ++ring) {
    const double share = static_cast<double>(ring) / 4.0;
    for (std::size_t i = 7 * ring; i < 7 * ring + 7; ++i) {
      const Vector3& p = mesh.positions[i];
      EXPECT_NEAR(std::hypot(p.x, p.z), 0.4 - 0.3 * share * share, 1e-15);
      EXPECT_NEAR(p.y, share, 1e-15);
      EXPECT_NEAR(mesh.texture_points[i].v, share, 1e-15);
    }
  }
}

TEST(Horn, WithoutAnyRadiusHasNoTriangles) {
  Tried horn("horn");
  EXPECT_TRUE(horn.set("radius_first", 0.0).set("radius_last", 0.0).parts().empty());
}

TEST(HornLaw, TwiceTheLengthsAreTwiceThePlaces) {
  Tried small("horn"), large("horn");
  for (Tried* horn : {&small, &large})
    horn->set("bend_first", 11.0).set("bend_last", -4.0).set("twist", 21.0);
  small.set("length", 0.7).set("radius_first", 0.03).set("radius_last", 0.013);
  large.set("length", 1.4).set("radius_first", 0.06).set("radius_last", 0.026);
  const TriangleMesh a = small.mesh(), b = large.mesh();
  ASSERT_EQ(a.vertex_count(), b.vertex_count());
  for (std::size_t i = 0; i < a.vertex_count(); ++i) {
    EXPECT_EQ(2.0 * a.positions[i], b.positions[i]);
    EXPECT_EQ(a.normals[i], b.normals[i]);
  }
  EXPECT_EQ(2.0 * small.child().origin, large.child().origin);
}

TEST(Horn, ResolutionMovesNothingButAddsOrTakesDetail) {
  Tried horn("horn");
  horn.set("bend_first", 11.0).set("bend_last", -4.0).set("segments", 10.0).set("corners", 8.0);
  const Frame end = horn.child();
  for (const auto& [resolution, vertices] :
       {std::pair{0.5, 6u * 5u}, {1.0, 11u * 9u}, {2.0, 11u * 17u}, {0.01, 2u * 4u}}) {
    horn.context.resolution = resolution;
    horn.set_word("caps", "none");
    EXPECT_EQ(horn.child(), end);
    EXPECT_EQ(horn.mesh().vertex_count(), vertices) << resolution;
  }
}

TEST(Horn, RefusesAMeshThatWouldFillTheMemory) {
  Tried horn("horn");
  horn.set("segments", 10000.0).set("corners", 1000.0);
  try {
    horn.mesh();
    FAIL() << "ten million vertices";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "a stem would have 10001 x 1001 vertices, and one component may have a million; "
                 "lower its corners or pieces, or the resolution");
  }
}

TEST(Horn, ATwistedBendLeavesThePlane) {
  Tried horn("horn");
  horn.set("bend_first", 10.0).set("bend_last", 10.0);
  EXPECT_EQ(horn.child().origin.x, 0.0);
  EXPECT_GT(std::abs(horn.set("twist", 30.0).child().origin.x), 0.01);
}

}  // namespace
}  // namespace phytobench
