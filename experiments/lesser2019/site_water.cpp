// SPDX-License-Identifier: MIT
// Sec. 8.5, listing 9.16: what water the soil takes up, and what the sun takes of it.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/terrain/site_model.hpp"
#include "experiments/experiment.hpp"
#include "experiments/lesser2019/thesis_site.hpp"
#include "reference/oracles/lesser2019_growth.hpp"

namespace phytobench::experiments::lesser2019 {

namespace {

namespace oracle = oracles::lesser2019;

double water(double depth_cm, double energy) {
  return corrected_site_model()
      ->water(centimetres(depth_cm), thesis_dirt(), polar_zone(), DailyEnergy(energy))
      .value();
}

oracle::Ground polar_dirt(double depth_cm) {
  return {.depth = depth_cm,
          .water_absorption = thesis_dirt().water_absorption,
          .groundwater = polar_zone().groundwater.value(),
          .avg_rainfall_per_day = polar_zone().rain.value()};
}

void record_supply(ExperimentContext& context) {
  context.record("supply", water(150.0, 0.0), "l/m2");
  context.record("supply/by-the-listing", oracle::water_supply(polar_dirt(150.0)), "l/m2");
  for (const int depth : {150, 100, 50, 0}) {
    context.record(fmt::format("coefficient/{}", depth), water(depth, 0.0) / water(150.0, 0.0));
    context.record(
        fmt::format("coefficient/{}/by-the-listing", depth),
        oracle::water_supply(polar_dirt(depth)) / oracle::water_supply(polar_dirt(150.0)));
  }
}

/// 819 kcal: what dirt keeps of a lit polar day; 900.9 with what its neighbours throw over.
void record_evaporation(ExperimentContext& context) {
  const double printed = oracle::PRINTED_KCAL_PER_ML, product = oracle::kcal_per_ml(2.5e3, 2.39e-4);
  const auto evaporated = [](double heat, oracle::Evaporation how) {
    return oracle::evaporated_litres(819.0, heat, how);
  };
  context.record("evaporated/printed", evaporated(printed, oracle::Evaporation::multiplied),
                 "l/m2");
  context.record("evaporated", evaporated(product, oracle::Evaporation::divided), "l/m2");
  context.record("evaporated/by-054", evaporated(printed, oracle::Evaporation::divided), "l/m2");
  context.record("evaporated/of-the-suite", (DailyEnergy(819.0) / heat_of_evaporation).value(),
                 "l/m2");
  context.record("evaporated/energy-that-dries-the-soil",
                 water(150.0, 0.0) * heat_of_evaporation.value(), "kcal/m2");
  context.record("left/819/printed", oracle::listing_9_16(polar_dirt(150.0), 819.0), "l/m2");
  context.record("left/900.9/printed", oracle::listing_9_16(polar_dirt(150.0), 900.9), "l/m2");
  context.record("left/819", water(150.0, 819.0), "l/m2");
  context.record("left/900.9", water(150.0, 900.9), "l/m2");
  // With the product of the printed factors alone, still multiplied.
  context.record("left/900.9/only-the-product",
                 oracle::listing_9_16(polar_dirt(150.0), 900.9, product), "l/m2");
}

/// Over depths and energies: never below zero, never more with more sun, never less in deeper soil.
void record_laws(ExperimentContext& context) {
  double least = 1.0, least_printed = 1.0;
  std::int64_t rises_with_energy = 0, falls_with_depth = 0, points = 0, off_listing = 0;
  for (int depth = 0; depth <= 200; depth += 5)
    for (int energy = 0; energy <= 4000; energy += 50) {
      ++points;
      const double left = water(depth, energy);
      least = std::min(least, left);
      least_printed = std::min(least_printed, oracle::listing_9_16(polar_dirt(depth), energy));
      rises_with_energy += left > water(depth, energy - 50 >= 0 ? energy - 50 : 0);
      falls_with_depth += left < water(depth >= 5 ? depth - 5 : 0, energy);
      off_listing +=
          std::abs(left - oracle::listing_9_16(polar_dirt(depth), energy, 2500.0 / 4184.0,
                                               oracle::Evaporation::divided)) > 1e-12;
    }
  context.record("points", points, "points");
  context.record("least", least, "l/m2");
  context.record("least/printed", least_printed, "l/m2");
  context.record("rises-with-energy", rises_with_energy, "points");
  context.record("falls-with-depth", falls_with_depth, "points");
  context.record("not-what-the-listing-gives-when-divided", off_listing, "points");
}

/// Figure 10.3 asks for l/cm2 where figure 10.2 shows l/day.
void record_units(ExperimentContext& context) {
  context.record("appletree/demand", appletree().water_demand.value(), "l/day");
  context.record("appletree/demand-as-litres-per-cm2", appletree().water_demand.value() * 1e4,
                 "l/m2");
}

void run(ExperimentContext& context) {
  record_supply(context);
  record_evaporation(context);
  record_laws(context);
  record_units(context);
}

}  // namespace

extern const ExperimentDescriptor site_water;
constinit const ExperimentDescriptor site_water{
    .id = "lesser2019/site-water",
    .question = "How much water does the sun leave in the soil?",
    .source = "[Lesser2019] sec. 8.5, 9.2.8, listing 9.16",
    .seconds = {0.01, 0.01, 0.01},
    .run = run,
};

}  // namespace phytobench::experiments::lesser2019
