// SPDX-License-Identifier: MIT
#include "benchmarks/lsystem/lsystem_race.hpp"

#include <algorithm>
#include <map>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmarks/lsystem/drawing_judge.hpp"
#include "core/contract/errors.hpp"
#include "reference/oracles/lsystem_closed_forms.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;
using State = DrawingEntry::State;

/// Engines that are wrong on purpose, each in one way: they change what `memoised` draws.
using Change = void (*)(std::uint64_t place, PlanarSegment& segment);

template <Change change>
DrawingWork draw_changed(const LSystem& system, int steps, int /*threads*/,
                         const SegmentSink<PlanarSegment>& sink) {
  std::uint64_t place = 0;
  std::vector<PlanarSegment> copy;
  SegmentStream(system, steps)
      .stream(SegmentSink<PlanarSegment>([&](std::span<const PlanarSegment> block) {
        copy.assign(block.begin(), block.end());
        for (PlanarSegment& segment : copy) change(place++, segment);
        sink(copy);
      }));
  return {};
}

constexpr std::uint64_t in_the_middle = 100'000;

void move_one(std::uint64_t place, PlanarSegment& segment) {
  if (place == in_the_middle) segment.to_x += 1.0;
}
void forget_one(std::uint64_t place, PlanarSegment& segment) {
  if (place == in_the_middle) segment = {};
}
void turn_round(std::uint64_t, PlanarSegment& segment) {
  std::swap(segment.from_x, segment.to_x);
  std::swap(segment.from_y, segment.to_y);
}
void make_no_number(std::uint64_t place, PlanarSegment& segment) {
  if (place == in_the_middle) segment.from_y = std::numeric_limits<double>::quiet_NaN();
}

DrawingWork draw_swapped(const LSystem& system, int steps, int /*threads*/,
                         const SegmentSink<PlanarSegment>& sink) {
  std::vector<PlanarSegment> all;
  SegmentStream(system, steps)
      .stream(SegmentSink<PlanarSegment>([&](std::span<const PlanarSegment> block) {
        all.insert(all.end(), block.begin(), block.end());
      }));
  std::swap(all[in_the_middle], all[in_the_middle + 1]);
  sink(all);
  return {};
}

DrawingWork draw_less(const LSystem& system, int steps, int /*threads*/,
                      const SegmentSink<PlanarSegment>& sink) {
  SegmentStream(system, steps)
      .stream(SegmentSink<PlanarSegment>(
          [&](std::span<const PlanarSegment> block) { sink(block.first(block.size() - 1)); }));
  return {};
}

DrawingWork draw_nothing(const LSystem&, int, int, const SegmentSink<SpatialSegment>&) {
  return {};
}
std::string no_objection(const LSystem&) {
  return "";
}

DerivationEngine faulty(std::string_view name,
                        DrawingWork (*draw)(const LSystem&, int, int,
                                            const SegmentSink<PlanarSegment>&)) {
  DerivationEngine engine;
  engine.name = name;
  engine.objection = no_objection;
  engine.draw = draw_nothing;
  engine.draw_planar = draw;
  return engine;
}

DrawingRaceResult raced(const LSystemWorkload& workload,
                        const std::vector<const DerivationEngine*>& engines) {
  DrawingRaceRequest request;
  request.workload = &workload;
  request.contestants = drawing_contestants(engines, {1, 2});
  request.rounds = 2;
  return race_drawings(request);
}

std::vector<const DerivationEngine*> everyone() {
  const auto all = all_derivation_engines();
  return {all.begin(), all.end()};
}

TEST(LSystemRace, TimesEveryEngineOnEverySystem) {
  for (const BenchSystem& system : bench_systems()) {
    const LSystemWorkload workload = lsystem_workload(std::string(system.name), 70'000);
    const DrawingRaceResult result = raced(workload, everyone());
    EXPECT_TRUE(result.planar) << system.name;
    EXPECT_GE(result.entries.size(), 2 * everyone().size() + 2) << system.name;
    for (const DrawingEntry& entry : result.entries) {
      EXPECT_EQ(entry.state, State::timed)
          << system.name << " " << entry.engine->name << ": " << entry.objection;
      EXPECT_EQ(entry.seconds.size(), 2u) << system.name << " " << entry.engine->name;
      EXPECT_GT(entry.bytes_held, 0u) << system.name << " " << entry.engine->name;
    }
  }
}

TEST(LSystemRace, GivesNoTimeForAWrongAnswer) {
  const LSystemWorkload workload = lsystem_workload("gosper_curve", 300'000);
  ASSERT_GT(workload.segments, in_the_middle + 1);
  const DerivationEngine wrong[] = {
      faulty("moves one", draw_changed<move_one>),
      faulty("forgets one", draw_changed<forget_one>),
      faulty("turns them round", draw_changed<turn_round>),
      faulty("makes no number", draw_changed<make_no_number>),
      faulty("swaps two", draw_swapped),
      faulty("draws less", draw_less),
  };
  std::vector<const DerivationEngine*> engines;
  for (const DerivationEngine& engine : wrong) engines.push_back(&engine);
  const DrawingRaceResult result = raced(workload, engines);
  EXPECT_EQ(result.entries.size(), 2 * std::size(wrong));
  for (const DrawingEntry& entry : result.entries) {
    EXPECT_EQ(entry.state, State::wrong) << entry.engine->name << " " << name_of(entry.lane);
    EXPECT_NE(entry.objection, "") << entry.engine->name;
    EXPECT_TRUE(entry.seconds.empty()) << entry.engine->name;
  }
  EXPECT_THAT(result.entries.front().objection, HasSubstr("segments from 65536 on"));
}

TEST(LSystemRace, SaysWhyAnEngineIsLeftOut) {
  const LSystemWorkload workload = lsystem_workload("bush", 1'000);
  DerivationEngine picky = faulty("picky", draw_less);
  picky.objection = [](const LSystem&) { return std::string("does not like it"); };
  DerivationEngine helpless = faulty("helpless", draw_less);
  helpless.draw_planar = [](const LSystem&, int, int,
                            const SegmentSink<PlanarSegment>&) -> DrawingWork {
    throw InputError("too long a word");
  };
  const DerivationEngine missing{.name = "missing", .missing_package = "package"};
  for (const DrawingEntry& entry : raced(workload, {&picky, &helpless, &missing}).entries) {
    EXPECT_EQ(entry.state, entry.engine->built() ? State::refused : State::not_built);
    EXPECT_EQ(entry.objection.empty(), !entry.engine->built());
    EXPECT_TRUE(entry.seconds.empty());
  }
}

TEST(LSystemRace, StopsWhenAsked) {
  const LSystemWorkload workload = lsystem_workload("bush", 1'000);
  DrawingRaceRequest request;
  request.workload = &workload;
  request.contestants = drawing_contestants(everyone(), {1});
  request.is_interrupted = [] { return true; };
  EXPECT_THROW(race_drawings(request), Interrupted);
}

/// With 2e8 segments at most they are what was timed: 50 to 168 million. Each number from the
/// productions by hand.
TEST(LSystemWorkload, PublishedSystemsAreAsLargeAsWhereTheyWerePublished) {
  const auto power = oracles::whole_power;
  const std::map<std::string, std::uint64_t> segments = {
      {"sierpinski_arrowhead", power(3, 17)},
      {"sierpinski_triangle", power(3, 17)},
      {"dragon_every_letter", power(2, 27)},
      {"barnsley_fern", power(4, 13) + 3 * (power(4, 13) - power(2, 13)) / 2},
      {"sticks", 2 * (power(3, 16) - power(2, 16))},
      {"hilbert", power(4, 13) - 1},
      {"pentaplexity", 5 * power(6, 9)},
  };
  ASSERT_EQ(published_systems().size(), segments.size());
  std::uint64_t least = ~std::uint64_t{0}, most = 0;
  for (const BenchSystem& system : published_systems()) {
    const LSystemWorkload workload = lsystem_workload(std::string(system.name), 2e8);
    EXPECT_EQ(workload.steps, system.published_steps) << system.name;
    EXPECT_EQ(workload.segments, segments.at(workload.name)) << system.name;
    least = std::min(least, workload.segments);
    most = std::max(most, workload.segments);
  }
  EXPECT_EQ(least, 50'388'480u);
  EXPECT_EQ(most, 167'759'872u);
}

TEST(LSystemRace, TimesThePublishedSystemsToo) {
  for (const BenchSystem& system : published_systems()) {
    const LSystemWorkload workload = lsystem_workload(std::string(system.name), 20'000);
    for (const DrawingEntry& entry : raced(workload, everyone()).entries)
      EXPECT_EQ(entry.state, State::timed)
          << system.name << " " << entry.engine->name << ": " << entry.objection;
  }
}

TEST(LSystemWorkload, HasAsManySegmentsAsAskedForAtMost) {
  const LSystemWorkload island = lsystem_workload("koch_island", 2'048);
  EXPECT_EQ(island.steps, 3);
  EXPECT_EQ(island.segments, 2'048u);
  EXPECT_EQ(island.modules, 3'803u);  // [Liebemann2017] fig. 2.4
  EXPECT_EQ(lsystem_workload("koch_island", 2'047).steps, 2);
  EXPECT_THROW(lsystem_workload("koch_island", 3), InputError);
  EXPECT_THROW(lsystem_workload("koch_iland", 1e6), InputError);
}

}  // namespace
}  // namespace phytobench
