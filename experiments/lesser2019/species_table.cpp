// SPDX-License-Identifier: MIT
// Figure 10.2 and listings 9.3 to 9.6: inputs that stand in two places, and one that is used but
// never described.
#include <string>

#include <fmt/format.h>

#include "core/contract/errors.hpp"
#include "core/terrain/shadow/shadow_registry.hpp"
#include "core/terrain/site_maps.hpp"
#include "experiments/experiment.hpp"
#include "experiments/lesser2019/thesis_site.hpp"

namespace phytobench::experiments::lesser2019 {

namespace {

/// Figure 10.2 and listing 9.6 show the same species.
void record_appletree(ExperimentContext& context) {
  const PlantSpecies listed = species_from(thesis_parameters().table("apple-tree-of-listing-9-6"));
  const PlantSpecies& shown = appletree();
  const std::int64_t agreeing =
      (listed.name == shown.name) + (listed.energy_demand == shown.energy_demand) +
      (listed.water_demand == shown.water_demand) + (listed.soil == shown.soil) +
      (listed.soil_depth == shown.soil_depth);
  context.record("appletree/values", std::int64_t{5}, "values");
  context.record("appletree/agreeing", agreeing, "values");
}

/// Sec. 8.1.1, 10.4: a map names a soil that nobody has described.
void record_unknown_soil(ExperimentContext& context) {
  SiteInput input{.heights = HeightField(2, 1, 16.0, 16.0),
                  .soils = {thesis_dirt()},
                  .soil_of = {0, 1},
                  .biome = polar_zone()};
  bool is_refused = false;
  try {
    check_site(input);
  } catch (const InputError&) {
    is_refused = true;
  }
  context.record("unknown-soil/refused", std::int64_t{is_refused});
  input.soil_of = {0, 0};
  check_site(input);
}

/// Sec. 7.3: what grows depends on what is there, not on the name of a biome.
void record_biome_names(ExperimentContext& context) {
  const auto chances = [](const std::string& name) {
    SiteInput input{.heights = HeightField(3, 3, 16.0, 16.0),
                    .soils = {thesis_dirt()},
                    .soil_of = std::vector<std::int16_t>(9, 0),
                    .biome = polar_zone()};
    input.biome.name = name;
    const auto model = corrected_site_model();
    const SiteOptions options{.suns = model->sun_path({.hours = 13})};
    const SiteMaps maps =
        site_maps(input, options, *model, *shadow_engine_named("exact_traversal").create());
    return chance_maps(input, maps, appletree(), *model, options).chance.values;
  };
  const std::vector<double> polar = chances("PolarZone"), alps = chances("Alps");
  context.record("biome-names/chance", polar[4]);
  context.record("biome-names/differences", std::int64_t{polar != alps});
}

void run(ExperimentContext& context) {
  record_appletree(context);
  record_unknown_soil(context);
  record_biome_names(context);
}

}  // namespace

extern const ExperimentDescriptor species_table;
constinit const ExperimentDescriptor species_table{
    .id = "lesser2019/species-table",
    .question = "Do listings, figures and maps agree on species and soils?",
    .source = "[Lesser2019] figure 10.2, listings 9.3 to 9.6, sec. 7.3, 8.1.1",
    .seconds = {0.01, 0.01, 0.01},
    .run = run,
};

}  // namespace phytobench::experiments::lesser2019
