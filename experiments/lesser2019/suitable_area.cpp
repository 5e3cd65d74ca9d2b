// SPDX-License-Identifier: MIT
// On real land: where species can grow, and what each erratum, put back in alone, changes in that.
// Biomes but the polar one, soils but dirt, and some species are ours: the thesis does not print
// them.
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/terrain/made/posterised.hpp"
#include "core/terrain/site_maps.hpp"
#include "experiments/experiment.hpp"
#include "experiments/lesser2019/real_tile.hpp"
#include "experiments/lesser2019/site_scenes.hpp"
#include "experiments/lesser2019/thesis_site.hpp"
#include "reference/lesser2019_site_model.hpp"

namespace phytobench::experiments::lesser2019 {

namespace {

struct NamedBiome {
  const char* name;
  Biome biome;
};

std::vector<NamedBiome> biomes() {
  const Biome temperate{.name = "temperate",
                        .absorption_percent = 40.0,
                        .diffusion_percent = 8.0,
                        .cloud_percent = 30.0,
                        .rain = DailyWater(4.0),
                        .groundwater = DailyWater(4.0)};
  const Biome subtropical{.name = "subtropical",
                          .absorption_percent = 20.0,
                          .diffusion_percent = 7.0,
                          .cloud_percent = 20.0,
                          .rain = DailyWater(3.0),
                          .groundwater = DailyWater(3.0)};
  return {{"polar", polar_zone()},
          {"assumed-temperate", temperate},
          {"assumed-subtropical", subtropical}};
}

/// Stone low down is not likely; it is what posterising a height map gives.
std::vector<Soil> soils() {
  return {{.name = "Clay", .id = 10, .albedo = 0.20, .water_absorption = 0.45},
          thesis_dirt(),
          {.name = "Stone", .id = 80, .albedo = 0.275, .water_absorption = 0.15}};
}

/// Figure 10.2, then with what sec. 10.4 prints of a fir and a made-up rest, and one that needs no
/// water.
std::vector<PlantSpecies> species() {
  return {appletree(),
          shrub(),
          moss(),
          {.name = "assumed-fir",
           .energy_demand = DailyEnergy(2200.0),
           .water_demand = DailyWater(0.5),
           .soil = "Clay",
           .soil_depth = centimetres(60.0)},
          {.name = "assumed-cactus",
           .energy_demand = DailyEnergy(3000.0),
           .water_demand = DailyWater(0.0),
           .soil = "Dirt",
           .soil_depth = centimetres(10.0)}};
}

/// Errata that act on a path of 13 hours; those of even and short days do not.
constexpr std::array one_by_one = {"E01", "E02", "E07", "E08", "E10", "E12", "E13",
                                   "E14", "E15", "E16", "E18", "E21", "E22", "E23"};

constexpr std::array<std::pair<const char*, double>, 3> thresholds = {
    {{"some", 0.0}, {"quarter", 0.25}, {"half", 0.5}}};

/// Of one form: the square kilometres of each species at each threshold.
class Areas {
 public:
  Areas(const HeightField& tile, const Biome& biome, const std::string& switches, int threads) {
    const std::vector<Soil> kinds = soils();
    const std::array<std::int16_t, 3> ids = {0, 1, 2};
    const SiteInput input{
        .heights = tile, .soils = kinds, .soil_of = posterised(tile, ids).numbers, .biome = biome};
    const LesserSwitches form = lesser_switches(switches);
    const auto model = printed_site_model(form);
    const SiteOptions options{
        .suns = model->sun_path({.hours = thesis_hours, .max_elevation = 80.0}),
        .surface = SurfaceEstimator::six_faces,
        .threads = threads};
    const SiteMaps maps = site_maps(input, options, *model, *lesser_shadows(form));
    for (const PlantSpecies& plant : species()) {
      const ChanceMaps chances = chance_maps(input, maps, plant, *model, options);
      for (const auto& [name, least] : thresholds)
        km2_.push_back(suitable_area(tile, chances.chance, least).suitable / 1e6);
    }
  }

  double at(std::size_t plant, std::size_t threshold) const {
    return km2_[plant * thresholds.size() + threshold];
  }
  /// How many of the areas are others.
  std::int64_t changed_from(const Areas& other) const {
    std::int64_t count = 0;
    for (std::size_t i = 0; i < km2_.size(); ++i) count += km2_[i] != other.km2_[i];
    return count;
  }

 private:
  std::vector<double> km2_;
};

void record_areas(ExperimentContext& context, const std::string& name, const Areas& areas) {
  const std::vector<PlantSpecies> plants = species();
  for (std::size_t plant = 0; plant < plants.size(); ++plant)
    for (std::size_t t = 0; t < thresholds.size(); ++t)
      context.record(fmt::format("{}/{}/{}", name, plants[plant].name, thresholds[t].first),
                     areas.at(plant, t), "km2");
}

void record_biome(ExperimentContext& context, const HeightField& tile, const NamedBiome& biome) {
  const int threads = context.untimed_threads();
  const std::string start = std::string(biome.name) + "/";
  const Areas corrected(tile, biome.biome, "none", threads);
  record_areas(context, start + "corrected", corrected);
  const Areas printed(tile, biome.biome, "all", threads);
  record_areas(context, start + "printed", printed);
  context.record(start + "printed/changed", printed.changed_from(corrected), "areas");
  for (const char* erratum : one_by_one) {
    context.progress(fmt::format("{}, {}", biome.name, erratum));
    const Areas alone(tile, biome.biome, erratum, threads);
    record_areas(context, start + erratum, alone);
    context.record(fmt::format("{}{}/changed", start, erratum), alone.changed_from(corrected),
                   "areas");
  }
}

void run(ExperimentContext& context) {
  const HeightField tile = real_tile_on_squares(context.tier());
  context.record("land",
                 static_cast<double>(tile.size()) * tile.cell_width() * tile.cell_depth() / 1e6,
                 "km2");
  context.record("areas", whole(species().size() * thresholds.size()), "areas");
  for (const NamedBiome& biome : biomes()) record_biome(context, tile, biome);
}

}  // namespace

extern const ExperimentDescriptor suitable_area;
constinit const ExperimentDescriptor suitable_area{
    .id = "lesser2019/suitable-area",
    .question = "How much land suits each species, and what does each erratum change in that?",
    .source = "[Lesser2019] sec. 10.4",
    .seconds = {2.0, 25.0, 25.0},
    .run = run,
};

}  // namespace phytobench::experiments::lesser2019
