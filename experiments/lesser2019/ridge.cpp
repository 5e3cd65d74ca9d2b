// SPDX-License-Identifier: MIT
// Sec. 10.4: a ridge from west to east and a valley, their light, soil and water. The biomes of
// those pictures are not printed: ours have more water than the polar one, so that some is left.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/terrain/made/analytic_terrains.hpp"
#include "core/terrain/site_maps.hpp"
#include "experiments/experiment.hpp"
#include "experiments/lesser2019/site_scenes.hpp"
#include "experiments/lesser2019/thesis_site.hpp"
#include "reference/lesser2019_site_model.hpp"

namespace phytobench::experiments::lesser2019 {

namespace {

constexpr int side = 33;

/// Assumed: temperate and subtropical.
Biome wet_biome(const char* name, double absorption_percent) {
  return {.name = name,
          .absorption_percent = absorption_percent,
          .diffusion_percent = 8.0,
          .cloud_percent = 35.0,
          .rain = DailyWater(12.0),
          .groundwater = DailyWater(6.0)};
}
const Biome temperate = wet_biome("assumed temperate", 40.0);
const Biome subtropical = wet_biome("assumed subtropical", 20.0);

SiteInput site_on(const HeightField& heights, const Biome& biome) {
  return {.heights = heights,
          .soils = {thesis_dirt()},
          .soil_of = std::vector<std::int16_t>(heights.size(), 0),
          .biome = biome};
}

/// As the listings have it, or with everything corrected.
struct Form {
  const char* name;
  LesserSwitches switches;
};
std::vector<Form> forms() {
  return {{"printed", lesser_switches("all")}, {"corrected", lesser_switches("none")}};
}

struct Site {
  SiteInput input;
  SiteOptions options;
  SiteMaps maps;
  std::unique_ptr<SiteModel> model;
};

Site site_of(const HeightField& heights, const Biome& biome, double max_elevation,
             const LesserSwitches& switches) {
  Site site{site_on(heights, biome), {}, {}, printed_site_model(switches)};
  site.options.suns = site.model->sun_path({.hours = thesis_hours, .max_elevation = max_elevation});
  site.options.surface = SurfaceEstimator::six_faces;
  site.maps = site_maps(site.input, site.options, *site.model, *lesser_shadows(switches));
  return site;
}

/// Over rows, without the columns at the border.
double mean(const TerrainMap& map, int first_row, int last_row) {
  double sum = 0.0;
  int count = 0;
  for (int row = first_row; row <= last_row; ++row)
    for (int column = side / 4; column < side - side / 4; ++column, ++count)
      sum += map.at(column, row);
  return sum / count;
}

constexpr int north_first = 4, north_last = 12, south_first = 20, south_last = 28;

double north_minus_south(const TerrainMap& map) {
  return mean(map, north_first, north_last) - mean(map, south_first, south_last);
}

/// In which of 13 hours the middle of the north flank is dark.
void record_dark_hours(ExperimentContext& context, const std::string& name, const LitMaps& lit) {
  std::int64_t early = 0, midday = 0, late = 0;
  for (int hour = 0; hour < thesis_hours; ++hour) {
    auto& part = hour < 4 ? early : hour < thesis_hours - 4 ? midday : late;
    part += !lit.is_lit(static_cast<std::size_t>(hour), side / 2, side / 4);
  }
  context.record(name + "north-dark/first-four-hours", early, "h");
  context.record(name + "north-dark/five-hours-between", midday, "h");
  context.record(name + "north-dark/last-four-hours", late, "h");
}

/// How many of 13 hours the middle of each flank is lit.
void record_lit_hours(ExperimentContext& context, const HeightField& heights, double slope,
                      double max_elevation) {
  for (const char* engine : {"printed_march", "exact_traversal"}) {
    const LitMaps lit = cast_by(engine, heights, thesis_path(max_elevation)).lit;
    const auto hours = lit_positions(lit);
    const std::string name = fmt::format("slope-{}/max-{}/{}/", slope, max_elevation, engine);
    context.record(name + "north-hours", std::int64_t{hours[heights.index(side / 2, side / 4)]},
                   "h");
    context.record(name + "south-hours",
                   std::int64_t{hours[heights.index(side / 2, side - 1 - side / 4)]}, "h");
    record_dark_hours(context, name, lit);
  }
}

/// The same ridge where the air takes less: more energy, and what it leaves of the water.
void record_subtropical(ExperimentContext& context, const std::string& name,
                        const HeightField& heights, const Site& site, const Form& form) {
  const Site hot = site_of(heights, subtropical, 80.0, form.switches);
  const auto whole_ridge = [](const TerrainMap& map) { return mean(map, north_first, south_last); };
  context.record(name + "subtropical/more-energy",
                 whole_ridge(hot.maps.energy) - whole_ridge(site.maps.energy), "kcal/m2");
  context.record(name + "subtropical/less-water",
                 whole_ridge(site.maps.water) - whole_ridge(hot.maps.water), "l/m2");
  // Without any sun all water is left that the soil takes up.
  TerrainMap taken_up = hot.maps.soil_depth;
  for (double& value : taken_up.values)
    value = hot.model->water(Length(value), thesis_dirt(), subtropical, DailyEnergy(0.0)).value();
  context.record(name + "subtropical/evaporated-share",
                 1.0 - whole_ridge(hot.maps.water) / whole_ridge(taken_up));
}

void record_flanks(ExperimentContext& context, double slope) {
  const HeightField heights = ridge_terrain({side, side, thesis_cell, thesis_cell}, slope);
  for (const double max_elevation : {80.0, 90.0})
    record_lit_hours(context, heights, slope, max_elevation);
  for (const Form& form : forms()) {
    const Site site = site_of(heights, temperate, 80.0, form.switches);
    const std::string name = fmt::format("slope-{}/{}/", slope, form.name);
    context.record(name + "energy-north-minus-south", north_minus_south(site.maps.energy),
                   "kcal/m2");
    context.record(name + "water-north-minus-south", north_minus_south(site.maps.water), "l/m2");
    // Of a fir only the energy is printed, which decides here.
    const PlantSpecies fir{
        .name = "Fir",
        .energy_demand = DailyEnergy(thesis_entry("species", "Fir").number("energy_kcal_per_day"))};
    const ChanceMaps chances = chance_maps(site.input, site.maps, fir, *site.model, site.options);
    context.record(name + "fir-light-north-minus-south", north_minus_south(chances.light));
    record_subtropical(context, name, heights, site, form);
  }
}

/// Two slopes down to a level floor.
HeightField valley_terrain(int first_floor, int last_floor, double slope) {
  return square_field(side, thesis_cell, [&](int, int row) {
    const int away = row < first_floor ? first_floor - row : std::max(0, row - last_floor);
    return away * thesis_cell * std::tan(slope * std::numbers::pi / 180.0);
  });
}

double mean_lit_hours(const Site& site, int first_row, int last_row) {
  const auto hours = lit_positions(site.maps.lit);
  TerrainMap map = site.maps.energy;
  map.values.assign(hours.begin(), hours.end());
  return mean(map, first_row, last_row);
}

/// Where soil is deepest, where the sun comes least, and where most water is: on the floor, on its
/// flanks or on open level ground.
void record_valley(ExperimentContext& context, double slope) {
  constexpr int first_floor = 12, last_floor = 20;
  const HeightField heights = valley_terrain(first_floor, last_floor, slope),
                    open = square_field(side, thesis_cell, [](int, int) { return 0.0; });
  const auto floor = [](const TerrainMap& map) {
    return mean(map, first_floor + 1, last_floor - 1);
  };
  for (const Form& form : forms()) {
    const Site site = site_of(heights, temperate, 80.0, form.switches),
               level = site_of(open, temperate, 80.0, form.switches);
    const std::string name = fmt::format("valley/slope-{}/{}/", slope, form.name);
    const auto record = [&](const char* what, const TerrainMap& map, const char* unit) {
      const double north = mean(map, 2, first_floor - 2),
                   south = mean(map, last_floor + 2, side - 3);
      context.record(fmt::format("{}{}-floor-minus-flanks", name, what),
                     floor(map) - std::max(north, south), unit);
    };
    record("depth", site.maps.soil_depth, "m");
    record("water", site.maps.water, "l/m2");
    context.record(name + "water-floor-minus-open-level-ground",
                   floor(site.maps.water) - floor(level.maps.water), "l/m2");
    context.record(name + "lit-hours-floor-minus-open-level-ground",
                   mean_lit_hours(site, first_floor + 1, last_floor - 1) -
                       mean_lit_hours(level, first_floor + 1, last_floor - 1),
                   "h");
  }
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const auto n = static_cast<double>(a.size());
  double mean_a = 0.0, mean_b = 0.0, ab = 0.0, aa = 0.0, bb = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    mean_a += a[i] / n;
    mean_b += b[i] / n;
  }
  for (std::size_t i = 0; i < a.size(); ++i) {
    ab += (a[i] - mean_a) * (b[i] - mean_b);
    aa += (a[i] - mean_a) * (a[i] - mean_a);
    bb += (b[i] - mean_b) * (b[i] - mean_b);
  }
  return ab / std::sqrt(aa * bb);
}

/// On rough land: soil is deepest where it is most level, and water goes with it, not quite. Steep
/// enough for soils that hold less than all the water: those of a metre and more hold the same.
void record_correlations(ExperimentContext& context) {
  constexpr int size = 64;
  const HeightField heights =
      fractal_field(size, thesis_cell, size * thesis_cell * 0.6, context.seed() + 6);
  for (const Form& form : forms()) {
    const Site site = site_of(heights, temperate, 80.0, form.switches);
    const std::string name = fmt::format("rough/{}/", form.name);
    const auto& depth = site.maps.soil_depth.values;
    context.record(name + "water-and-depth", correlation(site.maps.water.values, depth));
    const auto deepest = std::max_element(depth.begin(), depth.end()) - depth.begin();
    const auto& slope = site.maps.slope.values;
    context.record(
        name + "slope-where-deepest-over-least",
        slope[static_cast<std::size_t>(deepest)] - *std::min_element(slope.begin(), slope.end()),
        "degrees");
  }
}

void run(ExperimentContext& context) {
  for (const double slope : {30.0, 53.0}) record_flanks(context, slope);
  // The sun is seen from 42 degrees on over such flanks: the gentle ones leave the floor without
  // shade.
  for (const double slope : {39.0, 53.0}) record_valley(context, slope);
  record_correlations(context);
}

}  // namespace

extern const ExperimentDescriptor ridge;
constinit const ExperimentDescriptor ridge{
    .id = "lesser2019/ridge",
    .question = "Is it darker and wetter north of a ridge, and are valleys deep and wet?",
    .source = "[Lesser2019] sec. 9.2.3, 10.4",
    .seconds = {0.3, 0.3, 0.3},
    .run = run,
};

}  // namespace phytobench::experiments::lesser2019
