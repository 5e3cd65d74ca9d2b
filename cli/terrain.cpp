// SPDX-License-Identifier: MIT
// phytobench terrain: a site in, maps of light, soil, water and chances to grow out, and plants.
#include <filesystem>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/commands.hpp"
#include "cli/terminal.hpp"
#include "cli/terrain_findings.hpp"
#include "cli/terrain_folder.hpp"
#include "cli/terrain_maps.hpp"
#include "cli/terrain_plants.hpp"
#include "cli/terrain_settings.hpp"
#include "cli/terrain_shadows.hpp"
#include "core/contract/errors.hpp"
#include "core/memory/keep_freed_memory.hpp"
#include "core/terrain/shadow/shadow_registry.hpp"
#include "core/terrain/site_checks.hpp"
#include "core/terrain/site_file.hpp"
#include "reference/lesser2019_site_model.hpp"
#include "reference/site_presets.hpp"

namespace phytobench::cli {

namespace {

namespace fs = std::filesystem;

void check_terrain_options(const TerrainOptions& options) {
  if (options.site.empty() == options.preset.empty())
    throw InputError(
        options.site.empty()
            ? "terrain needs a site file or a --preset; phytobench terrain --example prints a file "
              "to start from, phytobench list sites lists the presets"
            : "give a site file or --preset, not both");
  if (!options.plants.empty() && options.out.empty())
    throw InputError("--plants needs --out DIR, the folder for the table of plants");
  check_map_formats(options.maps);
}

/// The calculation, corrected or with errata left in.
struct TerrainModel {
  std::unique_ptr<SiteModel> model;
  std::unique_ptr<ShadowEngine> shadows;
  std::string engine;
  std::string as_printed;
};

TerrainModel terrain_model_of(const SiteChoices& choices, const TerrainOptions& options) {
  const LesserSwitches switches =
      lesser_switches(options.as_printed.empty() ? "none" : options.as_printed);
  TerrainModel result;
  if (switches != LesserSwitches{}) {
    result.model = printed_site_model(switches, choices.options);
    result.as_printed = shown(switches);
  } else {
    result.model = corrected_site_model(choices.options);
  }
  result.engine = options.engine.empty() ? choices.engine : options.engine;
  if (switches.has(LesserErratum::ray_step_rule)) {
    if (!options.engine.empty())
      throw InputError("--engine " + options.engine +
                       ": erratum E08 has a march of its own; leave one of the two out");
    result.shadows = lesser_shadows(switches);
    result.engine = "the march as printed";
  } else {
    result.shadows = shadow_engine_named(result.engine).create();
  }
  return result;
}

void begin_stage(std::string_view stage) {
  if (is_interrupted()) throw Interrupted("nothing is written");
  show_progress(fmt::format("terrain: {}", stage));
}

class TerrainRun {
 public:
  TerrainRun(const TerrainOptions& options, SiteDescription description)
      : options_(options), description_(std::move(description)) {
    if (!options.plants.empty()) sampling_ = plant_sampling_from(options);
    model_ = terrain_model_of(description_.choices, options);
    begin_stage("heights and soils");
    site_ = load_site(description_, options.species);
    site_.options.threads = options.threads;
    set_sun(site_.options, description_, *model_.model);
    folder_ = TerrainFolder(options.out);  // when all that is read is known to be right
  }

  void run() {
    ShadowsByTheHour shadows(
        std::move(model_.shadows), [](std::size_t position, std::size_t positions) {
          begin_stage(fmt::format("shadows, sun {} of {}", position + 1, positions));
        });
    maps_ = site_maps(site_.input, site_.options, *model_.model, shadows, begin_stage);
    refuse_without_slopes();
    describe_site();
    if (writes())
      for (const MapSheet& sheet : site_sheets(site_, maps_)) add(sheet);
    std::vector<TerrainMap> chances;
    for (const SiteEntry<SitePlant>& species : site_.species) chances.push_back(chance_of(species));
    if (sampling_) place_plants(chances);
    begin_stage("writing");
    if (!writes()) return;
    folder_.add({{"settings.toml", terrain_settings_file(description_, site_, options_)}});
    findings_.files = folder_.names();
    findings_.older_files = folder_.older_files();
    folder_.write(document(),
                  {description_.file, description_.heights.file, description_.ground.file});
  }

  /// Maps that this run did not replace look as if they belonged to it.
  void warn_of_older_files() const {
    if (!findings_.older_files.empty())
      tell(fmt::format("warning: {} still holds files of an earlier run: {}", options_.out,
                       fmt::join(findings_.older_files, ", ")));
  }

  std::string shown() const {
    return options_.json ? document() : terrain_text(site_, findings_, options_);
  }

 private:
  bool writes() const { return !options_.out.empty(); }

  std::string document() const { return terrain_json({description_, site_, findings_, options_}); }

  void add(const MapSheet& sheet) {
    begin_stage("map " + sheet.name);
    folder_.add(sheet_files(site_, sheet, options_.maps));
  }

  /// Of heights that have no neighbours nothing can be said.
  void refuse_without_slopes() const {
    if (range_of(maps_.slope).cells == 0)
      throw InputError(description_.place_of("heights") +
                       ": no place has heights beside it and above or below it, and so none has a "
                       "slope; give a map with less ground without data");
  }

  void describe_site() {
    const HeightField& heights = site_.input.heights;
    findings_.sun_positions = site_.options.suns.size();
    findings_.hours = site_.options.hours_each * static_cast<double>(findings_.sun_positions);
    findings_.engine = model_.engine;
    findings_.as_printed = model_.as_printed;
    findings_.biome_source = biome_named(description_, description_.biome).source;
    findings_.soils = soil_findings(description_, site_);
    findings_.height = range_of(
        {heights.columns(), heights.rows(), {heights.heights().begin(), heights.heights().end()}});
    findings_.slope = range_of(maps_.slope);
    findings_.lit_hours = range_of(lit_hours_map(site_, maps_.lit));
    findings_.raw_energy = range_of(maps_.raw_energy);
    findings_.energy = range_of(maps_.energy);
    findings_.soil_depth = range_of(in_centimetres(maps_.soil_depth));
    findings_.water = range_of(maps_.water);
  }

  TerrainMap chance_of(const SiteEntry<SitePlant>& species) {
    begin_stage("chances of " + species.entry.name);
    ChanceMaps chances =
        chance_maps(site_.input, maps_, species.entry, *model_.model, site_.options);
    findings_.species.push_back(species_findings(site_.input.heights, species, chances));
    if (writes()) add(chance_sheet(site_, species, chances.chance, findings_.biome_source));
    return sampling_ ? std::move(chances.chance) : TerrainMap();
  }

  void place_plants(const std::vector<TerrainMap>& chances) {
    begin_stage("plants");
    const PlacedPlants placed = placed_plants(site_, chances, *sampling_);
    for (std::size_t i = 0; i < placed.counts.size(); ++i)
      findings_.species[i].plants = placed.counts[i];
    findings_.wanted_plants = placed.wanted;
    folder_.add(placed.files);
  }

  const TerrainOptions& options_;
  SiteDescription description_;
  TerrainFolder folder_;
  std::optional<PlantSampling> sampling_;
  TerrainModel model_;
  Site site_;
  SiteMaps maps_;
  TerrainFindings findings_;
};

}  // namespace

int terrain(const TerrainOptions& options) {
  if (options.example) {
    print(example_site_file());
    return 0;
  }
  keep_freed_memory();
  check_terrain_options(options);
  const fs::path file =
      options.preset.empty() ? fs::path(options.site) : site_preset_file(options.preset);
  SiteDescription description = read_site_file(file, site_entry_file);
  catch_interrupts();  // from here on there are stages to stop between
  TerrainRun run(options, std::move(description));
  run.run();
  run.warn_of_older_files();
  print(run.shown());
  return 0;
}

}  // namespace phytobench::cli
