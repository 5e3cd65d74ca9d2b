// SPDX-License-Identifier: MIT
// phytobench build: counts and their prediction, files, frames, the tree of instances, refusals.
#include <map>

#include "cli/command_line_fixture.hpp"
#include "core/picture/image.hpp"
#include "core/picture/render.hpp"

namespace phytobench {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* build_schema = "phytobench/build-1";

/// The example of [Lintermann1997] sec. 3.1.1; A and B are bodies.
constexpr const char* published_example = R"(
[graph]
root = "A"
[component.A]
kind = "simple"
[component.B]
kind = "horn"
[component.C]
kind = "hydra"
count = 3
[component.D]
kind = "horn"
most_recursions = 3
[[link]]
from = "A"
to = "B"
[[link]]
from = "B"
to = "C"
[[link]]
from = "C"
to = "D"
[[link]]
from = "D"
to = "D"
)";

/// Grows from time 0 to 1, and bears more and more.
constexpr const char* growing = R"(
[graph]
root = "stem"
[component.stem]
kind = "horn"
length = { frames = [{ time = 0, value = 0.2 }, { time = 1, value = 2.0 }] }
[component.fan]
kind = "hydra"
count = { frames = [{ time = 0, value = 0 }, { time = 1, value = 6 }] }
[component.blade]
kind = "leaf"
[[link]]
from = "stem"
to = "fan"
[[link]]
from = "fan"
to = "blade"
)";

class BuildCommand : public CommandLine {
 protected:
  void SetUp() override {
    write("plant.toml", published_example);
    write("growing.toml", growing);
  }

  /// Instances of each component, which must be those that are predicted.
  static std::map<std::string, std::uint64_t> counts_of(const json& plant) {
    std::map<std::string, std::uint64_t> counts;
    for (const json& component : plant.at("components")) {
      EXPECT_EQ(component.at("instances"), component.at("predicted")) << component;
      counts[component.at("name").get<std::string>()] =
          component.at("instances").get<std::uint64_t>();
    }
    return counts;
  }

  Image picture(const std::string& name, const Words& more) const {
    Words words{"build", "plant.toml", "--picture", name, "--picture-height", "60"};
    words.insert(words.end(), more.begin(), more.end());
    output_of(words);
    return parse_png(read(name), name);
  }
};

std::uint64_t sum_of(const json& rows, const char* key) {
  std::uint64_t sum = 0;
  for (const json& row : rows) sum += row.at(key).get<std::uint64_t>();
  return sum;
}

TEST_F(BuildCommand, CountsThePublishedExampleAsItWasPredicted) {
  const json plant = json_of({"build", "plant.toml", "--json"}, build_schema);
  EXPECT_EQ(counts_of(plant),
            (std::map<std::string, std::uint64_t>{{"A", 1}, {"B", 1}, {"C", 1}, {"D", 9}}));
  EXPECT_EQ(plant["instances"], 12);
  EXPECT_EQ(plant["edges"], 11);
  EXPECT_EQ(plant["levels"], 6);
  EXPECT_EQ(sum_of(plant["links"], "instances"), 11u);
  EXPECT_EQ(plant["components"][3]["most_recursions"], 3);
  EXPECT_EQ(plant["components"][0]["most_recursions"], nullptr);
  EXPECT_EQ(plant["files"].size(), 0u);
  EXPECT_EQ(plant["frames"].size(), 0u);
  EXPECT_EQ(left_behind(), (std::set<std::string>{"growing.toml", "plant.toml"}));
}

TEST_F(BuildCommand, SaysTheSameInWords) {
  const std::string text = output_of({"build", "plant.toml"});
  EXPECT_THAT(text, StartsWith("plant.toml: seed 0, time 0\n"));
  EXPECT_THAT(text, HasSubstr("D          horn              9          9\n"));
  EXPECT_THAT(text, HasSubstr("D -> D  child             6\n"));
  EXPECT_THAT(text, HasSubstr("\n12 instances on 6 levels\n"));
  EXPECT_THAT(text, HasSubstr("\nbox "));
}

TEST_F(BuildCommand, WritesModelsThatHoldWhatItCounts) {
  std::filesystem::create_directories(folder() / "a");
  const json plant =
      json_of({"build", "--preset", "bush", "--out", "a/bush.obj,bush.glb", "--json"},
              "phytobench/build-1");
  EXPECT_EQ(plant["preset"], "bush");
  for (const json& file : plant["files"]) EXPECT_TRUE(exists(file.get<std::string>())) << file;
  const std::string obj = read("a/bush.obj");
  EXPECT_EQ(lines_with(obj, "v "), plant["vertices"].get<std::size_t>());
  EXPECT_EQ(lines_with(obj, "f "), plant["triangles"].get<std::size_t>());
  EXPECT_EQ(lines_with(obj, "o "), plant["materials"].size());
  EXPECT_EQ(sum_of(plant["materials"], "triangles"), plant["triangles"].get<std::uint64_t>());
  EXPECT_EQ(sum_of(plant["materials"], "vertices"), plant["vertices"].get<std::uint64_t>());
  EXPECT_THAT(read("bush.glb"), StartsWith("glTF"));
}

TEST_F(BuildCommand, BuildsEveryPresetAsPredicted) {
  const json listed = json_of({"list", "graphs", "--json"}, "phytobench/list-1");
  EXPECT_GE(listed["entries"].size(), 3u);
  for (const json& entry : listed["entries"]) {
    const std::string name = entry.at("id").get<std::string>();
    SCOPED_TRACE(name);
    counts_of(json_of({"build", "--preset", name, "--json"}, build_schema));
    EXPECT_THAT(output_of({"list", "presets"}), HasSubstr("\n" + name + " "));
  }
  const auto bush = counts_of(json_of({"build", "--preset", "bush", "--json"}, build_schema));
  EXPECT_EQ(bush.at("fork"), 121u);
  EXPECT_EQ(bush.at("twig"), 363u);
}

TEST_F(BuildCommand, WritesTheSameBytesAgainAndOthersForAnotherSeed) {
  const auto bytes = [&](const std::string& name, const Words& more) {
    Words words{"build", "--preset", "bush", "--out", name};
    words.insert(words.end(), more.begin(), more.end());
    output_of(words);
    return read(name);
  };
  const std::string first = bytes("one.glb", {});
  EXPECT_EQ(first, bytes("two.glb", {}));
  EXPECT_EQ(first, bytes("same.glb", {"--seed", "1", "--threads", "2"}));  // that of the file
  EXPECT_NE(first, bytes("other.glb", {"--seed", "2"}));
}

TEST_F(BuildCommand, ResolutionChangesMeshesAlone) {
  const json coarse =
      json_of({"build", "--preset", "bush", "--resolution", "0.5", "--json"}, build_schema);
  const json usual = json_of({"build", "--preset", "bush", "--json"}, build_schema);
  EXPECT_LT(coarse["triangles"], usual["triangles"]);
  EXPECT_EQ(coarse["components"], usual["components"]);
  EXPECT_EQ(coarse["resolution"], 0.5);
}

TEST_F(BuildCommand, PredictsNothingWhereChanceDecides) {
  write("chance.toml",
        "[graph]\nroot = \"a\"\n[component.a]\nkind = \"hydra\"\ncount = \"floor(random(2, 9))\"\n"
        "[component.b]\nkind = \"horn\"\n[[link]]\nfrom = \"a\"\nto = \"b\"\n");
  const json plant = json_of({"build", "chance.toml", "--json"}, build_schema);
  EXPECT_EQ(plant["components"][0]["predicted"], 1);
  EXPECT_EQ(plant["components"][1]["predicted"], nullptr);
  EXPECT_GE(plant["components"][1]["instances"], 2);
  EXPECT_THAT(output_of({"build", "chance.toml"}), HasSubstr("\n-: not predicted, random()"));
}

TEST_F(BuildCommand, RendersFromTheSideAskedFor) {
  if (!can_render()) GTEST_SKIP() << "Embree is not installed";
  const Image front = picture("front.png", {});
  EXPECT_EQ(front.height(), 60);
  EXPECT_EQ(front, picture("again.png", {"--threads", "2"}));
  EXPECT_NE(front, picture("side.png", {"--azimuth", "10"}));
  EXPECT_NE(front, picture("above.png", {"--elevation", "60"}));
  EXPECT_NE(front, picture("far.png", {"--distance", "40"}));
}

TEST_F(BuildCommand, BuildsTheMomentAskedFor) {
  const auto at = [&](const std::string& time) {
    return json_of({"build", "growing.toml", "--time=" + time, "--json"}, build_schema);
  };
  EXPECT_EQ(at("0")["instances"], 2);
  EXPECT_EQ(at("0.5")["instances"], 5);
  EXPECT_EQ(at("1")["instances"], 8);
  EXPECT_EQ(at("-3")["instances"], 2);
  EXPECT_EQ(at("0.5")["time"], 0.5);
  EXPECT_LT(at("0")["box"]["high"][1], at("1")["box"]["high"][1]);
}

TEST_F(BuildCommand, WritesFramesOfAnAnimation) {
  std::filesystem::create_directories(folder() / "film");
  Words words{"build", "growing.toml", "--time", "0:1:4", "--out", "film/%03d.glb", "--json"};
  if (can_render()) words.insert(words.end(), {"--picture", "f-%d.png", "--picture-height", "40"});
  const json plant = json_of(words, build_schema);
  const json& frames = plant["frames"];
  ASSERT_EQ(frames.size(), 4u);
  EXPECT_EQ(frames[0]["time"], 0.0);
  EXPECT_EQ(frames[3]["time"], 1.0);
  for (std::size_t i = 0; i + 1 < frames.size(); ++i)
    EXPECT_LT(frames[i]["triangles"], frames[i + 1]["triangles"]);
  EXPECT_EQ(plant["triangles"], frames[3]["triangles"]);  // the last one in full
  for (const json& file : plant["files"]) EXPECT_TRUE(exists(file.get<std::string>())) << file;
  EXPECT_TRUE(exists("film/000.glb") && exists("film/003.glb") && !exists("film/004.glb"));
  // A frame is the plant of that moment.
  output_of({"build", "growing.toml", "--time", "1", "--out", "last.glb"});
  EXPECT_EQ(read("last.glb"), read("film/003.glb"));
}

/// The camera stands still: the young plant is small in the picture.
TEST_F(BuildCommand, FramesShareACamera) {
  if (!can_render()) GTEST_SKIP() << "Embree is not installed";
  output_of({"build", "growing.toml", "--time", "0:1:2", "--picture", "f%d.png", "--picture-height",
             "60"});
  output_of(
      {"build", "growing.toml", "--time", "0", "--picture", "young.png", "--picture-height", "60"});
  EXPECT_NE(read("f0.png"), read("young.png"));
}

TEST_F(BuildCommand, PrintsTheTreeOfInstances) {
  EXPECT_EQ(output_of({"build", "plant.toml", "--tree"}),
            "A\n  B\n    C\n"
            "      D 1/3\n        D #2\n          D #3\n"
            "      D 2/3\n        D #2\n          D #3\n"
            "      D 3/3\n        D #2\n          D #3\n");
  const std::string dot = output_of({"build", "plant.toml", "--tree=dot"});
  EXPECT_THAT(dot, StartsWith("digraph i_tree {\n"));
  EXPECT_EQ(lines_with(dot, "  n"), 1u + 12u + 11u);  // "node", nodes and edges
  EXPECT_EQ(line_count(output_of({"build", "growing.toml", "--tree", "--time", "1"})), 8);
  expect_refused({"build", "--preset", "weeping-willow", "--tree"}, 2, "--tree shows 10000");
  expect_refused_line("build plant.toml --tree=xml", "list or dot");
  expect_refused_line("build plant.toml --tree --json", "leave out --json");
  expect_refused_line("build plant.toml --tree --out x.obj", "leave out --out");
  expect_refused_line("build plant.toml --tree --time 0:1:5", "one moment");
}

TEST_F(BuildCommand, ExamplesOfEveryKindCanBeBuilt) {
  const json listed = json_of({"list", "components", "--json"}, "phytobench/list-1");
  EXPECT_GE(listed["entries"].size(), 9u);
  for (const json& entry : listed["entries"]) {
    const std::string kind = entry.at("id").get<std::string>();
    SCOPED_TRACE(kind);
    EXPECT_GT(entry.at("keys").size(), 0u);
    EXPECT_FALSE(entry.at("source").get<std::string>().empty());
    EXPECT_THAT(output_of({"build", "--example", "list"}), HasSubstr(kind));
    if (!entry.at("built").get<bool>()) continue;
    write("example.toml", output_of({"build", "--example", kind}));
    counts_of(json_of({"build", "example.toml", "--out", "example.obj", "--json"}, build_schema));
  }
  expect_refused_line("build --example phiballs", "did you mean 'phiball'?");
}

TEST_F(BuildCommand, AnExampleMayBeAPreset) {
  const std::string examples = "\n" + output_of({"build", "--example", "list"});
  const json presets = json_of({"list", "graphs", "--json"}, "phytobench/list-1");
  const json kinds = json_of({"list", "components", "--json"}, "phytobench/list-1");
  for (const json& preset : presets["entries"]) {
    const std::string name = preset.at("id").get<std::string>();
    SCOPED_TRACE(name);
    EXPECT_THAT(examples, HasSubstr("\n" + name + " "));
    for (const json& kind : kinds["entries"]) EXPECT_NE(kind.at("id"), name) << "would hide it";
    write("mine.toml", output_of({"build", "--example", name}));
    EXPECT_EQ(json_of({"build", "mine.toml", "--json"}, build_schema)["components"],
              json_of({"build", "--preset", name, "--json"}, build_schema)["components"]);
  }
  expect_refused_line("build --example bushh", "did you mean 'bush'?");
  expect_refused_line("build --example bush --json", "leave out --json");
  expect_refused_line("build --example bush plant.toml", "leave out plant.toml");
}

TEST_F(BuildCommand, CountsOneInTheSingular) {
  write("one.toml", "[graph]\nroot = \"a\"\n[component.a]\nkind = \"horn\"\n");
  const std::string text = output_of({"build", "one.toml", "--time=-0"});
  EXPECT_THAT(text, HasSubstr("\n1 instance on 1 level\n"));
  EXPECT_THAT(text, StartsWith("one.toml: seed 0, time 0\n"));
}

TEST_F(BuildCommand, RefusesWrongOptionsBeforeItBuilds) {
  expect_refused_line("build", "phytobench list graphs");
  expect_refused_line("build plant.toml --preset bush", "not both");
  expect_refused_line("build --preset bushes", "did you mean 'bush'?");
  expect_refused_line("build none.toml", "none.toml");
  expect_refused_line("build plant.toml --out plant.fbx", ".obj or .glb");
  expect_refused_line("build plant.toml --picture plant.svg", ".png");
  expect_refused_line("build plant.toml --out x.obj,./x.obj", "two documents");
  for (const char* resolution : {"0", "-1", "101", "nan"})
    expect_refused_line(std::string("build plant.toml --resolution ") + resolution, "--resolution");
  expect_refused_line("build plant.toml --seed -1", "--seed");
  expect_refused_line("build plant.toml --elevation 91", "--elevation");
  for (const char* option : {"--azimuth", "--elevation", "--distance"})
    expect_refused_line(std::string("build plant.toml ") + option + " nan", option);
  for (const char* time : {"x", "1:2", "0:1:1", "0:1:20000", "0:1:2:3", "0:1:-2", "0:nan:2"})
    expect_refused({"build", "plant.toml", "--out", "%d.obj", std::string("--time=") + time}, 2,
                   "--time");
  expect_refused_line("build plant.toml --time 0:1:3 --out x.obj", "frame-%03d.png");
  expect_refused_line("build plant.toml --time 0:1:3 --out %d-%d.obj", "frame-%03d.png");
  expect_refused_line("build plant.toml --out x-%d.obj", "FIRST:LAST:FRAMES");
  EXPECT_EQ(left_behind(), (std::set<std::string>{"growing.toml", "plant.toml"}));
}

TEST_F(BuildCommand, NamesFileLineAndKeyOfAMistake) {
  write("wrong.toml", "[graph]\nroot = \"a\"\n[component.a]\nkind = \"horn\"\nlenght = 2\n");
  const Outcome outcome = run({"build", "wrong.toml"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("wrong.toml:5"));
  EXPECT_THAT(outcome.err, HasSubstr("did you mean 'a.length'?"));
}

TEST_F(BuildCommand, RefusesPlantsOfAbsurdSize) {
  write("huge.toml",
        "[graph]\nroot = \"a\"\n[component.a]\nkind = \"hydra\"\ncount = 10\nmost_recursions = 30\n"
        "[[link]]\nfrom = \"a\"\nto = \"a\"\n");
  expect_refused_line("build huge.toml", "more than 10000000 instances");
  expect_refused_line("build huge.toml --tree", "more than 10000000 instances");
  expect_refused_line("build --preset bush --resolution 100", "lower the resolution");
}

TEST_F(BuildCommand, RefusesToWriteAPlantWithoutTriangles) {
  write("bare.toml", "[graph]\nroot = \"a\"\n[component.a]\nkind = \"simple\"\nshape = \"none\"\n");
  const json plant = json_of({"build", "bare.toml", "--json"}, build_schema);
  EXPECT_EQ(plant["triangles"], 0);
  EXPECT_EQ(plant["box"], nullptr);
  expect_refused_line("build bare.toml --out bare.obj", "no triangles");
  EXPECT_FALSE(exists("bare.obj"));
}

TEST_F(BuildCommand, LeavesWhatWasThereWhenItCannotWrite) {
  write("kept/plant.obj", "old\n");
  write("file", "");
  expect_refused({"build", "plant.toml", "--out", "kept/plant.obj,file/plant.glb"}, 3, "file");
  EXPECT_EQ(read("kept/plant.obj"), "old\n");
  EXPECT_FALSE(exists("kept/plant.mtl"));
  {
    const SmallFilesOnly full(20'000);
    expect_refused({"build", "--preset", "bush", "--out", "kept/plant.obj"}, 3, "plant.obj");
  }
  EXPECT_EQ(read("kept/plant.obj"), "old\n");
  EXPECT_FALSE(exists("kept/plant.mtl"));
}

TEST_F(BuildCommand, StopsAtCtrlCAndLeavesNothing) {
  if (!can_render()) GTEST_SKIP() << "Embree is not installed";
  // Many seconds.
  const Words slow = {"build", "--preset",         "bush", "--picture",
                      "x.png", "--picture-height", "8192"};
  const std::set<std::string> before = left_behind();
  const Outcome outcome = interrupt(slow, [&] { EXPECT_EQ(left_behind(), before); });
  EXPECT_THAT(outcome.err, HasSubstr("nothing is written"));
}

TEST_F(BuildCommand, SaysWhenStandardOutputIsFull) {
  EXPECT_EQ(run_on_full_disk({"build", "plant.toml"}).code, 3);
  EXPECT_EQ(run_on_full_disk({"build", "plant.toml", "--tree"}).code, 3);
}

}  // namespace
}  // namespace phytobench
