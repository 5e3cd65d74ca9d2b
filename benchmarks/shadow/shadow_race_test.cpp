// SPDX-License-Identifier: MIT
#include "benchmarks/shadow/shadow_race.hpp"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmarks/shadow/shadow_judge.hpp"
#include "core/contract/errors.hpp"
#include "core/terrain/shadow/shadow_registry.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;
using State = ShadowEntry::State;

std::vector<ShadowContestant> every_shadow_engine() {
  std::vector<ShadowContestant> all;
  for (const ShadowEngineDescriptor* engine : all_shadow_engines()) all.push_back({engine, 1});
  return all;
}

bool is_faulty(const ShadowEngineDescriptor& engine) {
  return engine.summary.starts_with("Wrong on purpose");
}

ShadowRaceResult raced_shadows(const FractalShadows& terrain,
                               std::vector<ShadowContestant> contestants, double budget_s = 1e6) {
  const ShadowWorkload workload = fractal_shadows(terrain);
  return race_shadows({.workload = &workload,
                       .contestants = std::move(contestants),
                       .budget_s = budget_s,
                       .rounds = 2});
}

TEST(ShadowRace, TimesWhatIsRightOrKnownToApproximateAndRefusesWhatIsWrong) {
  for (const FractalShadows& terrain :
       {FractalShadows{.size = 100, .relief = 200.0, .seed = 1},
        FractalShadows{.size = 65, .relief = 400.0, .hours = 7, .seed = 2}}) {
    const ShadowRaceResult result = raced_shadows(terrain, every_shadow_engine());
    std::size_t refused = 0;
    for (const ShadowEntry& entry : result.entries) {
      const bool faulty = is_faulty(*entry.engine);
      EXPECT_EQ(entry.state, faulty ? State::wrong : State::timed)
          << entry.name() << ": " << entry.disagreement;
      EXPECT_EQ(entry.seconds.size(), faulty ? 0u : 2u) << entry.name();
      if (!faulty) EXPECT_EQ(entry.wrong_share > 0.0, !entry.engine->exact) << entry.name();
      EXPECT_GT(entry.work.samples + entry.work.blocks, 0u) << entry.name();
      refused += faulty;
    }
    EXPECT_EQ(refused, 3u);
    EXPECT_GT(result.lit, 0u);
  }
}

TEST(ShadowRace, SaysWhatIsWrong) {
  const ShadowRaceResult result =
      raced_shadows({.size = 100, .relief = 200.0, .seed = 1}, every_shadow_engine());
  const auto said_of = [&](std::string_view name) {
    for (const ShadowEntry& entry : result.entries)
      if (entry.engine->name == name) return entry.disagreement;
    return std::string("is not there");
  };
  EXPECT_THAT(said_of("forgets_one_vertex"), HasSubstr("1 of 130000 vertex-hours; in hour "));
  EXPECT_THAT(said_of("forgets_one_vertex"), HasSubstr("dark, but in the sun"));
  EXPECT_THAT(said_of("looks_too_near"), HasSubstr("lit, but hidden"));
  EXPECT_THAT(said_of("takes_near_vertices"), HasSubstr(" vertex-hours; in hour "));
}

TEST(ShadowRace, SkipsWhatWouldTakeTooLong) {
  const ShadowRaceResult result =
      raced_shadows({.size = 600, .relief = 400.0, .hours = 3},
                    {{&shadow_engine_named("exact_traversal"), 1}}, 1e-9);
  EXPECT_EQ(result.entries[0].state, State::skipped);
  EXPECT_GT(result.entries[0].predicted_s, 1e-9);
}

TEST(ShadowRace, StopsWhenAskedTo) {
  const ShadowWorkload workload = fractal_shadows({.size = 20});
  EXPECT_THROW(race_shadows({.workload = &workload,
                             .contestants = every_shadow_engine(),
                             .is_interrupted = [] { return true; }}),
               Interrupted);
}

TEST(ShadowJudge, SampleSeesWrongVertices) {
  const ShadowWorkload workload = fractal_shadows({.size = 60, .relief = 150.0, .seed = 3});
  const ShadowJudge judge(workload, 3, 2);
  EXPECT_EQ(wrong_in_sample(workload, judge.lit(), 2000, 3), 0u);
  EXPECT_EQ(judge.disagreement(judge.lit()), "");
  EXPECT_EQ(judge.wrong_share(judge.lit()), 0.0);
  LitMaps all = judge.lit();
  for (std::size_t position = 0; position < all.positions(); ++position) all.light_all(position);
  EXPECT_GT(wrong_in_sample(workload, all, 2000, 3), 0u);
  EXPECT_NEAR(
      judge.wrong_share(all),
      1.0 - static_cast<double>(judge.lit().lit()) / static_cast<double>(workload.vertex_hours()),
      1e-12);
  EXPECT_THAT(judge.disagreement(LitMaps(60, 60, 2)), HasSubstr("gives 2 maps"));
  LitMaps beyond = judge.lit();
  beyond.row(0, 0)[0] |= std::uint64_t{1} << 63;
  EXPECT_THAT(judge.disagreement(beyond), HasSubstr("beyond the last column"));
}

TEST(ShadowWorkload, CornersAreCornersAndSunsGoRound) {
  const ShadowWorkload workload = fractal_shadows({.size = 40, .relief = 90.0, .hours = 7});
  EXPECT_EQ(height_range(workload.field).highest, 90.0);
  ASSERT_EQ(workload.suns.size(), 7u);
  EXPECT_EQ(workload.suns.front(), (SunDirection{1.0, 0.0, 0.0}));
  EXPECT_TRUE(in_zenith(workload.suns[3]));
  const ShadowWorkload corner = corner_of(workload, 17);
  EXPECT_EQ(corner.field.columns(), 17);
  EXPECT_EQ(corner.field.at(16, 9), workload.field.at(16, 9));
  EXPECT_EQ(corner_of(workload, 99).field.size(), 1600u);
}

}  // namespace
}  // namespace phytobench
