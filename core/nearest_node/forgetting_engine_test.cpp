// SPDX-License-Identifier: MIT
#include "core/nearest_node/forgetting_engine.hpp"

#include <algorithm>
#include <numbers>
#include <optional>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/nearest_node/engine_registry.hpp"
#include "core/nearest_node/perception.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

std::vector<Vector3> random_points(std::size_t count, std::uint64_t seed) {
  CounterStream stream(seed, 0);
  std::vector<Vector3> points;
  for (std::size_t i = 0; i < count; ++i)
    points.push_back({stream.next_unit(), stream.next_unit(), stream.next_unit()});
  return points;
}

/// Every fourth node stands where another does: ties go to the lowest number that is left.
std::vector<SearchableNode> random_nodes(std::size_t count, std::uint64_t seed) {
  std::vector<SearchableNode> nodes;
  for (const Vector3& at : random_points(count, seed)) nodes.push_back({at, {0, 1, 0}});
  for (std::size_t i = 4; i < count; i += 4) nodes[i] = nodes[i - 3];
  return nodes;
}

constexpr double reach = 0.4;

/// The contract of engines, word by word, for nodes that may be forgotten.
struct LiteralSearch {
  std::vector<Vector3> points;
  Perception perception;
  std::vector<bool> removed{};
  std::vector<SearchableNode> nodes{};
  std::vector<bool> forgotten{};

  NodeIndex nearest(std::size_t point) const {
    NodeIndex best = no_node;
    double smallest = perception.beyond_reach();
    for (std::size_t n = 0; n < nodes.size() && !removed[point]; ++n) {
      const double squared = squared_distance(points[point], nodes[n].position);
      if (forgotten[n] || !(squared < smallest)) continue;
      if (!perception.within_angle(nodes[n].position, nodes[n].direction, points[point], squared))
        continue;
      best = static_cast<NodeIndex>(n);
      smallest = squared;
    }
    return best;
  }
};

void expect_same(const LiteralSearch& expected, const Assignment& assignment,
                 std::string_view engine, int round) {
  ASSERT_EQ(assignment.node.size(), expected.points.size());
  for (std::size_t i = 0; i < expected.points.size(); ++i) {
    ASSERT_EQ(assignment.node[i], expected.nearest(i)) << engine << ", round " << round;
    ASSERT_EQ(assignment.associated.contains(static_cast<PointIndex>(i)),
              assignment.node[i] != no_node);
  }
}

void run_rounds(const EngineDescriptor& descriptor, double half_angle_rad, PointFilter filter) {
  LiteralSearch literal{random_points(300, 1), Perception(reach, half_angle_rad)};
  literal.removed.assign(literal.points.size(), false);
  const auto inner = descriptor.create();
  ForgettingEngine engine(*inner);
  engine.reset(literal.points, {.influence_distance = reach,
                                .perception_half_angle_rad = half_angle_rad,
                                .search_filter = filter,
                                .kill_filter = filter});
  CounterStream stream(9, 0);
  std::size_t live = literal.points.size();
  for (int round = 0; round < 12; ++round) {
    const auto added = random_nodes(8, 100 + static_cast<std::uint64_t>(round));
    literal.nodes.insert(literal.nodes.end(), added.begin(), added.end());
    literal.forgotten.resize(literal.nodes.size(), false);
    ASSERT_NO_FATAL_FAILURE(expect_same(literal, engine.associate(added), descriptor.name, round));
    // Forget some nodes; in one round all.
    std::vector<NodeIndex> tired;
    for (std::size_t n = 0; n < literal.nodes.size(); ++n) {
      if (literal.forgotten[n] || (round != 7 && stream.next_unit() > 0.2)) continue;
      if (round % 3 == 2) continue;
      literal.forgotten[n] = true;
      tired.push_back(static_cast<NodeIndex>(n));
    }
    engine.forget(tired);
    // Remove some points, with nodes that may be forgotten as well.
    const double kill = 0.02 * round;
    std::vector<PointIndex> expected;
    for (std::size_t i = 0; i < literal.points.size(); ++i)
      for (const SearchableNode& killer : added) {
        if (literal.removed[i] ||
            squared_distance(literal.points[i], killer.position) > kill * kill)
          continue;
        literal.removed[i] = true;
        expected.push_back(static_cast<PointIndex>(i));
      }
    const auto removed = engine.kill(added, kill);
    std::vector<PointIndex> sorted(removed.begin(), removed.end());
    std::sort(sorted.begin(), sorted.end());
    ASSERT_EQ(sorted, expected) << descriptor.name << ", round " << round;
    live -= expected.size();
    ASSERT_EQ(engine.live_points(), live);
  }
  EXPECT_LT(live, literal.points.size());
}

TEST(ForgettingEngine, GivesEachPointTheNearestNodeThatIsNotForgottenWithEveryEngine) {
  for (const EngineDescriptor* descriptor : all_engines()) {
    if (!descriptor->built()) continue;
    run_rounds(*descriptor, std::numbers::pi, PointFilter::none);
    run_rounds(*descriptor, 1.2, PointFilter::none);
    run_rounds(*descriptor, 1.2, PointFilter::bounding_box);
  }
}

TEST(ForgettingEngine, WithNothingForgottenDoesTheWorkOfTheEngineAlone) {
  const auto points = random_points(200, 3);
  const auto nodes = random_nodes(40, 4);
  const auto alone = engine_named("squared_scan").create();
  const auto inner = engine_named("squared_scan").create();
  ForgettingEngine engine(*inner);
  for (NearestNodeEngine* each : {static_cast<NearestNodeEngine*>(&engine), alone.get()}) {
    each->reset(points,
                {.influence_distance = reach, .perception_half_angle_rad = std::numbers::pi});
    each->associate(nodes);
    each->kill(nodes, 0.1);
    each->associate({});
  }
  EXPECT_EQ(engine.counters(), alone->counters());
  EXPECT_EQ(engine.live_points(), alone->live_points());
}

TEST(ForgettingEngine, SparesTheDistancesToWhatIsForgotten) {
  const auto points = random_points(100, 5);
  const auto inner = engine_named("squared_scan").create();
  ForgettingEngine engine(*inner);
  engine.reset(points, {.influence_distance = reach, .perception_half_angle_rad = 3.0});
  engine.associate(random_nodes(10, 6));
  EXPECT_EQ(engine.counters().search_evaluations, 1000u);
  engine.forget(std::vector<NodeIndex>{0, 1, 2, 3, 4, 5, 6});
  engine.associate({});
  EXPECT_EQ(engine.counters().search_evaluations, 1300u);
}

TEST(ForgettingEngine, ResetForgetsEverythingElse) {
  const auto points = random_points(50, 7);
  const auto nodes = random_nodes(5, 8);
  const auto inner = engine_named("node_driven").create();
  ForgettingEngine engine(*inner);
  const EngineSetup setup{.influence_distance = reach, .perception_half_angle_rad = 3.0};
  std::optional<std::vector<NodeIndex>> first;
  for (int round = 0; round < 2; ++round) {
    engine.reset(points, setup);
    EXPECT_EQ(engine.live_points(), 50u);
    const auto found = engine.associate(nodes).node;
    const std::vector<NodeIndex> copy(found.begin(), found.end());
    if (first) {
      EXPECT_EQ(copy, *first);
    }
    first = copy;
    engine.forget(std::vector<NodeIndex>{0, 2});
    engine.kill(nodes, 0.2);
    engine.associate({});
  }
}

TEST(ForgettingEngine, RefusesNodesThatItDoesNotKnowOrHasForgotten) {
  const auto points = random_points(5, 7);
  const auto inner = engine_named("squared_scan").create();
  ForgettingEngine engine(*inner);
  engine.reset(points, {.influence_distance = reach, .perception_half_angle_rad = 3.0});
  engine.associate(random_nodes(2, 8));
  EXPECT_THROW(engine.forget(std::vector<NodeIndex>{2}), ContractViolation);
  EXPECT_THROW(engine.forget(std::vector<NodeIndex>{-1}), ContractViolation);
  engine.forget(std::vector<NodeIndex>{1});
  EXPECT_THROW(engine.forget(std::vector<NodeIndex>{1}), ContractViolation);
}

}  // namespace
}  // namespace phytobench
