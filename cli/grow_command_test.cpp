// SPDX-License-Identifier: MIT
// phytobench grow with everything it can write.
#include "cli/command_line_fixture.hpp"
#include "core/picture/image.hpp"
#include "core/picture/render.hpp"

namespace phytobench {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::StartsWith;

class GrowCommand : public CommandLine {
 protected:
  void SetUp() override {
    write("tree.toml", "cloud.radii = [1.5, 2.0, 1.5]\ngrowth.iterations = 12\n");
  }
};

TEST_F(GrowCommand, WritesModelsThatHoldWhatItCounts) {
  std::filesystem::create_directories(folder() / "a");
  const json tree =
      json_of({"grow", "tree.toml", "--out", "a/tree.obj,tree.glb", "--json"}, "phytobench/grow-2");
  EXPECT_EQ(tree["files"].size(), 5u);
  for (const json& file : tree["files"]) EXPECT_TRUE(exists(file.get<std::string>())) << file;
  const std::string obj = read("a/tree.obj");
  const auto lines = [&obj](const std::string& start) {
    std::size_t count = 0;
    for (std::size_t at = obj.find("\n" + start); at != std::string::npos;
         at = obj.find("\n" + start, at + 1))
      ++count;
    return count;
  };
  EXPECT_EQ(lines("v "), tree["vertices"].get<std::size_t>());
  EXPECT_EQ(lines("vn "), lines("v "));
  EXPECT_EQ(lines("vt "), lines("v "));
  EXPECT_EQ(lines("f "), tree["triangles"].get<std::size_t>());
  EXPECT_THAT(obj, HasSubstr("mtllib tree.mtl"));
  EXPECT_THAT(read("tree.glb"), StartsWith("glTF"));
}

TEST_F(GrowCommand, WritesTheSameBytesForAnyNumberOfThreads) {
  output_of({"grow", "tree.toml", "--out", "one.glb", "--threads", "1"});
  output_of({"grow", "tree.toml", "--out", "two.glb", "--threads", "2"});
  EXPECT_EQ(read("one.glb"), read("two.glb"));
}

TEST_F(GrowCommand, GrowsPresetsByName) {
  const json tree = json_of({"grow", "--preset", "figure-45-left", "--json"}, "phytobench/grow-2");
  EXPECT_EQ(tree["edges"], 401);
  EXPECT_EQ(tree["vertices"], 1808);
  EXPECT_EQ(tree["triangles"], 2406);
  expect_refused({"grow", "--preset", "figure-99"}, 2, "list presets");
  expect_refused({"grow", "tree.toml", "--preset", "birch"}, 2, "not both");
}

TEST_F(GrowCommand, SaysTheSameOfTheTreeWithEveryOption) {
  const auto tree_of = [this](const std::string& option) {
    json tree = json_of({"grow", "tree.toml", "--option", option, "--json"}, "phytobench/grow-2");
    for (const char* key : {"option", "work", "stop_reason"}) tree.erase(key);
    return tree;
  };
  const json tree = tree_of("s");
  EXPECT_EQ(tree["iterations"], 12);
  EXPECT_LT(tree["points_at_last_search"], tree["attraction_points"]);
  for (const char* option : {"d", "n", "dn"}) EXPECT_EQ(tree_of(option), tree) << option;
}

TEST_F(GrowCommand, RendersFromTheSideAskedFor) {
  if (!can_render()) GTEST_SKIP() << "Embree is not installed";
  const auto picture = [&](const std::string& name, const Words& more) {
    Words words{"grow", "tree.toml", "--picture", name, "--picture-height", "60"};
    words.insert(words.end(), more.begin(), more.end());
    output_of(words);
    return parse_png(read(name), name);
  };
  const Image front = picture("front.png", {});
  EXPECT_EQ(front.height(), 60);
  EXPECT_EQ(front, picture("again.png", {}));
  EXPECT_NE(front, picture("side.png", {"--azimuth", "10"}));
  EXPECT_NE(front, picture("above.png", {"--elevation", "60"}));
  EXPECT_NE(front, picture("far.png", {"--distance", "40"}));
}

TEST_F(GrowCommand, RefusesFilesOfAnotherKindBeforeItGrows) {
  expect_refused({"grow", "tree.toml", "--out", "tree.fbx"}, 2, ".obj or .glb");
  expect_refused({"grow", "tree.toml", "--picture", "tree.jpg"}, 2, ".png or .svg");
  expect_refused({"grow", "tree.toml", "--elevation", "91"}, 2, "--elevation");
  expect_refused({"grow", "tree.toml", "--elevation", "nan"}, 2, "--elevation");
  expect_refused({"grow", "tree.toml", "--picture-height", "1"}, 2, "--picture-height");
}

TEST_F(GrowCommand, LeavesWhatWasThereWhenItCannotWrite) {
  write("kept/tree.obj", "old\n");
  write("file", "");
  expect_refused({"grow", "tree.toml", "--out", "kept/tree.obj,file/tree.glb"}, 3, "file");
  EXPECT_EQ(read("kept/tree.obj"), "old\n");
  EXPECT_FALSE(exists("kept/tree.mtl"));
}

TEST_F(GrowCommand, LeavesWhatWasThereWhenTheDiskIsFull) {
  write("bush.obj", "old\n");
  write("bush.mtl", "old, too\n");
  const std::set<std::string> before = left_behind();
  {
    const SmallFilesOnly full(100'000);
    expect_refused({"grow", "--preset", "figure-44-left", "--out", "bush.obj,bush.glb"}, 3,
                   "bush.obj");
  }
  EXPECT_EQ(left_behind(), before);
  EXPECT_EQ(read("bush.obj"), "old\n");
  EXPECT_EQ(read("bush.mtl"), "old, too\n");
  output_of({"grow", "--preset", "figure-44-left", "--out", "bush.obj,bush.glb"});
  EXPECT_GT(read("bush.obj").size(), 100'000u);
}

TEST_F(GrowCommand, StopsAtCtrlCAndLeavesNothing) {
  // Ten seconds of growth and more.
  const Words slow = {"grow",           "--preset", "figure-52", "--engine",
                      "euclidean_scan", "--out",    "big.obj"};
  const std::set<std::string> before = left_behind();
  interrupt(slow, [&] { EXPECT_EQ(left_behind(), before); });
}

TEST_F(GrowCommand, NamesATextureThatIsMissingOrNoPicture) {
  write("bark.toml", "colours.bark_texture = \"none.png\"\n");
  expect_refused({"grow", "bark.toml", "--out", "x.obj"}, 2, "none.png");
  write("none.png", "no picture\n");
  expect_refused({"grow", "bark.toml", "--out", "x.obj"}, 2, "none.png");
  EXPECT_EQ(left_behind(), (std::set<std::string>{"bark.toml", "none.png", "tree.toml"}));
}

TEST_F(GrowCommand, SplitsWhereSixteenBitsEnd) {
  output_of({"grow", "--preset", "figure-43-right", "--out", "whole.obj"});
  output_of({"grow", "--preset", "figure-43-right", "--out", "parts.obj", "--split"});
  const auto objects = [](const std::string& text) {
    std::size_t count = 0;
    for (std::size_t at = text.find("\no "); at != std::string::npos;
         at = text.find("\no ", at + 1))
      ++count;
    return count;
  };
  EXPECT_EQ(objects(read("whole.obj")), 2u);
  EXPECT_EQ(objects(read("parts.obj")), 2u);  // 18,984 vertices of bark, 59,392 of leaves
  output_of({"grow", "--preset", "figure-52", "--out", "large.obj", "--split"});
  EXPECT_EQ(objects(read("large.obj")), 3u);  // 190,504 vertices
}

}  // namespace
}  // namespace phytobench
