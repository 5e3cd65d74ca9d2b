// SPDX-License-Identifier: MIT
// What terrain has used is written beside its maps, and makes the same maps again.
#include "cli/command_line_fixture.hpp"

namespace phytobench {
namespace {

using nlohmann::json;
using testing::HasSubstr;

/// No key that it gives has its default.
constexpr const char* unusual_site = R"(
grow = ["Fern"]
[heights]
made = "ring-wall"
columns = 20
rows = 15
cell_width = 12.5
cell_depth = 10.0
relief = 30.0
radius = 60.0
thickness = 20.0
[ground]
posterise = ["Peat", "Dirt"]
max_depth = 29.0
[climate]
biome = "Bog"
neighbour_share = 0.25
[sun]
hours = 6
start_elevation = 5.0
start_azimuth = 20.0
max_elevation = 50.0
even_hours = "tent"
[model]
engine = "max_pyramid"
cosine = false
sequential_losses = true
reflected_is_absorbed = false
surface = "other-six"
depth_tolerance = "threshold"
[[biome]]
name = "Bog"
absorption = 11
diffusion = 12
clouds = 13
rain = 5
groundwater = 6
source = "a \"friend\""
[[soil]]
name = "Peat"
id = 7
albedo = 0.11
water_absorption = 0.9
[[species]]
name = "Fern"
energy_demand = 900
water_demand = 2
soil = "Peat"
soil_depth = 29
spacing = 2
start_radius = 0.1
)";

class TerrainSettings : public CommandLine {
 protected:
  json terrain(Words words) const {
    words.insert(words.begin(), "terrain");
    words.emplace_back("--json");
    return json_of(words, "phytobench/terrain-1");
  }
};

TEST_F(TerrainSettings, MakeTheSameAgain) {
  write("heights.csv", "1,2,nan,4\n2,3,4,5\n4,5,6,6\n");
  write("site.toml",
        "heights = { file = \"heights.csv\", cell_width = 20.0 }\nclimate.biome = \"PolarZone\"\n"
        "ground.soil = \"Dirt\"\ngrow = [\"Appletree\"]\nsun.max_elevation = 60.0\n");
  const json first = terrain({"site.toml", "--out", "one", "--maps", "csv", "--plants", "20",
                              "--seed", "3", "--as-printed", "E13", "--engine", "max_pyramid"});
  EXPECT_THAT(
      read("one/settings.toml"),
      HasSubstr("phytobench terrain settings.toml --as-printed 'E13' --plants 20 --seed 3"));
  std::filesystem::rename(folder() / "one/settings.toml", folder() / "again.toml");
  const json second = terrain({"again.toml", "--out", "two", "--maps", "csv", "--plants", "20",
                               "--seed", "3", "--as-printed", "E13"});
  EXPECT_EQ(first["files"], second["files"]);
  EXPECT_EQ(first["engine"], second["engine"]);
  for (const json& name : first["files"]) {
    const std::string file = name.get<std::string>();
    if (file.ends_with(".csv")) EXPECT_EQ(read("one/" + file), read("two/" + file)) << file;
  }
}

TEST_F(TerrainSettings, HaveEveryKey) {
  write("unusual.toml", unusual_site);
  const json first = terrain({"unusual.toml", "--out", "one", "--maps", "none"});
  const json second = terrain({"one/settings.toml"});
  for (const char* part : {"settings", "ground", "soils", "species", "water", "energy"})
    EXPECT_EQ(first[part], second[part]) << part;
  const json& settings = first["settings"];
  EXPECT_EQ(settings["heights"].size(), 8u);  // as above
  EXPECT_EQ(settings["ground"].size(), 2u);
  EXPECT_EQ(settings["climate"].size(), 2u);
  EXPECT_EQ(settings["sun"].size(), 6u);  // with sun.kind
  EXPECT_EQ(settings["model"].size(), 6u);
  EXPECT_EQ(settings["model"]["surface"], "other-six");
  EXPECT_EQ(settings["biome"][0]["source"], "a \"friend\"");
  EXPECT_EQ(settings["species"][0]["soil_depth"], 29.0);
  EXPECT_EQ(settings["species"][0]["spacing"], 2.0);
  EXPECT_THAT(output_of({"--version"}), HasSubstr(first["program"]["version"].get<std::string>()));
}

TEST_F(TerrainSettings, OfTheTrueSunNameTheDay) {
  write("solar.toml",
        "heights = { made = \"flat\", columns = 2, rows = 2 }\nclimate.biome = \"PolarZone\"\n"
        "ground.soil = \"Dirt\"\ngrow = [\"Appletree\"]\n"
        "sun = { kind = \"solar\", latitude = 36.5, longitude = -84.25, date = 2024-02-29 }\n");
  const Outcome outcome = run_line("terrain solar.toml");
  if (outcome.err.find("libnova") != std::string::npos) GTEST_SKIP() << outcome.err;
  const json first = terrain({"solar.toml", "--out", "one", "--maps", "none"});
  EXPECT_EQ(first["settings"]["sun"]["date"], "2024-02-29");
  EXPECT_THAT(read("one/settings.toml"), HasSubstr("\ndate = 2024-02-29\n"));
  EXPECT_EQ(terrain({"one/settings.toml"})["settings"], first["settings"]);
}

}  // namespace
}  // namespace phytobench
