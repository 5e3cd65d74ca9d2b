// SPDX-License-Identifier: MIT
#include "core/lsystem/outline_triangles.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/geometry/rotation.hpp"
#include "core/lsystem/drawing_measures.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

double area_of(const OutlineTriangles& filled) {
  double sum = 0.0;
  for (const auto& [a, b, c] : filled.triangles) {
    const Vector3 twice =
        cross(filled.corners[b] - filled.corners[a], filled.corners[c] - filled.corners[a]);
    EXPECT_GE(dot(twice, filled.normal), 0.0);  // all the same way round
    sum += 0.5 * norm(twice);
  }
  return sum;
}

/// A star-shaped outline about the origin, concave nearly everywhere.
std::vector<Vector3> star(std::size_t corners, std::uint64_t seed) {
  std::vector<Vector3> outline;
  CounterStream stream(seed, 0);
  for (std::size_t i = 0; i < corners; ++i) {
    const double angle =
        2.0 * std::acos(-1.0) * static_cast<double>(i) / static_cast<double>(corners);
    const double radius = 0.1 + stream.next_unit();
    outline.push_back({radius * std::cos(angle), radius * std::sin(angle), 0.0});
  }
  return outline;
}

TEST(OutlineTrianglesLaw, FillConcaveOutlinesInAnyPlane) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const auto turned = Rotation::uniform(0.1 + 0.01 * static_cast<double>(seed), 0.3, 0.7);
    std::vector<Vector3> outline = star(5 + seed, seed);
    for (Vector3& corner : outline) corner = turned(corner) + Vector3{3, -2, 5};
    const OutlineTriangles filled = outline_triangles(outline);
    EXPECT_EQ(filled.triangles.size(), outline.size() - 2);
    EXPECT_NEAR(area_of(filled), norm(vector_area(outline)), 1e-12);
  }
}

TEST(OutlineTrianglesLaw, CornersInTheMidstOfEdgesChangeNothing) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const auto turned = Rotation::uniform(0.1 + 0.01 * static_cast<double>(seed), 0.3, 0.7);
    const std::vector<Vector3> corners = star(5 + seed, seed);
    std::vector<Vector3> outline;
    for (std::size_t i = 0; i < corners.size(); ++i)
      for (const double share : {0.0, 0.3, 0.5, 0.9})
        outline.push_back(
            turned(corners[i] + share * (corners[(i + 1) % corners.size()] - corners[i])));
    EXPECT_NEAR(area_of(outline_triangles(outline)), norm(vector_area(corners)), 1e-9);
  }
}

TEST(OutlineTrianglesLaw, AFanWouldFailOnAConcaveOutline) {
  // An arrow head: a fan from its first corner covers the notch.
  const std::vector<Vector3> arrow{{2, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, -1, 0}};
  double fan = 0.0;
  const std::vector<Vector3> from_tail{{0, 1, 0}, {1, 0, 0}, {0, -1, 0}, {2, 0, 0}};
  for (std::size_t i = 1; i + 1 < from_tail.size(); ++i)
    fan += norm(vector_area(std::vector<Vector3>{from_tail[0], from_tail[i], from_tail[i + 1]}));
  const double area = norm(vector_area(arrow));
  EXPECT_GT(fan, area);
  EXPECT_NEAR(area_of(outline_triangles(from_tail)), area, 1e-15);
  EXPECT_NEAR(area_of(outline_triangles(arrow)), area, 1e-15);
}

TEST(OutlineTriangles, LeaveOutRepeatedCorners) {
  const std::vector<Vector3> square{{0, 0, 0}, {1, 0, 0},     {1, 0, 0}, {1, 1, 0},
                                    {0, 1, 0}, {0, 1e-15, 0}, {0, 0, 0}};
  const OutlineTriangles filled = outline_triangles(square);
  EXPECT_EQ(filled.corners.size(), 4u);
  EXPECT_EQ(filled.triangles.size(), 2u);
  EXPECT_EQ(filled.normal, (Vector3{0, 0, 1}));
}

TEST(OutlineTriangles, TakeStraightEdgesAndSpikes) {
  const std::vector<Vector3> outline{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0},
                                     {2, 3, 0}, {2, 2, 0}, {0, 2, 0}, {0, 1, 0}};
  EXPECT_NEAR(area_of(outline_triangles(outline)), 4.0, 1e-15);
  // A stalk, on which the outline begins and ends.
  const std::vector<Vector3> stalked{{0, -5, 0}, {0, -1, 0}, {0, 0, 0}, {1, 1, 0},
                                     {0, 2, 0},  {-1, 1, 0}, {0, 0, 0}, {0, -1, 0}};
  EXPECT_NEAR(area_of(outline_triangles(stalked)), 2.0, 1e-15);
  EXPECT_EQ(outline_triangles(stalked).corners.size(), 4u);
}

TEST(OutlineTriangles, OfNoAreaAreNone) {
  EXPECT_TRUE(outline_triangles({}).triangles.empty());
  EXPECT_TRUE(outline_triangles(std::vector<Vector3>{{0, 0, 0}, {1, 0, 0}}).triangles.empty());
  EXPECT_TRUE(
      outline_triangles(std::vector<Vector3>{{0, 0, 0}, {1, 0, 0}, {3, 0, 0}}).triangles.empty());
  EXPECT_TRUE(outline_triangles(std::vector<Vector3>(5, Vector3{1, 1, 1})).triangles.empty());
}

TEST(OutlineTriangles, EndForOutlinesThatCrossThemselves) {
  std::vector<Vector3> tangle;
  CounterStream stream(1, 0);
  for (int i = 0; i < 60; ++i) {
    const double x = stream.next_unit(), y = stream.next_unit();
    tangle.push_back({x, y, 0.0});
  }
  EXPECT_LE(outline_triangles(tangle).triangles.size(), 58u);
}

TEST(OutlineTriangles, ExpectNoMoreCornersThanTheyTake) {
  EXPECT_THROW(outline_triangles(std::vector<Vector3>(most_outline_corners + 1)),
               ContractViolation);
}

}  // namespace
}  // namespace phytobench
