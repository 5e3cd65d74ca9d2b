// SPDX-License-Identifier: MIT
// The folder that phytobench terrain writes into: made, left alone, or found with files in it.
#include "cli/command_line_fixture.hpp"

namespace phytobench {
namespace {

using nlohmann::json;

/// A rising plain with both soils.
class TerrainFolderCommand : public CommandLine {
 protected:
  void SetUp() override {
    std::string heights;
    for (int row = 0; row < 12; ++row)
      for (int column = 0; column < 9; ++column)
        heights += std::to_string(3 * row) + (column == 8 ? "\n" : ",");
    write("heights.csv", heights);
    write("site.toml",
          "grow = [\"Appletree\", \"Moss\"]\nheights.file = \"heights.csv\"\n"
          "heights.cell_width = 20.0\nground.posterise = [\"Dirt\", \"Stone\"]\n"
          "climate.biome = \"TemperateZone\"\nsun.max_elevation = 60.0\n");
  }
};

TEST_F(TerrainFolderCommand, OnlyFoldersMadeForNothingGoAgain) {
  write("heights.csv", "1,nan,nan\nnan,nan,nan\nnan,nan,2\n");  // found out late: no slopes
  write("kept/mine.txt", "mine");
  std::filesystem::create_directory(folder() / "empty");
  for (const char* out : {"new/deep/maps", "new/maps/", "kept/maps", "kept", "empty"})
    expect_refused_line(std::string("terrain site.toml --out ") + out, "no place has heights");
  EXPECT_FALSE(exists("new"));
  EXPECT_FALSE(exists("kept/maps"));
  EXPECT_EQ(read("kept/mine.txt"), "mine");
  EXPECT_TRUE(exists("empty"));
}

TEST_F(TerrainFolderCommand, NamesWhatAnEarlierRunHasLeft) {
  const auto run_in_maps = [&](const std::string& options) {
    const Outcome outcome =
        run_line("terrain site.toml --json --out maps --maps asc --species " + options);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return std::pair{outcome.err, json::parse(outcome.out)["older_files"]};
  };
  EXPECT_EQ(run_in_maps("Moss --plants 5").first, "");
  const auto [told, older] = run_in_maps("Appletree");
  EXPECT_EQ(told,
            "phytobench: warning: maps still holds files of an earlier run: chance-Moss.asc, "
            "placed.csv, stand.toml\n");
  EXPECT_EQ(older, (json{"chance-Moss.asc", "placed.csv", "stand.toml"}));
  // However long ago, until they are replaced or gone.
  std::filesystem::remove(folder() / "maps/stand.toml");
  EXPECT_EQ(run_in_maps("Appletree").second, (json{"chance-Moss.asc", "placed.csv"}));
  EXPECT_EQ(run_in_maps("Appletree,Moss").second, json::array({"placed.csv"}));
}

TEST_F(TerrainFolderCommand, SummariesOfOthersSayNothing) {
  write("secret", "mine");
  write("maps/kept.txt", "mine");
  const auto older = [&](const std::string& summary) {
    write("maps/summary.json", summary);
    const Outcome outcome = run_line("terrain site.toml --out maps --maps none --json");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return json::parse(outcome.out)["older_files"];
  };
  const std::string ours = R"({"schema": "phytobench/terrain-1", "files": )";
  for (const std::string& summary : {std::string("no json"), std::string("[\"kept.txt\"]"),
                                     ours + "\"kept.txt\"}", ours + R"([1, "../secret", "gone"]})",
                                     std::string(R"({"schema": "other", "files": ["kept.txt"]})")})
    EXPECT_TRUE(older(summary).empty()) << summary;
  EXPECT_EQ(older(ours + "[\"kept.txt\"]}"), json::array({"kept.txt"}));
}

}  // namespace
}  // namespace phytobench
