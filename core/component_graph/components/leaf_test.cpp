// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/component_graph/shapes/component_fixture.hpp"
#include "core/component_graph/shapes/half_width_spline.hpp"
#include "core/component_graph/shapes/outward_frame.hpp"
#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

using namespace component_fixture;

Tried flat_leaf() {
  Tried leaf("leaf");
  leaf.set("fold", 0.0).set("bend", 0.0);
  return leaf;
}

TEST(HalfWidthSpline, GoesThroughItsPointsAndStraightBetweenStraightOnes) {
  const std::vector<double> bent{0.0, 0.7, 1.0, 0.4, 0.0}, straight{0.2, 0.4, 0.6, 0.8};
  for (std::size_t i = 0; i < bent.size(); ++i)
    EXPECT_EQ(half_width_at(bent, static_cast<double>(i) / 4.0), bent[i]);
  for (double share = 0.0; share <= 1.0; share += 0.01)
    EXPECT_NEAR(half_width_at(straight, share), 0.2 + 0.6 * share, 1e-15);
}

TEST(HalfWidthSpline, IsNeverNegativeAndHasNoCorners) {
  const std::vector<double> widths{0.0, 1.0, 0.0, 0.0, 1.0, 0.0};
  constexpr double step = 1e-6;
  for (double share = step; share + step < 1.0; share += 0.003)
    EXPECT_GE(half_width_at(widths, share), 0.0);
  for (const double knot : {0.2, 0.8}) {
    const double below = half_width_at(widths, knot) - half_width_at(widths, knot - step);
    const double above = half_width_at(widths, knot + step) - half_width_at(widths, knot);
    EXPECT_NEAR(below / step, above / step, 1e-3);
  }
}

TEST(LeafLaw, AFlatOneHasTheAreaOfItsOutlineOnBothSides) {
  Tried leaf = flat_leaf();
  leaf.set("length", 3.0).set("width", 0.8).set_list("outline", {1.0, 1.0});
  EXPECT_NEAR(surface_area(leaf.mesh()), 2.0 * 3.0 * 0.8, 1e-12);
  leaf.set_list("outline", {1.0, 0.0});
  EXPECT_NEAR(surface_area(leaf.mesh()), 3.0 * 0.8, 1e-12);
  // Folding only turns the halves.
  EXPECT_NEAR(surface_area(leaf.set("fold", 35.0).mesh()), 3.0 * 0.8, 1e-12);
}

TEST(Leaf, TheUpperSideLooksToTheAxisAndTheLowerSideBack) {
  const TriangleMesh mesh = flat_leaf().mesh();
  const std::size_t half = mesh.vertex_count() / 2;
  for (std::size_t i = 0; i < half; ++i) {
    EXPECT_EQ(mesh.normals[i], (Vector3{0.0, 0.0, -1.0}));
    EXPECT_EQ(mesh.positions[i + half], mesh.positions[i]);
    EXPECT_EQ(mesh.normals[i + half], -1.0 * mesh.normals[i]);
  }
  Tried formed("leaf");
  formed.set("wave_height", 0.2).set("fold", 30.0).set("bend", 80.0);
  EXPECT_EQ(SurfaceEdges(formed.mesh()).open_edges(), 0u);
}

TEST(LeafLaw, TheMiddleIsAnArcOfTheLeafsLength) {
  for (const double bend : {-120.0, 0.0, 45.0, 360.0, 800.0}) {
    Tried leaf("leaf");
    const Frame tip = leaf.set("length", 2.0).set("bend", bend).child();
    EXPECT_NEAR(tip.y.y, std::cos(radians(bend)), 1e-12);
    EXPECT_NEAR(tip.y.z, std::sin(radians(bend)), 1e-12);
    const double turn = std::abs(radians(bend));
    const double chord = turn == 0.0 ? 2.0 : 2.0 * (2.0 / turn) * std::abs(std::sin(0.5 * turn));
    EXPECT_NEAR(norm(tip.origin), chord, 1e-12);
  }
}

TEST(Leaf, FoldsBothHalvesToTheUpperSide) {
  Tried leaf = flat_leaf();
  leaf.set("fold", 30.0).set("width", 2.0).set_list("outline", {1.0, 1.0});
  for (const Vector3& place : leaf.mesh().positions) {
    EXPECT_NEAR(place.z, -std::abs(place.x) * std::tan(radians(30.0)), 1e-12);
    EXPECT_LE(std::abs(place.x), std::cos(radians(30.0)) + 1e-12);
  }
}

TEST(Leaf, WavesAtItsEdgeAndNotInItsMiddle) {
  Tried leaf = flat_leaf();
  leaf.set("wave_height", 0.25).set("waves", 2.0).set("pieces_along", 16.0);
  leaf.set("width", 0.4).set_list("outline", {1.0, 1.0});
  double highest = 0.0;
  for (const Vector3& place : leaf.mesh().positions) {
    if (std::abs(place.x) < 1e-12) {
      EXPECT_EQ(place.z, 0.0);
    }
    highest = std::max(highest, std::abs(place.z));
  }
  EXPECT_NEAR(highest, 0.25 * 0.4, 1e-12);
}

TEST(Leaf, AStalkCarriesTheBlade) {
  Tried leaf = flat_leaf();
  leaf.set("petiole_length", 0.5).set("petiole_radius", 0.02);
  EXPECT_LT(norm(leaf.child().origin - Vector3{0.0, 1.5, 0.0}), 1e-12);
  double lowest = 1.0;
  for (const Vector3& place : leaf.mesh().positions) lowest = std::min(lowest, place.y);
  EXPECT_EQ(lowest, 0.0);
}

/// [Lintermann1997] sec. 4: leaves follow the fields as trees do.
TEST(LeafLaw, TropismsTurnItAsAWhole) {
  Tried leaf = flat_leaf();
  leaf.frame = outward_frame({}, 50.0, 60.0);
  for (const double weight : {30.0, 90.0, 2000.0}) {
    leaf.set("gravitropism", weight);
    const double half = std::atan(std::tan(radians(60.0)) * std::exp(-radians(weight)));
    EXPECT_NEAR(angle_deg(leaf.frame.direction(leaf.child().y), {0, -1, 0}), 2.0 * degrees(half),
                1e-9);
    EXPECT_NEAR(norm(leaf.child().origin), 1.0, 1e-12);
  }
}

TEST(LeafLaw, TwiceTheLengthsAreTwiceThePlaces) {
  Tried small("leaf"), large("leaf");
  for (Tried* leaf : {&small, &large}) leaf->set("wave_height", 0.1).set("bend", 70.0);
  small.set("length", 0.7).set("width", 0.3).set("petiole_length", 0.1);
  large.set("length", 1.4).set("width", 0.6).set("petiole_length", 0.2);
  large.set("petiole_radius", 0.02);
  const TriangleMesh a = small.mesh(), b = large.mesh();
  ASSERT_EQ(a.vertex_count(), b.vertex_count());
  for (std::size_t i = 0; i < a.vertex_count(); ++i)
    EXPECT_EQ(2.0 * a.positions[i], b.positions[i]);
}

TEST(Leaf, RefusesAMeshThatWouldFillTheMemory) {
  Tried leaf("leaf");
  EXPECT_THROW(leaf.set("pieces_along", 9000.0).set("pieces_per_half", 900.0).mesh(), InputError);
}

TEST(Leaf, ResolutionChangesTheNumberOfTriangles) {
  Tried leaf("leaf");
  const std::size_t usual = leaf.mesh().triangle_count();
  leaf.context.resolution = 2.0;
  EXPECT_GT(leaf.mesh().triangle_count(), 3 * usual);
  leaf.context.resolution = 0.01;
  EXPECT_EQ(leaf.mesh().triangle_count(), 8u);  // two at each end of both sides
}

}  // namespace
}  // namespace phytobench
