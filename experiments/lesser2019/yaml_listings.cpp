// SPDX-License-Identifier: MIT
// Sec. 9.1.1: whether what is printed as YAML is YAML. A document has one root: a list, whose
// entries start with a hyphen, or a mapping, whose entries have a key.
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "experiments/experiment.hpp"

namespace phytobench::experiments::lesser2019 {

namespace {

constexpr std::string_view listing_9_2 = R"(# Dies ist ein Kommentar
# Es folgt eine Liste
- Auto
- Katze
- Mond
# Es folgt eine assoziative Liste
name: Bernd
alter: 27
studium: Feng-Shui-Wissenschaften
# Es folgt eine Kombination aus assoziativer Liste und Liste
compiler:
  - c
  - c++
  - fortran
interpreter:
  - python
  - ruby
  - javascript
)";
constexpr std::string_view listing_9_3 = R"(PolarZone:
  atmospheric_absorption: '45'
  atmospheric_diffusion: '8'
  avg_rainfall_per_day: '1.5'
  cloud_reflection: '40'
  groundwater: '1.0'
)";
constexpr std::string_view listing_9_4 = R"(Dirt:
  id: '40'
  albedo: '0.25'
  water_absorption: '0.38'
)";
/// Paths are broken at the ends of lines; joined, and shortened.
constexpr std::string_view listing_9_5 = R"(Big_Terrain:
  biom: TemperateZone
  height_conversion: 0.1
  height_map_path: maps\16bitHeightMap512x512Terrain8km.png
  max_soil_depth: 150.0
  pixel_size: 16.0
  texture_map_path: maps\16bitHeightMap512x512Terrain8km_soil_ids.png
)";
constexpr std::string_view listing_9_6 = R"(Appletree:
    energy_demand: '2000'
    soil_demand: Dirt
    soil_depth_demand: '80'
    water_demand: '0.7'
)";

/// What stands at the left edge of a document.
struct Roots {
  std::set<std::string> kinds;
  std::vector<std::string> keys;
  int line_of_second_kind = 0;  ///< 0: there is none
};

Roots roots_of(std::string_view text) {
  Roots roots;
  std::istringstream lines{std::string(text)};
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    if (line.empty() || line[0] == '#' || line[0] == ' ') continue;
    const bool is_entry = line.starts_with("- ");
    if (!is_entry) roots.keys.push_back(line.substr(0, line.find(':')));
    const bool is_new = roots.kinds.insert(is_entry ? "list" : "mapping").second;
    if (is_new && roots.kinds.size() == 2) roots.line_of_second_kind = number;
  }
  return roots;
}

void run(ExperimentContext& context) {
  const Roots example = roots_of(listing_9_2);
  context.record("9.2/root-kinds", static_cast<std::int64_t>(example.kinds.size()), "kinds");
  context.record("9.2/line-of-second-kind", std::int64_t{example.line_of_second_kind});
  // Its two parts are documents, each for itself.
  const std::size_t second = listing_9_2.find("name:");
  context.record("9.2/root-kinds/list-alone",
                 static_cast<std::int64_t>(roots_of(listing_9_2.substr(0, second)).kinds.size()),
                 "kinds");
  context.record("9.2/root-kinds/mapping-alone",
                 static_cast<std::int64_t>(roots_of(listing_9_2.substr(second)).kinds.size()),
                 "kinds");
  for (const auto& [name, text] : std::map<std::string, std::string_view>{{"9.3", listing_9_3},
                                                                          {"9.4", listing_9_4},
                                                                          {"9.5", listing_9_5},
                                                                          {"9.6", listing_9_6}}) {
    const Roots roots = roots_of(text);
    context.record(name + "/root-kinds", static_cast<std::int64_t>(roots.kinds.size()), "kinds");
    context.record(name + "/entries", static_cast<std::int64_t>(roots.keys.size()), "entries");
  }
  // Listing 9.1 opens the file to append: a species that is saved twice stands there twice.
  const Roots twice = roots_of(std::string(listing_9_6) + std::string(listing_9_6));
  context.record("saved-twice/keys", static_cast<std::int64_t>(twice.keys.size()), "keys");
  context.record(
      "saved-twice/different-keys",
      static_cast<std::int64_t>(std::set<std::string>(twice.keys.begin(), twice.keys.end()).size()),
      "keys");
}

}  // namespace

extern const ExperimentDescriptor yaml_listings;
constinit const ExperimentDescriptor yaml_listings{
    .id = "lesser2019/yaml-listings",
    .question = "Is what is printed as YAML a document of one list or one mapping?",
    .source = "[Lesser2019] sec. 9.1.1, listings 9.1 to 9.6",
    .seconds = {0.01, 0.01, 0.01},
    .run = run,
};

}  // namespace phytobench::experiments::lesser2019
