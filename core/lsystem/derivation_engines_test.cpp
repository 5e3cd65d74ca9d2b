// SPDX-License-Identifier: MIT
// Every engine of derivation_engines.def times many systems, against a literal turtle.
#include "core/lsystem/derivation_engine.hpp"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/lsystem/test_literal_turtle.hpp"
#include "core/lsystem/test_systems.hpp"
#include "core/lsystem/turtle.hpp"

namespace phytobench {
namespace {

using Collected = std::vector<SpatialSegment>;

class DerivationEnginesOracle : public testing::TestWithParam<const DerivationEngine*> {
 protected:
  const DerivationEngine& engine() const { return *GetParam(); }

  void SetUp() override {
    if (!engine().built()) GTEST_SKIP() << engine().missing_package << " was not found";
  }
};

TEST_P(DerivationEnginesOracle, DrawWhatTheLiteralTurtleDraws) {
  for (const auto& [system, steps] : all_test_cases()) {
    ASSERT_EQ(engine().objection(system), "") << system.source;
    const LiteralDrawing expected = literal_drawing(system, steps);
    Collected found;
    engine().draw(system, steps, 1, collector<SpatialSegment>(found));
    EXPECT_EQ(difference_from(expected, found), "") << system.source;
    if (!is_planar(system)) continue;
    Collected planar;
    engine().draw_planar(system, steps, 1, collector<PlanarSegment>(planar));
    EXPECT_EQ(difference_from(expected, planar), "") << system.source << " in the plane";
  }
}

TEST_P(DerivationEnginesOracle, GiveTheSameBitsForAnyNumberOfThreads) {
  for (const auto& [system, steps] : all_test_cases()) {
    Collected one;
    engine().draw(system, steps, 1, collector<SpatialSegment>(one));
    for (const int threads : {2, 3, 7}) {
      Collected several;
      engine().draw(system, steps, threads, collector<SpatialSegment>(several));
      EXPECT_TRUE(are_equal(one, several)) << system.source;
    }
  }
}

TEST_P(DerivationEnginesOracle, HandOverFewEnoughForACache) {
  const LSystem system = test_system("island", "F-F-F-F", {{'F', "F-F+F+FF-F-F+F"}}, 90);
  std::size_t most = 0;
  engine().draw_planar(system, 5, 1, [&](std::span<const PlanarSegment> block) {
    most = std::max(most, block.size());
  });
  EXPECT_LE(most * sizeof(PlanarSegment), 128u * 1024);
  EXPECT_GT(most, 0u);
}

std::string name_of_engine(const testing::TestParamInfo<const DerivationEngine*>& info) {
  return std::string(info.param->name);
}

INSTANTIATE_TEST_SUITE_P(All, DerivationEnginesOracle,
                         testing::ValuesIn(all_derivation_engines().begin(),
                                           all_derivation_engines().end()),
                         name_of_engine);

TEST(DerivationEnginesOracle, ThoseThatWriteWriteWhatTheyDraw) {
  std::size_t compared = 0;
  for (const DerivationEngine* engine : all_derivation_engines()) {
    if (!engine->built() || engine->write == nullptr) continue;
    for (const auto& [system, steps] : all_test_cases()) {
      Collected drawn;
      engine->draw(system, steps, 1, collector<SpatialSegment>(drawn));
      Collected written(drawn.size());
      engine->write(system, steps, 1, written);
      EXPECT_TRUE(are_equal(drawn, written)) << engine->name << " " << system.source;
      ++compared;
    }
  }
  EXPECT_GT(compared, 20u);
}

TEST(DerivationEnginesOracle, TheComparisonSeesWhatIsWrong) {
  const LSystem system = test_system("plant", "F", {{'F', "F[+F]F"}}, 30);
  const LiteralDrawing expected = literal_drawing(system, 4);
  Collected right;
  derivation_engine_named("string_rewriting").draw(system, 4, 1, collector<SpatialSegment>(right));
  ASSERT_EQ(difference_from(expected, right), "");
  Collected wrong = right;
  wrong.pop_back();
  EXPECT_NE(difference_from(expected, wrong), "");
  wrong = right;
  std::swap(wrong[3], wrong[4]);
  EXPECT_NE(difference_from(expected, wrong), "");
  wrong = right;
  wrong.back().to.y += 1e-10;
  EXPECT_NE(difference_from(expected, wrong), "");
  wrong = right;
  wrong.front().from.z = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(difference_from(expected, wrong), "");
}

TEST(DerivationEngineRegistry, NamesAreUniqueAndUnknownOnesAreRefused) {
  std::set<std::string_view> names;
  for (const DerivationEngine* engine : all_derivation_engines()) {
    EXPECT_TRUE(names.insert(engine->name).second) << engine->name;
    EXPECT_TRUE(engine->summary.ends_with('.')) << engine->name;
    EXPECT_FALSE(engine->source.empty()) << engine->name;
    EXPECT_EQ(engine->built(), engine->missing_package.empty()) << engine->name;
  }
  EXPECT_GE(names.size(), 3u);
  EXPECT_THROW(derivation_engine_named("memoized"), InputError);
}

}  // namespace
}  // namespace phytobench
