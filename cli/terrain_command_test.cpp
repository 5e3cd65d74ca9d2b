// SPDX-License-Identifier: MIT
// phytobench terrain: chances as computed by hand, maps, plants that compete takes over, refusals.
#include "cli/command_line_fixture.hpp"
#include "core/picture/image.hpp"

namespace phytobench {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* terrain_schema = "phytobench/terrain-1";

/// Rows of different heights, so that there are both soils; no data in one corner.
constexpr const char* small_site = R"(
grow = ["Appletree", "Moss"]
[heights]
file = "heights.csv"
cell_width = 20.0
[ground]
posterise = ["Dirt", "Stone"]
[climate]
biome = "TemperateZone"
[sun]
max_elevation = 60.0
)";

class TerrainCommand : public CommandLine {
 protected:
  void SetUp() override {
    std::string heights;
    for (int row = 0; row < 12; ++row)
      for (int column = 0; column < 16; ++column)
        heights += (row == 0 && column == 0 ? "nan" : std::to_string(3 * row + column % 4)) +
                   (column == 15 ? "\n" : ",");
    write("heights.csv", heights);
    write("site.toml", small_site);
  }

  json terrain(const Words& more) const {
    Words words{"terrain"};
    words.insert(words.end(), more.begin(), more.end());
    words.emplace_back("--json");
    return json_of(words, terrain_schema);
  }

  /// Of the level plain in the polar zone.
  double apple_chance(const std::string& as_printed) const {
    Words words{"--preset", "worked-example"};
    if (!as_printed.empty()) words.insert(words.end(), {"--as-printed", as_printed});
    const json site = terrain(words);
    EXPECT_EQ(site["species"][0]["name"], "Appletree");
    // In the middle; as printed, the border gets less light from its neighbours.
    return site["species"][0]["chance"]["most"].get<double>();
  }
};

TEST_F(TerrainCommand, HasTheChancesComputedByHand) {
  EXPECT_NEAR(apple_chance(""), 0.184437, 5e-7);
  EXPECT_NEAR(apple_chance("all"), 0.45045, 5e-7);
  // Whatever else is printed: the corrected evaporation leaves no water.
  EXPECT_EQ(apple_chance("no-cosine,reflect-absorbed"), 0.0);
}

TEST_F(TerrainCommand, AddsUpAreas) {
  const json site = terrain({"site.toml"});
  EXPECT_EQ(site["ground"]["columns"], 16);
  EXPECT_EQ(site["ground"]["cells_with_data"], 191);
  EXPECT_EQ(site["hours"], 13);
  EXPECT_EQ(site["sun_positions"], 13);
  EXPECT_EQ(site["biome_source"], "assumed");
  ASSERT_EQ(site["species"].size(), 2u);
  for (const json& species : site["species"]) {
    EXPECT_EQ(species["with_data_m2"], 191 * 400.0);
    const json& areas = species["suitable"];
    EXPECT_GT(areas[0]["m2"], 0.0) << species;
    EXPECT_GE(areas[0]["m2"], areas[1]["m2"]);
    EXPECT_GE(areas[1]["m2"], areas[2]["m2"]);
    double limited = 0.0;
    for (const json& area : species["limited_by_m2"]) limited += area.get<double>();
    EXPECT_LE(limited, 191 * 400.0);
    // The other's soil keeps it from the other half.
    EXPECT_GT(species["limited_by_m2"]["soil"], 0.0);
  }
  EXPECT_LE(site["lit_hours"]["most"], 13.0);
  EXPECT_EQ(site["files"].size(), 0u);
}

TEST_F(TerrainCommand, SaysTheSameInWords) {
  const std::string text = output_of({"terrain", "site.toml"});
  EXPECT_THAT(text,
              StartsWith("site.toml: 16 by 12 cells of 20 m by 20 m, 0 to 36 m high (CSV)\n"));
  for (const char* part : {"no data in 0.521 % of the cells", "biome TemperateZone (assumed)",
                           "13 hours of sun", "Appletree", "Moss: [Lesser2019] fig. 10.2"})
    EXPECT_THAT(text, HasSubstr(part));
}

TEST_F(TerrainCommand, PrintsTheChanceOfTheWorkedExample) {
  EXPECT_THAT(output_of({"terrain", "--preset", "worked-example", "--as-printed", "E07,E13,E16"}),
              HasSubstr("   0.45045   0.45045   0.45045\n"));
}

TEST_F(TerrainCommand, SaysWhereNumbersAreFrom) {
  const std::string soils =
      "soils Dirt ([Lesser2019] listing 9.4), Stone (albedo: [Lesser2019] fig. 4.6; id and water: "
      "assumed)";
  EXPECT_THAT(output_of({"terrain", "site.toml", "--out", "maps"}), HasSubstr(soils));
  EXPECT_THAT(read("maps/chance-Moss.svg"),
              HasSubstr(">Moss: [Lesser2019] fig. 10.2; TemperateZone: assumed</text>"));
  const json site = terrain({"site.toml"});
  ASSERT_EQ(site["soils"].size(), 2u);
  EXPECT_EQ(site["soils"][0]["source"], "[Lesser2019] listing 9.4");
  EXPECT_EQ(site["soils"][0]["m2"].get<double>() + site["soils"][1]["m2"].get<double>(),
            191 * 400.0);
}

TEST_F(TerrainCommand, SaysWhichNumbersAreTheUsers) {
  write("mine.toml", std::string(small_site) +
                         "[[biome]]\nname = \"TemperateZone\"\nabsorption = 20\ndiffusion = 10\n"
                         "clouds = 30\nrain = 3\ngroundwater = 1\n"
                         "[[species]]\nname = \"Moss\"\nenergy_demand = 10\nwater_demand = 1\n"
                         "soil = \"\"\nsoil_depth = 1\n");
  const std::string text = output_of({"terrain", "mine.toml"});
  for (const char* part : {"biome TemperateZone (yours)", "\nMoss: yours\n"})
    EXPECT_THAT(text, HasSubstr(part));
  EXPECT_TRUE(terrain({"mine.toml"})["biome_source"].is_null());
}

TEST_F(TerrainCommand, SaysWhatAllLeavesOut) {
  const std::string text = output_of({"terrain", "site.toml", "--as-printed", "all"});
  EXPECT_THAT(text,
              HasSubstr("; E02, E14, E15, E21, which only the text has, and E22, E23, which"));
  expect_refused_line("terrain site.toml --as-printed E99", "all (without E02,");
  expect_refused_line("terrain site.toml --as-printed none,E16", "none leaves nothing as printed");
  EXPECT_EQ(terrain({"site.toml", "--as-printed", "e16"})["as_printed"], "E16");
}

TEST_F(TerrainCommand, AnHourIsOne) {
  write("short.toml", std::string(small_site) + "hours = 1\nstart_elevation = 40.0\n");
  EXPECT_THAT(output_of({"terrain", "short.toml"}), HasSubstr(", 1 hour of sun at 1 position, "));
}

TEST_F(TerrainCommand, WritesMapsInEveryFormat) {
  const json site = terrain({"site.toml", "--out", "maps", "--maps", "png,svg,asc,csv"});
  for (const json& file : site["files"])
    EXPECT_TRUE(exists(std::filesystem::path("maps") / file.get<std::string>())) << file;
  for (const char* map : {"heights", "soil", "lit-hours", "insolation", "normals", "slope",
                          "soil-depth", "water", "chance-Appletree", "chance-Moss"}) {
    SCOPED_TRACE(map);
    const Image image = parse_png(read("maps/" + std::string(map) + ".png"), map);
    EXPECT_EQ(image.width(), 16);
    EXPECT_EQ(image.height(), 12);
    EXPECT_EQ(image.at(0, 0)[3], 0);  // without data
    EXPECT_EQ(image.at(5, 5)[3], 255);
    EXPECT_THAT(read("maps/" + std::string(map) + ".svg"), HasSubstr(">N</text>"));
  }
  EXPECT_THAT(read("maps/water.svg"), HasSubstr(">l/m2 a day</text>"));
  for (const char* map : {"heights", "soil", "normals", "water", "chance-Moss"})
    EXPECT_THAT(read("maps/" + std::string(map) + ".svg"), HasSubstr(">no data</text>")) << map;
  EXPECT_THAT(read("maps/soil.svg"), HasSubstr(">Stone</text>"));
  EXPECT_THAT(read("maps/water.asc"), HasSubstr("ncols"));
  EXPECT_EQ(line_count(read("maps/chance-Moss.csv")), 12);
  // The summary is the document, which names it, too.
  EXPECT_EQ(json::parse(read("maps/summary.json")), site);
}

TEST_F(TerrainCommand, LegendsSayWhatIsMissing) {
  write("heights.csv", "1,2,nan\n3,4,5\n");
  write("soils.csv", "40,40,40\n40,nan,40\n");
  std::string text = small_site;
  const std::string posterised = "posterise = [\"Dirt\", \"Stone\"]";
  text.replace(text.find(posterised), posterised.size(), "file = \"soils.csv\"");
  write("holes.toml", text);
  terrain({"holes.toml", "--out", "maps", "--maps", "svg"});
  EXPECT_THAT(read("maps/heights.svg"), HasSubstr(">no data</text>"));
  for (const char* map : {"soil", "chance-Appletree"})
    EXPECT_THAT(read("maps/" + std::string(map) + ".svg"), HasSubstr(">no data, no soil</text>"));
  terrain({"--preset", "worked-example", "--out", "full", "--maps", "svg"});
  EXPECT_EQ(read("full/chance-Appletree.svg").find("no data"), std::string::npos);
}

TEST_F(TerrainCommand, WritesTheSameBytesForAnyThreads) {
  const auto files = [&](const std::string& folder, const char* threads) {
    const json site = terrain({"--preset", "worked-example", "--out", folder, "--threads", threads,
                               "--plants", "50", "--seed", "3"});
    std::string bytes;
    for (const json& file : site["files"])
      bytes += read(std::filesystem::path(folder) / file.get<std::string>());
    return bytes;
  };
  EXPECT_EQ(files("one", "1"), files("two", "3"));
}

TEST_F(TerrainCommand, EnginesThatAreExactAgree) {
  const std::string usual = output_of({"terrain", "--preset", "fractal"});
  for (const char* engine : {"exact_traversal", "max_pyramid"}) {
    std::string other = output_of({"terrain", "--preset", "fractal", "--engine", engine});
    const std::size_t at = other.find(engine);
    ASSERT_NE(at, std::string::npos);
    other.replace(at, std::string(engine).size(), "bounded_sweep");
    EXPECT_EQ(other, usual);
  }
}

TEST_F(TerrainCommand, CompeteTakesItsPlantsOver) {
  const json site =
      terrain({"site.toml", "--out", "site", "--maps", "none", "--plants", "200", "--seed", "7"});
  EXPECT_EQ(site["seed"], 7);
  std::uint64_t plants = 0;
  for (const json& species : site["species"]) plants += species["plants"].get<std::uint64_t>();
  EXPECT_EQ(plants, 200u);
  EXPECT_EQ(line_count(read("site/placed.csv")), 201);
  const json stand =
      json_of({"compete", "site/stand.toml", "--steps", "2", "--out", "grown", "--json"},
              "phytobench/compete-1");
  std::uint64_t start = 0;
  for (const json& species : stand["species"]) start += species["start"].get<std::uint64_t>();
  EXPECT_EQ(start, 200u);
  EXPECT_EQ(stand["ground"]["size"], (json{320.0, 240.0}));
  EXPECT_EQ(site["files"].size(), 4u);
  // What the run starts from lies beside what it leaves.
  EXPECT_EQ(read("grown/placed.csv"), read("site/placed.csv"));
  EXPECT_TRUE(exists("grown/plants.csv"));
  EXPECT_EQ(site["plants"]["placed"], 200);
}

TEST_F(TerrainCommand, SaysThatThereAreFewerPlantsThanAsked) {
  const Words crowd{"terrain", "--preset", "worked-example", "--out",    "crowd",
                    "--maps",  "none",     "--species",      "Appletree"};
  const auto placed = [&](const char* plants) {
    Words words = crowd;
    words.insert(words.end(), {"--plants", plants});
    return output_of(words);
  };
  EXPECT_THAT(placed("100000"), HasSubstr(" of 100000; no room for more)\n"));
  EXPECT_THAT(placed("50"), HasSubstr("placed, seed 0: 50 Appletree\n"));
  EXPECT_THAT(placed("100000/ha"), HasSubstr(" darts found room)\n"));
  const json plants = json::parse(read("crowd/summary.json"))["plants"];
  EXPECT_EQ(plants["asked"], "100000/ha");
  EXPECT_LT(plants["placed"].get<double>(), plants["wanted"].get<double>());
}

TEST_F(TerrainCommand, WritesNoStandWithoutPlants) {
  EXPECT_THAT(output_of({"terrain", "--preset", "worked-example", "--out", "none", "--maps", "none",
                         "--species", "Moss", "--plants", "100"}),
              HasSubstr("\nno plants: there is no chance to grow anywhere; neither placed.csv"));
  EXPECT_THAT(output_of({"terrain", "--preset", "worked-example", "--out", "none", "--maps", "none",
                         "--plants", "0.1/ha"}),
              HasSubstr("\nno plants: --plants 0.1/ha is less than one on this map"));
  EXPECT_FALSE(exists("none/placed.csv"));
  EXPECT_FALSE(exists("none/stand.toml"));
}

TEST_F(TerrainCommand, MapsOfTwoRowsAndMostlyWithoutDataWork) {
  std::string wide = "1,2";
  for (int column = 2; column < 500; ++column) wide += ",nan";
  write("heights.csv", wide + "\n" + wide + "\n");
  const json site = terrain({"site.toml", "--out", "wide"});
  EXPECT_EQ(site["ground"]["cells_with_data"], 4);
  EXPECT_EQ(site["slope_degrees"]["cells"], 4);
  EXPECT_EQ(parse_png(read("wide/water.png"), "").width(), 500);
}

TEST_F(TerrainCommand, MapsWithoutSlopesAreRefused) {
  for (const char* line : {"5\n", "1,2,3\n", "1\n2\n"}) {
    write("heights.csv", line);
    expect_refused_line("terrain site.toml --out maps", "give at least 2 of each");
  }
  write("heights.csv", "1,nan,nan\nnan,nan,nan\nnan,nan,2\n");
  expect_refused_line("terrain site.toml --out maps",
                      "site.toml:3: no place has heights beside it");
  EXPECT_FALSE(exists("maps"));
}

TEST_F(TerrainCommand, PlantsThatNeedNothingGrow) {
  write("weed.toml", std::string(small_site) +
                         "[[species]]\nname = \"Weed\"\nenergy_demand = 0\nwater_demand = 0\n"
                         "soil = \"\"\nsoil_depth = 0\n");
  const json weed = terrain({"weed.toml", "--species", "Weed"})["species"][0];
  EXPECT_EQ(weed["chance"]["least"], 1.0);
  EXPECT_EQ(weed["suitable"][2]["m2"], weed["with_data_m2"]);
}

TEST_F(TerrainCommand, AListIsOneWord) {
  // The site may stand behind it, and a space behind a comma.
  for (const Words& words :
       {Words{"--species", "Moss", "site.toml"}, Words{"site.toml", "--species", "Moss,"}})
    EXPECT_EQ(terrain(words)["species"].size(), 1u);
  EXPECT_EQ(terrain({"--species", "Appletree, Moss", "site.toml"})["species"].size(), 2u);
  EXPECT_EQ(terrain({"--out", "maps", "--maps", "none", "site.toml"})["files"].size(), 2u);
}

TEST_F(TerrainCommand, TheExampleCanBeUsed) {
  write("example.toml", output_of({"terrain", "--example"}));
  EXPECT_GE(terrain({"example.toml"})["species"].size(), 6u);
  expect_refused_line("terrain --example --json", "nothing else; leave out --json");
  expect_refused_line("terrain site.toml --example", "nothing else; leave out site.toml");
}

TEST_F(TerrainCommand, RefusesWrongOptions) {
  expect_refused_line("terrain", "phytobench list sites");
  expect_refused_line("terrain site.toml --preset fractal", "not both");
  expect_refused_line("terrain --preset fractals", "did you mean 'fractal'?");
  expect_refused_line("terrain none.toml", "none.toml");
  expect_refused_line("terrain site.toml --species Appeltree", "did you mean 'Appletree'?");
  expect_refused_line("terrain site.toml --out x --maps jpg", "--maps jpg: unknown format");
  expect_refused_line("terrain site.toml --plants 10", "--plants needs --out");
  expect_refused_line("terrain site.toml --maps png", "--maps needs --out");
  for (const char* option : {"--out", "--as-printed", "--preset", "--engine", "--plants"})
    expect_refused({"terrain", "site.toml", option, ""}, 2, std::string(option) + ": a ");
  for (const char* plants : {"x", "0", "-5", "nan", "1e9", "10/km", "/ha"})
    expect_refused_line(std::string("terrain site.toml --out x --plants=") + plants, "--plants");
  expect_refused_line("terrain site.toml --engine bounded", "bounded_sweep");
  expect_refused_line("terrain site.toml --as-printed E99", "E99");
  expect_refused_line("terrain site.toml --as-printed E08 --engine max_pyramid", "E08");
  expect_refused_line("terrain site.toml --threads 0", "--threads");
  expect_refused({"terrain", "site.toml", "--out", "heights.csv"}, 3, "heights.csv");
  EXPECT_EQ(left_behind(), (std::set<std::string>{"heights.csv", "site.toml"}));
}

struct BadSite {
  const char* from;
  const char* to;
  const char* message;
};

TEST_F(TerrainCommand, NamesFileAndLineOfBadData) {
  const BadSite all[] = {
      {"max_elevation = 60.0", "max_elevation = nan", "wrong.toml:11"},
      {"cell_width = 20.0", "cell_width = 0", "wrong.toml:5"},
      {"cell_width = 20.0", "cell_width = 0.01\nconversion = 10", "units seem to be mixed"},
      {"cell_width = 20.0", "", "wrong.toml:4: heights.file"},
      {"file = \"heights.csv\"", "file = \"none.csv\"", "wrong.toml:4: heights.file"},
      {"posterise = [\"Dirt\", \"Stone\"]", "file = \"heights.csv\"", "no [[soil]] with this id"},
      {"posterise = [\"Dirt\", \"Stone\"]", "soil = \"Drit\"", "did you mean 'Dirt'?"},
      {"biome = \"TemperateZone\"", "biome = \"Mars\"", "there is no biome 'Mars'"},
      {"max_elevation = 60.0",
       "[[biome]]\nname = \"B\"\nabsorption = 60\ndiffusion = 20\nclouds = 30\nrain = "
       "1\ngroundwater = 1\n",
       "wrong.toml:11: biome 'B'"},
      {"max_elevation = 60.0", "kind = \"solar\"\nlatitude = 80\nlongitude = 0\ndate = 5",
       "wrong.toml:14: sun.date must be a date"}};
  for (const BadSite& bad : all) {
    std::string text = small_site;
    text.replace(text.find(bad.from), std::string(bad.from).size(), bad.to);
    write("wrong.toml", text);
    expect_refused_line("terrain wrong.toml --out maps", bad.message);
  }
  EXPECT_FALSE(exists("maps"));
}

TEST_F(TerrainCommand, NeverOverwritesWhatItReads) {
  write("maps/heights.csv", "1,2\n3,4\n");
  write("maps/site.toml", small_site);
  expect_refused_line("terrain maps/site.toml --out maps --maps csv", "would overwrite");
  EXPECT_EQ(read("maps/heights.csv"), "1,2\n3,4\n");
  EXPECT_FALSE(exists("maps/water.csv"));
}

TEST_F(TerrainCommand, AFullDiskLeavesNothing) {
  const SmallFilesOnly limit(2000);
  const Outcome outcome = run_line("terrain site.toml --out maps --maps svg");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_EQ(line_count(outcome.err), 1) << outcome.err;
  EXPECT_FALSE(exists("maps"));
}

TEST_F(TerrainCommand, CanBeInterrupted) {
  write("large.toml",
        "heights.made = \"fractal\"\nheights.columns = 3000\nheights.rows = 3000\n"
        "ground.soil = \"Dirt\"\nclimate.biome = \"PolarZone\"\n"
        "model.engine = \"exact_traversal\"\n");
  interrupt({"terrain", "large.toml", "--out", "maps", "--maps", "png"},
            [&] { EXPECT_FALSE(exists("maps")); });
}

}  // namespace
}  // namespace phytobench
