// SPDX-License-Identifier: MIT
#include "benchmarks/nearest_node/checked_growth.hpp"

#include <gtest/gtest.h>

#include "benchmarks/nearest_node/awkward_seedlings.hpp"
#include "benchmarks/nearest_node/engine_fixture.hpp"
#include "core/colonization/tree_parameters_file.hpp"
#include "core/nearest_node/engine_registry.hpp"
#include "core/nearest_node/plugin/engine_plugin.hpp"
#include "reference/tree_presets.hpp"

namespace phytobench {
namespace {

/// The thesis' own engines remove points by looking at every pair; others may know better.
bool is_row_of_table_1(const EngineDescriptor& engine) {
  return engine.source.starts_with("[Brzoska2019]");
}

std::vector<Vector3> flattened(std::vector<Vector3> points, double x, double z) {
  for (Vector3& point : points) point = {x * point.x, point.y, z * point.z};
  return points;
}

std::vector<NamedSeedling> workloads() {
  std::vector<NamedSeedling> all;
  all.push_back({"random", with_crown_stem(seedling_with(random_cube(900, 1.0), 0.5, 0.3, 15))});
  all.push_back({"lattice", with_crown_stem(seedling_with(lattice(4, 0.25), 0.5, 0.25, 10))});
  all.push_back({"duplicates", seedling_with(repeated(random_cube(200, 1.0)), 0.6, 0.3, 12)});
  all.push_back({"plane", seedling_with(flattened(random_cube(500, 1.0), 1.0, 0.0), 0.5, 0.3, 12)});
  all.push_back({"line", seedling_with(flattened(random_cube(60, 1.0), 0.0, 0.0), 0.5, 0.3, 12)});
  all.push_back({"one_point", seedling_with({{0.0, 0.5, 0.0}}, 0.5, 0.25, 5)});
  all.push_back({"no_point", seedling_with({}, 0.5, 0.25, 5)});
  all.push_back({"tiny_influence", seedling_with(random_cube(500, 1.0), 1e-9, 1e-9, 5)});
  all.push_back(
      {"infinite_influence", seedling_with(random_cube(300, 1.0), infinite_length, 0.3, 10)});
  all.push_back({"huge_coordinates", scaled_growth(1e12)});
  all.push_back({"tiny_coordinates", scaled_growth(1e-12)});
  return all;
}

TEST(EveryEngineOracle, AgreesOnEveryNamedSeedlingWithEveryOptionAndThreadCount) {
  for (const NamedSeedling& workload : workloads()) {
    const GrowthOracle oracle(workload.seedling);
    for (const EngineDescriptor* engine : all_engines()) {
      if (!engine->built() || is_wrong_on_purpose(*engine)) continue;
      for (const std::string_view option : loop_option_names)
        for (const int threads : {1, 2}) {
          const CheckedGrowth checked =
              grow_checked(*engine, workload.seedling, oracle,
                           {.options = loop_options_named(option), .threads = threads});
          EXPECT_TRUE(checked.verified.has_value())
              << workload.name << ", " << engine->name << ", option " << option << ", " << threads
              << " threads: " << checked.disagreement;
        }
    }
  }
}

TEST(EveryEngineOracle, NamedSeedlingsReallyGrowAndContestNodes) {
  for (const NamedSeedling& workload : workloads()) {
    const std::string name = workload.name;
    const bool grows = name != "no_point" && name != "tiny_influence";
    const GrowthOracle oracle(workload.seedling);
    const std::size_t start = start_nodes(workload.seedling).size();
    EXPECT_EQ(oracle.tree().nodes.size() > start, grows) << name;
  }
}

// A wrong engine enters by one file and one line, as any other; the check refuses it, and what is
// not verified has nothing that could be timed.
TEST(WrongEngine, IsRefusedBeforeItCanBeTimed) {
  int wrong_engines = 0;
  for (const EngineDescriptor* engine : all_engines()) {
    if (!is_wrong_on_purpose(*engine)) continue;
    ++wrong_engines;
    bool refused = false;
    for (const NamedSeedling& workload : workloads()) {
      const GrowthOracle oracle(workload.seedling);
      const CheckedGrowth checked = grow_checked(*engine, workload.seedling, oracle, {});
      EXPECT_EQ(checked.verified.has_value(), checked.disagreement.empty());
      refused |= !checked.verified.has_value();
    }
    EXPECT_TRUE(refused) << engine->name << " passed every workload";
  }
  EXPECT_EQ(wrong_engines, 4) << "faulty_engines.def did not reach the registry";
}

TEST(WrongEngine, IsReportedWithIterationPointNodesAndDistances) {
  const Seedling seedling = with_crown_stem(seedling_with(lattice(4, 0.25), 0.5, 0.25, 10));
  const GrowthOracle oracle(seedling);
  const CheckedGrowth checked =
      grow_checked(engine_named("breaks_ties_upwards"), seedling, oracle, {});
  for (const char* part :
       {"iteration ", "point ", "node ", "squared distance", "the judge has node "})
    EXPECT_NE(checked.disagreement.find(part), std::string::npos) << checked.disagreement;
}

// An engine from outside that is moody is no bug of this program.
TEST(VerifiedRun, OfAPluginIsNotTimedIfItsTreeIsAnotherThen) {
  const EnginePlugin plugin(PHYTOBENCH_EXAMPLE_PLUGINS "/faulty/changes_its_mind.so");
  const Seedling seedling = with_crown_stem(seedling_with(lattice(4, 0.25), 0.5, 0.25, 10));
  const GrowthOracle oracle(seedling);
  const CheckedGrowth checked = grow_checked(plugin.descriptor(), seedling, oracle, {});
  ASSERT_TRUE(checked.verified.has_value()) << checked.disagreement;
  EXPECT_NO_THROW(checked.verified->grow());
  EXPECT_THROW(checked.verified->grow(), PluginMisbehaved);
}

// Every reading of the thesis, grown by core and by the oracle, which share no code.
TEST(GrowthVariantOracle, EveryVariantGrowsTheOraclesTree) {
  TreeParameters base;
  base.cloud.radii = {2.0, 2.8, 1.8};
  base.iterations = 20;
  base.crown_stem_ratio = 0.6;
  std::vector<GrowthVariant> variants(6);
  variants[1].tropism_order = TropismOrder::after_normalising;
  variants[2].attraction_sum = AttractionSum::raw_vectors;
  variants[3].perception_test = PerceptionTest::after_search;
  variants[4].repeat_guard = RepeatGuard::off;
  variants[5].start_killers = StartKillers::crown_stem_too;
  std::vector<std::string> hashes;
  for (const GrowthVariant& variant : variants) {
    TreeParameters parameters = base;
    parameters.variant = variant;
    const Seedling seedling = make_seedling(parameters);
    const GrowthOracle oracle(seedling);
    const CheckedGrowth checked = grow_checked(engine_named("voxel_grid"), seedling, oracle, {});
    EXPECT_TRUE(checked.verified.has_value())
        << "variant " << hashes.size() << ": " << checked.disagreement;
    hashes.push_back(oracle.hash());
  }
  for (std::size_t i = 1; i < hashes.size(); ++i)
    EXPECT_NE(hashes[i], hashes[0]) << "variant " << i << " changes nothing";
}

TEST(DeferredMistakeOracle, GrowTheOraclesWrongTrees) {
  TreeParameters parameters;
  parameters.cloud.radii = {2.0, 2.8, 1.8};
  parameters.iterations = 20;
  for (const bool current_distance : {false, true})
    for (const bool first_pass : {false, true}) {
      parameters.variant.deferred_kill_distance = current_distance
                                                      ? DeferredKillDistance::current_iteration
                                                      : DeferredKillDistance::previous_iteration;
      parameters.variant.deferred_first_pass =
          first_pass ? DeferredFirstPass::kill : DeferredFirstPass::skip;
      const Seedling seedling = make_seedling(parameters);
      auto problem = oracle_problem(seedling);
      problem.deferred = {.enabled = true,
                          .first_pass_removes_nothing = !first_pass,
                          .uses_previous_kill_distance = !current_distance};
      const auto truth = oracles::brzoska2019::grow(problem);
      const auto engine = engine_named("squared_scan").create();
      const GrowthResult grown =
          grow_crown(seedling, *engine, {.options = loop_options_named("d")});
      ASSERT_EQ(grown.skeleton.node_count() - static_cast<std::size_t>(seedling.crown_root),
                truth.nodes.size());
      for (std::size_t i = 0; i < truth.nodes.size(); ++i) {
        const Vector3& position =
            grown.skeleton.position(seedling.crown_root + static_cast<std::int32_t>(i));
        ASSERT_EQ(position, (Vector3{truth.nodes[i].x, truth.nodes[i].y, truth.nodes[i].z}));
      }
    }
}

// The thesis' own test tree: published 5200 edges, and the evaluations derived for a plain scan.
TEST(TestTreeSlow, HasThePublishedEdgesForEveryEngineAndOption) {
  const Seedling seedling = make_seedling(read_tree_parameters(tree_preset_file("figure-51")));
  EXPECT_EQ(seedling.attraction_points.size(), 25298u);
  const GrowthOracle oracle(seedling);
  for (const EngineDescriptor* engine : all_engines()) {
    if (!engine->built() || is_wrong_on_purpose(*engine)) continue;
    for (const std::string_view option : loop_option_names) {
      const CheckedGrowth checked = grow_checked(
          *engine, seedling, oracle, {.options = loop_options_named(option), .threads = 2});
      ASSERT_TRUE(checked.verified.has_value()) << engine->name << ": " << checked.disagreement;
      EXPECT_EQ(checked.result.skeleton.edge_count(), 5200u);
      EXPECT_EQ(checked.result.passes.size(), 40u);
      const std::uint64_t kills = option == "s" || option == "n" ? 115177619u
                                  : option == "d"                ? 96043881u
                                                                 : 52823785u;
      if (is_row_of_table_1(*engine))
        EXPECT_EQ(checked.result.work.kill_evaluations, kills) << engine->name << " " << option;
      if (engine->name != "squared_scan") continue;
      const bool boxed = option == "n" || option == "dn";
      EXPECT_EQ(checked.result.work.search_evaluations, boxed ? 237628148u : 454287315u);
    }
  }
}

}  // namespace
}  // namespace phytobench
