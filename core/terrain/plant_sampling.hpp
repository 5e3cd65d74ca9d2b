// SPDX-License-Identifier: MIT
// From chances to grow to plants that stand somewhere, for models that begin with plants.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/terrain/height_field.hpp"
#include "core/terrain/site_model.hpp"

namespace phytobench {

struct SampledSpecies {
  const TerrainMap* chance = nullptr;  ///< 0 to 1; NaN where nothing grows
  double spacing = 1.0;  ///< m between two of them, at least; of two species half of both sums
};

/// Darts that may not come close to those that stand (blue noise; Cook 1986, ACM Transactions on
/// Graphics 5): where there is room, plants are as dense as the chance says.
struct PlantSampling {
  std::uint64_t seed = 0;
  /// Plants wanted on the whole map, or darts for each hectare and species where the chance is 1.
  double number = 1000.0;
  bool is_per_hectare = false;
};

/// At most so many plants, or darts for each hectare, are thrown.
inline constexpr double most_sampled_plants = 1e7;

struct SampledPlant {
  double east = 0.0;   ///< m from the west border of the first column's cell
  double south = 0.0;  ///< m from the north border of the first row's cell
  std::uint32_t species = 0;

  friend bool operator==(const SampledPlant&, const SampledPlant&) = default;
};

/// In the order in which they were thrown. Fewer than wanted where there is no more room. A pure
/// function of what is given. Maps have the size of `heights`. Throws InputError if more darts than
/// most_sampled_plants would be thrown.
std::vector<SampledPlant> sampled_plants(const HeightField& heights,
                                         std::span<const SampledSpecies> species,
                                         const PlantSampling& sampling);

/// Plants that are wanted, or darts that are thrown.
double sampled_number(const HeightField& heights, std::span<const SampledSpecies> species,
                      const PlantSampling& sampling);

/// A species in the table of plants.
struct PlantColumns {
  std::string_view name;
  double stem_radius = 0.05;  ///< m
};

/// The table that `compete --plants` reads: x towards east, y towards north from the map's
/// south-west corner, radius, species.
std::string sampled_plants_csv(const HeightField& heights, std::span<const SampledPlant> plants,
                               std::span<const PlantColumns> species);

}  // namespace phytobench
