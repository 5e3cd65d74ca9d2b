// SPDX-License-Identifier: MIT
#include "cli/terrain_settings.hpp"

#include <cmath>
#include <filesystem>
#include <optional>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/option_values.hpp"
#include "core/contract/errors.hpp"
#include "core/terrain/site_checks.hpp"
#include "core/terrain/site_keys.hpp"

namespace phytobench::cli {

namespace {

using nlohmann::ordered_json;

/// null: not given, and without a default.
struct Setting {
  std::string_view key;
  ordered_json value;
};

template <class Value>
ordered_json setting_or_null(const std::optional<Value>& value) {
  return value ? ordered_json(*value) : ordered_json(nullptr);
}

/// Text or a list.
template <class Value>
ordered_json unless_empty(const Value& value) {
  return value.empty() ? ordered_json(nullptr) : ordered_json(value);
}

const SiteKey& site_key_named(std::string_view name) {
  for (const SiteKey& key : site_keys())
    if (key.name == name) return key;
  throw ContractViolation(fmt::format("no key of a site is named {}", name));
}

/// As a site file writes it.
template <class Choice>
Setting chosen_setting(std::string_view key, Choice choice) {
  const auto& words = std::get<SiteChoice>(site_key_named(key).kind).words;
  return {key, std::string(words.at(static_cast<std::size_t>(choice)))};
}

/// As the file had them: hundredths of a metre come back with a last digit that nobody wrote.
double written_centimetres(Length length) {
  constexpr double finer_than_any = 1e9;
  return std::round(finer_than_any * in_centimetres(length)) / finer_than_any;
}

std::vector<Setting> height_settings(const HeightSource& heights) {
  if (!heights.file.empty())
    return {{"heights.file", heights.file},
            {"heights.conversion", heights.conversion},
            {"heights.cell_width", setting_or_null(heights.cell_width)},
            {"heights.cell_depth", setting_or_null(heights.cell_depth)}};
  const double width = heights.cell_width.value_or(made_cell);
  return {chosen_setting("heights.made", heights.made),
          {"heights.columns", heights.columns},
          {"heights.rows", heights.rows},
          {"heights.cell_width", width},
          {"heights.cell_depth", heights.cell_depth.value_or(width)},
          {"heights.relief", heights.relief},
          {"heights.roughness", heights.roughness},
          {"heights.seed", heights.seed},
          {"heights.slope", heights.slope_degrees},
          {"heights.aspect", heights.aspect_degrees},
          {"heights.radius", heights.radius},
          {"heights.thickness", heights.thickness}};
}

std::vector<Setting> ground_settings(const SiteDescription& site) {
  return {{"ground.posterise", unless_empty(site.ground.posterise)},
          {"ground.soil", unless_empty(site.ground.soil)},
          {"ground.file", unless_empty(site.ground.file)},
          {"ground.max_depth", written_centimetres(site.ground.max_depth)},
          {"climate.biome", site.biome},
          {"climate.neighbour_share", site.neighbour_share}};
}

std::vector<Setting> sun_settings(const SunSource& sun) {
  if (sun.is_solar)
    return {
        {"sun.kind", "solar"},
        {"sun.hours", setting_or_null(sun.hours)},
        {"sun.latitude", sun.day.latitude},
        {"sun.longitude", sun.day.longitude},
        {"sun.date", fmt::format("{:04}-{:02}-{:02}", sun.day.year, sun.day.month, sun.day.day)}};
  return {{"sun.kind", "hourly"},
          {"sun.hours", sun.hourly.hours},
          {"sun.start_elevation", sun.hourly.start_elevation},
          {"sun.start_azimuth", sun.hourly.start_azimuth},
          {"sun.max_elevation", sun.hourly.max_elevation},
          chosen_setting("sun.even_hours", sun.hourly.even_hours)};
}

std::vector<Setting> model_settings(const SiteChoices& choices, const TerrainOptions& options) {
  return {{"model.engine", options.engine.empty() ? choices.engine : options.engine},
          {"model.cosine", choices.options.cosine},
          {"model.sequential_losses", choices.options.sequential_losses},
          {"model.reflected_is_absorbed", choices.options.reflected_is_absorbed},
          chosen_setting("model.surface", choices.surface),
          chosen_setting("model.depth_tolerance", choices.depth_tolerance)};
}

/// Only what a site file may say beside the rest.
void put_settings(ordered_json& json, const SiteDescription& site,
                  const std::vector<Setting>& settings) {
  for (const Setting& setting : settings) {
    const SiteKeyCondition& condition = site_key_named(setting.key).condition;
    if (setting.value.is_null() || (condition.holds != nullptr && !condition.holds(site))) continue;
    json[std::string(section_of(setting.key))][std::string(short_name_of(setting.key))] =
        setting.value;
  }
}

ordered_json with_source(ordered_json entry, const std::string& source) {
  if (!source.empty()) entry["source"] = source;
  return entry;
}

ordered_json biome_values(const SiteEntry<Biome>& found) {
  const Biome& biome = found.entry;
  return with_source({{"name", biome.name},
                      {"absorption", biome.absorption_percent},
                      {"diffusion", biome.diffusion_percent},
                      {"clouds", biome.cloud_percent},
                      {"rain", biome.rain.value()},
                      {"groundwater", biome.groundwater.value()}},
                     found.source);
}

ordered_json soil_values(const SiteEntry<Soil>& found) {
  return with_source({{"name", found.entry.name},
                      {"id", found.entry.id},
                      {"albedo", found.entry.albedo},
                      {"water_absorption", found.entry.water_absorption}},
                     found.source);
}

ordered_json plant_values(const SiteEntry<SitePlant>& found) {
  const SitePlant& plant = found.entry;
  return with_source({{"name", plant.name},
                      {"energy_demand", plant.energy_demand.value()},
                      {"water_demand", plant.water_demand.value()},
                      {"soil", plant.soil},
                      {"soil_depth", written_centimetres(plant.soil_depth)},
                      {"spacing", plant.spacing},
                      {"start_radius", plant.start_radius}},
                     found.source);
}

/// The command that makes the same of settings.toml.
std::string repeating_command(const TerrainOptions& options) {
  std::string command = "phytobench terrain settings.toml";
  if (!options.as_printed.empty()) command += " --as-printed '" + options.as_printed + "'";
  if (!options.plants.empty())
    command += fmt::format(" --plants {} --seed {}", options.plants, options.seed);
  return command;
}

/// Numbers, texts, switches and lists of texts are written alike in JSON and in TOML; days are not.
std::string toml_lines(const ordered_json& section) {
  std::string text;
  for (const auto& [key, value] : section.items())
    text += fmt::format("{} = {}\n", key,
                        key == "date" ? value.get<std::string>() : json_text(value, -1));
  return text;
}

}  // namespace

ordered_json terrain_settings(const SiteDescription& description, const Site& site,
                              const TerrainOptions& options) {
  ordered_json json;
  json["entries"] = ordered_json::array();  // all that it needs is here
  for (const std::vector<Setting>& part :
       {height_settings(description.heights), ground_settings(description),
        sun_settings(description.sun), model_settings(description.choices, options)})
    put_settings(json, description, part);
  json["biome"].push_back(biome_values(biome_named(description, description.biome)));
  for (const Soil& soil : site.input.soils)
    json["soil"].push_back(soil_values(soil_named(description, soil.name, "ground")));
  for (const SiteEntry<SitePlant>& species : site.species)
    json["species"].push_back(plant_values(species));
  return json;
}

std::string terrain_settings_file(const SiteDescription& description, const Site& site,
                                  const TerrainOptions& options) {
  ordered_json settings = terrain_settings(description, site, options);
  for (const char* section : {"heights", "ground"})
    if (ordered_json& part = settings[section]; part.contains("file"))
      part["file"] = std::filesystem::absolute(part["file"].get<std::string>()).string();
  std::string text = fmt::format(
      "# All that `phytobench terrain` has used. The same again: {}\n# Every key and its meaning: "
      "phytobench terrain --example.\n",
      repeating_command(options));
  for (const auto& [name, part] : settings.items()) {
    if (part.is_object()) {
      text += fmt::format("\n[{}]\n{}", name, toml_lines(part));
    } else if (part.empty() || !part.front().is_object()) {
      text += fmt::format("{} = {}\n", name, json_text(part, -1));
    } else {
      for (const ordered_json& entry : part)
        text += fmt::format("\n[[{}]]\n{}", name, toml_lines(entry));
    }
  }
  return text;
}

}  // namespace phytobench::cli
