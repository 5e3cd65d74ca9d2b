// SPDX-License-Identifier: MIT
#include "experiments/alsweis/paired_runs.hpp"

#include "core/contract/check.hpp"
#include "core/overlap/overlap_registry.hpp"
#include "core/statistics/running_moments.hpp"

namespace phytobench::experiments::alsweis {

namespace {

void record_moments_of(ExperimentContext& context, const std::string& name,
                       const RunningMoments& moments, const std::string& unit) {
  Record record{.experiment = {},
                .measurement = name,
                .value = moments.mean(),
                .unit = unit,
                .sample_size = moments.count(),
                .seed = context.seed()};
  if (moments.count() > 1) record.spread = moments.deviation();
  context.record(std::move(record));
}

double standard_errors_of(const RunningMoments& differences) {
  if (differences.mean() == 0.0) return 0.0;
  return std::clamp(differences.mean() / differences.standard_error(), -certain, certain);
}

}  // namespace

std::uint64_t seed_of_run(const ExperimentContext& context, Question question, std::size_t run) {
  PHYTOBENCH_EXPECT(run < 1000);
  return (context.seed() * 100 + static_cast<std::uint64_t>(question)) * 1000 + run;
}

Population population_of(const PopulationParameters& parameters,
                         std::span<const StartPlant> plants) {
  return {parameters, sow(parameters, plants), overlap_engine_named("layered_grid")};
}

Population lived(const PopulationParameters& parameters, int steps,
                 std::span<const StartPlant> plants) {
  Population population = population_of(parameters, plants);
  for (int i = 0; i < steps; ++i) population.step();
  return population;
}

ByPlant by_plant(const Stand& stand, std::span<const double> values) {
  PHYTOBENCH_EXPECT(values.size() == stand.size());
  ByPlant result;
  for (std::size_t i = 0; i < stand.size(); ++i) result[stand.id[i]] = values[i];
  return result;
}

void record_mean(ExperimentContext& context, const std::string& name,
                 std::span<const double> values, const std::string& unit) {
  RunningMoments moments;
  for (const double value : values) moments.add(value);
  record_moments_of(context, name, moments, unit);
}

void record_paired(ExperimentContext& context, const std::string& group,
                   std::span<const double> more, std::span<const double> less,
                   const std::string& unit) {
  PHYTOBENCH_EXPECT(more.size() == less.size() && more.size() > 1);
  RunningMoments differences;
  std::int64_t wins = 0;
  for (std::size_t i = 0; i < more.size(); ++i) {
    differences.add(more[i] - less[i]);
    wins += more[i] > less[i] ? 1 : 0;
  }
  const auto record = [&](const char* what, RecordValue value, const char* its_unit) {
    context.record({.experiment = {},
                    .measurement = group + what,
                    .value = std::move(value),
                    .unit = its_unit,
                    .sample_size = differences.count(),
                    .seed = context.seed()});
  };
  record("/wins", wins, "pairs");
  record_moments_of(context, group + "/mean_difference", differences, unit);
  record("/standard_errors", standard_errors_of(differences), "standard errors");
}

}  // namespace phytobench::experiments::alsweis
