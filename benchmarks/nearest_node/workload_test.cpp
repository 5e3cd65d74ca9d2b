// SPDX-License-Identifier: MIT
#include "benchmarks/nearest_node/workload.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmarks/nearest_node/engine_fixture.hpp"
#include "core/colonization/tree_parameters_file.hpp"
#include "core/contract/errors.hpp"
#include "core/contract/text_file.hpp"
#include "core/nearest_node/engine_registry.hpp"
#include "core/random/counter_stream.hpp"
#include "reference/tree_presets.hpp"

namespace phytobench {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

namespace fs = std::filesystem;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// A few roundings of products and cube roots.
constexpr double rounding = 1e-13;

TreeParameters published_test_tree() {
  return read_tree_parameters(tree_preset_file("figure-51"));
}

GrowthResult grown(const Workload& workload) {
  const auto engine = engine_named("squared_scan").create();
  return grow_crown(workload.seedling, *engine);
}

/// A crown as a user may have measured it: no ellipsoid, not at the origin.
std::vector<Vector3> random_cone(std::size_t count) {
  CounterStream stream(41, 0);
  std::vector<Vector3> points;
  while (points.size() < count) {
    const double y = stream.next_unit();
    const double x = stream.next_between(-1.0, 1.0);
    const double z = stream.next_between(-1.0, 1.0);
    if (x * x + z * z <= (1.0 - 0.8 * y) * (1.0 - 0.8 * y))
      points.push_back({3.0 + 2.0 * x, 1.0 + 5.0 * y, -4.0 + 2.0 * z});
  }
  return points;
}

std::vector<Vector3> scaled(std::vector<Vector3> points, double factor) {
  for (Vector3& point : points) point = factor * point;
  return points;
}

void expect_near_each_other(double value, double expected) {
  EXPECT_NEAR(value, expected, rounding * std::abs(expected));
}

TEST(ScaledTestTree, IsThePublishedOneAtItsOwnSize) {
  const Workload workload = scaled_test_tree({});
  const Seedling expected = make_seedling(published_test_tree());
  EXPECT_EQ(workload.seedling.attraction_points.size(), 25298u);
  EXPECT_EQ(workload.seedling.growth.iterations, 40);
  EXPECT_EQ(workload.density, 30.0);
  EXPECT_EQ(workload.seed, 0u);
  EXPECT_EQ(workload.seedling.attraction_points, expected.attraction_points);
  EXPECT_EQ(tree_hash(workload.seedling.skeleton), tree_hash(expected.skeleton));
  EXPECT_EQ(workload.seedling.growth.tropism, expected.growth.tropism);
}

TEST(ScaledTestTree, OfAMillionPointsGrowsProportionallyLonger) {
  const Workload workload = scaled_test_tree({.points = 1e6});
  EXPECT_EQ(workload.seedling.attraction_points.size(), 999985u);
  EXPECT_EQ(workload.seedling.growth.iterations, 136);
  EXPECT_EQ(workload.density, 30.0);
}

TEST(ScaledTestTree, HasAboutAsManyPointsAsAskedFor) {
  for (const double points : {1.0, 2.0, 100.0, 1500.0, 30000.0, 100000.0}) {
    const auto count =
        static_cast<double>(scaled_test_tree({.points = points}).seedling.attraction_points.size());
    // Rounded up, as is the size it is scaled from.
    EXPECT_NEAR(count, points, 1.0 + 1e-4 * points);
  }
}

TEST(ScaledTestTree, GrowsAtLeastOnce) {
  EXPECT_EQ(scaled_test_tree({.points = 1.0}).seedling.growth.iterations, 1);
  EXPECT_EQ(scaled_test_tree({.points = 1.0, .density = 1e6}).seedling.growth.iterations, 1);
}

TEST(ScaledTestTree, HasAsManyPointsAtAnyDensityInProportionallyLessSpace) {
  const auto extent = [](const Workload& workload) {
    return extent_of(workload.seedling.attraction_points).extent();
  };
  for (const double points : {1500.0, 25298.0}) {
    const Workload usual = scaled_test_tree({.points = points});
    const Workload dense = scaled_test_tree({.points = points, .density = 60.0});
    EXPECT_EQ(dense.density, 60.0);
    EXPECT_EQ(dense.seedling.attraction_points.size(), usual.seedling.attraction_points.size());
    const double shrink = std::cbrt(0.5);
    expect_near_each_other(extent(dense).x, shrink * extent(usual).x);
    expect_near_each_other(extent(dense).z, shrink * extent(usual).z);
  }
}

// The local work is the same only if neither the density nor a length changes with the size.
TEST(ScaledTestTree, KeepsEveryLengthOfTheModelAtAnySize) {
  const GrowthParameters expected = make_seedling(published_test_tree()).growth;
  for (const double points : {1000.0, 100000.0}) {
    const GrowthParameters growth = scaled_test_tree({.points = points}).seedling.growth;
    EXPECT_EQ(growth.step_length, expected.step_length);
    EXPECT_EQ(growth.influence_distance, expected.influence_distance);
    EXPECT_EQ(growth.perception_angle_rad, expected.perception_angle_rad);
    EXPECT_EQ(growth.kill_distance.begin, expected.kill_distance.begin);
    EXPECT_EQ(growth.kill_distance.end, expected.kill_distance.end);
  }
}

TEST(ScaledTestTree, TakesIterationsAndSeedFromTheRequest) {
  const Workload workload = scaled_test_tree({.points = 1500.0, .iterations = 7, .seed = 3});
  EXPECT_EQ(workload.seedling.growth.iterations, 7);
  EXPECT_EQ(workload.seed, 3u);
  const Workload other = scaled_test_tree({.points = 1500.0, .iterations = 7, .seed = 4});
  EXPECT_NE(workload.seedling.attraction_points, other.seedling.attraction_points);
  EXPECT_EQ(workload.seedling.attraction_points,
            scaled_test_tree({.points = 1500.0, .seed = 3}).seedling.attraction_points);
}

TEST(ScaledTestTree, OfAnAbsurdSizeIsAnInputErrorThatSaysWhatIsPossible) {
  for (const double points :
       {0.0, 0.5, -1.0, 2.1e8, 1e300, infinite_length, -infinite_length, not_a_number}) {
    try {
      scaled_test_tree({.points = points});
      ADD_FAILURE() << points << " points were accepted";
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), AllOf(HasSubstr("--points"), HasSubstr("give 1 to")));
    }
  }
}

/// A fresh folder per test, removed with all it holds.
class ReadPoints : public testing::Test {
 protected:
  void SetUp() override {
    const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) /
              (std::string("phytobench-points-") + test->name() + "-" + std::to_string(::getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path with(const std::string& text) const {
    write_file_atomically(folder_ / "cloud.csv", text);
    return folder_ / "cloud.csv";
  }

  static std::string reading_error(const fs::path& file) {
    try {
      read_points(file);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }

  fs::path folder_;
};

TEST_F(ReadPoints, TakesColumnsByName) {
  EXPECT_EQ(read_points(with("# a scan\nz,intensity,x,y\n3,9,1,2\n-6,9,4.5,5e-1\n")),
            (std::vector<Vector3>{{1, 2, 3}, {4.5, 0.5, -6}}));
}

TEST_F(ReadPoints, ErrorsNameFileAndLine) {
  const std::string file = (folder_ / "cloud.csv").string();
  EXPECT_THAT(reading_error(with("x,y\n1,2\n")), StartsWith(file + ":1: no column 'z'"));
  EXPECT_THAT(reading_error(with("x,y,z\n1,2,3\n1,two,3\n")), StartsWith(file + ":3: y = 'two'"));
  EXPECT_THAT(reading_error(with("x,y,z\n1,2\n")), StartsWith(file + ":2: 2 fields"));
  EXPECT_THAT(reading_error(with("x,y,z\n")), StartsWith(file + ": has a header but no line"));
  EXPECT_THAT(reading_error(with("")), StartsWith(file + ": is empty"));
  EXPECT_THAT(reading_error(folder_ / "nowhere.csv"), HasSubstr("nowhere.csv: no such file"));
}

TEST_F(ReadPoints, CoordinatesWhoseSquaresOverflowAreRefused) {
  for (const char* line : {"1e200,0,0", "0,-1e151,0", "0,0,1.7e308"})
    EXPECT_THAT(reading_error(with(std::string("x,y,z\n") + line + "\n")),
                AllOf(StartsWith((folder_ / "cloud.csv").string()), HasSubstr("larger unit")))
        << line;
}

TEST(WorkloadFromPoints, PlantsTheSeedlingBelowTheMiddle) {
  const std::vector<Vector3> points{{-1, 2, 3}, {5, 4, 13}, {0, 9, 4}};
  const Workload workload = workload_from_points(points, "three points", 0);
  EXPECT_EQ(workload.name, "three points");
  EXPECT_EQ(workload.seedling.attraction_points, points);
  EXPECT_EQ(workload.seedling.skeleton.node_count(), 1u);
  EXPECT_EQ(workload.seedling.crown_root, 0);
  EXPECT_EQ(workload.seedling.skeleton.position(0), (Vector3{2, 2, 8}));
  EXPECT_EQ(workload.seedling.crown_root_direction, (Vector3{0, 1, 0}));
}

TEST(WorkloadFromPoints, KillsNoFartherThanItAttracts) {
  for (const std::size_t count : {2u, 10u, 1000u, 30000u}) {
    const GrowthParameters growth =
        workload_from_points(random_cone(count), "cone", 0).seedling.growth;
    EXPECT_LE(growth.kill_distance.begin, growth.influence_distance);
    EXPECT_LE(growth.kill_distance.end, growth.kill_distance.begin);
    EXPECT_GT(growth.kill_distance.end, 0.0);
  }
}

TEST(WorkloadFromPoints, TakesIterationsOrAsManyAsTheSizeAsksFor) {
  const std::vector<Vector3> points = random_cone(25298);
  EXPECT_EQ(workload_from_points(points, "cone", 12).seedling.growth.iterations, 12);
  EXPECT_EQ(workload_from_points(points, "cone", 0).seedling.growth.iterations, 40);
  EXPECT_EQ(workload_from_points({{1, 2, 3}}, "point", 0).seedling.growth.iterations, 1);
}

// Only that the ellipsoid's ends are cut off is not seen in a cloud: it fills more of its box, and
// counts as denser by about a fifth.
TEST(WorkloadFromPoints, GivesTheTestTreesOwnCloudNearlyItsLengths) {
  const Seedling published = make_seedling(published_test_tree());
  const Workload workload = workload_from_points(published.attraction_points, "test tree", 0);
  const GrowthParameters& growth = workload.seedling.growth;
  EXPECT_NEAR(workload.density / 30.0, 1.2, 0.05);
  EXPECT_NEAR(growth.step_length / published.growth.step_length, 0.95, 0.02);
  EXPECT_NEAR(growth.influence_distance / published.growth.influence_distance, 0.95, 0.02);
  EXPECT_EQ(growth.perception_angle_rad, published.growth.perception_angle_rad);
  EXPECT_EQ(growth.iterations, 40);
}

// The point of scaling lengths: what a node reaches is the same number of points in any cloud.
TEST(WorkloadFromPoints, ReachesAsManyPointsPerNodeInAnyCloud) {
  const TreeParameters tree = published_test_tree();
  const auto in_reach = [](double density, double reach) { return density * std::pow(reach, 3); };
  const double expected = in_reach(tree.cloud_density, tree.influence_distance);
  for (const std::size_t count : {100u, 5000u, 20000u})
    for (const double size : {1e-9, 1.0, 1e9}) {
      const Workload workload = workload_from_points(scaled(random_cone(count), size), "cone", 0);
      expect_near_each_other(
          in_reach(workload.density, workload.seedling.growth.influence_distance), expected);
    }
}

/// A cloud of no volume, or hardly any.
struct DegenerateCloud {
  const char* name;
  std::vector<Vector3> points;
  bool must_grow;  ///< what lies level with the seedling is not perceived: it looks up
};

std::vector<DegenerateCloud> degenerate_clouds() {
  const auto flattened = [](std::vector<Vector3> points, const Vector3& factors) {
    for (Vector3& point : points) point = hadamard_product(factors, point);
    return points;
  };
  const std::vector<Vector3> cone = random_cone(500);
  return {{"flat_upright", flattened(cone, {1, 1, 0}), true},
          {"flat_lying", flattened(cone, {1, 0, 1}), false},
          {"line_upright", flattened(cone, {0, 1, 0}), true},
          {"line_lying", flattened(cone, {1, 0, 0}), false},
          {"two_points", {{0, 0, 0}, {0, 1, 0}}, true},
          {"one_point", {{1, 2, 3}}, true},
          {"one_point_often", std::vector<Vector3>(50, {1, 2, 3}), true}};
}

TEST(WorkloadFromPoints, OfADegenerateCloudHasFinitePositiveLengthsAndGrows) {
  for (const DegenerateCloud& cloud : degenerate_clouds()) {
    const Workload workload = workload_from_points(cloud.points, cloud.name, 5);
    const GrowthParameters& growth = workload.seedling.growth;
    for (const double length : {growth.step_length, growth.influence_distance,
                                growth.kill_distance.begin, growth.kill_distance.end}) {
      EXPECT_GT(length, 0.0) << cloud.name;
      EXPECT_LT(length, infinite_length) << cloud.name;
    }
    EXPECT_GE(workload.density, 0.0) << cloud.name;
    EXPECT_LT(workload.density, infinite_length) << cloud.name;
    EXPECT_TRUE(is_finite(workload.seedling.skeleton.position(0))) << cloud.name;
    const GrowthResult result = grown(workload);
    for (const Vector3& node : result.skeleton.positions())
      ASSERT_TRUE(is_finite(node)) << cloud.name;
    if (cloud.must_grow) EXPECT_GT(result.skeleton.edge_count(), 0u) << cloud.name;
  }
}

TEST(WorkloadFromPointsLaw, TenfoldCoordinatesGiveTenfoldLengthsAndTheSameTree) {
  const std::vector<Vector3> points = random_cone(2000);
  const Workload small = workload_from_points(points, "cone", 0);
  const Workload large = workload_from_points(scaled(points, 10.0), "cone", 0);
  const GrowthParameters& a = small.seedling.growth;
  const GrowthParameters& b = large.seedling.growth;
  expect_near_each_other(b.step_length, 10.0 * a.step_length);
  expect_near_each_other(b.influence_distance, 10.0 * a.influence_distance);
  expect_near_each_other(b.kill_distance.begin, 10.0 * a.kill_distance.begin);
  expect_near_each_other(b.kill_distance.end, 10.0 * a.kill_distance.end);
  expect_near_each_other(large.density, 1e-3 * small.density);
  EXPECT_EQ(b.iterations, a.iterations);
  EXPECT_EQ(b.perception_angle_rad, a.perception_angle_rad);

  const GrowthResult first = grown(small), second = grown(large);
  EXPECT_GT(first.skeleton.node_count(), 200u);
  EXPECT_EQ(second.skeleton.node_count(), first.skeleton.node_count());
  EXPECT_EQ(second.skeleton.parents(), first.skeleton.parents());
  EXPECT_EQ(second.live_points, first.live_points);
}

TEST(WorkloadFromPointsLaw, WhereTheCloudIsDoesNotChangeLengths) {
  const std::vector<Vector3> points = random_cone(300);
  std::vector<Vector3> moved = points;
  for (Vector3& point : moved) point = point + Vector3{64, -128, 32};
  const Workload here = workload_from_points(points, "cone", 0);
  const Workload there = workload_from_points(moved, "cone", 0);
  // Coordinates of some hundred keep about 14 digits of differences of some units.
  EXPECT_NEAR(there.seedling.growth.step_length, here.seedling.growth.step_length, 1e-12);
  const Vector3 shift = there.seedling.skeleton.position(0) - here.seedling.skeleton.position(0);
  EXPECT_NEAR(norm(shift - Vector3{64, -128, 32}), 0.0, 1e-12);
}

TEST(WorkloadFromPointsLaw, OrderOfPointsDoesNotChangeLengthsOrTheSeedling) {
  const std::vector<Vector3> points = random_cone(300);
  CounterStream stream(42, 0);
  std::vector<Vector3> shuffled;
  for (const std::size_t i : random_order(points.size(), stream)) shuffled.push_back(points[i]);
  const Workload one = workload_from_points(points, "cone", 0);
  const Workload other = workload_from_points(shuffled, "cone", 0);
  EXPECT_EQ(one.seedling.skeleton.position(0), other.seedling.skeleton.position(0));
  EXPECT_EQ(one.seedling.growth.step_length, other.seedling.growth.step_length);
  EXPECT_EQ(one.density, other.density);
}

}  // namespace
}  // namespace phytobench
