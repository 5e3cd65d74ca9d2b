// SPDX-License-Identifier: MIT
// What a site file says, before heights and maps are read.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/terrain/relief.hpp"
#include "core/terrain/site_model.hpp"
#include "core/terrain/site_parameters.hpp"
#include "core/terrain/sun/hourly_path.hpp"
#include "core/terrain/sun/solar_position.hpp"

namespace phytobench {

/// Terrains that are computed instead of read.
enum class MadeTerrain {
  fractal,
  diamond_square,
  flat,
  plane,
  ridge,
  valley,
  cone,
  hemisphere,
  ring_wall,
  needle
};

struct HeightSource {
  std::string file;  ///< empty: made
  double conversion = 1.0;
  std::optional<double> cell_width, cell_depth;  ///< m; not set: what the file says, or made_cell
  MadeTerrain made = MadeTerrain::fractal;
  int columns = 256;
  int rows = 256;
  double relief = 400.0;   ///< m: from the lowest to the highest vertex
  double roughness = 0.5;  ///< of fractals: each octave's swing to the one before
  std::uint64_t seed = 1;
  double slope_degrees = 30.0;   ///< of plane, ridge, valley and cone
  double aspect_degrees = 90.0;  ///< of a plane: where it falls to, from east over south
  double radius = 1000.0;        ///< m: of cone, hemisphere and ring wall
  double thickness = 50.0;       ///< m: of a ring wall
};
/// The thesis' cells, m ([Lesser2019] listing 9.5).
inline constexpr double made_cell = 16.0;

/// One of the first three is given.
struct GroundSource {
  std::string soil;                    ///< everywhere
  std::vector<std::string> posterise;  ///< soils of equal bands of height, from the lowest
  std::string file;                    ///< a map of soil ids
  Length max_depth = centimetres(150.0);
};

struct SunSource {
  bool is_solar = false;
  HourlyPath hourly;
  SolarDay day{.latitude = 47.5, .longitude = 12.8};
  std::optional<int> hours;  ///< equal parts of `day`; not set: as many as it has hours
};

struct SiteChoices {
  std::string engine = "bounded_sweep";
  SiteModelOptions options;
  SurfaceEstimator surface = SurfaceEstimator::sobel;
  Tolerance depth_tolerance = Tolerance::saturating;
};

/// A species with what a plant of it needs to be placed.
struct SitePlant : PlantSpecies {
  double spacing = 1.0;        ///< m between two of them, at least
  double start_radius = 0.05;  ///< m, of the stem
};

/// An entry, where its numbers are from, and where it stands.
template <class Entry>
struct SiteEntry {
  Entry entry;
  std::string source;
  std::string place;  ///< "site.toml:12"
};

struct SiteDescription {
  std::filesystem::path file;
  std::vector<std::string> entry_files{"lesser2019", "assumed"};
  std::vector<std::string> grow;  ///< names of species; empty: all
  HeightSource heights;
  GroundSource ground;
  std::string biome;
  double neighbour_share = 0.1;
  SunSource sun;
  SiteChoices choices;
  /// Of the file itself, then of its entry files in their order; the first of a name counts.
  std::vector<SiteEntry<Biome>> biomes;
  std::vector<SiteEntry<Soil>> soils;
  std::vector<SiteEntry<SitePlant>> species;
  std::map<std::string, std::uint32_t, std::less<>> lines;  ///< of keys and sections in the file

  /// "site.toml:12" of a key, or of the section that it belongs to.
  std::string place_of(std::string_view key) const;
};

}  // namespace phytobench
