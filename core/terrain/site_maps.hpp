// SPDX-License-Identifier: MIT
// The whole way from a height field to the chances of species to grow on it ([Lesser2019] fig.
// 8.7): sunlight and relief, soil depth, water, chance.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "core/terrain/height_field.hpp"
#include "core/terrain/shadow/lit_maps.hpp"
#include "core/terrain/shadow/shadow_engine.hpp"
#include "core/terrain/site_model.hpp"

namespace phytobench {

/// What the maps are made from. Indices of `soil_of` count `soils`; -1 where there is no soil.
struct SiteInput {
  HeightField heights;
  std::vector<Soil> soils;
  std::vector<std::int16_t> soil_of;  ///< of each vertex, row by row
  Biome biome;
  Length max_soil_depth{1.5};
  double neighbour_share = 0.1;  ///< of what a vertex throws back that its neighbours get, 0 to 1
};

struct SiteOptions {
  std::vector<SunDirection> suns;  ///< where it stands, in equal steps of time
  double hours_each = 1.0;         ///< that one of them stands for, more than 0
  SurfaceEstimator surface = SurfaceEstimator::sobel;
  Tolerance depth_tolerance = Tolerance::saturating;
  int threads = 1;  ///< results are the same for any number
};

/// Row by row; NaN at vertices without data, and without soil where soil decides.
struct SiteMaps {
  LitMaps lit;
  TerrainMap slope;       ///< degrees
  TerrainMap raw_energy;  ///< kcal/m2 a day, above the air
  TerrainMap incoming;    ///< the same, through the air
  TerrainMap energy;      ///< the same, kept by the ground
  TerrainMap soil_depth;  ///< m
  TerrainMap water;       ///< l/m2 a day
};

/// Throws InputError if the parts do not fit each other: sizes, soils, losses, shares.
void check_site(const SiteInput& input);

/// `shadows` finds what is lit. The input must have been checked. `progress` hears the name of each
/// stage; it may throw.
SiteMaps site_maps(const SiteInput& input, const SiteOptions& options, const SiteModel& model,
                   ShadowEngine& shadows,
                   const std::function<void(std::string_view)>& progress = {});

/// The factors of one species' chance, and the least of them, which decides (Liebig's law).
struct ChanceMaps {
  TerrainMap light;
  TerrainMap water;
  TerrainMap depth;
  TerrainMap soil;
  TerrainMap chance;
};
ChanceMaps chance_maps(const SiteInput& input, const SiteMaps& maps, const PlantSpecies& species,
                       const SiteModel& model, const SiteOptions& options);

/// m2 of the map where the chance is `least` or more (more than 0 for 0), and m2 with data.
struct SuitableArea {
  double suitable = 0.0;
  double with_data = 0.0;
};
SuitableArea suitable_area(const HeightField& heights, const TerrainMap& chance, double least);

}  // namespace phytobench
