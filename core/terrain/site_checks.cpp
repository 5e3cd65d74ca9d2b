// SPDX-License-Identifier: MIT
#include "core/terrain/site_checks.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/contract/errors.hpp"
#include "core/contract/parameter_keys.hpp"
#include "core/contract/suggestion.hpp"
#include "core/terrain/shadow/shadow_registry.hpp"

namespace phytobench {

namespace {

bool is_key_given(const SiteDescription& site, std::string_view key) {
  return site.lines.find(key) != site.lines.end();
}

[[noreturn]] void fail_at_key(const SiteDescription& site, std::string_view key,
                              const std::string& problem) {
  throw InputError(fmt::format("{}: {}", site.place_of(key), problem));
}

template <class Entry>
const SiteEntry<Entry>& entry_named(const SiteDescription& site,
                                    const std::vector<SiteEntry<Entry>>& entries,
                                    std::string_view list, std::string_view name,
                                    std::string_view key) {
  std::vector<std::string> known;
  for (const SiteEntry<Entry>& entry : entries) {
    if (entry.entry.name == name) return entry;
    known.push_back(entry.entry.name);
  }
  fail_at_key(
      site, key,
      fmt::format("{}: there is no {} '{}'{}; describe it in a [[{}]], or add the file of entries "
                  "that does",
                  key, list, in_one_line(name), did_you_mean(in_one_line(name), known), list));
}

void check_heights(const SiteDescription& site) {
  const bool has_file = is_key_given(site, "heights.file"),
             has_made = is_key_given(site, "heights.made");
  if (has_file && site.heights.file.empty())
    fail_at_key(site, "heights.file",
                "heights.file is empty; give a name, or heights.made instead");
  if (!has_file && !has_made)
    fail_at_key(
        site, "heights",
        "there are no heights; give heights.file, or heights.made = \"fractal\" or another form");
}

void check_ground(const SiteDescription& site) {
  std::vector<std::string_view> given;
  for (const std::string_view key : {"ground.posterise", "ground.soil", "ground.file"})
    if (is_key_given(site, key)) given.push_back(key);
  if (given.size() > 1) fail_at_key(site, given[1], set_the_same(given[0], given[1]));
  if (given.empty())
    fail_at_key(
        site, "ground",
        "there is no soil; give ground.soil, ground.posterise or ground.file, a map of ids");
  if (is_key_given(site, "ground.soil")) soil_named(site, site.ground.soil, "ground.soil");
  if (given[0] == "ground.posterise" && site.ground.posterise.empty())
    fail_at_key(site, "ground.posterise", "ground.posterise is empty; give at least one soil");
  for (const std::string& name : site.ground.posterise) soil_named(site, name, "ground.posterise");
}

void check_losses_of(const SiteEntry<Biome>& found) {
  const Biome& biome = found.entry;
  try {
    check_losses(biome);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", found.place, error.what()));
  }
  const double most =
      std::max({biome.absorption_percent, biome.diffusion_percent, biome.cloud_percent});
  if (most > 0.0 && most <= 1.0)
    throw InputError(fmt::format(
        "{}: biome '{}' loses {:g}, {:g} and {:g} percent of its light, which look like shares; "
        "give percent, as in 45 for 0.45",
        found.place, biome.name, biome.absorption_percent, biome.diffusion_percent,
        biome.cloud_percent));
}

void check_biome(const SiteDescription& site) {
  if (!is_key_given(site, "climate.biome")) {
    std::string known;
    for (const SiteEntry<Biome>& entry : site.biomes)
      known += (known.empty() ? "" : ", ") + entry.entry.name;
    fail_at_key(site, "climate", "climate.biome is missing; give one of " + known);
  }
  biome_named(site, site.biome);
  for (const SiteEntry<Biome>& entry : site.biomes) check_losses_of(entry);
}

void check_species(const SiteDescription& site) {
  if (site.species.empty())
    fail_at_key(site, "entries", "there is no species; describe one in a [[species]]");
  if (is_key_given(site, "grow") && site.grow.empty())
    fail_at_key(site, "grow", "grow is empty; give names of species, or leave it out for all");
  for (const std::string& name : site.grow) species_named(site, name, "grow");
}

void check_sun(const SiteDescription& site) {
  const HourlyPath& path = site.sun.hourly;
  if (!site.sun.is_solar && path.start_elevation > path.max_elevation)
    fail_at_key(
        site, "sun.start_elevation",
        fmt::format("sun.start_elevation = {:g} is above sun.max_elevation = {:g}; the sun is "
                    "highest at noon",
                    path.start_elevation, path.max_elevation));
  if (site.sun.is_solar && !is_key_given(site, "sun.date"))
    fail_at_key(site, "sun.kind", "sun.date is missing; give the day, as in 2019-06-21");
  for (const std::string_view key : {"sun.latitude", "sun.longitude"})
    if (site.sun.is_solar && !is_key_given(site, key))
      fail_at_key(site, "sun.kind", fmt::format("{} is missing; give degrees", key));
}

void check_engine(const SiteDescription& site) {
  try {
    shadow_engine_named(site.choices.engine);
  } catch (const InputError& error) {
    fail_at_key(site, "model.engine", fmt::format("model.engine: {}", error.what()));
  }
}

}  // namespace

const SiteEntry<Biome>& biome_named(const SiteDescription& site, std::string_view name) {
  return entry_named(site, site.biomes, "biome", name, "climate.biome");
}

const SiteEntry<Soil>& soil_named(const SiteDescription& site, std::string_view name,
                                  std::string_view key) {
  return entry_named(site, site.soils, "soil", name, key);
}

const SiteEntry<SitePlant>& species_named(const SiteDescription& site, std::string_view name,
                                          std::string_view key) {
  return entry_named(site, site.species, "species", name, key);
}

void refuse_two_kinds_of_heights(const SiteDescription& site) {
  if (is_key_given(site, "heights.file") && is_key_given(site, "heights.made"))
    fail_at_key(site, "heights.made", set_the_same("heights.file", "heights.made"));
}

void check_description(const SiteDescription& site) {
  check_heights(site);
  check_ground(site);
  check_biome(site);
  check_species(site);
  check_sun(site);
  check_engine(site);
}

void check_units(const SiteDescription& site, const HeightField& heights) {
  constexpr double steepest = 20.0;     // times as high as wide: no terrain, but metres and degrees
  constexpr double deepest = 20'000.0;  // m from the ocean's floor to the highest peak
  const HeightRange range = height_range(heights);
  const double relief = range.highest - range.lowest;
  const double side =
      std::max(heights.columns() * heights.cell_width(), heights.rows() * heights.cell_depth());
  if (relief > deepest)
    fail_at_key(site, "heights",
                fmt::format("heights are from {:g} to {:g} m, more than Earth has; give "
                            "heights.conversion, the metres of a step in the file",
                            range.lowest, range.highest));
  if (relief > steepest * side)
    fail_at_key(
        site, "heights",
        fmt::format("heights differ by {:g} m on a map of {:g} m: units seem to be mixed; give "
                    "heights.conversion, or heights.cell_width in metres",
                    relief, side));
}

}  // namespace phytobench
