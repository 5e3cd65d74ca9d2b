// SPDX-License-Identifier: MIT
// Which plants die: those whose zones others overlap, and those that are old.
#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/overlap/overlap_registry.hpp"
#include "experiments/alsweis/paired_runs.hpp"

namespace phytobench::experiments::alsweis {

namespace {

constexpr std::size_t seeds = 20;

PopulationParameters crowd(const char* rule, std::uint64_t seed) {
  PopulationParameters parameters;
  parameters.seed = seed;
  parameters.rule = rule;
  parameters.species = {
      {.name = "plant", .count = 400, .roots = {.poor_factor = 12.0, .rich_factor = 12.0}}};
  parameters.mortality = {.rule = MortalityRule::mean_growth, .threshold = 0.0002};
  return parameters;
}

/// Part of the plants alive at step 20 that die until step 120.
struct DeathShares {
  double above = 0.0, below = 0.0;  ///< of those with more overlap than the median, and of the rest
};

/// Sums of overlaps over the plant's own zone, in any unit: what equal shares would cost.
std::vector<double> overlap_sums(const Population& population) {
  PopulationParameters parameters = population.parameters();
  parameters.rule = "symmetric";
  Population twin(parameters, population.state(), overlap_engine_named("layered_grid"));
  return twin.losses();
}

DeathShares death_shares(const PopulationParameters& parameters) {
  Population population = lived(parameters, 20);
  const ByPlant overlap = by_plant(population.stand(), overlap_sums(population));
  std::vector<double> sorted;
  for (const auto& [id, sum] : overlap) sorted.push_back(sum);
  std::sort(sorted.begin(), sorted.end());
  const double median = sorted[(sorted.size() - 1) / 2];
  for (int t = 20; t < 120; ++t) population.step();
  const std::vector<PlantId>& alive = population.stand().id;
  std::array<double, 2> died{}, all{};
  for (const auto& [id, sum] : overlap) {
    const std::size_t side = sum > median ? 1 : 0;
    all[side] += 1.0;
    died[side] += std::find(alive.begin(), alive.end(), id) == alive.end() ? 1.0 : 0.0;
  }
  return {died[1] / all[1], died[0] / all[0]};
}

void record_crowded_deaths(ExperimentContext& context) {
  for (const char* rule : {"symmetric", "mixture", "asymmetric"}) {
    std::vector<double> above(seeds), below(seeds);
    for_runs(context, fmt::format("crowd, {}", rule), seeds, [&](std::size_t s) {
      const DeathShares shares =
          death_shares(crowd(rule, seed_of_run(context, Question::crowded_deaths, s)));
      above[s] = shares.above;
      below[s] = shares.below;
    });
    const std::string group = fmt::format("crowding/{}", rule);
    record_mean(context, group + "/deaths_above_median", above);
    record_mean(context, group + "/deaths_below_median", below);
    record_paired(context, group + "/above_over_below", above, below);
  }
}

/// A cohort, and a population of all ages.
void record_largest_age(ExperimentContext& context) {
  constexpr std::int32_t largest_age = 30;
  PopulationParameters parameters =
      crowd("asymmetric", seed_of_run(context, Question::largest_age, 0));
  parameters.species[0].largest_age = largest_age;
  Population cohort = population_of(parameters);
  for (int t = 1; t < largest_age; ++t) cohort.step();
  context.record("age/largest", std::int64_t{largest_age}, "steps");
  context.record("age/alive_one_step_before", static_cast<std::int64_t>(cohort.stand().size()),
                 "plants");
  cohort.step();
  context.record("age/alive_then", static_cast<std::int64_t>(cohort.stand().size()), "plants");

  parameters.species[0].reproduction = {.threshold = 0.1, .seeds_per_metre = 2.0};
  Population population = population_of(parameters);
  std::int32_t oldest = 0;
  for (int t = 0; t < 5 * largest_age; ++t) {
    population.step();
    for (const std::int32_t age : population.stand().age) oldest = std::max(oldest, age);
  }
  context.record("age/oldest_seen", std::int64_t{oldest}, "steps");
  context.record("age/died", static_cast<std::int64_t>(population.state().died[0]), "plants");
}

void run(ExperimentContext& context) {
  record_crowded_deaths(context);
  record_largest_age(context);
}

}  // namespace

extern const ExperimentDescriptor deaths;
constinit const ExperimentDescriptor deaths{
    .id = "alsweis/deaths",
    .question =
        "Do plants that others compete with die more often, and does none outlive its largest age?",
    .source = "[Alsweis] sec. 4.5",
    .seconds = {1, 1, 1},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
