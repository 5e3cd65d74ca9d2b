// SPDX-License-Identifier: MIT
#include "benchmarks/overlap/overlap_race.hpp"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmarks/overlap/overlap_judge.hpp"
#include "core/contract/errors.hpp"
#include "core/overlap/overlap_registry.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;
using State = OverlapEntry::State;

std::vector<OverlapContestant> everyone() {
  std::vector<OverlapContestant> all;
  for (const OverlapEngineDescriptor* engine : all_overlap_engines()) all.push_back({engine, 1});
  return all;
}

bool is_faulty(const OverlapEntry& entry) {
  return entry.engine->summary.starts_with("Wrong on purpose");
}

OverlapRaceResult raced(const RandomDiscs& discs, std::vector<OverlapContestant> contestants,
                        double budget_s = 1e6) {
  const OverlapWorkload workload = random_discs(discs);
  return race_overlap({.workload = &workload,
                       .contestants = std::move(contestants),
                       .budget_s = budget_s,
                       .rounds = 2});
}

TEST(OverlapRace, TimesWhatIsExactAndRefusesWhatIsNot) {
  for (const RandomDiscs& discs :
       {RandomDiscs{.count = 800, .seed = 1},
        RandomDiscs{.count = 900, .sizes = DiscSizes::mixed, .is_torus = true, .seed = 2},
        RandomDiscs{.count = 6000, .sizes = DiscSizes::uniform, .is_torus = true, .seed = 3}}) {
    const OverlapRaceResult result = raced(discs, everyone());
    std::size_t refused = 0;
    for (const OverlapEntry& entry : result.entries) {
      if (!entry.engine->built()) continue;
      EXPECT_EQ(entry.state, is_faulty(entry) ? State::inexact : State::timed)
          << entry.name() << ": " << entry.disagreement;
      EXPECT_EQ(entry.seconds.size(), is_faulty(entry) ? 0u : 2u) << entry.name();
      EXPECT_EQ(entry.disagreement.empty(), !is_faulty(entry)) << entry.name();
      refused += is_faulty(entry);
    }
    EXPECT_EQ(refused, 4u);
    EXPECT_EQ(result.lens.size(), 3u);
    EXPECT_LT(result.largest_area_error, 1e-14);
    EXPECT_GT(result.pairs, discs.count);
  }
}

TEST(OverlapRace, SaysWhatIsWrong) {
  const OverlapRaceResult result = raced({.count = 800, .seed = 1}, everyone());
  const auto said_of = [&](std::string_view name) {
    for (const OverlapEntry& entry : result.entries)
      if (entry.engine->name == name) return entry.disagreement;
    return std::string("is not there");
  };
  EXPECT_THAT(said_of("misses_one_pair"), HasSubstr("misses discs "));
  EXPECT_THAT(said_of("reports_a_pair_twice"), HasSubstr("finds discs "));
  EXPECT_THAT(said_of("rounds_areas"), HasSubstr("area should be "));
  EXPECT_THAT(said_of("counts_touching"), HasSubstr("which do not overlap"));
}

TEST(OverlapRace, SkipsWhatWouldTakeTooLong) {
  const auto result = raced(
      {.count = 30'000, .seed = 4},
      {{&overlap_engine_named("all_pairs"), 1}, {&overlap_engine_named("layered_grid"), 1}}, 0.25);
  EXPECT_EQ(result.entries[0].state, State::skipped);
  EXPECT_GT(result.entries[0].predicted_s, 0.25);
  EXPECT_EQ(result.entries[1].state, State::timed);
}

TEST(OverlapRace, StopsWhenAskedTo) {
  const OverlapWorkload workload = random_discs({.count = 100});
  EXPECT_THROW(race_overlap({.workload = &workload,
                             .contestants = everyone(),
                             .is_interrupted = [] { return true; }}),
               Interrupted);
}

TEST(OverlapRace, TakesDiscsThatDoNotOverlap) {
  const auto result = raced({.count = 50, .partners = 0.0}, everyone());
  EXPECT_EQ(result.pairs, 0u);
  EXPECT_TRUE(result.lens.empty());
}

TEST(RandomDiscs, HaveAsManyPartnersAsAskedFor) {
  for (const DiscSizes sizes : {DiscSizes::equal, DiscSizes::uniform, DiscSizes::mixed}) {
    const OverlapWorkload workload = random_discs(
        {.count = 20'000, .sizes = sizes, .partners = 6.0, .is_torus = true, .seed = 5});
    ASSERT_EQ(problem_with(workload.discs(), workload.ground), std::nullopt);
    const OverlapJudge judge(workload, 0);
    const double partners = 2.0 * static_cast<double>(judge.pairs().size()) / 20'000;
    EXPECT_NEAR(partners, 6.0, sizes == DiscSizes::mixed ? 0.5 : 0.15) << name_of(sizes);
  }
  EXPECT_THROW(disc_sizes_named("large"), InputError);
  EXPECT_EQ(disc_sizes_named("mixed"), DiscSizes::mixed);
}

TEST(SmallerWorkload, KeepsTheKindOfScene) {
  const OverlapWorkload whole = random_discs({.count = 40'000, .seed = 6});
  const OverlapWorkload part = smaller(whole, 4'000);
  EXPECT_NEAR(static_cast<double>(part.x.size()), 4'000, 300);
  const auto partners = [](const OverlapWorkload& w) {
    return 2.0 * static_cast<double>(OverlapJudge(w, 0).pairs().size()) /
           static_cast<double>(w.x.size());
  };
  EXPECT_NEAR(partners(part) / partners(whole), 1.0, 0.1);
}

}  // namespace
}  // namespace phytobench
