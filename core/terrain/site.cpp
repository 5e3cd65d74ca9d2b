// SPDX-License-Identifier: MIT
#include "core/terrain/site.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "core/contract/errors.hpp"
#include "core/terrain/files/same_ground.hpp"
#include "core/terrain/made/posterised.hpp"
#include "core/terrain/site_checks.hpp"
#include "core/terrain/soil_map.hpp"

namespace phytobench {

namespace {

/// What reading a file has to say, with the key that names it.
template <class Read>
auto read_named(const SiteDescription& site, const std::string& key, const Read& read) {
  try {
    return read();
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}: {}", site.place_of(key), key, error.what()));
  }
}

/// The first of each name.
std::vector<SiteEntry<Soil>> soils_of(const SiteDescription& site) {
  std::vector<SiteEntry<Soil>> soils;
  std::set<std::string> names;
  for (const SiteEntry<Soil>& entry : site.soils)
    if (names.insert(entry.entry.name).second) soils.push_back(entry);
  return soils;
}

void refuse_equal_ids(const std::vector<SiteEntry<Soil>>& soils) {
  for (std::size_t i = 0; i < soils.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (soils[i].entry.id == soils[j].entry.id)
        throw InputError(
            fmt::format("{}: soils '{}' and '{}' (at {}) have the same id {}; give "
                        "each its own, or leave entries of one out",
                        soils[i].place, soils[i].entry.name, soils[j].entry.name, soils[j].place,
                        soils[i].entry.id));
}

std::int16_t index_named(const std::vector<Soil>& soils, const std::string& name) {
  const auto found =
      std::find_if(soils.begin(), soils.end(), [&](const Soil& soil) { return soil.name == name; });
  return static_cast<std::int16_t>(found - soils.begin());
}

std::vector<std::int16_t> mapped_soils(const SiteDescription& site, const SiteInput& input,
                                       const std::optional<GeoReference>& place) {
  return read_named(site, "ground.file", [&] {
    const NumberMap map = read_number_map(site.ground.file);
    const HeightField& heights = input.heights;
    if (map.columns != heights.columns() || map.rows != heights.rows())
      throw InputError(fmt::format(
          "{}: has {} columns and {} rows, and the heights {} and {}; give maps of the same size",
          site.ground.file, map.columns, map.rows, heights.columns(), heights.rows()));
    if (map.place && place)
      refuse_other_ground({site.ground.file, *map.place}, {site.heights.file, *place}, map.columns,
                          map.rows);
    return soils_of_ids(map, input.soils, site.ground.file);
  });
}

std::vector<std::int16_t> soil_of(const SiteDescription& site, const SiteInput& input,
                                  const std::optional<GeoReference>& place) {
  if (!site.ground.file.empty()) return mapped_soils(site, input, place);
  if (!site.ground.soil.empty())
    return std::vector<std::int16_t>(input.heights.size(),
                                     index_named(input.soils, site.ground.soil));
  std::vector<std::int16_t> indices;
  for (const std::string& name : site.ground.posterise)
    indices.push_back(index_named(input.soils, name));
  return posterised(input.heights, indices).numbers;
}

/// All of them without a choice, the first of each name.
std::vector<SiteEntry<SitePlant>> chosen_species(const SiteDescription& site,
                                                 const std::vector<std::string>& grow) {
  std::vector<std::string> names = grow.empty() ? site.grow : grow;
  if (names.empty())
    for (const SiteEntry<SitePlant>& entry : site.species) names.push_back(entry.entry.name);
  std::vector<SiteEntry<SitePlant>> species;
  std::set<std::string> known;
  for (const std::string& name : names) {
    if (!known.insert(name).second) continue;
    const SiteEntry<SitePlant>& entry =
        species_named(site, name, grow.empty() ? "grow" : "--species");
    if (!entry.entry.soil.empty() &&
        std::none_of(site.soils.begin(), site.soils.end(),
                     [&](const auto& soil) { return soil.entry.name == entry.entry.soil; }))
      throw InputError(
          fmt::format("{}: species '{}' grows on soil '{}', which has no entry; "
                      "describe it in a [[soil]], or leave the species out (grow)",
                      entry.place, name, entry.entry.soil));
    species.push_back(entry);
  }
  return species;
}

double soilless_share(const SiteInput& input) {
  std::size_t with_data = 0, soilless = 0;
  for (std::size_t i = 0; i < input.heights.size(); ++i) {
    if (std::isnan(input.heights.heights()[i])) continue;
    ++with_data;
    if (input.soil_of[i] < 0) ++soilless;
  }
  return static_cast<double>(soilless) / static_cast<double>(with_data);
}

}  // namespace

Site load_site(const SiteDescription& description, const std::vector<std::string>& grow) {
  Site site;
  site.species = chosen_species(description, grow);
  const std::vector<SiteEntry<Soil>> soils = soils_of(description);
  if (!description.ground.file.empty()) refuse_equal_ids(soils);
  HeightFile heights = heights_of(description);
  check_units(description, heights.field);
  site.place = std::move(heights.place);
  site.heights = std::move(heights.format);
  SiteInput& input = site.input;
  input.heights = std::move(heights.field);
  for (const SiteEntry<Soil>& soil : soils) input.soils.push_back(soil.entry);
  input.soil_of = soil_of(description, input, site.place);
  input.biome = biome_named(description, description.biome).entry;
  input.max_soil_depth = description.ground.max_depth;
  input.neighbour_share = description.neighbour_share;
  check_site(input);
  site.soilless_share = soilless_share(input);
  if (site.soilless_share == 1.0)
    throw InputError(
        fmt::format("{}: has no soil where there are heights; give maps of the same "
                    "ground",
                    description.place_of("ground.file")));
  site.options.surface = description.choices.surface;
  site.options.depth_tolerance = description.choices.depth_tolerance;
  return site;
}

void set_sun(SiteOptions& options, const SiteDescription& description, const SiteModel& model) {
  const SunSource& sun = description.sun;
  if (!sun.is_solar) {
    options.suns = model.sun_path(sun.hourly);
    options.hours_each = 1.0;
    return;
  }
  const auto [daylight, angles] = read_named(description, "sun.kind", [&] {
    const double hours = daylight_hours(sun.day);
    const int whole = static_cast<int>(std::lround(hours));
    return std::pair{hours, solar_path(sun.day, sun.hours.value_or(std::max(1, whole)))};
  });
  if (angles.empty())
    throw InputError(
        fmt::format("{}: the sun does not rise at {:g} degrees on {}-{:02}-{:02}; "
                    "give another day",
                    description.place_of("sun.date"), sun.day.latitude, sun.day.year, sun.day.month,
                    sun.day.day));
  options.suns.clear();
  for (const SunAngles& angle : angles) options.suns.push_back(direction_of(angle));
  options.hours_each = daylight / static_cast<double>(angles.size());
}

}  // namespace phytobench
