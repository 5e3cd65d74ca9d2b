// SPDX-License-Identifier: MIT
#include "benchmarks/nearest_node/pair_floor.hpp"
#include "benchmarks/nearest_node/awkward_seedlings.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "benchmarks/nearest_node/engine_fixture.hpp"
#include "benchmarks/nearest_node/workload.hpp"
#include "core/nearest_node/engine_registry.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

/// Follows a growth and looks at every pair there is.
class LoopOverAllPairs final : public NearestNodeEngine {
 public:
  void reset(std::span<const Vector3> points, const EngineSetup& setup) override {
    points_ = points;
    reach_ = setup.influence_distance;
    live_.assign(points.size(), true);
    floor_ = {};
    inner_->reset(points, setup);
  }

  Assignment associate(std::span<const SearchableNode> nodes) override {
    for (const SearchableNode& node : nodes)
      for (std::size_t i = 0; i < points_.size(); ++i)
        floor_.association +=
            live_[i] && squared_distance(points_[i], node.position) <= reach_ * reach_;
    return inner_->associate(nodes);
  }

  std::span<const PointIndex> kill(std::span<const SearchableNode> killers,
                                   double distance) override {
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (!live_[i]) continue;
      for (const SearchableNode& killer : killers)
        if (squared_distance(points_[i], killer.position) <= distance * distance) live_[i] = false;
      floor_.removal += !live_[i];
    }
    return inner_->kill(killers, distance);
  }

  std::size_t live_points() const override { return inner_->live_points(); }
  WorkCounters counters() const override { return inner_->counters(); }
  const PairFloor& floor() const { return floor_; }

 private:
  std::unique_ptr<NearestNodeEngine> inner_ = engine_named("squared_scan").create();
  std::span<const Vector3> points_;
  double reach_ = 0.0;
  std::vector<bool> live_;
  PairFloor floor_;
};

std::vector<NamedSeedling> counted_seedlings() {
  std::vector<NamedSeedling> all;
  all.push_back({"random", with_crown_stem(seedling_with(random_cube(900, 1.0), 0.5, 0.3, 15))});
  all.push_back({"lattice", with_crown_stem(seedling_with(lattice(4, 0.25), 0.5, 0.25, 10))});
  all.push_back({"odd_lattice", with_crown_stem(seedling_with(lattice(6, 0.1), 0.3, 0.2, 10))});
  all.push_back({"duplicates", seedling_with(repeated(random_cube(200, 1.0)), 0.6, 0.3, 12)});
  all.push_back(
      {"infinite_influence", seedling_with(random_cube(300, 1.0), infinite_length, 0.3, 10)});
  all.push_back({"huge_coordinates", scaled_growth(1e12)});
  all.push_back({"tiny_coordinates", scaled_growth(1e-12)});
  all.push_back({"test_tree", scaled_test_tree({.points = 1500.0}).seedling});
  return all;
}

PairFloor counted_by_loop(const Seedling& seedling, const GrowthRun& run) {
  LoopOverAllPairs loop;
  grow_crown(seedling, loop, run);
  return loop.floor();
}

TEST(PairFloor, IsWhatALoopOverAllPairsCounts) {
  for (const NamedSeedling& tried : counted_seedlings())
    for (const std::string_view option : loop_option_names)
      for (const int threads : {1, 2}) {
        const GrowthRun run{.options = loop_options_named(option), .threads = threads};
        const PairFloor expected = counted_by_loop(tried.seedling, run);
        const PairFloor floor = count_pairs(tried.seedling, run);
        EXPECT_EQ(floor.association, expected.association)
            << tried.name << ", option " << option << ", " << threads << " threads";
        EXPECT_EQ(floor.removal, expected.removal)
            << tried.name << ", option " << option << ", " << threads << " threads";
      }
}

// Otherwise the test above could pass by counting nothing, or everything.
TEST(PairFloor, IsFarFromBothNothingAndAllPairs) {
  for (const NamedSeedling& tried : counted_seedlings()) {
    const Seedling& seedling = tried.seedling;
    const auto engine = engine_named("squared_scan").create();
    const GrowthResult result = grow_crown(seedling, *engine);
    const PairFloor floor = count_pairs(seedling, {});
    const std::size_t points = seedling.attraction_points.size();
    EXPECT_GT(floor.association, points / 4) << tried.name;
    EXPECT_EQ(floor.removal, points - result.live_points) << tried.name;
    EXPECT_GT(floor.removal, 0u) << tried.name;
    EXPECT_LE(floor.association, points * result.skeleton.node_count()) << tried.name;
    if (seedling.growth.influence_distance < infinite_length)
      EXPECT_LT(floor.association, points * result.skeleton.node_count() / 2) << tried.name;
  }
}

// By hand: the root sees both points, its child at height 0.25 only the one that the root's removal
// leaves.
TEST(PairFloor, OfTwoPointsIsCountedByHand) {
  Seedling seedling = seedling_with({{0, 0.25, 0}, {0, 1, 0}}, 1.0, 0.25, 2);
  EXPECT_EQ(count_pairs(seedling, {}).association, 3u);
  EXPECT_EQ(count_pairs(seedling, {}).removal, 1u);
  seedling.growth.iterations = 1;
  EXPECT_EQ(count_pairs(seedling, {}).association, 2u);
  EXPECT_EQ(count_pairs(seedling, {}).removal, 1u);
}

// A node just below a cell's border and a point one influence distance on, just above the border
// after next: there rounding decides, and cells exactly as wide as that distance lose pairs.
TEST(PairFloor, LosesNothingToRoundingAtCellBorders) {
  for (int hundredths = 1; hundredths <= 200; hundredths += 3)
    for (int cell = 1; cell <= 8; ++cell) {
      const double influence = hundredths / 100.0;
      double along = cell * influence;
      for (int i = 0; i < 4; ++i) along = std::nextafter(along, 0.0);
      for (int i = 0; i < 6; ++i, along = std::nextafter(along, infinite_length))
        for (const Vector3& axis : {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}}) {
          std::vector<Vector3> points{{0, 0, 0}};
          double beyond = along + influence;
          for (int j = 0; j < 3; ++j, beyond = std::nextafter(beyond, 0.0))
            points.push_back(beyond * axis);
          Seedling seedling = seedling_with(points, influence, influence, 1);
          seedling.skeleton = Skeleton(along * axis);
          ASSERT_EQ(count_pairs(seedling, {}).association,
                    counted_by_loop(seedling, {}).association)
              << "influence distance " << influence << ", node " << along;
        }
    }
}

// Far from the origin a coordinate over the cell's edge has no bits left for the margin.
TEST(PairFloor, LosesNothingFarFromTheOrigin) {
  for (const double offset : {1e9, 1e10, 1e11, 1e12})
    for (int k = 0; k < 50; ++k) {
      const double base = offset + 0.625 * k;
      Seedling seedling =
          seedling_with({{base + 0.5, 0, 0}, {base - 0.5, 0, 0}, {base + 3, 0, 0}}, 0.5, 0.25, 1);
      seedling.skeleton = Skeleton({base, 0, 0});
      ASSERT_EQ(count_pairs(seedling, {}).association, 2u) << base;
    }
}

TEST(PairFloor, OfNoPointIsNothing) {
  const PairFloor floor = count_pairs(seedling_with({}, 0.5, 0.25, 5), {});
  EXPECT_EQ(floor.association, 0u);
  EXPECT_EQ(floor.removal, 0u);
}

// The box of option n and putting a removal off change no tree; a deferred removal only leaves the
// last one undone.
TEST(PairFloorLaw, LoopOptionsDoNotChangeTheAssociations) {
  for (const NamedSeedling& tried : counted_seedlings()) {
    const PairFloor plain = count_pairs(tried.seedling, {});
    for (const std::string_view option : loop_option_names) {
      const PairFloor other = count_pairs(tried.seedling, {.options = loop_options_named(option)});
      EXPECT_EQ(other.association, plain.association) << tried.name << ", option " << option;
      EXPECT_LE(other.removal, plain.removal) << tried.name << ", option " << option;
    }
  }
}

TEST(PairFloorLaw, OrderOfPointsDoesNotMatter) {
  // Equal attraction sums only up to rounding: one iteration, before they can grow apart.
  Seedling seedling = with_crown_stem(seedling_with(random_cube(900, 1.0), 0.5, 0.3, 1));
  const PairFloor floor = count_pairs(seedling, {});
  CounterStream stream(52, 0);
  std::vector<Vector3> shuffled;
  for (const std::size_t i : random_order(seedling.attraction_points.size(), stream))
    shuffled.push_back(seedling.attraction_points[i]);
  seedling.attraction_points = shuffled;
  EXPECT_EQ(count_pairs(seedling, {}).association, floor.association);
  EXPECT_EQ(count_pairs(seedling, {}).removal, floor.removal);
}

}  // namespace
}  // namespace phytobench
