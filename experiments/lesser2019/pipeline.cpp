// SPDX-License-Identifier: MIT
// Sec. 8.7, chapter 3: which result depends on which input.
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/terrain/site_maps.hpp"
#include "experiments/experiment.hpp"
#include "experiments/lesser2019/site_scenes.hpp"
#include "experiments/lesser2019/thesis_site.hpp"
#include "reference/lesser2019_site_model.hpp"

namespace phytobench::experiments::lesser2019 {

namespace {

/// All that can be set, with a biome of enough water.
struct Settings {
  HeightField heights;
  Biome biome;
  Soil soil = thesis_dirt();
  PlantSpecies species = appletree();
  Length max_soil_depth{1.5};
  double neighbour_share = 0.1;
  HourlyPath path{.hours = thesis_hours, .max_elevation = 80.0};
};

Settings usual(std::uint64_t seed) {
  Settings settings{.heights = fractal_field(24, thesis_cell, 200.0, seed + 8),
                    .biome = polar_zone()};
  settings.biome.rain = DailyWater(6.0);
  settings.species.soil_depth = centimetres(140.0);
  return settings;
}

/// The results, by the names of the thesis' classes.
using Results = std::map<std::string, std::vector<double>>;

Results results_of(const Settings& settings, const SiteModel& model) {
  const SiteInput input{.heights = settings.heights,
                        .soils = {settings.soil},
                        .soil_of = std::vector<std::int16_t>(settings.heights.size(), 0),
                        .biome = settings.biome,
                        .max_soil_depth = settings.max_soil_depth,
                        .neighbour_share = settings.neighbour_share};
  const SiteOptions options{.suns = model.sun_path(settings.path)};
  const SiteMaps maps =
      site_maps(input, options, model, *shadow_engine_named("exact_traversal").create());
  const ChanceMaps chances = chance_maps(input, maps, settings.species, model, options);
  return {{"insolation", maps.energy.values},     {"orography", maps.slope.values},
          {"edaphology", maps.soil_depth.values}, {"hydrology", maps.water.values},
          {"light", chances.light.values},        {"moisture", chances.water.values},
          {"depth", chances.depth.values},        {"soil", chances.soil.values}};
}

struct Change {
  const char* name;
  std::function<void(Settings&)> apply;
};

std::vector<Change> changes() {
  return {
      {"absorption", [](Settings& s) { s.biome.absorption_percent -= 5.0; }},
      {"cloud", [](Settings& s) { s.biome.cloud_percent -= 5.0; }},
      {"diffusion", [](Settings& s) { s.biome.diffusion_percent -= 5.0; }},
      {"albedo", [](Settings& s) { s.soil.albedo += 0.1; }},
      {"neighbours", [](Settings& s) { s.neighbour_share += 0.1; }},
      {"sun", [](Settings& s) { s.path.max_elevation = 30.0; }},
      {"heights",
       [](Settings& s) {
         for (double& height : s.heights.heights()) height *= 2.0;
       }},
      {"rain", [](Settings& s) { s.biome.rain = DailyWater(7.0); }},
      {"groundwater", [](Settings& s) { s.biome.groundwater = DailyWater(2.0); }},
      {"deepest-soil", [](Settings& s) { s.max_soil_depth = Length(0.8); }},
      {"soil-absorption", [](Settings& s) { s.soil.water_absorption += 0.1; }},
      {"needed-energy", [](Settings& s) { s.species.energy_demand = DailyEnergy(1500.0); }},
      {"needed-depth", [](Settings& s) { s.species.soil_depth = centimetres(145.0); }},
      {"needed-water", [](Settings& s) { s.species.water_demand = DailyWater(2.0); }},
      {"needed-soil", [](Settings& s) { s.species.soil = "Stone"; }},
  };
}

/// What the requirements of chapter 3 ask to consider, and the result that must depend on it.
constexpr std::pair<const char*, const char*> required[] = {
    {"absorption", "insolation"}, {"cloud", "insolation"},       {"diffusion", "insolation"},
    {"albedo", "insolation"},     {"neighbours", "insolation"},  {"sun", "insolation"},
    {"heights", "orography"},     {"heights", "edaphology"},     {"rain", "hydrology"},
    {"groundwater", "hydrology"}, {"deepest-soil", "hydrology"}, {"soil-absorption", "hydrology"},
    {"cloud", "hydrology"},       {"needed-energy", "light"},    {"needed-depth", "depth"},
    {"needed-water", "moisture"}, {"needed-soil", "soil"}};

void record_dependencies(ExperimentContext& context, const std::string& form,
                         const SiteModel& model) {
  const Settings settings = usual(context.seed());
  const Results before = results_of(settings, model);
  std::map<std::string, Results> after;
  for (const Change& change : changes()) {
    Settings changed = settings;
    change.apply(changed);
    after[change.name] = results_of(changed, model);
  }
  const auto depends = [&](const char* result, const char* on) {
    return std::int64_t{after.at(on).at(result) != before.at(result)};
  };
  std::int64_t without_effect = 0;
  for (const auto& [input, result] : required) without_effect += depends(result, input) == 0;
  context.record(form + "/required", whole(std::size(required)), "inputs");
  context.record(form + "/required-without-effect", without_effect, "inputs");
  // Figure 8.7: soil depth comes from the relief alone, water from both.
  context.record(form + "/edaphology-with-sun", depends("edaphology", "sun"));
  context.record(form + "/edaphology-with-heights", depends("edaphology", "heights"));
  context.record(form + "/orography-with-sun", depends("orography", "sun"));
  context.record(form + "/insolation-with-heights", depends("insolation", "heights"));
  context.record(form + "/insolation-with-deepest-soil", depends("insolation", "deepest-soil"));
  context.record(form + "/insolation-with-the-soils-albedo", depends("insolation", "albedo"));
  context.record(form + "/hydrology-with-sun", depends("hydrology", "sun"));
  context.record(form + "/hydrology-with-deepest-soil", depends("hydrology", "deepest-soil"));
}

void run(ExperimentContext& context) {
  record_dependencies(context, "printed", *printed_site_model(lesser_switches("all")));
  record_dependencies(context, "corrected", *corrected_site_model());
  context.record("requirements/groups", std::int64_t{7}, "groups");
  // 1a-g, 2, 3, 4a-e, 5a-d, 6, 7: said to be fulfilled in sec. 8.2 to 8.6 and 9.3.
  context.record("requirements/said-to-be-fulfilled", std::int64_t{7 + 1 + 1 + 5 + 4 + 1 + 1},
                 "requirements");
}

}  // namespace

extern const ExperimentDescriptor pipeline;
constinit const ExperimentDescriptor pipeline{
    .id = "lesser2019/pipeline",
    .question = "Which result depends on which input?",
    .source = "[Lesser2019] chapter 3, sec. 8.7, figures 8.7, 8.8",
    .seconds = {0.1, 0.1, 0.1},
    .run = run,
};

}  // namespace phytobench::experiments::lesser2019
