// SPDX-License-Identifier: MIT
#include "cli/terrain_plants.hpp"

#include <charconv>

#include <fmt/format.h>

#include "core/contract/check.hpp"
#include "core/contract/errors.hpp"

namespace phytobench::cli {

namespace {

/// Not plants.csv: a run of `compete` copies what it starts from into a folder where that is the
/// name of its own table.
constexpr const char* plants_table_name = "placed.csv";

/// A stand for `compete` on the same ground. What the plants do there is the user's to say.
std::string placed_stand_file(const Site& site) {
  const HeightField& heights = site.input.heights;
  std::string text = fmt::format(
      "# The plants that `phytobench terrain` has placed, for `phytobench compete`. Growth, zones "
      "and competition are at their\n# defaults: phytobench compete --example explains every key.\n"
      "plants = \"{}\"\nground.size = [{}, {}]\nground.torus = false\n",
      plants_table_name, heights.columns() * heights.cell_width(),
      heights.rows() * heights.cell_depth());
  for (const SiteEntry<SitePlant>& species : site.species)
    text += fmt::format("\n[[species]]\nname = \"{}\"\n", species.entry.name);
  return text;
}

}  // namespace

PlantSampling plant_sampling_from(const TerrainOptions& options) {
  std::string text = options.plants;
  PlantSampling sampling{.seed = options.seed};
  constexpr std::string_view per_hectare = "/ha";
  if (text.ends_with(per_hectare)) {
    sampling.is_per_hectare = true;
    text.resize(text.size() - per_hectare.size());
  }
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, sampling.number);
  const bool is_number = error == std::errc() && stop == end;
  if (!is_number || !(sampling.number > 0.0 && sampling.number <= most_sampled_plants))
    throw InputError(fmt::format(
        "--plants {}: give a number > 0 and <= {:g}, as in 1000, or 200/ha for each hectare",
        options.plants, most_sampled_plants));
  return sampling;
}

PlacedPlants placed_plants(const Site& site, const std::vector<TerrainMap>& chances,
                           const PlantSampling& sampling) {
  PHYTOBENCH_EXPECT(chances.size() == site.species.size());
  std::vector<SampledSpecies> sampled;
  std::vector<PlantColumns> columns;
  for (std::size_t i = 0; i < chances.size(); ++i) {
    const SitePlant& plant = site.species[i].entry;
    sampled.push_back({&chances[i], plant.spacing});
    columns.push_back({plant.name, plant.start_radius});
  }
  const HeightField& heights = site.input.heights;
  const std::vector<SampledPlant> plants = sampled_plants(heights, sampled, sampling);
  PlacedPlants placed{.counts = std::vector<std::uint64_t>(chances.size()),
                      .wanted = sampled_number(heights, sampled, sampling),
                      .files = {}};
  for (const SampledPlant& plant : plants) ++placed.counts[plant.species];
  if (plants.empty()) return placed;
  placed.files.push_back({plants_table_name, sampled_plants_csv(heights, plants, columns)});
  placed.files.push_back({"stand.toml", placed_stand_file(site)});
  return placed;
}

}  // namespace phytobench::cli
