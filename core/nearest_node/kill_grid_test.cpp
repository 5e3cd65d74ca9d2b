// SPDX-License-Identifier: MIT
#include "core/nearest_node/kill_grid.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Killers, points that look for one, and the distances that are tried on them.
struct Case {
  const char* name;
  std::vector<Vector3> killers;
  std::vector<Vector3> points;
  std::vector<double> distances;
};

Vector3 random_point(UnitStream& stream, double scale) {
  const double x = stream.next_between(-1.0, 1.0);
  const double y = stream.next_between(-1.0, 1.0);
  const double z = stream.next_between(-1.0, 1.0);
  return scale * Vector3{x, y, z};
}

std::vector<Vector3> random_cube(std::size_t count, double scale, std::uint64_t stream_number) {
  CounterStream stream(21, stream_number);
  std::vector<Vector3> points;
  for (std::size_t i = 0; i < count; ++i) points.push_back(random_point(stream, scale));
  return points;
}

/// (2 half_width + 1)^3 points whose coordinates are multiples of the spacing.
std::vector<Vector3> lattice(int half_width, double spacing) {
  std::vector<Vector3> points;
  for (int x = -half_width; x <= half_width; ++x)
    for (int y = -half_width; y <= half_width; ++y)
      for (int z = -half_width; z <= half_width; ++z)
        points.push_back({x * spacing, y * spacing, z * spacing});
  return points;
}

std::vector<Vector3> moved(std::vector<Vector3> points, const Vector3& by) {
  for (Vector3& point : points) point = point + by;
  return points;
}

std::vector<Vector3> squeezed(std::vector<Vector3> points, const Vector3& factors) {
  for (Vector3& point : points) point = hadamard_product(factors, point);
  return points;
}

std::vector<Vector3> joined(std::vector<Vector3> first, const std::vector<Vector3>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

std::vector<Vector3> repeated(const std::vector<Vector3>& points) {
  return joined(points, points);
}

/// Points at the given distance of each killer, as exactly as numbers allow, and one step nearer
/// and farther.
std::vector<Vector3> at_distance(const std::vector<Vector3>& killers, double distance) {
  std::vector<Vector3> points;
  for (const Vector3& killer : killers)
    for (const double side : {-1.0, 1.0}) {
      const double x = killer.x + side * distance;
      points.push_back({x, killer.y, killer.z});
      points.push_back({std::nextafter(x, infinity), killer.y, killer.z});
      points.push_back({std::nextafter(x, -infinity), killer.y, killer.z});
      points.push_back({killer.x, killer.y + side * distance, killer.z});
      points.push_back({killer.x, killer.y, killer.z + side * distance});
    }
  return points;
}

std::vector<Case> cases() {
  std::vector<Case> all;
  const auto cube = random_cube(300, 1.0, 0);
  const auto points = random_cube(2000, 1.5, 1);
  all.push_back({"random", cube, points, {0.0, 1e-9, 0.01, 0.1, 0.3, 1.0, 3.0, 10.0, infinity}});
  all.push_back({"few_random", random_cube(5, 1.0, 2), points, {0.1, 0.5, 2.0}});
  all.push_back({"killers_are_points", cube, joined(cube, points), {0.0, 1e-300, 1e-9, 0.2}});
  // Squares of multiples of 0.25 are exact: many points lie exactly at the distance.
  all.push_back({"lattice", lattice(3, 0.5), lattice(8, 0.25), {0.0, 0.25, 0.5, 0.75, 1.5, 4.0}});
  all.push_back({"lattice_elsewhere",
                 moved(lattice(3, 0.5), {100.25, -7.5, 3.0}),
                 moved(lattice(8, 0.25), {100.25, -7.5, 3.0}),
                 {0.25, 0.5, 1.0}});
  all.push_back({"odd_lattice", lattice(3, 0.3), lattice(9, 0.1), {0.1, 0.2, 0.3, 0.6}});
  all.push_back({"at_the_distance", cube, at_distance(cube, 0.11), {0.11}});
  all.push_back({"at_a_wide_distance", cube, at_distance(cube, 1.7), {1.7}});
  all.push_back({"duplicates", repeated(repeated(cube)), repeated(points), {0.0, 0.1, 0.5}});
  all.push_back({"one_place", std::vector<Vector3>(200, {0.25, 0.5, -1.0}), points, {0.0, 0.1, 1}});
  all.push_back({"plane", squeezed(cube, {1, 0, 1}), points, {0.05, 0.3, 2.0}});
  all.push_back(
      {"plane_in_plane", squeezed(cube, {1, 1, 0}), squeezed(points, {1, 1, 0}), {0.05, 0.3, 2.0}});
  all.push_back({"line", squeezed(cube, {0, 1, 0}), points, {0.05, 0.3, 2.0}});
  all.push_back(
      {"line_on_line", squeezed(cube, {0, 0, 1}), squeezed(points, {0, 0, 1}), {0.0, 0.001, 0.1}});
  all.push_back({"one_killer", {{0.25, -0.5, 0.125}}, points, {0.0, 0.1, 1.0, 100.0, infinity}});
  all.push_back({"one_far_killer", {{1e6, 0.0, 0.0}}, points, {1.0, 999999.0, 1e6, 2e6}});
  all.push_back({"two_far_apart", {{-1e9, 0.0, 0.0}, {1e9, 0.0, 0.0}}, points, {0.5, 1e9, 2e9}});
  all.push_back({"one_apart", {{0, 0, 0}, {0.1, 0.1, 0.1}, {1e12, 0, 0}}, points, {0.3, 1.0}});
  all.push_back(
      {"huge", random_cube(300, 1e12, 3), random_cube(2000, 1e12, 4), {1.0, 1e11, 3e11, 4e12}});
  all.push_back({"tiny",
                 random_cube(300, 1e-12, 5),
                 random_cube(2000, 1e-12, 6),
                 {1e-14, 1e-13, 3e-13, 1.0}});
  // Neighbouring numbers are 2 apart here.
  all.push_back({"small_and_far",
                 moved(lattice(3, 2.0), {1e16, -1e16, 1e16}),
                 moved(lattice(6, 2.0), {1e16, -1e16, 1e16}),
                 {2.0, 4.0, 18.0}});
  return all;
}

/// Sorts the killers into `grid`; which way they look must not matter.
void build(KillGrid& grid, const std::vector<Vector3>& killers, double distance) {
  std::vector<SearchableNode> nodes;
  for (const Vector3& killer : killers) nodes.push_back({killer, {0, 1, 0}});
  grid.build(nodes, distance);
}

/// The contract of NearestNodeEngine::kill(), word by word.
bool is_reached(const Vector3& point, const std::vector<Vector3>& killers, double distance) {
  for (const Vector3& killer : killers)
    if (squared_distance(point, killer) <= distance * distance) return true;
  return false;
}

TEST(KillGrid, ReachesWhatAPlainLoopOverAllKillersReaches) {
  for (const Case& tried : cases())
    for (const double distance : tried.distances) {
      KillGrid grid;
      build(grid, tried.killers, distance);
      std::uint64_t evaluations = 0;
      for (std::size_t i = 0; i < tried.points.size(); ++i)
        ASSERT_EQ(grid.reaches(tried.points[i], evaluations),
                  is_reached(tried.points[i], tried.killers, distance))
            << tried.name << ", point " << i << ", kill distance " << distance;
    }
}

// Otherwise the test above could pass by saying no.
TEST(KillGrid, CasesHavePointsWithinReachAndBeyond) {
  for (const Case& tried : cases()) {
    std::size_t reached = 0;
    for (const double distance : tried.distances)
      for (const Vector3& point : tried.points)
        reached += is_reached(point, tried.killers, distance);
    EXPECT_GT(reached, 0u) << tried.name;
    EXPECT_LT(reached, tried.points.size() * tried.distances.size()) << tried.name;
  }
}

TEST(KillGrid, ReachesAPointExactlyAtTheDistanceOnEverySide) {
  KillGrid grid;
  build(grid, {{1, 2, 3}}, 0.5);
  std::uint64_t evaluations = 0;
  for (const Vector3& side : {Vector3{0.5, 0, 0}, Vector3{0, 0.5, 0}, Vector3{0, 0, 0.5}}) {
    EXPECT_TRUE(grid.reaches(Vector3{1, 2, 3} + side, evaluations));
    EXPECT_TRUE(grid.reaches(Vector3{1, 2, 3} - side, evaluations));
    EXPECT_FALSE(grid.reaches(Vector3{1, 2, 3} + (1 + 1e-9) * side, evaluations));
    EXPECT_FALSE(grid.reaches(Vector3{1, 2, 3} - (1 + 1e-9) * side, evaluations));
  }
}

// A killer just below a cell's border and a point one kill distance on, just above the border after
// next: there rounding decides, and cells exactly one kill distance wide lose pairs.
TEST(KillGrid, LosesNothingToRoundingAtCellBorders) {
  for (int hundredths = 1; hundredths <= 200; hundredths += 3)
    for (int cell = 1; cell <= 8; ++cell) {
      const double distance = hundredths / 100.0;
      double along = cell * distance;
      for (int i = 0; i < 4; ++i) along = std::nextafter(along, 0.0);
      for (int i = 0; i < 6; ++i, along = std::nextafter(along, infinity))
        for (const Vector3& axis : {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}}) {
          const std::vector<Vector3> killers{{0, 0, 0}, along * axis};
          KillGrid grid;
          build(grid, killers, distance);
          std::uint64_t evaluations = 0;
          double beyond = along + distance;
          for (int j = 0; j < 3; ++j, beyond = std::nextafter(beyond, 0.0))
            ASSERT_EQ(grid.reaches(beyond * axis, evaluations),
                      is_reached(beyond * axis, killers, distance))
                << "kill distance " << distance << ", killer " << along << ", point " << beyond;
        }
    }
}

TEST(KillGrid, OfNoKillerReachesNothing) {
  KillGrid grid;
  std::uint64_t evaluations = 0;
  EXPECT_FALSE(grid.reaches({0, 0, 0}, evaluations)) << "never built";
  for (const double distance : {0.0, 1.0, infinity}) {
    build(grid, {}, distance);
    for (const Vector3& point : random_cube(50, 1.0, 7))
      EXPECT_FALSE(grid.reaches(point, evaluations)) << "kill distance " << distance;
  }
  EXPECT_EQ(evaluations, 0u);
}

TEST(KillGrid, BuiltAgainForgetsWhatWasBefore) {
  KillGrid grid;
  std::uint64_t evaluations = 0;
  build(grid, random_cube(500, 5.0, 8), 0.5);
  build(grid, {{1, 0, 0}}, 0.25);
  EXPECT_TRUE(grid.reaches({1.25, 0, 0}, evaluations));
  for (const Vector3& point : random_cube(500, 5.0, 8))
    EXPECT_EQ(grid.reaches(point, evaluations), is_reached(point, {{1, 0, 0}}, 0.25));
  build(grid, {}, 0.25);
  EXPECT_FALSE(grid.reaches({1, 0, 0}, evaluations));
  // And back to a larger one.
  const auto killers = random_cube(700, 2.0, 9);
  build(grid, killers, 0.2);
  for (const Vector3& point : random_cube(500, 2.0, 10))
    ASSERT_EQ(grid.reaches(point, evaluations), is_reached(point, killers, 0.2));
}

TEST(KillGridLaw, OrderOfKillersDoesNotMatter) {
  const auto killers = random_cube(200, 1.0, 11);
  CounterStream stream(22, 0);
  std::vector<Vector3> shuffled;
  for (const std::size_t i : random_order(killers.size(), stream)) shuffled.push_back(killers[i]);
  KillGrid grid, other;
  build(grid, killers, 0.15);
  build(other, shuffled, 0.15);
  std::uint64_t evaluations = 0;
  for (const Vector3& point : random_cube(1000, 1.2, 12))
    EXPECT_EQ(grid.reaches(point, evaluations), other.reaches(point, evaluations));
}

TEST(KillGridLaw, LargerDistanceReachesAllThatASmallerDoes) {
  const auto killers = random_cube(100, 1.0, 13);
  const auto points = random_cube(500, 1.5, 14);
  std::vector<bool> before(points.size(), false);
  for (double distance = 0.01; distance < 4.0; distance *= 1.5) {
    KillGrid grid;
    build(grid, killers, distance);
    std::uint64_t evaluations = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const bool reached = grid.reaches(points[i], evaluations);
      EXPECT_TRUE(reached || !before[i]) << "kill distance " << distance << ", point " << i;
      before[i] = reached;
    }
  }
}

TEST(KillGridWork, NeverExceedsOneDistancePerPair) {
  for (const Case& tried : cases())
    for (const double distance : tried.distances) {
      KillGrid grid;
      build(grid, tried.killers, distance);
      for (const Vector3& point : tried.points) {
        std::uint64_t evaluations = 0;
        grid.reaches(point, evaluations);
        ASSERT_LE(evaluations, tried.killers.size()) << tried.name << ", " << distance;
      }
    }
}

TEST(KillGridWork, IsAddedToWhatWasCountedBefore) {
  KillGrid grid;
  build(grid, {{0, 0, 0}}, 1.0);
  std::uint64_t evaluations = 41;
  EXPECT_TRUE(grid.reaches({0.5, 0, 0}, evaluations));
  EXPECT_EQ(evaluations, 42u);
  EXPECT_FALSE(grid.reaches({0.9, 0.9, 0}, evaluations)) << "in the box, but too far";
  EXPECT_EQ(evaluations, 43u);
  EXPECT_FALSE(grid.reaches({9, 0, 0}, evaluations));
  EXPECT_EQ(evaluations, 43u) << "outside the box there is nothing to compare with";
}

// Of 3000 killers, 27 cells of one kill distance hold about 10: a grid that looks elsewhere looks
// at hundreds. Every axis in turn is the long one, and the killers are nowhere near the origin.
TEST(KillGridWork, IsLocalInALargeRandomCloud) {
  for (const Vector3& factors :
       {Vector3{1, 1, 1}, Vector3{4, 1, 0.25}, Vector3{0.25, 4, 1}, Vector3{1, 0.25, 4}}) {
    const Vector3 centre{50, -70, 90};
    const auto killers = moved(squeezed(random_cube(3000, 1.0, 15), factors), centre);
    const auto points = moved(squeezed(random_cube(5000, 1.0, 16), factors), centre);
    KillGrid grid;
    build(grid, killers, 0.1);
    std::uint64_t evaluations = 0;
    for (const Vector3& point : points) grid.reaches(point, evaluations);
    EXPECT_GT(evaluations, points.size());
    EXPECT_LT(evaluations, points.size() * 8) << "of 3000 per point if all were looked at";
  }
}

// Cells as narrow as this distance would be more than memory holds: they must be widened, but not
// to one.
TEST(KillGridWork, IsLocalForFewKillersFarApartAndATinyDistance) {
  const auto killers = random_cube(1000, 1e6, 17);
  KillGrid grid;
  build(grid, killers, 1e-3);
  std::uint64_t evaluations = 0;
  const auto points = random_cube(5000, 1e6, 18);
  for (const Vector3& point : points) grid.reaches(point, evaluations);
  EXPECT_LT(evaluations, points.size() * 50);
}

// The square of such a distance is zero: a point that near is removed even at no distance, as a
// loop over all pairs does.
TEST(KillGrid, AgreesWithAPlainLoopWhereSquaresUnderflow) {
  const std::vector<SearchableNode> killers{{{0, 0, 0}, {0, 1, 0}}};
  for (const double distance : {0.0, 1e-300, 1e-170, 1e-160}) {
    KillGrid grid;
    grid.build(killers, distance);
    std::uint64_t evaluations = 0;
    EXPECT_TRUE(grid.reaches({1e-165, 0, 0}, evaluations)) << distance;
    EXPECT_FALSE(grid.reaches({1e-100, 0, 0}, evaluations)) << distance;
  }
}

}  // namespace
}  // namespace phytobench
