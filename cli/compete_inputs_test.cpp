// SPDX-License-Identifier: MIT
// What phytobench compete copies into its folder, so that the run can be repeated from there.
#include "cli/compete_fixture.hpp"
#include "core/picture/image.hpp"

namespace phytobench {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;

/// A parameter file that names plants and a map.
std::string stand_with(const std::string& plants, const std::string& map) {
  return "steps = 8\nplants = \"" + plants + "\"\nresources.nutrients = \"" + map +
         "\"\n[ground]\nsize = [40.0, 20.0]\n[[species]]\nname = \"shrub\"\ncount = 30\n"
         "root_factor_poor = 15\nroot_factor_rich = 6\n";
}

class CompeteInputs : public CompeteCommand {
 protected:
  CompeteInputs() {
    Image soil(4, 2);
    soil.at(3, 0) = soil.at(0, 1) = {255, 255, 255, 255};
    write("soil.png", to_png(soil));
    write("maps/soil.png", to_png(soil));
    write("start.csv", "x,y,radius\n1,1,0.1\n2,2,0.2\n");
    write("stand.toml", stand_with("start.csv", "maps/soil.png"));
  }

  /// What was found, without where it was read and written.
  static json findings(json document) {
    for (const char* key : {"config", "preset", "plants", "files"}) document.erase(key);
    return document;
  }

  /// The run again, from the folder of its first one alone.
  void expect_repeatable(const std::string& folder, const json& first, const std::string& options) {
    fs::rename(this->folder() / folder, this->folder() / (folder + "-moved"));
    EXPECT_EQ(findings(document(folder + "-moved/parameters.toml" + options)), findings(first));
  }
};

TEST_F(CompeteInputs, ARunCanBeRepeatedFromItsFolder) {
  const json first = document("stand.toml --out A");
  EXPECT_EQ(read("A/parameters.toml"), read("stand.toml"));
  EXPECT_EQ(read("A/maps/soil.png"), read("soil.png"));
  EXPECT_EQ(first["all"]["start"], 32);
  for (const char* name : {"start.csv", "maps/soil.png"})
    EXPECT_THAT(first["files"].dump(), HasSubstr(name));
  fs::remove_all(folder() / "maps");
  fs::remove(folder() / "start.csv");
  expect_repeatable("A", first, "");
}

TEST_F(CompeteInputs, SoCanPresets) {
  for (const std::string preset : {"five-regions-mixture", "disease"}) {
    SCOPED_TRACE(preset);
    const json first = document("--preset " + preset + " --steps 5 --out " + preset);
    expect_repeatable(preset, first, " --steps 5");
  }
}

TEST_F(CompeteInputs, PlantsOfTheCommandLineKeepTheirNameUnlessItIsTaken) {
  write("other/few.csv", "x,y,radius\n3,3,0.1\n");
  write("other/start.csv", "x,y,radius\n4,3,0.1\n");
  write("other/plants.csv", "x,y,radius\n5,3,0.1\n");
  const json first = document("stand.toml --out A --plants other/few.csv");
  EXPECT_EQ(first["plants"], "other/few.csv");
  EXPECT_EQ(read("A/few.csv"), read("other/few.csv"));
  EXPECT_EQ(read("A/start.csv"), read("start.csv"));  // parameters.toml names it still
  expect_repeatable("A", first, " --plants A-moved/few.csv");
  document("stand.toml --out B --plants other/start.csv");
  EXPECT_EQ(read("B/start.csv"), read("start.csv"));
  EXPECT_EQ(read("B/start-start.csv"), read("other/start.csv"));
  document("stand.toml --out C --plants other/plants.csv");
  EXPECT_EQ(read("C/start-plants.csv"), read("other/plants.csv"));
  document("stand.toml --out D --plants start.csv");
  EXPECT_FALSE(exists("D/start-start.csv"));
}

TEST_F(CompeteInputs, NamesThatLeaveTheFolderStayAsTheyAre) {
  write("in/stand.toml", stand_with("../start.csv", (folder() / "soil.png").string()));
  document("in/stand.toml --out run/A");
  EXPECT_FALSE(exists("run/start.csv"));
  EXPECT_FALSE(exists("run/A/start.csv"));
  EXPECT_FALSE(exists("run/A/soil.png"));
}

TEST_F(CompeteInputs, RefusesNamesOfFilesThatTheRunWrites) {
  write("plants.csv", "x,y,radius\n1,1,0.1\n");
  write("taken.toml", stand_with("plants.csv", "soil.png"));
  expect_refused_line("compete taken.toml --out A", "names plants.csv, which is also a file that");
  EXPECT_FALSE(exists("A"));
  expect_done("taken.toml");
}

TEST_F(CompeteInputs, RefusesToReplaceAFileOfThatName) {
  write("A/start.csv", "mine");
  expect_refused_line("compete stand.toml --out A", "A/start.csv: is another file than");
  EXPECT_EQ(read("A/start.csv"), "mine");
  EXPECT_EQ(files_below("A").size(), 1u);
}

TEST_F(CompeteInputs, ResumedRunsLeaveTheSameFiles) {
  const std::string options = "stand.toml --checkpoint 3 --plants start.csv ";
  expect_done(options + "--out whole");
  expect_done(options + "--out broken --steps 4");
  fs::remove(folder() / "broken/start.csv");
  write("broken/maps/soil.png.part12", "half");
  write("broken/maps/mine.part12", "mine");
  expect_done(options + "--out broken --resume");
  EXPECT_EQ(read("broken/maps/mine.part12"), "mine");
  fs::remove(folder() / "broken/maps/mine.part12");
  expect_same_files("whole", "broken");
}

TEST_F(CompeteInputs, MayLieInTheFolderOfTheRun) {
  write("A/parameters.toml", stand_with("few.csv", "soil.png"));
  write("A/few.csv", "x,y,radius\n3,3,0.1\n");
  fs::create_symlink(folder() / "soil.png", folder() / "A/soil.png");
  expect_done("A/parameters.toml --out A");
  EXPECT_TRUE(fs::is_symlink(folder() / "A/soil.png"));
  expect_refused_line("compete A/parameters.toml --out A", "already holds");
}

}  // namespace
}  // namespace phytobench
