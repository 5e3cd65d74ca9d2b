// SPDX-License-Identifier: MIT
#include "benchmarks/nearest_node/growth_trace.hpp"

#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "benchmarks/nearest_node/engine_fixture.hpp"
#include "benchmarks/nearest_node/workload.hpp"
#include "core/nearest_node/engine_registry.hpp"

namespace phytobench {
namespace {

/// Points on a lattice, and a trunk on it whose nodes are two points apart: what lies between two
/// nodes is equally near to both, and perceived by both.
Seedling on_lattice(int half_width) {
  std::vector<Vector3> points;
  for (int x = -half_width; x <= half_width; ++x)
    for (int y = 0; y <= 2 * half_width; ++y)
      for (int z = -half_width; z <= half_width; ++z)
        points.push_back({0.25 * x, 0.25 * y, 0.25 * z});
  Seedling seedling = workload_from_points(std::move(points), "lattice", 15).seedling;
  for (std::int32_t i = 0; i < half_width; ++i) seedling.skeleton.append(i, {0, 0.5 * (i + 1), 0});
  seedling.growth.perception_angle_rad = 2.0 * std::numbers::pi;
  return seedling;
}

Seedling small_test_tree() {
  return scaled_test_tree({.points = 1500.0}).seedling;
}

GrowthTrace trace_of(const Seedling& seedling, const GrowthRun& run = {}) {
  return record_trace(engine_named("squared_scan"), seedling, run);
}

Replay replay_on(const char* engine, const GrowthTrace& trace, const Seedling& seedling) {
  return replay(trace, engine_named(engine), seedling.attraction_points, 1);
}

/// Positions of all nodes that an engine was told of, in that order.
std::vector<Vector3> handed_to_association(const GrowthTrace& trace) {
  std::vector<Vector3> positions;
  for (const GrowthTrace::Step& step : trace.steps)
    if (!step.is_kill)
      for (const SearchableNode& node : step.nodes) positions.push_back(node.position);
  return positions;
}

std::size_t removals_in(const GrowthTrace& trace) {
  std::size_t count = 0;
  for (const GrowthTrace::Step& step : trace.steps) count += step.is_kill;
  return count;
}

void expect_equal_traces(const GrowthTrace& a, const GrowthTrace& b) {
  ASSERT_EQ(a.steps.size(), b.steps.size());
  for (std::size_t i = 0; i < a.steps.size(); ++i) {
    EXPECT_EQ(a.steps[i].is_kill, b.steps[i].is_kill) << "step " << i;
    EXPECT_EQ(a.steps[i].kill_distance, b.steps[i].kill_distance) << "step " << i;
    ASSERT_EQ(a.steps[i].nodes.size(), b.steps[i].nodes.size()) << "step " << i;
    for (std::size_t n = 0; n < a.steps[i].nodes.size(); ++n) {
      EXPECT_EQ(a.steps[i].nodes[n].position, b.steps[i].nodes[n].position) << "step " << i;
      EXPECT_EQ(a.steps[i].nodes[n].direction, b.steps[i].nodes[n].direction) << "step " << i;
    }
  }
}

TEST(GrowthTrace, HoldsTheCallsOfTheGrowthLoop) {
  const Seedling seedling = small_test_tree();
  const auto engine = engine_named("squared_scan").create();
  const GrowthResult grown = grow_crown(seedling, *engine);
  const GrowthTrace trace = trace_of(seedling);
  EXPECT_EQ(trace.setup.influence_distance, seedling.growth.influence_distance);
  EXPECT_EQ(trace.setup.perception_half_angle_rad, 0.5 * seedling.growth.perception_angle_rad);
  EXPECT_EQ(trace.setup.associations, seedling.growth.iterations);
  ASSERT_EQ(trace.steps.size(), 2 * grown.passes.size());
  for (std::size_t i = 0; i < trace.steps.size(); ++i) {
    EXPECT_EQ(trace.steps[i].is_kill, i % 2 == 1) << "step " << i;
    const int iteration = static_cast<int>(i / 2);
    if (i % 2 == 1)
      EXPECT_EQ(trace.steps[i].kill_distance,
                seedling.growth.kill_distance.at(iteration, seedling.growth.iterations));
  }
  // Every node is handed over once, but those of the last iteration.
  const auto& nodes = grown.skeleton.positions();
  const auto root = nodes.begin() + seedling.crown_root;
  const auto last = nodes.end() - static_cast<std::ptrdiff_t>(grown.passes.back().new_nodes);
  EXPECT_EQ(handed_to_association(trace), std::vector<Vector3>(root, last));
  EXPECT_GT(trace.steps.size(), 10u);
}

TEST(GrowthTrace, IsThatOfTheOptionItIsRecordedWith) {
  const Seedling seedling = small_test_tree();
  const GrowthTrace plain = trace_of(seedling);
  const GrowthTrace boxed = trace_of(seedling, {.options = loop_options_named("n")});
  const GrowthTrace deferred = trace_of(seedling, {.options = loop_options_named("d")});
  EXPECT_EQ(plain.setup.search_filter, PointFilter::none);
  EXPECT_EQ(boxed.setup.search_filter, PointFilter::bounding_box);
  expect_equal_traces(plain, boxed);
  EXPECT_FALSE(plain.steps[0].is_kill);
  EXPECT_TRUE(plain.steps[1].is_kill);
  EXPECT_EQ(removals_in(deferred) + 1, removals_in(plain)) << "the last one is left undone";
}

TEST(GrowthTraceLaw, DoesNotDependOnTheEngineOrTheThreads) {
  const Seedling seedling = small_test_tree();
  const GrowthTrace expected = trace_of(seedling);
  expect_equal_traces(record_trace(engine_named("node_driven"), seedling, {}), expected);
  expect_equal_traces(record_trace(engine_named("voxel_grid"), seedling, {.threads = 2}), expected);
}

TEST(Replay, GivesEqualHashesOnEveryEngineThatIsRight) {
  for (const Seedling& seedling : {small_test_tree(), on_lattice(5)})
    for (const std::string_view option : loop_option_names) {
      const GrowthTrace trace = trace_of(seedling, {.options = loop_options_named(option)});
      const Replay expected = replay_on("squared_scan", trace, seedling);
      ASSERT_EQ(expected.removal_hashes.size(), removals_in(trace));
      ASSERT_EQ(expected.assignment_hashes.size(), trace.steps.size() - removals_in(trace));
      for (const EngineDescriptor* engine : all_engines()) {
        if (!engine->built() || is_wrong_on_purpose(*engine)) continue;
        for (const int threads : {1, 2}) {
          const Replay replayed = replay(trace, *engine, seedling.attraction_points, threads);
          EXPECT_EQ(replayed.assignment_hashes, expected.assignment_hashes)
              << engine->name << ", option " << option << ", " << threads << " threads";
          EXPECT_EQ(replayed.removal_hashes, expected.removal_hashes)
              << engine->name << ", option " << option << ", " << threads << " threads";
        }
      }
    }
}

TEST(Replay, HashesDifferFromIterationToIterationOfAGrowingTree) {
  const Seedling seedling = small_test_tree();
  const auto engine = engine_named("squared_scan").create();
  const GrowthResult grown = grow_crown(seedling, *engine);
  const Replay replayed = replay_on("squared_scan", trace_of(seedling), seedling);
  const auto& assignments = replayed.assignment_hashes;
  EXPECT_GT(assignments.size(), 10u);
  EXPECT_EQ(std::set<std::uint64_t>(assignments.begin(), assignments.end()).size(),
            assignments.size());
  // Removals differ as well, but all those of nothing are equal.
  std::set<std::uint64_t> removals;
  std::size_t expected = 0, empty = 0;
  for (std::size_t i = 0; i < replayed.removal_hashes.size(); ++i) {
    const bool removes = grown.passes[i].removed_points > 0;
    (removes ? expected : empty) += 1;
    removals.insert(replayed.removal_hashes[i]);
  }
  EXPECT_GT(expected, 5u);
  EXPECT_EQ(removals.size(), expected + (empty > 0));
}

/// Writes down what it is asked, in the one place that its factory can reach.
class AskedEngine final : public NearestNodeEngine {
 public:
  static inline GrowthTrace asked;

  void reset(std::span<const Vector3> points, const EngineSetup& setup) override {
    asked = {.setup = setup, .steps = {}};
    inner_->reset(points, setup);
  }
  Assignment associate(std::span<const SearchableNode> nodes) override {
    asked.steps.push_back({false, 0.0, {nodes.begin(), nodes.end()}});
    return inner_->associate(nodes);
  }
  std::span<const PointIndex> kill(std::span<const SearchableNode> killers,
                                   double distance) override {
    asked.steps.push_back({true, distance, {killers.begin(), killers.end()}});
    return inner_->kill(killers, distance);
  }
  std::size_t live_points() const override { return inner_->live_points(); }
  WorkCounters counters() const override { return inner_->counters(); }

 private:
  std::unique_ptr<NearestNodeEngine> inner_ = engine_named("squared_scan").create();
};

TEST(Replay, AsksWhatTheGrowthAsked) {
  constexpr EngineDescriptor engine{.name = "asked",
                                    .create = []() -> std::unique_ptr<NearestNodeEngine> {
                                      return std::make_unique<AskedEngine>();
                                    }};
  const Seedling seedling = small_test_tree();
  for (const std::string_view option : loop_option_names) {
    const GrowthTrace trace = trace_of(seedling, {.options = loop_options_named(option)});
    for (const int threads : {1, 2}) {
      replay(trace, engine, seedling.attraction_points, threads);
      expect_equal_traces(AskedEngine::asked, trace);
      const EngineSetup& setup = AskedEngine::asked.setup;
      EXPECT_EQ(setup.threads, threads);
      EXPECT_EQ(setup.influence_distance, trace.setup.influence_distance);
      EXPECT_EQ(setup.perception_half_angle_rad, trace.setup.perception_half_angle_rad);
      EXPECT_EQ(setup.search_filter, trace.setup.search_filter);
      EXPECT_EQ(setup.kill_filter, trace.setup.kill_filter);
    }
  }
}

TEST(Replay, DoesNotChangeTheTrace) {
  const Seedling seedling = on_lattice(3);
  const GrowthTrace trace = trace_of(seedling);
  const Replay first = replay_on("node_driven", trace, seedling);
  expect_equal_traces(trace, trace_of(seedling));
  const Replay second = replay_on("node_driven", trace, seedling);
  EXPECT_EQ(second.assignment_hashes, first.assignment_hashes);
  EXPECT_EQ(second.removal_hashes, first.removal_hashes);
}

TEST(ReplayOfAWrongEngine, GivesOtherAssignmentsOrRemovals) {
  int wrong_engines = 0;
  const Seedling seedlings[] = {small_test_tree(), on_lattice(5)};
  for (const EngineDescriptor* engine : all_engines()) {
    if (!is_wrong_on_purpose(*engine)) continue;
    ++wrong_engines;
    bool differs = false;
    for (const Seedling& seedling : seedlings) {
      const GrowthTrace trace = trace_of(seedling);
      const Replay right = replay_on("squared_scan", trace, seedling);
      const Replay wrong = replay(trace, *engine, seedling.attraction_points, 1);
      differs |= wrong.assignment_hashes != right.assignment_hashes ||
                 wrong.removal_hashes != right.removal_hashes;
    }
    EXPECT_TRUE(differs) << engine->name;
  }
  EXPECT_EQ(wrong_engines, 4) << "faulty_engines.def did not reach the registry";
}

TEST(ReplayOfAWrongEngine, ShowsWrongTiesInTheAssignmentsAlone) {
  const Seedling seedling = on_lattice(5);
  const GrowthTrace trace = trace_of(seedling);
  const Replay right = replay_on("squared_scan", trace, seedling);
  const Replay wrong = replay_on("breaks_ties_upwards", trace, seedling);
  EXPECT_NE(wrong.assignment_hashes, right.assignment_hashes);
  EXPECT_EQ(wrong.removal_hashes, right.removal_hashes)
      << "what is removed does not depend on who is nearest";
}

TEST(ReplayOfAWrongEngine, ShowsAMissingRemovalInTheRemovalsAlone) {
  const Seedling seedling = small_test_tree();
  const GrowthTrace trace = trace_of(seedling);
  const Replay right = replay_on("squared_scan", trace, seedling);
  const Replay wrong = replay_on("kills_too_few", trace, seedling);
  EXPECT_EQ(wrong.assignment_hashes, right.assignment_hashes);
  EXPECT_NE(wrong.removal_hashes, right.removal_hashes);
}

TEST(Replay, OfNoPointsHasHashesOfNothing) {
  Seedling seedling = small_test_tree();
  seedling.attraction_points.clear();
  const GrowthTrace trace = trace_of(seedling);
  const Replay replayed = replay_on("node_driven", trace, seedling);
  EXPECT_EQ(replayed.assignment_hashes,
            replay_on("squared_scan", trace, seedling).assignment_hashes);
  EXPECT_EQ(replayed.assignment_hashes.size(), 1u);
  EXPECT_TRUE(replayed.removal_hashes.empty());
}

// Every engine holds at least a node index per point.
TEST(ReplayMemory, IsAtLeastWhatTheAssignmentTakes) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer's memory is not the C library's";
#endif
  const Seedling seedling = scaled_test_tree({.points = 20000.0, .iterations = 3}).seedling;
  const auto points = static_cast<double>(seedling.attraction_points.size());
  const GrowthTrace trace = trace_of(seedling);
  for (const EngineDescriptor* engine : all_engines()) {
    if (!engine->built() || is_wrong_on_purpose(*engine)) continue;
    const double bytes = replay(trace, *engine, seedling.attraction_points, 1).bytes;
    EXPECT_GE(bytes, points * sizeof(NodeIndex)) << engine->name;
    EXPECT_LT(bytes, points * 1000.0) << engine->name;
  }
}

}  // namespace
}  // namespace phytobench
