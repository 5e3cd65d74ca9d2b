// SPDX-License-Identifier: MIT
// The columns of figure 5.2: the same plants under symmetric competition, asymmetric competition
// and none. How large they grow, how many are left, and how near to each other these stand.
#include <array>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/population/stand_statistics.hpp"
#include "experiments/alsweis/ecosystem.hpp"
#include "experiments/alsweis/stand_panels.hpp"

namespace phytobench::experiments::alsweis {

namespace {

struct Column {
  const char* name;
  const char* rule;
};

constexpr std::array columns = {Column{"symmetric", "symmetric"},
                                Column{"asymmetric", "asymmetric"}, Column{"none", "none"}};

/// Woody plants on a torus of 200 m, nearly alike at the start, on ground that makes zones of
/// `zone_factor` sqrt(R).
PopulationParameters woody_plants(const Column& column, std::int64_t count, double zone_factor,
                                  std::uint64_t seed) {
  PopulationParameters parameters;
  parameters.seed = seed;
  parameters.rule = column.rule;
  Species& species = parameters.species.emplace_back();
  species.name = "woody plant";
  species.count = count;
  species.roots = zone_of(zone_factor);
  return parameters;
}

/// Plants that have all but stopped growing, though not grown up, die.
void let_starve(PopulationParameters& parameters) {
  parameters.mortality = {
      .rule = MortalityRule::mean_growth, .window = 5, .threshold = 0.0002, .grown_up = 0.95};
}

double mean_radius(const Stand& stand) {
  double sum = 0.0;
  for (const std::size_t i : order_of_ids(stand)) sum += stand.stem_radius[i];
  return sum / static_cast<double>(stand.size());
}

constexpr std::size_t growth_seeds = 20;

/// A hundred plants of which none dies.
void record_growth(ExperimentContext& context) {
  constexpr std::array<int, 3> steps = {20, 40, 60};
  std::array<std::array<std::vector<double>, columns.size()>, steps.size()> radius;
  for (auto& moment : radius)
    for (auto& values : moment) values.resize(growth_seeds);
  for (std::size_t c = 0; c < columns.size(); ++c)
    for_runs(context, fmt::format("growth, {}", columns[c].name), growth_seeds,
             [&](std::size_t run) {
               Population population = population_of(
                   woody_plants(columns[c], 100, 15.0, seed_of_run(context, question_growth, run)));
               for (std::size_t m = 0; m < steps.size(); ++m) {
                 while (population.state().step < steps[m]) population.step();
                 radius[m][c][run] = mean_radius(population.stand());
               }
             });
  for (std::size_t m = 0; m < steps.size(); ++m) {
    const std::string group = fmt::format("growth/step-{}", steps[m]);
    for (std::size_t c = 0; c < columns.size(); ++c)
      record_mean(context, fmt::format("{}/{}/mean_radius", group, columns[c].name), radius[m][c],
                  "m");
    record_order(context, group + "/none_over_symmetric", radius[m][2], radius[m][0], "m");
    record_order(context, group + "/none_over_asymmetric", radius[m][2], radius[m][1], "m");
    record_order(context, group + "/symmetric_over_asymmetric", radius[m][0], radius[m][1], "m");
  }
}

/// Of the plants that are left, one entry per seed.
struct Survivors {
  std::vector<double> plants, nearest_distance, clark_evans, hopkins, radius;

  explicit Survivors(std::size_t seeds)
      : plants(seeds), nearest_distance(seeds), clark_evans(seeds), hopkins(seeds), radius(seeds) {}

  void set(std::size_t run, const Population& population) {
    const Stand& stand = population.stand();
    const StandPattern pattern = stand_pattern(stand, population.parameters().ground, true);
    plants[run] = static_cast<double>(stand.size());
    nearest_distance[run] = pattern.mean_nearest_distance;
    clark_evans[run] = pattern.clark_evans;
    hopkins[run] = pattern.hopkins;
    radius[run] = mean_radius(stand);
  }

  void record(ExperimentContext& context, const std::string& group) const {
    record_mean(context, group + "/plants", plants, "plants");
    record_mean(context, group + "/nearest_distance", nearest_distance, "m");
    record_mean(context, group + "/clark_evans", clark_evans);
    record_mean(context, group + "/hopkins", hopkins);
    record_mean(context, group + "/mean_radius", radius, "m");
  }
};

constexpr std::array<int, 3> moments = {0, 60, 120};
/// By moment, then by column.
using AllSurvivors = std::vector<std::vector<Survivors>>;

/// Four hundred plants, of which those die that are kept small.
AllSurvivors survivors_of(ExperimentContext& context, std::size_t seeds) {
  AllSurvivors left(moments.size(), std::vector<Survivors>(columns.size(), Survivors(seeds)));
  for (std::size_t c = 0; c < columns.size(); ++c)
    for_runs(context, fmt::format("spacing, {}", columns[c].name), seeds, [&](std::size_t run) {
      PopulationParameters parameters =
          woody_plants(columns[c], 400, 12.0, seed_of_run(context, question_spacing, run));
      let_starve(parameters);
      Population population = population_of(parameters);
      for (std::size_t m = 0; m < moments.size(); ++m) {
        while (population.state().step < moments[m]) population.step();
        left[m][c].set(run, population);
      }
    });
  return left;
}

void record_spacing(ExperimentContext& context) {
  const AllSurvivors left = survivors_of(context, context.tier() == Tier::full ? 100 : 20);
  left[0][0].record(context, "spacing/step-0");
  for (std::size_t m = 1; m < moments.size(); ++m) {
    const std::string group = fmt::format("spacing/step-{}", moments[m]);
    for (std::size_t c = 0; c < columns.size(); ++c)
      left[m][c].record(context, fmt::format("{}/{}", group, columns[c].name));
    const Survivors &symmetric = left[m][0], &asymmetric = left[m][1];
    const std::string over = group + "/asymmetric_over_symmetric/";
    record_order(context, over + "nearest_distance", asymmetric.nearest_distance,
                 symmetric.nearest_distance, "m");
    record_order(context, over + "clark_evans", asymmetric.clark_evans, symmetric.clark_evans);
    record_order(context, over + "radius", asymmetric.radius, symmetric.radius, "m");
    record_order(context, group + "/symmetric_over_asymmetric/plants", symmetric.plants,
                 asymmetric.plants, "plants");
  }
}

/// Zones are red and dashed where a plant loses more than half of its growth space, as in
/// figure 4.7.
StandPanel stage_panel(Population& population, const Column& column) {
  const std::vector<double> loss = population.losses();
  const StandLayer zones = root_zones_of(population, 0);
  StandLayer free{.name = "zone", .places = {}, .radii = {}, .mark = StandMark::ring, .colour = 2};
  StandLayer oppressed = free;
  oppressed.name = "zone of a plant that does not grow";
  oppressed.mark = StandMark::dashed_ring;
  oppressed.colour = 4;
  for (std::size_t i = 0; i < loss.size(); ++i) {
    StandLayer& layer = is_oppressed(loss[i]) ? oppressed : free;
    layer.places.push_back(zones.places[i]);
    layer.radii.push_back(zones.radii[i]);
  }
  StandLayer stems = stems_of(population, 0, 3.0);
  stems.name = "stem, three times as wide";
  stems.colour = 1;
  return {.layers = {free, oppressed, stems},
          .caption = fmt::format("{}, step {}: {} plants", column.name, population.state().step,
                                 population.stand().size())};
}

void draw_columns(ExperimentContext& context) {
  constexpr std::array<int, 3> stages = {15, 40, 120};
  constexpr Rectangle ground{{0.0, 0.0}, {140.0, 140.0}};
  std::vector<StandPanel> panels(stages.size() * columns.size());
  for (std::size_t c = 0; c < columns.size(); ++c) {
    PopulationParameters parameters =
        woody_plants(columns[c], 80, 15.0, seed_of_run(context, question_spacing, 999));
    parameters.ground = ground;
    let_starve(parameters);
    Population population = population_of(parameters);
    for (std::size_t s = 0; s < stages.size(); ++s) {
      while (population.state().step < stages[s]) population.step();
      panels[s * columns.size() + c] = stage_panel(population, columns[c]);
    }
  }
  context.artifact("figure-5.2.svg",
                   stand_panels_svg({.ground = ground, .is_torus = true}, panels,
                                    "Figure 5.2: the same 80 plants under symmetric competition, "
                                    "asymmetric competition and none, at three stages"));
}

void run(ExperimentContext& context) {
  record_growth(context);
  record_spacing(context);
  draw_columns(context);
}

}  // namespace

extern const ExperimentDescriptor spacing;
constinit const ExperimentDescriptor spacing{
    .id = "alsweis/spacing",
    .question = "Do plants stand closer together, and stay smaller, if competition is symmetric?",
    .source = "[Alsweis] sec. 5.2, figure 5.2",
    .seconds = {1, 1, 2},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
