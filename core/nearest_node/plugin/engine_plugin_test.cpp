// SPDX-License-Identifier: MIT
#include "core/nearest_node/plugin/engine_plugin.hpp"

#include <unistd.h>

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/nearest_node/engine_registry.hpp"
#include "core/nearest_node/plugin/floating_point_control.hpp"
#include "core/nearest_node/plugin/phytobench_engine.h"
#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const fs::path built = PHYTOBENCH_EXAMPLE_PLUGINS;

fs::path faulty(const std::string& name) {
  return built / "faulty" / (name + ".so");
}

const fs::path good_plugin = built / "nearest_scan.so";

std::string refusal_of(const fs::path& file) {
  try {
    const EnginePlugin plugin(file);
  } catch (const InputError& error) {
    return error.what();
  }
  return "it was accepted";
}

std::vector<Vector3> random_points(std::size_t count, std::uint64_t stream) {
  CounterStream numbers(5, stream);
  std::vector<Vector3> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = numbers.next_between(-1.0, 1.0);
    const double y = numbers.next_between(-1.0, 1.0);
    const double z = numbers.next_between(-1.0, 1.0);
    points.push_back({x, y, z});
  }
  return points;
}

/// Three batches of nodes that look in different directions; the second repeats the first.
std::vector<std::vector<SearchableNode>> node_batches() {
  std::vector<std::vector<SearchableNode>> batches(3);
  for (std::size_t batch = 0; batch < batches.size(); ++batch)
    for (const Vector3& position : random_points(20, batch == 2 ? 2 : 1))
      batches[batch].push_back({position, position / norm(position)});
  return batches;
}

std::vector<NodeIndex> nodes_of(const Assignment& assignment) {
  return {assignment.node.begin(), assignment.node.end()};
}

std::vector<PointIndex> ascending(std::span<const PointIndex> points) {
  std::vector<PointIndex> sorted(points.begin(), points.end());
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

/// Asks both the same and compares all they say.
void expect_same_answers(NearestNodeEngine& engine, NearestNodeEngine& trusted,
                         const EngineSetup& setup) {
  const std::vector<Vector3> points = random_points(900, 0);
  engine.reset(points, setup);
  trusted.reset(points, setup);
  for (const auto& batch : node_batches()) {
    const Assignment answer = engine.associate(batch), truth = trusted.associate(batch);
    EXPECT_EQ(nodes_of(answer), nodes_of(truth));
    for (PointIndex point = 0; point < 900; ++point)
      EXPECT_EQ(answer.associated.contains(point), truth.associated.contains(point)) << point;
    EXPECT_EQ(ascending(engine.kill(batch, 0.15)), ascending(trusted.kill(batch, 0.15)));
    EXPECT_EQ(engine.live_points(), trusted.live_points());
  }
  EXPECT_LT(engine.live_points(), points.size()) << "nothing was removed";
}

TEST(EnginePluginLoad, GivesADescriptorLikeThatOfAnyEngine) {
  const EnginePlugin plugin(good_plugin);
  const EngineDescriptor& engine = plugin.descriptor();
  EXPECT_EQ(engine.name, "nearest_scan");
  EXPECT_EQ(engine.summary, "Compares every live point with every new node, once.");
  EXPECT_EQ(engine.source, "plugin nearest_scan.so");
  EXPECT_EQ(plugin.file(), good_plugin.string());
  EXPECT_TRUE(engine.built());
  EXPECT_FALSE(engine.uses_point_filter);
  const EngineDescriptor copy = engine;
  EXPECT_TRUE(copy.create() != nullptr);
}

TEST(EnginePluginLoad, RefusesWhatIsNoEngineAndSaysWhy) {
  const std::pair<const char*, const char*> cases[] = {
      {"no_symbol", "exports no function phytobench_engine()"},
      {"no_table", "gives no table"},
      {"wrong_abi", "was built for version 2 of the interface, but this program has 1"},
      {"short_table", "its table has 8 bytes"},
      {"bad_name", "'Nearest Scan' is not made of a-z"},
      {"taken_name", "'voxel_grid', as one of this program's"},
      {"no_summary", "has no summary"},
      {"no_associate", "lacks associate()"},
      {"rounds_when_loaded", "changes the floating-point environment when it is loaded"}};
  for (const auto& [name, part] : cases) {
    const std::string refusal = refusal_of(faulty(name));
    EXPECT_THAT(refusal, HasSubstr(part));
    EXPECT_THAT(refusal, HasSubstr(std::string(name) + ".so'")) << "the file is not named";
  }
}

TEST(EnginePluginLoad, LeavesTheFloatingPointEnvironmentAsItWas) {
  const FloatingPointControl before;
  refusal_of(faulty("rounds_when_loaded"));
  EXPECT_TRUE(before.is_in_force());
}

// Newer and older plugins of one version of the interface differ in nothing but the table's end.
TEST(EnginePluginLoad, TakesLongerTablesAndThoseThatEndAfterDestroy) {
  const EnginePlugin longer(faulty("longer_table")), shorter(faulty("shorter_table"));
  EXPECT_TRUE(longer.table().last_error != nullptr);
  EXPECT_TRUE(shorter.table().destroy != nullptr);
  EXPECT_TRUE(shorter.table().last_error == nullptr) << "read beyond the table's end";
}

TEST(EnginePluginLoad, RefusesFilesThatAreNoLibrary) {
  const fs::path folder =
      fs::path(testing::TempDir()) / ("phytobench_plugin_" + std::to_string(::getpid()));
  fs::create_directories(folder);
  std::ofstream(folder / "text.so") << "no library\n";
  EXPECT_THAT(refusal_of(folder / "text.so"), HasSubstr("cannot be loaded ("));
  EXPECT_THAT(refusal_of(folder / "text.so"), testing::Not(HasSubstr("\n")));
  EXPECT_THAT(refusal_of(folder), HasSubstr("is no file"));
  EXPECT_THAT(refusal_of(folder / "nothing.so"), HasSubstr("there is no such file"));
  EXPECT_THAT(refusal_of(""), HasSubstr("there is no such file"));
  fs::remove_all(folder);
}

// A bare name must not be looked for where the system keeps its libraries.
TEST(EnginePluginLoad, LooksOnlyWhereItIsTold) {
  EXPECT_THAT(refusal_of("libm.so.6"), HasSubstr("there is no such file"));
}

TEST(PluginEngineOracle, AnswersAsTheLiteralScanDoes) {
  constexpr double pi = std::numbers::pi, infinity = std::numeric_limits<double>::infinity();
  for (const fs::path& file : {good_plugin, faulty("removing")}) {
    const EnginePlugin plugin(file);
    const auto engine = plugin.descriptor().create();
    const auto trusted = engine_named("squared_scan").create();
    for (const double influence : {0.4, infinity})
      for (const double half_angle : {0.4 * pi, pi})
        for (const int threads : {1, 2}) {
          SCOPED_TRACE(testing::Message() << file << " " << influence << " " << half_angle);
          expect_same_answers(*engine, *trusted,
                              {.influence_distance = influence,
                               .perception_half_angle_rad = half_angle,
                               .threads = threads});
        }
  }
}

TEST(PluginEngine, LivesWithoutPoints) {
  const EnginePlugin plugin(good_plugin);
  const auto engine = plugin.descriptor().create();
  engine->reset({}, {.influence_distance = 1.0, .perception_half_angle_rad = 1.0});
  const SearchableNode node{{0, 0, 0}, {0, 1, 0}};
  EXPECT_TRUE(engine->associate({&node, 1}).node.empty());
  EXPECT_TRUE(engine->kill({&node, 1}, 0.5).empty());
}

std::string misbehaviour_of(const std::string& name) {
  const EnginePlugin plugin(faulty(name));
  const auto engine = plugin.descriptor().create();
  const std::vector<Vector3> points = {{0, 0.5, 0}, {0, 1, 0}, {5, 5, 5}};
  const SearchableNode node{{0, 0, 0}, {0, 1, 0}};
  try {
    engine->reset(points, {.influence_distance = 2.0, .perception_half_angle_rad = 1.0});
    engine->associate({&node, 1});
    engine->kill({&node, 1}, 0.75);
  } catch (const PluginMisbehaved& misbehaved) {
    return misbehaved.what();
  }
  return "nothing was noticed";
}

TEST(PluginEngine, ReportsWhatCannotBe) {
  const std::pair<const char*, const char*> cases[] = {
      {"node_beyond", "iteration 0, point 0: node 1, which does not exist (there are 1)"},
      {"node_negative", "iteration 0, point 0: node -2, which does not exist"},
      {"removed_twice", "removal 0: point 0 twice, or removed before"},
      {"removed_beyond", "removal 0: point 3, which does not exist"},
      {"too_many", "removal 0: 4 points, but only 3 are left"},
      {"reports_failure", "associate() in iteration 0 failed: out of memory"},
      {"creates_nothing", "create() failed: out of memory"},
      {"rounds_upward", "associate() in iteration 0 changes the floating-point environment"},
      {"flushes_denormals", "create() changes the floating-point environment"}};
  for (const auto& [name, message] : cases)
    EXPECT_THAT(misbehaviour_of(name), HasSubstr(message)) << name;
  EXPECT_EQ(misbehaviour_of("removing"), "nothing was noticed");
}

TEST(PluginEngine, LetsNobodyElseRoundOtherwise) {
  const FloatingPointControl before;
  for (const char* name : {"rounds_upward", "flushes_denormals", "rounds_at_the_end"}) {
    misbehaviour_of(name);
    EXPECT_TRUE(before.is_in_force()) << name;
  }
  EXPECT_EQ(std::fegetround(), FE_TONEAREST);
}

TEST(PluginEngine, ReportsAtTheNextStartWhatDestroyChanged) {
  const EnginePlugin plugin(faulty("rounds_at_the_end"));
  const auto engine = plugin.descriptor().create();
  const EngineSetup setup{.influence_distance = 2.0, .perception_half_angle_rad = 1.0};
  engine->reset({}, setup);
  try {
    engine->reset({}, setup);
    ADD_FAILURE() << "nothing was noticed";
  } catch (const PluginMisbehaved& misbehaved) {
    EXPECT_STREQ(misbehaved.what(), "destroy() changes the floating-point environment");
  }
}

TEST(PluginWatch, SeesEveryCallAndReturn) {
  PluginPulse pulse;
  const EnginePlugin plugin(good_plugin, {.pulse = &pulse, .plugin = 3});
  EXPECT_EQ(pulse.call.load(), PluginCall::load);
  EXPECT_EQ(pulse.plugin.load(), 3);
  const std::uint64_t loaded = pulse.beats;
  EXPECT_GT(loaded, 0u);
  auto engine = plugin.descriptor().create();
  const std::vector<Vector3> points = {{0, 0.5, 0}};
  engine->reset(points, {.influence_distance = 2.0, .perception_half_angle_rad = 1.0});
  const SearchableNode node{{0, 0, 0}, {0, 1, 0}};
  engine->associate({&node, 1});
  engine->associate({});
  EXPECT_EQ(pulse.call.load(), PluginCall::associate);
  EXPECT_EQ(pulse.number.load(), 1);
  EXPECT_EQ(pulse.beats.load() - loaded, 6u);
  engine->kill({&node, 1}, 0.75);
  EXPECT_EQ(pulse.call.load(), PluginCall::removed);
  EXPECT_EQ(pulse.number.load(), 0);
  engine.reset();
  EXPECT_EQ(pulse.call.load(), PluginCall::destroy);
  EXPECT_FALSE(pulse.is_inside.load());
}

TEST(PluginHeader, HelpersRoundAsTheSuiteDoes) {
  const phytobench_setup setup{.influence_distance = 1.0,
                               .squared_reach = 1.0,
                               .perception_half_angle_rad = 1.2,
                               .cosine = std::cos(1.2)};
  const std::vector<Vector3> a = random_points(300, 7), b = random_points(300, 8);
  for (std::size_t i = 0; i < a.size(); ++i) {
    const phytobench_vector from{a[i].x, a[i].y, a[i].z}, to{b[i].x, b[i].y, b[i].z};
    const double squared = phytobench_squared_distance(&from, &to);
    EXPECT_EQ(squared, squared_distance(a[i], b[i]));
    const phytobench_node node{from, {0, 1, 0}};
    EXPECT_EQ(phytobench_perceives(&setup, &node, &to, squared) != 0,
              squared <= 1.0 && dot({0, 1, 0}, b[i] - a[i]) >= std::cos(1.2) * std::sqrt(squared));
  }
}

TEST(PlainLine, IsShortPrintableAndOne) {
  EXPECT_EQ(plain_line("a\nb\tc\x80"), "a b c ");
  EXPECT_EQ(plain_line(nullptr), "");
  EXPECT_EQ(plain_line(std::string(1000, 'x').c_str()).size(), 200u);
}

}  // namespace
}  // namespace phytobench
