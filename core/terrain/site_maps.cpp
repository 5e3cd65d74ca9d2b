// SPDX-License-Identifier: MIT
#include "core/terrain/site_maps.hpp"

#include <algorithm>
#include <cmath>

#include "core/contract/check.hpp"
#include "core/contract/errors.hpp"
#include "core/parallel/for_blocks.hpp"

namespace phytobench {

namespace {

TerrainMap map_like(const HeightField& field) {
  return {field.columns(), field.rows(), std::vector<double>(field.size(), HeightField::no_data)};
}

/// Fills a map by value(index) at vertices with data, row by row.
template <class Value>
TerrainMap mapped(const HeightField& field, int threads, const Value& value) {
  TerrainMap map = map_like(field);
  for_tasks(static_cast<std::size_t>(field.rows()), threads, [&](std::size_t row) {
    const std::size_t first = field.index(0, static_cast<int>(row));
    for (std::size_t i = first; i < first + static_cast<std::size_t>(field.columns()); ++i)
      if (!std::isnan(field.heights()[i])) map.values[i] = value(i);
  });
  return map;
}

/// What the day brings above the air.
TerrainMap raw_energy(const SiteInput& input, const SiteOptions& options, const SiteModel& model,
                      const LitMaps& lit, const std::vector<SurfaceGradient>& surfaces) {
  const auto columns = static_cast<std::size_t>(input.heights.columns());
  return mapped(input.heights, options.threads, [&](std::size_t i) {
    EnergyPerArea sum;
    for (std::size_t hour = 0; hour < options.suns.size(); ++hour)
      if (lit.is_lit(hour, static_cast<int>(i % columns), static_cast<int>(i / columns)))
        sum = sum + model.hourly_energy(surfaces[i], options.suns[hour]);
    return (sum / one_day).value() * options.hours_each;
  });
}

const Soil* soil_at(const SiteInput& input, std::size_t i) {
  const int soil = input.soil_of[i];
  return soil < 0 ? nullptr : &input.soils[static_cast<std::size_t>(soil)];
}

}  // namespace

void check_site(const SiteInput& input) {
  if (height_range(input.heights).empty())
    throw InputError("the height field has no vertex with data; give one that has");
  if (input.soil_of.size() != input.heights.size())
    throw InputError("the soil map has " + std::to_string(input.soil_of.size()) +
                     " entries and the height field " + std::to_string(input.heights.size()) +
                     " vertices; give maps of the same size");
  for (const std::int16_t soil : input.soil_of)
    if (soil >= 0 && static_cast<std::size_t>(soil) >= input.soils.size())
      throw InputError("the soil map names soil " + std::to_string(soil) +
                       ", for which there is no entry; describe it or change the map");
  if (!(input.neighbour_share >= 0.0 && input.neighbour_share <= 1.0))
    throw InputError("neighbours get a share of " + std::to_string(input.neighbour_share) +
                     " of what a vertex throws back; give 0 to 1");
  check_losses(input.biome);
}

SiteMaps site_maps(const SiteInput& input, const SiteOptions& options, const SiteModel& model,
                   ShadowEngine& shadows, const std::function<void(std::string_view)>& progress) {
  PHYTOBENCH_EXPECT(options.hours_each > 0.0);
  const auto stage = [&](std::string_view name) {
    if (progress) progress(name);
  };
  SiteMaps maps;
  stage("shadows");
  shadows.cast(input.heights, options.suns, {.threads = options.threads}, maps.lit);
  stage("relief");
  const std::vector<SurfaceGradient> surfaces =
      surface_gradients(input.heights, options.surface, options.threads);
  maps.slope = mapped(input.heights, options.threads,
                      [&](std::size_t i) { return slope_degrees(surfaces[i]); });
  stage("energy");
  maps.raw_energy = raw_energy(input, options, model, maps.lit, surfaces);
  maps.incoming = mapped(input.heights, options.threads, [&](std::size_t i) {
    return model.through_air(DailyEnergy(maps.raw_energy.values[i]), input.biome).value();
  });
  const TerrainMap albedo = mapped(input.heights, options.threads, [&](std::size_t i) {
    const Soil* soil = soil_at(input, i);
    return soil ? soil->albedo : HeightField::no_data;
  });
  maps.energy = model.absorbed(maps.incoming, albedo, input.neighbour_share, options.threads);
  stage("soil depth and water");
  maps.soil_depth = mapped(input.heights, options.threads, [&](std::size_t i) {
    return model.soil_depth(maps.slope.values[i], input.max_soil_depth).value();
  });
  maps.water = mapped(input.heights, options.threads, [&](std::size_t i) {
    const Soil* soil = soil_at(input, i);
    if (!soil) return HeightField::no_data;
    return model
        .water(Length(maps.soil_depth.values[i]), *soil, input.biome,
               DailyEnergy(maps.energy.values[i]))
        .value();
  });
  return maps;
}

ChanceMaps chance_maps(const SiteInput& input, const SiteMaps& maps, const PlantSpecies& species,
                       const SiteModel& model, const SiteOptions& options) {
  const HeightField& field = input.heights;
  const auto factor = [&](const TerrainMap& available, double needed, Tolerance tolerance) {
    return mapped(field, options.threads, [&](std::size_t i) {
      const double there = available.values[i];
      return std::isnan(there) ? there : model.chance(there, needed, tolerance);
    });
  };
  ChanceMaps result;
  result.light = factor(maps.energy, species.energy_demand.value(), Tolerance::triangle);
  result.water = factor(maps.water, species.water_demand.value(), Tolerance::triangle);
  result.depth = factor(maps.soil_depth, species.soil_depth.value(), options.depth_tolerance);
  result.soil = mapped(field, options.threads, [&](std::size_t i) {
    const Soil* soil = soil_at(input, i);
    if (!soil) return HeightField::no_data;
    return species.soil.empty() || species.soil == soil->name ? 1.0 : 0.0;
  });
  result.chance = mapped(field, options.threads, [&](std::size_t i) {
    double least = result.soil.values[i];
    for (const TerrainMap* map : {&result.light, &result.water, &result.depth})
      least = std::isnan(map->values[i]) ? map->values[i] : std::min(least, map->values[i]);
    return least;
  });
  return result;
}

SuitableArea suitable_area(const HeightField& heights, const TerrainMap& chance, double least) {
  PHYTOBENCH_EXPECT(chance.values.size() == heights.size());
  std::size_t with_data = 0, suitable = 0;
  for (const double value : chance.values) {
    if (std::isnan(value)) continue;
    ++with_data;
    if (least > 0.0 ? value >= least : value > 0.0) ++suitable;
  }
  const double cell = heights.cell_width() * heights.cell_depth();
  return {static_cast<double>(suitable) * cell, static_cast<double>(with_data) * cell};
}

}  // namespace phytobench
