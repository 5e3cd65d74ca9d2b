// SPDX-License-Identifier: MIT
#include "benchmarks/nearest_node/approximate_lane.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/nearest_node/engine_registry.hpp"
#include "core/nearest_node/nearest_perceiving.hpp"
#include "core/nearest_node/node_list.hpp"

// The stand-in under another name, so that it is tested where FLANN was found, too.
#define approximate_engines stand_ins_for_approximate_engines
#include "benchmarks/nearest_node/flann_randomised_not_built.cpp"
#undef approximate_engines

namespace phytobench {
namespace {

const Workload& small_workload() {
  static const Workload workload = scaled_test_tree({.points = 2000.0});
  return workload;
}

const EngineDescriptor& exact() {
  return engine_named("node_driven");
}

bool lacks_flann() {
  return !approximate_engines().front().built();
}

struct Edge {
  std::int32_t parent;
  Vector3 child;
};

/// From the origin.
Skeleton tree_of(const std::vector<Edge>& edges) {
  Skeleton tree{Vector3{}};
  for (const Edge& edge : edges) tree.append(edge.parent, edge.child);
  return tree;
}

TEST(TreeDifference, IsTheShareOfEdgesThatAreNotInBoth) {
  const Skeleton upright = tree_of({{0, {0, 1, 0}}, {1, {0, 2, 0}}});
  const Skeleton forked = tree_of({{0, {0, 1, 0}}, {1, {1, 1, 0}}, {1, {-1, 1, 0}}});
  EXPECT_EQ(tree_difference(upright, forked), 0.75) << "1 of 4 edges is in both";
  const Skeleton reordered = tree_of({{0, {0, 1, 0}}, {1, {-1, 1, 0}}, {1, {1, 1, 0}}});
  EXPECT_EQ(tree_difference(forked, reordered), 0.0);
  EXPECT_EQ(tree_difference(upright, tree_of({{0, {0, 2, 0}}})), 1.0)
      << "equal nodes with other parents";
}

TEST(TreeDifference, SeesTheLastBitAndTheDirection) {
  const Skeleton tree = tree_of({{0, {0, 1, 0}}});
  EXPECT_EQ(tree_difference(tree, tree_of({{0, {0, std::nextafter(1.0, 2.0), 0}}})), 1.0);
  EXPECT_EQ(tree_difference(tree, tree_of({{0, {-0.0, 1, 0}}})), 1.0);
  Skeleton reversed(Vector3{0, 1, 0});
  reversed.append(0, {0, 0, 0});
  EXPECT_EQ(tree_difference(tree, reversed), 1.0);
}

TEST(TreeDifference, CountsRepeatedEdgesOnceAndLoneRootsAsEqual) {
  const Skeleton once = tree_of({{0, {0, 1, 0}}, {0, {1, 0, 0}}});
  const Skeleton twice = tree_of({{0, {0, 1, 0}}, {0, {0, 1, 0}}});
  EXPECT_EQ(tree_difference(once, twice), 0.5);
  EXPECT_EQ(tree_difference(tree_of({}), Skeleton(Vector3{1, 0, 0})), 0.0);
  EXPECT_EQ(tree_difference(tree_of({}), once), 1.0);
}

/// Exact but for one point, which always gets the same answer.
template <PointIndex wrong_point, NodeIndex answer>
class OneAnswerReplaced : public NodeList {
 public:
  NearestHit nearest(PointIndex index, const Vector3& point, const Perception& perception,
                     WorkCounters& work) const {
    if (index == wrong_point) return {answer, 0.0};
    NearestPerceiving found(nodes_, point, perception, work);
    for (std::size_t node = 0; node < nodes_.size(); ++node) found.offer(node);
    return found.best();
  }
};

/// Share of wrong answers over two associations. Points 0, 1 and 2 are in reach of node 0, point 2
/// is removed before the second, and point 3 is in reach of nothing: 3 + 2 answers.
template <PointIndex point, NodeIndex answer>
double share_with_one_answer_replaced() {
  const std::vector<Vector3> points = {{0.5, 0, 0}, {-0.5, 0, 0}, {0, 0.1, 0}, {9, 0, 0}};
  const SearchableNode node{{0, 0, 0}, {0, 1, 0}};
  const GrowthTrace trace{
      .setup = {.influence_distance = 1.0, .perception_half_angle_rad = std::numbers::pi},
      .steps = {{false, 0.0, {node}}, {true, 0.2, {node}}, {false, 0.0, {}}}};
  const EngineDescriptor other{
      .name = "other", .create = make_point_driven_engine<OneAnswerReplaced<point, answer>>};
  return wrong_answer_share(trace, exact(), other, points);
}

TEST(WrongAnswerShare, CountsWhatAtLeastOneAnswers) {
  EXPECT_EQ((share_with_one_answer_replaced<0, 0>()), 0.0) << "the right answer";
  EXPECT_EQ((share_with_one_answer_replaced<0, no_node>()), 2.0 / 5.0) << "one missed";
  EXPECT_EQ((share_with_one_answer_replaced<3, no_node>()), 0.0) << "neither has one";
  EXPECT_EQ((share_with_one_answer_replaced<3, 0>()), 2.0 / 7.0) << "one too many";
}

TEST(WrongAnswerShare, IsZeroWithoutAnswers) {
  const GrowthTrace trace{.setup = {.influence_distance = 1.0, .perception_half_angle_rad = 1.0}};
  EXPECT_EQ(wrong_answer_share(trace, exact(), exact(), {}), 0.0);
}

TEST(ApproximateLaneLaw, ExactEnginesDoNotDiffer) {
  const Seedling& seedling = small_workload().seedling;
  const GrowthTrace trace = record_trace(exact(), seedling, {});
  const Skeleton expected = grow_crown(seedling, *exact().create()).skeleton;
  for (const char* name : {"node_driven", "squared_scan", "voxel_grid"}) {
    const EngineDescriptor& engine = engine_named(name);
    EXPECT_EQ(wrong_answer_share(trace, exact(), engine, seedling.attraction_points, 2), 0.0);
    EXPECT_EQ(tree_difference(expected, grow_crown(seedling, *engine.create()).skeleton), 0.0);
  }
}

TEST(ApproximateLaneLaw, AWrongEngineDiffers) {
  const Seedling& seedling = small_workload().seedling;
  const EngineDescriptor& wrong = engine_named("forgets_newest_node");
  const GrowthTrace trace = record_trace(exact(), seedling, {});
  EXPECT_GT(wrong_answer_share(trace, exact(), wrong, seedling.attraction_points), 0.0);
  const Skeleton expected = grow_crown(seedling, *exact().create()).skeleton;
  EXPECT_GT(tree_difference(expected, grow_crown(seedling, *wrong.create()).skeleton), 0.0);
}

TEST(ApproximateEngines, AreInNoRegistry) {
  for (const EngineDescriptor& engine : approximate_engines()) {
    EXPECT_EQ(engine.built(), engine.missing_package.empty()) << engine.name;
    for (const EngineDescriptor* registered : all_engines())
      EXPECT_NE(registered->name, engine.name);
  }
}

TEST(ApproximateEngines, HaveStandInsThatAreNotBuilt) {
  const auto real = approximate_engines(), stand_ins = stand_ins_for_approximate_engines();
  ASSERT_EQ(stand_ins.size(), real.size());
  for (std::size_t i = 0; i < real.size(); ++i) {
    EXPECT_EQ(stand_ins[i].name, real[i].name);
    EXPECT_FALSE(stand_ins[i].built());
    EXPECT_EQ(stand_ins[i].missing_package, "flann");
  }
}

// A long reach offers each point many nodes. The answers do not repeat, but the shares are far
// apart: in 40 runs 5 to 10 % with 16 leaves, and 0.2 % at most with 256.
TEST(ApproximateEngines, AreNoMoreOftenWrongIfTheySeeMore) {
  if (lacks_flann()) GTEST_SKIP() << "FLANN was not found";
  Seedling seedling = small_workload().seedling;
  seedling.growth.influence_distance *= 4.0;
  const GrowthTrace trace = record_trace(exact(), seedling, {});
  const auto share = [&](const EngineDescriptor& engine) {
    return wrong_answer_share(trace, exact(), engine, seedling.attraction_points);
  };
  EXPECT_LE(share(approximate_engines().back()), share(approximate_engines().front()));
}

TEST(ApproximateLane, HasAnEntryForEachEngineAndOption) {
  std::vector<std::string> steps;
  const auto entries = run_approximate_lane(
      small_workload(), exact(), {"s", "dn"}, 2,
      [&](const std::string& step) { steps.push_back(step); }, 2);
  ASSERT_EQ(entries.size(), 2 * approximate_engines().size());
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const ApproximateEntry& entry = entries[i];
    EXPECT_EQ(entry.engine, &approximate_engines()[i / 2]);
    EXPECT_EQ(entry.option, i % 2 == 0 ? "s" : "dn");
    ASSERT_EQ(entry.rounds.size(), entry.engine->built() ? 2u : 0u) << entry.name();
    EXPECT_EQ(entry.nodes > 0, entry.engine->built()) << entry.name();
    EXPECT_LE(entry.tree_difference, 1.0) << entry.name();
    EXPECT_LE(entry.wrong_answers, 1.0) << entry.name();
  }
  // Each option is recorded once; then each entry is replayed once and grown twice.
  EXPECT_EQ(steps.size(), lacks_flann() ? 0u : 2u + 3u * entries.size());
}

TEST(ApproximateLane, StopsWhenTheCallerThrows) {
  if (lacks_flann()) GTEST_SKIP() << "FLANN was not found";
  const auto stop = [](const std::string& step) {
    if (step.starts_with("round 1 of 1")) throw Interrupted();
  };
  EXPECT_THROW(run_approximate_lane(small_workload(), exact(), {"s"}, 1, stop), Interrupted);
}

TEST(ApproximateLane, WantsAnExactEngineAndARound) {
  EXPECT_THROW(run_approximate_lane(small_workload(), exact(), {"s"}, 0, {}), ContractViolation);
  EXPECT_THROW(run_approximate_lane(small_workload(), stand_ins_for_approximate_engines().front(),
                                    {"s"}, 1, {}),
               ContractViolation);
}

}  // namespace
}  // namespace phytobench
