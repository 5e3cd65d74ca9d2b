// SPDX-License-Identifier: MIT
// Sec. 4.1.3, 10.4: soils from a posterised height map.
#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <vector>

#include "core/terrain/made/posterised.hpp"
#include "core/terrain/site_maps.hpp"
#include "experiments/experiment.hpp"
#include "experiments/lesser2019/site_scenes.hpp"
#include "experiments/lesser2019/thesis_site.hpp"

namespace phytobench::experiments::lesser2019 {

namespace {

constexpr std::array<std::int16_t, 6> ids = {0, 1, 2, 3, 4, 5};

void record_intervals(ExperimentContext& context, const HeightField& field, const NumberMap& map) {
  std::array<double, ids.size()> lowest, highest;
  lowest.fill(std::numeric_limits<double>::infinity());
  highest.fill(-std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < field.size(); ++i) {
    const auto id = static_cast<std::size_t>(map.numbers[i]);
    lowest[id] = std::min(lowest[id], field.heights()[i]);
    highest[id] = std::max(highest[id], field.heights()[i]);
  }
  std::int64_t overlaps = 0;
  for (std::size_t id = 1; id < ids.size(); ++id) overlaps += lowest[id] <= highest[id - 1];
  context.record("intervals-that-overlap", overlaps, "intervals");
  // Of any two vertices the higher one has no smaller id.
  std::vector<std::size_t> order(field.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return field.heights()[a] < field.heights()[b];
  });
  std::int64_t inversions = 0;
  for (std::size_t i = 1; i < order.size(); ++i)
    inversions += map.numbers[order[i]] < map.numbers[order[i - 1]];
  context.record("inversions", inversions, "vertices");
  context.record(
      "ids", whole(std::set<std::int16_t>(map.numbers.begin(), map.numbers.end()).size()), "ids");
  context.record("different-heights",
                 whole(std::set<double>(field.heights().begin(), field.heights().end()).size()),
                 "heights");
}

/// A species that needs one of the soils grows nowhere else.
void record_species(ExperimentContext& context, const HeightField& field, const NumberMap& map) {
  SiteInput input{.heights = field, .soils = {}, .soil_of = map.numbers, .biome = polar_zone()};
  for (const std::int16_t id : ids) {
    Soil soil = thesis_dirt();
    soil.id = id;
    soil.name = "soil " + std::to_string(id);
    input.soils.push_back(soil);
  }
  const auto model = corrected_site_model();
  const SiteOptions options{.suns = model->sun_path({.hours = thesis_hours})};
  const SiteMaps maps =
      site_maps(input, options, *model, *shadow_engine_named("max_pyramid").create());
  PlantSpecies species = moss();
  species.soil = "soil 2";
  species.water_demand = DailyWater(0.0);
  const ChanceMaps chances = chance_maps(input, maps, species, *model, options);
  std::int64_t elsewhere = 0, there = 0, neither_nor = 0;
  for (std::size_t i = 0; i < field.size(); ++i) {
    const bool grows = chances.chance.values[i] > 0.0;
    (map.numbers[i] == 2 ? there : elsewhere) += grows;
    neither_nor += chances.soil.values[i] != 0.0 && chances.soil.values[i] != 1.0;
  }
  context.record("grows-on-its-soil", there, "vertices");
  context.record("grows-elsewhere", elsewhere, "vertices");
  context.record("soil-chances-neither-0-nor-1", neither_nor, "vertices");
}

void run(ExperimentContext& context) {
  const HeightField field = fractal_field(64, thesis_cell, 150.0, context.seed() + 7);
  const NumberMap map = posterised(field, ids);
  record_intervals(context, field, map);
  record_species(context, field, map);
}

}  // namespace

extern const ExperimentDescriptor posterise;
constinit const ExperimentDescriptor posterise{
    .id = "lesser2019/posterise",
    .question = "Do soils from a posterised map follow the height?",
    .source = "[Lesser2019] sec. 4.1.3, 10.4, figure 10.5",
    .seconds = {0.02, 0.02, 0.02},
    .run = run,
};

}  // namespace phytobench::experiments::lesser2019
