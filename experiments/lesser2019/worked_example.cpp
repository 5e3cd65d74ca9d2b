// SPDX-License-Identifier: MIT
// One pixel of flat dirt in the polar zone from sunrise to the chance of an apple tree: as printed,
// with one correction, and with several.
#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "experiments/experiment.hpp"
#include "experiments/lesser2019/thesis_site.hpp"
#include "reference/oracles/lesser2019_energy.hpp"
#include "reference/oracles/lesser2019_growth.hpp"
#include "reference/oracles/lesser2019_relief.hpp"

namespace phytobench::experiments::lesser2019 {

namespace {

namespace oracle = oracles::lesser2019;

/// What departs from the printed form.
struct Corrections {
  const char* name;
  bool cosine = false;                // E07
  bool product = false;               // E01
  bool divided = false;               // E16
  bool reflects_albedo = false;       // E13
  bool all_received_is_kept = false;  // a variant of E13
  bool whole_numbers = false;         // images of whole numbers, sec. 9.1.3
  bool sequential_losses = false;     // a reading of sec. 8.2.1
  oracle::DepthRule depth_rule = oracle::DepthRule::saturating;
};

double incident_energy(const Corrections& form) {
  const oracle::Day day{};
  const double raw =
      form.cosine ? oracle::raw_energy_by_height(day) : oracle::raw_energy_of_flat_ground(day);
  const Biome polar = polar_zone();
  if (form.sequential_losses)
    return raw * (1.0 - polar.cloud_percent / 100.0) * (1.0 - polar.absorption_percent / 100.0) *
           (1.0 - polar.diffusion_percent / 100.0);
  return oracle::through_the_air(
      raw, {polar.cloud_percent, polar.absorption_percent, polar.diffusion_percent});
}

/// Interior of an even map, neighbours included.
double energy(const Corrections& form) {
  constexpr double share = 0.1;
  const double incident = incident_energy(form), albedo = thesis_dirt().albedo;
  if (form.reflects_albedo)
    return oracle::reflected_by_albedo(
               oracle::even_values(3, incident), oracle::even_values(3, albedo), share,
               form.all_received_is_kept ? oracle::Received::all
                                         : oracle::Received::partly_reflected_again)
        .at(1, 1);
  double kept = incident * (1.0 - albedo);
  if (form.whole_numbers) kept = std::trunc(kept);
  const double with_neighbours = oracle::listing_9_14(oracle::even_values(3, kept), share).at(1, 1);
  return form.whole_numbers ? std::trunc(with_neighbours) : with_neighbours;
}

void record_example(ExperimentContext& context, const PlantSpecies& species,
                    const Corrections& form) {
  const std::string name = fmt::format("{}/{}/", species.name, form.name);
  const double there = energy(form), depth = oracle::listing_9_15(0.0, 150.0);
  const oracle::Ground ground{depth, thesis_dirt().water_absorption,
                              polar_zone().groundwater.value(), polar_zone().rain.value()};
  const double heat =
      form.product ? oracle::kcal_per_ml(2500.0, 1.0 / 4184.0) : oracle::PRINTED_KCAL_PER_ML;
  const double water = oracle::listing_9_16(
      ground, there, heat,
      form.divided ? oracle::Evaporation::divided : oracle::Evaporation::multiplied);
  const double by_light = oracle::listing_9_17(species.energy_demand.value(), there);
  const double by_water = oracle::listing_9_17(species.water_demand.value(), water);
  const double by_depth =
      oracle::depth_chance(in_centimetres(species.soil_depth), depth, form.depth_rule);
  context.record(name + "energy", there, "kcal/m2");
  context.record(name + "water", water, "l/m2");
  context.record(name + "by-light", by_light);
  context.record(name + "by-water", by_water);
  context.record(name + "by-depth", by_depth);
  context.record(name + "chance",
                 oracle::least_chance({by_light, by_water, by_depth,
                                       species.soil == thesis_dirt().name ? 1.0 : 0.0}));
}

constexpr Corrections forms[] = {
    {.name = "printed"},
    {.name = "whole-numbers", .whole_numbers = true},
    {.name = "e01", .product = true},
    {.name = "e16", .divided = true},
    {.name = "e01-e16", .product = true, .divided = true},
    {.name = "e07", .cosine = true},
    {.name = "e13", .reflects_albedo = true},
    {.name = "e13-all-kept", .reflects_albedo = true, .all_received_is_kept = true},
    {.name = "e19-sequential", .sequential_losses = true},
    {.name = "e21-triangle", .depth_rule = oracle::DepthRule::triangle},
    {.name = "e01-e07-e16", .cosine = true, .product = true, .divided = true},
    {.name = "e01-e07-e13-e16",
     .cosine = true,
     .product = true,
     .divided = true,
     .reflects_albedo = true},
};

void run(ExperimentContext& context) {
  for (const PlantSpecies& species : {appletree(), shrub(), moss()})
    for (const Corrections& form : forms) record_example(context, species, form);
}

}  // namespace

extern const ExperimentDescriptor worked_example;
constinit const ExperimentDescriptor worked_example{
    .id = "lesser2019/worked-example",
    .question =
        "What do the printed formulas, one after the other, say of one pixel, and what does "
        "each correction change?",
    .source = "[Lesser2019] listings 9.12 to 9.17",
    .seconds = {0.01, 0.01, 0.01},
    .run = run,
};

}  // namespace phytobench::experiments::lesser2019
