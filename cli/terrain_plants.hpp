// SPDX-License-Identifier: MIT
// Plants placed by their chances to grow, with what `compete` needs to take over.
#pragma once

#include <cstdint>
#include <vector>

#include "cli/commands.hpp"
#include "core/contract/text_file.hpp"
#include "core/terrain/plant_sampling.hpp"
#include "core/terrain/site.hpp"

namespace phytobench::cli {

/// --plants and --seed. Throws InputError.
PlantSampling plant_sampling_from(const TerrainOptions& options);

struct PlacedPlants {
  std::vector<std::uint64_t> counts;  ///< of each species
  double wanted = 0.0;                ///< plants; or darts, if so many are for each hectare
  /// placed.csv, and stand.toml that begins with it; none without plants, of which there is no
  /// stand.
  std::vector<FileContent> files;
};

/// `chances` are those of site.species, in this order.
PlacedPlants placed_plants(const Site& site, const std::vector<TerrainMap>& chances,
                           const PlantSampling& sampling);

}  // namespace phytobench::cli
