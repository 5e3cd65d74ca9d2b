// SPDX-License-Identifier: MIT
#include "benchmarks/nearest_node/unusual_calls.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/nearest_node/engine_registry.hpp"
#include "core/nearest_node/plugin/engine_plugin.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;

std::string wrong_in(const std::string& name) {
  const EnginePlugin plugin(PHYTOBENCH_EXAMPLE_PLUGINS "/faulty/" + name + ".so");
  return wrong_in_unusual_calls(plugin.descriptor());
}

TEST(UnusualCalls, AreNothingToAnEngineOfTheProgram) {
  EXPECT_EQ(wrong_in_unusual_calls(engine_named("voxel_grid")), "");
}

TEST(UnusualCalls, AreNothingToAGoodPlugin) {
  const EnginePlugin plugin(PHYTOBENCH_EXAMPLE_PLUGINS "/nearest_scan.so");
  EXPECT_EQ(wrong_in_unusual_calls(plugin.descriptor()), "");
  EXPECT_EQ(wrong_in("removing"), "");
}

TEST(UnusualCalls, FindWhatNoGrowthDoes) {
  EXPECT_THAT(wrong_in("global_state"), HasSubstr("two engines in turns: iteration "));
  EXPECT_THAT(wrong_in("needs_points"), HasSubstr("no points: create() failed"));
  EXPECT_THAT(wrong_in("needs_nodes"),
              HasSubstr("two engines in turns: associate() in iteration 0 failed"));
  EXPECT_THAT(wrong_in("needs_one_thread"), HasSubstr("two engines in turns: create() failed"));
}

}  // namespace
}  // namespace phytobench
