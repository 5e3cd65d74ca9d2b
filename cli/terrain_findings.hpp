// SPDX-License-Identifier: MIT
// What `phytobench terrain` finds out about a site, and how it is shown: as text and as a document
// of phytobench/terrain-1.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "core/terrain/site.hpp"
#include "core/terrain/site_description.hpp"

namespace phytobench::cli {

/// Chances from which on ground counts as suitable; 0 is any.
inline constexpr std::array<double, 3> suitable_from{0.0, 0.25, 0.5};

/// What the least of the factors can be. Where the soil is wrong, no other matters.
inline constexpr std::array<const char*, 4> factor_names{"soil", "light", "water", "depth"};

struct MapRange {
  double mean = 0.0;
  double least = 0.0;
  double most = 0.0;
  std::size_t cells = 0;  ///< with a number; none: the others are NaN
};

/// Of the numbers that there are.
MapRange range_of(const TerrainMap& map);

/// A soil that occurs.
struct SoilFindings {
  std::string name;
  std::string source;
  double m2 = 0.0;
};

struct SpeciesFindings {
  std::string name;
  std::string source;
  MapRange chance;
  std::array<double, suitable_from.size()> suitable_m2{};
  double with_data_m2 = 0.0;
  /// m2 where this factor is the least and below 1, and none before it is as small.
  std::array<double, factor_names.size()> limited_m2{};
  std::uint64_t plants = 0;  ///< that were placed
};

struct TerrainFindings {
  double hours = 0.0;  ///< from sunrise to sunset
  std::size_t sun_positions = 0;
  std::string engine;
  std::string as_printed;  ///< errata; empty: none
  std::string biome_source;
  std::vector<SoilFindings> soils;
  MapRange height, slope, lit_hours, raw_energy, energy, soil_depth, water;
  std::vector<SpeciesFindings> species;
  double wanted_plants = 0.0;  ///< or darts, if so many are for each hectare
  std::vector<std::string> files;
  std::vector<std::string> older_files;  ///< of earlier runs, in the same folder
};

/// Those on which there are heights, in the order of the site's soils.
std::vector<SoilFindings> soil_findings(const SiteDescription& description, const Site& site);

std::uint64_t placed_plants_of(const TerrainFindings& findings);

/// With settings and values enough to make the same again.
struct TerrainDocument {
  const SiteDescription& description;
  const Site& site;
  const TerrainFindings& findings;
  const TerrainOptions& options;
};

SpeciesFindings species_findings(const HeightField& heights, const SiteEntry<SitePlant>& species,
                                 const ChanceMaps& maps);

std::string terrain_text(const Site& site, const TerrainFindings& findings,
                         const TerrainOptions& options);
std::string terrain_json(const TerrainDocument& document);

}  // namespace phytobench::cli
