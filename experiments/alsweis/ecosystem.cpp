// SPDX-License-Identifier: MIT
#include "experiments/alsweis/ecosystem.hpp"

#include <cmath>

namespace phytobench::experiments::alsweis {

ZoneLaw zone_of(double factor) {
  return {.poor_factor = factor, .rich_factor = factor, .exponent = 0.5};
}

double zone_radius_of(double factor, double stem_radius) {
  return factor * std::sqrt(stem_radius);
}

Species species_of(const PlantKind& kind, std::int64_t count) {
  Species species;
  species.name = kind.name;
  species.count = count;
  species.start_radius_low = 0.8 * kind.start_radius;
  species.start_radius_high = 1.2 * kind.start_radius;
  species.largest_radius = kind.largest_radius;
  species.growth_rate = kind.growth_rate;
  species.roots = zone_of(kind.root_factor);
  species.crown = zone_of(kind.crown_factor);
  return species;
}

PopulationParameters plot_of(double side, double least_growth, std::uint64_t seed) {
  PopulationParameters parameters;
  parameters.seed = seed;
  parameters.ground = {{0.0, 0.0}, {side, side}};
  parameters.is_torus = false;
  parameters.rule = "above_below";
  parameters.competition.above_share = 0.5;
  parameters.mortality = {.rule = MortalityRule::mean_relative_growth,
                          .window = 5,
                          .threshold = least_growth,
                          .grown_up = 0.9};
  return parameters;
}

StartPlant in_the_middle_of(double side, double stem_radius) {
  return {.place = {0.5 * side, 0.5 * side}, .stem_radius = stem_radius, .species = 0};
}

void record_order(ExperimentContext& context, const std::string& group,
                  std::span<const double> more, std::span<const double> less,
                  const std::string& unit) {
  record_paired(context, group, more, less, unit);
  std::int64_t wins = 0;
  for (std::size_t i = 0; i < more.size(); ++i) wins += more[i] > less[i] ? 1 : 0;
  context.record({.experiment = {},
                  .measurement = group + "/share_of_wins",
                  .value = static_cast<double>(wins) / static_cast<double>(more.size()),
                  .sample_size = static_cast<std::int64_t>(more.size()),
                  .seed = context.seed()});
}

}  // namespace phytobench::experiments::alsweis
