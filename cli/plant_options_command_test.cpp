// SPDX-License-Identifier: MIT
// Options that derive, build and grow share: files to write, the camera, --split, --example.
#include "cli/command_line_fixture.hpp"

namespace phytobench {
namespace {

class PlantOptions : public CommandLine {
 protected:
  void SetUp() override {
    write("tree.lsys", "axiom: A\nA -> F[+A]/(90)[&A][{.f+f+f}]F\nangle: 120   steps: 2\n");
    write("plant.toml", "[graph]\nroot = \"a\"\n[component.a]\nkind = \"horn\"\n");
    write("tree.toml", "cloud.radii = [1.5, 2.0, 1.5]\ngrowth.iterations = 12\n");
  }
  const std::set<std::string> given_ = {"plant.toml", "tree.lsys", "tree.toml"};
};

TEST_F(PlantOptions, DeriveRefusesOptionsWithoutEffect) {
  for (const char* out : {"", " --out x.svg,x.csv"})
    expect_refused_line(std::string("derive tree.lsys --split") + out, "goes with models only");
  for (const char* option : {"--azimuth", "--elevation", "--distance", "--picture-height"})
    expect_refused_line(std::string("derive tree.lsys --out x.csv,x.obj ") + option + " 80",
                        std::string(option) + " goes with a");
  for (const char* option : {"--distance", "--picture-height"})
    expect_refused_line(std::string("derive tree.lsys --out x.svg ") + option + " 80",
                        std::string(option) + " goes with a .png picture only");
  expect_refused_line("derive --example bush --json", "leave out --json");
  expect_refused_line("derive --example bush tree.lsys", "leave out tree.lsys");
  EXPECT_EQ(left_behind(), given_);
  output_of({"derive", "tree.lsys", "--out", "front.svg"});
  output_of({"derive", "tree.lsys", "--out", "side.svg", "--azimuth", "10"});
  EXPECT_NE(read("front.svg"), read("side.svg"));
}

TEST_F(PlantOptions, DeriveMakesNoFolderAndKeepsWhatIsProtected) {
  expect_refused_line("derive tree.lsys --out typo/x.svg", "there is no folder typo");
  for (const char* names : {"x.svg,", ",x.svg", "x.svg,,x.csv", ","})
    expect_refused_line(std::string("derive tree.lsys --out ") + names, "a name is missing");
  EXPECT_EQ(left_behind(), given_);
  write("x.svg", "old\n");
  std::filesystem::permissions(folder() / "x.svg", std::filesystem::perms::owner_read);
  expect_refused({"derive", "tree.lsys", "--out", "x.svg"}, 3, "x.svg: it is write-protected");
  EXPECT_EQ(read("x.svg"), "old\n");
}

/// A word after the names is no name: it may be the system.
TEST_F(PlantOptions, NamesOfFilesEndAtABlank) {
  output_of({"derive", "--out", "x.csv", "tree.lsys"});
  output_of({"derive", "tree.lsys", "--out", "y.csv", "--out", "z.csv"});
  EXPECT_EQ(read("x.csv"), read("y.csv"));
  EXPECT_EQ(read("x.csv"), read("z.csv"));
}

TEST_F(PlantOptions, BuildRefusesOptionsWithoutEffect) {
  expect_refused_line("build plant.toml --split", "--split goes with models only");
  expect_refused_line("build plant.toml --split --picture x.png", "--split goes with models only");
  for (const char* option : {"--azimuth", "--elevation", "--distance"})
    expect_refused_line(std::string("build plant.toml --out x.obj ") + option + " 8",
                        std::string(option) + " goes with a");
  expect_refused_line("build plant.toml --picture-height 800", "as in --picture plant.png");
  expect_refused_line("build plant.toml --tree --resolution 1", "leave out --resolution");
  expect_refused_line("build plant.toml --tree --split", "leave --split out");
  EXPECT_EQ(left_behind(), given_);
}

TEST_F(PlantOptions, BuildMakesNoFolderAndKeepsWhatIsProtected) {
  expect_refused_line("build plant.toml --out x.obj,typo/x.obj", "there is no folder typo");
  expect_refused_line("build plant.toml --out x.obj,", "a name is missing");
  expect_refused_line("build plant.toml --out x.obj,,y.obj", "a name is missing");
  expect_refused({"build", "plant.toml", "--picture", ""}, 2, "a name is missing");
  EXPECT_EQ(left_behind(), given_);
  write("x.mtl", "old\n");  // which a model brings along
  std::filesystem::permissions(folder() / "x.mtl", std::filesystem::perms::owner_read);
  expect_refused({"build", "plant.toml", "--out", "x.obj"}, 3, "x.mtl: it is write-protected");
  EXPECT_EQ(read("x.mtl"), "old\n");
  EXPECT_FALSE(exists("x.obj"));
}

TEST_F(PlantOptions, GrowRefusesOptionsWithoutEffect) {
  expect_refused_line("grow tree.toml --split", "--split goes with models only");
  expect_refused_line("grow tree.toml --out x.obj --azimuth 90", "as in --picture plant.png");
  // The bare skeleton has no camera.
  for (const char* option : {"--azimuth", "--elevation", "--distance"})
    expect_refused_line(std::string("grow tree.toml --picture x.svg ") + option + " 8",
                        std::string(option) + " goes with a");
  expect_refused_line("grow tree.toml --picture x.svg --picture-height 800", "a .png picture");
  expect_refused_line("grow --example --json", "leave out --json");
  expect_refused_line("grow --example tree.toml", "leave out tree.toml");
  EXPECT_EQ(left_behind(), given_);
}

TEST_F(PlantOptions, GrowMakesNoFolderAndKeepsWhatIsProtected) {
  expect_refused_line("grow tree.toml --out typo/x.obj", "there is no folder typo");
  expect_refused_line("grow tree.toml --picture typo/x.svg", "there is no folder typo");
  expect_refused_line("grow tree.toml --out x.obj,", "a name is missing");
  for (const char* option : {"--out", "--picture"})
    expect_refused({"grow", "tree.toml", option, ""}, 2, "a name is missing");
  EXPECT_EQ(left_behind(), given_);
  write("x.svg", "old\n");
  std::filesystem::permissions(folder() / "x.svg", std::filesystem::perms::owner_read);
  expect_refused({"grow", "tree.toml", "--picture", "x.svg"}, 3, "x.svg: it is write-protected");
  EXPECT_EQ(read("x.svg"), "old\n");
  std::filesystem::permissions(folder() / "x.svg", std::filesystem::perms::owner_write);
  output_of({"grow", "tree.toml", "--picture", "x.svg"});  // whoever may write may replace
  EXPECT_NE(read("x.svg"), "old\n");
}

TEST_F(PlantOptions, GrowDoesNotOverwriteItsParameters) {
  write("tree.svg", read("tree.toml"));
  expect_refused_line("grow tree.svg --picture ./tree.svg", "overwrite the parameter file");
}

}  // namespace
}  // namespace phytobench
