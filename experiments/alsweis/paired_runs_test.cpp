// SPDX-License-Identifier: MIT
#include "experiments/alsweis/paired_runs.hpp"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"

namespace phytobench::experiments::alsweis {
namespace {

ExperimentContext context_with(std::uint64_t seed, int threads = 1) {
  return {"alsweis/paired-runs", Tier::smoke, seed, threads};
}

double value_of(const ExperimentContext& context, const std::string& name) {
  for (const Record& record : context.records())
    if (record.measurement == "alsweis/paired-runs/" + name) {
      if (const auto* count = std::get_if<std::int64_t>(&record.value))
        return static_cast<double>(*count);
      return std::get<double>(record.value);
    }
  ADD_FAILURE() << name << " is missing";
  return NAN;
}

TEST(PairedRuns, MeanDifferenceIsGivenInItsStandardErrors) {
  ExperimentContext context = context_with(1);
  record_paired(context, "group", std::vector{3.0, 5.0, 4.0}, std::vector{1.0, 1.0, 6.0}, "m");
  // Differences 2, 4 and -2: mean 4/3, deviation sqrt(28/3), over sqrt(3).
  EXPECT_EQ(value_of(context, "group/wins"), 2.0);
  EXPECT_DOUBLE_EQ(value_of(context, "group/mean_difference"), 4.0 / 3.0);
  EXPECT_DOUBLE_EQ(value_of(context, "group/standard_errors"),
                   4.0 / 3.0 / std::sqrt(28.0 / 3.0 / 3.0));
}

TEST(PairedRuns, ExchangeTurnsTheSign) {
  ExperimentContext context = context_with(1);
  const std::vector a{0.1, 0.9, 0.4, 0.4}, b{0.3, 0.2, 0.3, 0.4};
  record_paired(context, "forth", a, b);
  record_paired(context, "back", b, a);
  for (const char* what : {"/mean_difference", "/standard_errors"})
    EXPECT_DOUBLE_EQ(value_of(context, std::string("forth") + what),
                     -value_of(context, std::string("back") + what));
  // A tie is won by nobody.
  EXPECT_EQ(value_of(context, "forth/wins") + value_of(context, "back/wins"), 3.0);
}

TEST(PairedRuns, EqualDifferencesAreCertainAndNoneAreNot) {
  ExperimentContext context = context_with(1);
  const std::vector<double> low{1.0, 2.0}, high{2.0, 3.0};
  record_paired(context, "more", high, low);
  record_paired(context, "less", low, high);
  record_paired(context, "same", low, low);
  EXPECT_EQ(value_of(context, "more/standard_errors"), certain);
  EXPECT_EQ(value_of(context, "less/standard_errors"), -certain);
  EXPECT_EQ(value_of(context, "same/standard_errors"), 0.0);
}

TEST(PairedRuns, OnePairOrUnequalNumbersAreRefused) {
  ExperimentContext context = context_with(1);
  const std::vector<double> one{1.0}, two{1.0, 2.0};
  EXPECT_THROW(record_paired(context, "group", one, one), ContractViolation);
  EXPECT_THROW(record_paired(context, "group", two, one), ContractViolation);
}

TEST(PairedRuns, NoTwoRunsShareASeed) {
  std::set<std::uint64_t> seeds;
  for (const std::uint64_t seed : {0u, 1u, 2u})
    for (const Question question : {Question::size_inequality, Question::halves, Question::figures})
      for (const std::size_t run : {0u, 1u, 999u})
        seeds.insert(seed_of_run(context_with(seed), question, run));
  EXPECT_EQ(seeds.size(), 27u);
  EXPECT_THROW(seed_of_run(context_with(1), Question::halves, 1000), ContractViolation);
}

TEST(PairedRuns, EveryRunIsCarriedOutOnceWithAnyNumberOfThreads) {
  for (const int threads : {1, 2, 3}) {
    ExperimentContext context = context_with(1, threads);
    std::vector<int> calls(7);
    for_runs(context, "test", calls.size(), [&](std::size_t run) { ++calls[run]; });
    EXPECT_EQ(calls, std::vector<int>(7, 1)) << threads;
  }
}

TEST(PairedRuns, AnInterruptStopsBetweenRuns) {
  ExperimentContext context = context_with(1);
  int calls = 0;
  context.is_interrupted = [&] { return calls == 2; };
  EXPECT_THROW(for_runs(context, "test", 5, [&](std::size_t) { ++calls; }), Interrupted);
  EXPECT_EQ(calls, 2);
}

TEST(PairedRuns, RulesStartFromTheSamePlants) {
  PopulationParameters parameters;
  parameters.seed = seed_of_run(context_with(3), Question::halves, 5);
  parameters.species = {{.name = "plant", .count = 20}};
  PopulationParameters other = parameters;
  other.rule = "none";
  const Population a = population_of(parameters), b = population_of(other);
  EXPECT_EQ(a.stand().x, b.stand().x);
  EXPECT_EQ(a.stand().stem_radius, b.stand().stem_radius);
  EXPECT_NE(lived(parameters, 40).stand().stem_radius, lived(other, 40).stand().stem_radius);
}

TEST(PairedRuns, ValuesFollowTheirPlants) {
  Stand stand;
  stand.x = stand.y = {0.0, 0.0};
  stand.id = {7, 3};
  const ByPlant values = by_plant(stand, std::vector{0.7, 0.3});
  EXPECT_EQ(values.at(7), 0.7);
  EXPECT_EQ(values.at(3), 0.3);
}

}  // namespace
}  // namespace phytobench::experiments::alsweis
