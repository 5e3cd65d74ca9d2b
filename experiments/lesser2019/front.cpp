// SPDX-License-Identifier: MIT
// What is listed in front of the thesis, and names that differ from place to place.
#include <string>

#include <fmt/format.h>

#include "experiments/experiment.hpp"
#include "reference/data_folder.hpp"
#include "reference/toml_table.hpp"

namespace phytobench::experiments::lesser2019 {

namespace {

/// places.toml has been written from the text, not from its lists.
void record_places(ExperimentContext& context) {
  const TomlTable places = TomlTable::read(paper_folder("lesser2019") / "places.toml");
  for (const char* kind : {"listing", "figure", "table", "equation"})
    context.record(fmt::format("{}s", kind), whole(places.table(kind).keys().size()));
}

/// Listing 9.18: a window to list and one to make each kind of data, the menu, the calculation.
void record_windows(ExperimentContext& context) {
  const std::string windows[] = {"MenuWindow",          "MapWindow",
                                 "NewMapWindow",        "SoilWindow",
                                 "NewSoilWindow",       "BiomWindow",
                                 "NewBiomWindow",       "VegetationWindow",
                                 "newVegetationWindow", "ProbabilityCloudWindow"};
  constexpr std::int64_t kinds_of_data = 4, others = 2;
  context.record("windows", whole(std::size(windows)), "windows");
  context.record("windows/expected", 2 * kinds_of_data + others, "windows");
}

/// The same thing under the name that each place gives it.
void record_names(ExperimentContext& context) {
  context.record("names/species-file/text", std::string("vegetations_types.yml"));
  context.record("names/species-file/listings", std::string("vegetation_types.yml"));
  context.record("names/biome-file/text", std::string("biom.yml"));
  context.record("names/biome-file/caption", std::string("bioms.yml"));
  context.record("names/unreal/chapter-6", std::string("Unreal Engine 4"));
  context.record("names/unreal/chapter-7", std::string("Unreal Engine 5"));
  context.record("names/foliage-tool/cited", std::string("Unr"));
  context.record("names/foliage-tool/listed", std::string("Urn"));
  context.record("names/soil-depth-section/said", std::string("8.3"));
  context.record("names/soil-depth-section/is", std::string("8.4"));
  context.record("names/groundwater/chapter-3", std::string("m2"));
  context.record("names/groundwater/chapter-8", std::string("m3"));
}

void run(ExperimentContext& context) {
  record_places(context);
  record_windows(context);
  record_names(context);
}

}  // namespace

extern const ExperimentDescriptor front;
constinit const ExperimentDescriptor front{
    .id = "lesser2019/front",
    .question = "Do lists and names agree with what they list and name?",
    .source = "[Lesser2019] lists of figures, tables and listings",
    .seconds = {0.01, 0.01, 0.01},
    .run = run,
};

}  // namespace phytobench::experiments::lesser2019
