// SPDX-License-Identifier: MIT
// phytobench derive: counts and their prediction, the drawing, files, words too long, refusals.
#include <map>

#include "cli/command_line_fixture.hpp"
#include "core/picture/image.hpp"
#include "core/picture/render.hpp"

namespace phytobench {
namespace {

using nlohmann::json;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* derive_schema = "phytobench/derive-1";

/// [Liebemann2017] eq. 2.6 with sides of length 1.
constexpr const char* island =
    "axiom: F-F-F-F\np1 : F -> F+F-F-FF+F+F-F\nsteps: 2   angle: 90   step: 1\n";

/// A tree in space with leaves, wider at its root.
constexpr const char* tree_system =
    "axiom: A(2)\n"
    "A(w) -> !(w)F[+(40)A(w / 2)]/(90)[&(40)A(w / 2)][{.f+f+f}]F\n"
    "angle: 120   steps: 3\n";

constexpr const char* gambler = "axiom: F\nF -> FF : 0.5\nF -> F[+F] : 0.5\nsteps: 9\n";

class DeriveCommand : public CommandLine {
 protected:
  void SetUp() override {
    write("island.lsys", island);
    write("tree.lsys", tree_system);
    write("gambler.lsys", gambler);
  }
  const std::set<std::string> given_ = {"gambler.lsys", "island.lsys", "tree.lsys"};

  json derived(Words words) const {
    words.insert(words.begin(), "derive");
    words.emplace_back("--json");
    return json_of(words, derive_schema);
  }

  /// How often each letter occurs, which must be as often as it is predicted.
  static std::map<std::string, std::uint64_t> counts_of(const json& word) {
    std::map<std::string, std::uint64_t> counts;
    for (const json& symbol : word.at("symbols")) {
      const auto count = symbol.at("count").get<std::uint64_t>();
      EXPECT_EQ(symbol.at("predicted"), std::to_string(count)) << symbol;
      counts[symbol.at("letter").get<std::string>()] += count;
    }
    return counts;
  }
};

TEST_F(DeriveCommand, CountsAndDrawsAsItWasPredicted) {
  const json word = derived({"island.lsys"});
  EXPECT_EQ(word["steps"], 2);
  EXPECT_EQ(word["properties"], json::array({"D0L-system"}));
  EXPECT_EQ(word["made"], true);
  EXPECT_EQ(counts_of(word)["F"], 256u);
  EXPECT_EQ(word["modules"], 475);
  EXPECT_EQ(word["predicted_modules"], "475");
  EXPECT_EQ(word["drawing"]["segments"], 256);
  EXPECT_EQ(word["drawing"]["predicted_segments"], "256");
  EXPECT_EQ(word["drawing"]["streamed"], false);
  EXPECT_EQ(word["drawing"]["length"], 256.0);
  EXPECT_EQ(word["drawing"]["polygons"], 0);
  EXPECT_EQ(word["tree"]["nodes"], 257);
  EXPECT_EQ(word["tree"]["tips"], 1);
  EXPECT_EQ(word["tree"]["depth"], 256);
  EXPECT_EQ(word["files"], json::array());
  EXPECT_EQ(left_behind(), given_);
}

TEST_F(DeriveCommand, DescribesATreeWithLeaves) {
  const json word = derived({"tree.lsys", "--steps", "2"});
  // Two forks of two: the root's two pieces of stem, and twice the same.
  EXPECT_EQ(counts_of(word)["F"], 6u);
  EXPECT_EQ(word["drawing"]["segments"], 6);
  EXPECT_EQ(word["drawing"]["polygons"], 3);
  EXPECT_EQ(word["tree"]["nodes"], 7);
  EXPECT_EQ(word["tree"]["tips"], 3);
  EXPECT_EQ(word["tree"]["largest_degree"], 3);
  EXPECT_EQ(word["tree"]["depth"], 3);
  EXPECT_GT(word["tree"]["root_radius"], 0.0);
  EXPECT_EQ(word["parameters"].get<int>(),
            4 + 2 * (4 + 2));  // ! + / & of each fork, and A at its ends
  EXPECT_NE(word["drawing"]["polygon_box"], nullptr);
}

TEST_F(DeriveCommand, SaysTheSameInWords) {
  const std::string text = output_of({"derive", "island.lsys", "--steps", "1"});
  EXPECT_THAT(text, StartsWith("island.lsys: 1 step, D0L-system\n\n"));
  EXPECT_THAT(text, HasSubstr("\nF          32         32\n"));
  EXPECT_THAT(text, HasSubstr("\nall        59         59\n"));
  EXPECT_THAT(text, HasSubstr("\n32 segments of total length 32\nbox 6 x 6 x 0, from (-1, -1, 0)"));
  EXPECT_THAT(text, HasSubstr("\na tree of 33 nodes, 1 of them a tip; largest degree 1, depth 32"));
}

TEST_F(DeriveCommand, DerivesEveryPreset) {
  const json listed = json_of({"list", "lsystems", "--json"}, "phytobench/list-1");
  EXPECT_GE(listed["entries"].size(), 27u);
  std::string examples = "\n" + output_of({"derive", "--example", "list"});
  for (const json& entry : listed["entries"]) {
    const std::string name = entry.at("id").get<std::string>();
    SCOPED_TRACE(name);
    const json word = derived({"--preset", name});
    EXPECT_EQ(word["preset"], name);
    EXPECT_EQ(word["made"], true);
    if (word["not_predicted"].is_null()) counts_of(word);
    EXPECT_THAT(examples, HasSubstr("\n" + name + " "));
  }
  EXPECT_EQ(derived({"--preset", "bush"})["modules"], 9354);
  EXPECT_EQ(derived({"--preset", "bush-abop-slashes"})["modules"], 8294);
}

TEST_F(DeriveCommand, AnExampleIsAFileToStartFrom) {
  write("mine.lsys", output_of({"derive", "--example", "explained"}));
  EXPECT_EQ(derived({"mine.lsys"})["word_hash"], derived({"--preset", "explained"})["word_hash"]);
  expect_refused_line("derive --example explaned", "did you mean 'explained'?");
}

TEST_F(DeriveCommand, PrintsTheWord) {
  EXPECT_EQ(output_of({"derive", "island.lsys", "--steps", "0", "--print", "100"}), "F-F-F-F\n");
  EXPECT_EQ(output_of({"derive", "island.lsys", "--print", "9"}), "F+F-F-FF+\n");
  EXPECT_EQ(output_of({"derive", "tree.lsys", "--steps", "1", "--print", "5"}),
            "!(2)F[+(40)A(1)\n");
  const json word = derived({"island.lsys", "--print", "3"});
  EXPECT_EQ(word["word"], "F+F");
  EXPECT_EQ(word["modules"], 475);
  EXPECT_EQ(derived({"island.lsys"})["word"], nullptr);
  expect_refused_line("derive island.lsys --print 5 --out x.svg", "leave out --out");
}

TEST_F(DeriveCommand, SeedsDecideAndThreadsDoNot) {
  const auto hash = [&](const Words& more) {
    Words words{"gambler.lsys"};
    words.insert(words.end(), more.begin(), more.end());
    return derived(words)["word_hash"];
  };
  EXPECT_EQ(hash({"--seed", "7"}), hash({"--seed", "7", "--threads", "2"}));
  EXPECT_NE(hash({"--seed", "7"}), hash({"--seed", "8"}));
  const json word = derived({"gambler.lsys"});
  EXPECT_THAT(word["not_predicted"].get<std::string>(), HasSubstr("by lot"));
  EXPECT_EQ(word["symbols"][0]["predicted"], nullptr);
  EXPECT_THAT(output_of({"derive", "gambler.lsys"}),
              HasSubstr("\n-: not predicted, successors are drawn by lot\n"));
}

// Words that are too long

TEST_F(DeriveCommand, DrawsWithoutTheWordWhereItIsTooLong) {
  const json made = derived({"island.lsys", "--steps", "4"});
  const json counted = derived({"island.lsys", "--steps", "4", "--most-modules", "1000"});
  EXPECT_EQ(counted["made"], false);
  EXPECT_EQ(counted["modules"], made["modules"]);
  EXPECT_EQ(counts_of(counted), counts_of(made));
  EXPECT_EQ(counted["word_hash"], nullptr);
  EXPECT_EQ(counted["tree"], nullptr);
  EXPECT_EQ(counted["drawing"]["streamed"], true);
  for (const char* key : {"segments", "predicted_segments", "length", "box"})
    EXPECT_EQ(counted["drawing"][key], made["drawing"][key]) << key;
  EXPECT_THAT(output_of({"derive", "island.lsys", "--steps", "4", "--most-modules", "1000"}),
              HasSubstr("counted, not made: it has more than 1000 modules"));
}

TEST_F(DeriveCommand, CountsWhatNobodyCouldDraw) {
  const json word = derived({"island.lsys", "--steps", "40"});
  EXPECT_EQ(word["modules"], nullptr);
  EXPECT_EQ(word["drawing"], nullptr);
  EXPECT_THAT(word["not_drawn"].get<std::string>(), HasSubstr("10000000000 segments"));
  EXPECT_EQ(word["symbols"][0]["letter"], "F");
  EXPECT_EQ(word["symbols"][0]["predicted"], "5316911983139663491615228241121378304");  // 2^122
  // Parameters: counted, but there is no way to draw without the word.
  const json parametric = derived({"tree.lsys", "--steps", "100"});
  EXPECT_EQ(parametric["made"], false);
  EXPECT_THAT(parametric["not_drawn"].get<std::string>(), HasSubstr("has parameters"));
}

TEST_F(DeriveCommand, RefusesWhatNeedsTheWordWhereItIsTooLong) {
  expect_refused_line("derive island.lsys --steps 40 --out x.svg", "take --steps 7");
  expect_refused_line("derive island.lsys --steps 40 --print 5", "take --steps 7");
  expect_refused_line("derive gambler.lsys --steps 60", "100000000");
  expect_refused_line("derive gambler.lsys --steps 9 --most-modules 20", "gambler.lsys");
  EXPECT_EQ(left_behind(), given_);
}

// Files

TEST_F(DeriveCommand, WritesModelsTablesAndPictures) {
  std::filesystem::create_directories(folder() / "a");
  const json word =
      derived({"tree.lsys", "--out", "a/tree.obj,tree.glb,tree.ply,tree.csv,tree.svg", "--split"});
  for (const json& file : word["files"]) EXPECT_TRUE(exists(file.get<std::string>())) << file;
  const std::string csv = read("tree.csv");
  EXPECT_THAT(csv,
              StartsWith("from_x,from_y,from_z,to_x,to_y,to_z,width,colour\n0,0,0,0,1,0,2,0\n"));
  EXPECT_EQ(line_count(csv), word["drawing"]["segments"].get<std::ptrdiff_t>() + 1);
  const std::string obj = read("a/tree.obj");
  EXPECT_EQ(lines_with(obj, "o bark"), 1u);
  EXPECT_EQ(lines_with(obj, "o leaves"), 1u);
  EXPECT_THAT(read("tree.glb"), StartsWith("glTF"));
  EXPECT_THAT(read("tree.ply"), StartsWith("ply\n"));
  EXPECT_THAT(read("tree.ply"),
              HasSubstr("element face " + std::to_string(lines_with(obj, "f ")) + "\n"));
  EXPECT_THAT(read("tree.svg"), StartsWith("<svg"));
  EXPECT_THAT(output_of({"derive", "tree.lsys", "--out", "again.glb"}),
              EndsWith("\nwrote again.glb\n"));
  EXPECT_EQ(read("again.glb"), read("tree.glb"));
}

TEST_F(DeriveCommand, RendersPictures) {
  if (!can_render()) GTEST_SKIP() << "Embree is not installed";
  const auto picture = [&](const std::string& name, const Words& more) {
    Words words{"derive", "tree.lsys", "--out", name, "--picture-height", "60"};
    words.insert(words.end(), more.begin(), more.end());
    output_of(words);
    return parse_png(read(name), name);
  };
  const Image front = picture("front.png", {});
  EXPECT_EQ(front.height(), 60);
  EXPECT_EQ(front, picture("again.png", {"--threads", "2"}));
  EXPECT_NE(front, picture("side.png", {"--azimuth", "10"}));
}

TEST_F(DeriveCommand, RefusesModelsThatFillTheMemory) {
  for (const char* name : {"x.obj", "x.glb", "x.ply", "x.csv"})
    expect_refused_line(std::string("derive island.lsys --steps 6 --out ") + name,
                        "1048576 segments is too large (at most 1000000");
  EXPECT_EQ(left_behind(), given_);
}

TEST_F(DeriveCommand, RefusesToWriteNothing) {
  write("cells.lsys", "axiom: b\nb -> a\na -> ab\n");
  const json word = derived({"cells.lsys"});
  EXPECT_EQ(word["drawing"]["box"], nullptr);
  EXPECT_EQ(word["no_tree"], "nothing is drawn");
  EXPECT_THAT(output_of({"derive", "cells.lsys"}), EndsWith("\nnothing is drawn\n"));
  expect_refused_line("derive cells.lsys --out x.svg", "nothing is drawn");
}

TEST_F(DeriveCommand, DrawsLinesOfOutlinesInTablesAndTreesAlike) {
  const json word =
      derived({file("leaf.lsys", "axiom: F[{+F-F-F}]F\nangle: 60\n"), "--out", "leaf.csv"});
  EXPECT_EQ(word["drawing"]["segments"], 5);
  EXPECT_EQ(word["drawing"]["polygons"], 1);
  EXPECT_EQ(word["tree"]["nodes"], 6);
  EXPECT_EQ(line_count(read("leaf.csv")), 6);
}

TEST_F(DeriveCommand, SaysThatPolygonsAloneAreDrawn) {
  write("blade.lsys", "axiom: {f+f+f}{f+f+f}\nangle: 120\n");
  EXPECT_EQ(derived({"blade.lsys", "--out", "blade.obj,blade.svg"})["no_tree"],
            "only polygons are drawn");
  EXPECT_THAT(output_of({"derive", "blade.lsys"}), HasSubstr("\n\n2 polygons, box "));
  expect_refused_line("derive blade.lsys --out blade.csv", "draws polygons alone");
}

TEST_F(DeriveCommand, TakesWidthsAsTheyAreGiven) {
  const auto root = [&](const std::string& settings) {
    return derived({file("wide.lsys", "axiom: F[+F]F\n" + settings)})["tree"]["root_radius"];
  };
  EXPECT_EQ(root("width: 0.5\n"), 0.25);
  EXPECT_EQ(root("width: 1\n"), 0.5);
  EXPECT_NE(root(""), 0.5);
}

TEST_F(DeriveCommand, NamesProductionsThatAreNeverUsed) {
  write("slip.lsys", "axiom: A(1)\nA(x) -> A(x + 1)F\nA(x, y) -> F\n");
  Outcome outcome = run({"derive", "slip.lsys", "--json"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.err,
              StartsWith("phytobench: warning: slip.lsys:3:1: p2 is never used: 'A' "));
  EXPECT_EQ(line_count(outcome.err), 1);
  EXPECT_TRUE(json::accept(outcome.out));
  std::string many = "axiom: F\n";
  for (const char letter : std::string("ABCDEGHIJKLM")) many += std::string(1, letter) + " -> F\n";
  outcome = run({"derive", file("many.lsys", many)});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(line_count(outcome.err), 11);
  EXPECT_THAT(outcome.err, EndsWith("many.lsys: 2 productions more are never used\n"));
}

TEST_F(DeriveCommand, AMillionStepsAreNoTrouble) {
  const json chain = derived({file("chain.lsys", "axiom: A\nA -> F[+A]\n"), "--steps", "999999"});
  EXPECT_EQ(chain["modules"], 3999997);
  EXPECT_EQ(chain["predicted_modules"], "3999997");
  EXPECT_EQ(chain["tree"]["depth"], 999999);
  const std::string text =
      output_of({"derive", file("double.lsys", "axiom: F\nF -> FF\n"), "--steps", "1000000"});
  EXPECT_THAT(text, HasSubstr("would take too long\na count of -: more than 18446744073709551615"));
  EXPECT_THAT(text, HasSubstr("\nthe word is neither counted nor made: it has more than"));
}

TEST_F(DeriveCommand, SaysWhyADrawingIsNoTree) {
  const json word = derived({file("gap.lsys", "axiom: FfF\n")});
  EXPECT_EQ(word["tree"], nullptr);
  EXPECT_THAT(word["no_tree"].get<std::string>(), HasSubstr("after a move without drawing"));
  EXPECT_EQ(word["drawing"]["segments"], 2);
  output_of({"derive", "gap.lsys", "--out", "gap.glb"});
}

// Refusals

TEST_F(DeriveCommand, RefusesWrongOptionsBeforeItDerives) {
  expect_refused_line("derive", "phytobench list lsystems");
  expect_refused_line("derive island.lsys --preset bush", "not both");
  expect_refused_line("derive --preset bushes", "did you mean 'bush'?");
  expect_refused_line("derive none.lsys", "none.lsys");
  expect_refused_line("derive island.lsys --out x.fbx", ".obj, .glb, .ply, .svg, .png or .csv");
  expect_refused_line("derive island.lsys --out x.svg,./x.svg", "two documents");
  expect_refused_line("derive island.lsys --steps -1", "--steps");
  expect_refused_line("derive island.lsys --steps 1000001", "--steps");
  expect_refused_line("derive island.lsys --seed -1", "--seed");
  expect_refused_line("derive island.lsys --print -1", "--print");
  for (const char* number : {"0", "nan", "1e12"})
    expect_refused_line(std::string("derive island.lsys --most-modules ") + number,
                        "--most-modules");
  expect_refused_line("derive island.lsys --azimuth nan", "--azimuth");
  write("island.svg", island);
  expect_refused_line("derive island.svg --out ./island.svg", "overwrite the L-system");
}

TEST_F(DeriveCommand, CountsOneInTheSingular) {
  const std::string text =
      output_of({"derive", file("one.lsys", "axiom: F{.f+f.}\nangle: 90   steps: 0\n")});
  EXPECT_THAT(text, HasSubstr("\n1 segment of total length 1\n"));
  EXPECT_THAT(text, HasSubstr("\n1 polygon, box "));
  EXPECT_THAT(text, HasSubstr("a tree of 2 nodes, 1 of them a tip;"));
  EXPECT_THAT(output_of({"derive", "island.lsys", "--steps", "2", "--most-modules", "100"}),
              HasSubstr("1 step is the most\n"));
  EXPECT_THAT(output_of({"derive", "one.lsys", "--most-modules", "1"}),
              HasSubstr("more than 1 module (--most-modules)"));
}

/// Its leaves lie around a stem that sines and cosines of 180 degrees leave upright.
TEST_F(DeriveCommand, ShowsWhatRoundingLeftAsZero) {
  const Words words{"derive", "--preset", "bush"};
  EXPECT_THAT(output_of(words), HasSubstr("box 0 x 11.39 x 15.61, from (0, 0, -7.806) to (0, "));
  EXPECT_NE(derived({"--preset", "bush"})["drawing"]["box"]["low"][0], 0.0);  // as it is
}

TEST_F(DeriveCommand, NamesFileLineAndColumnOfAMistake) {
  const auto expect_mistake = [&](const std::string& text, const std::string& part) {
    write("wrong.lsys", text);
    expect_refused_line("derive wrong.lsys", part);
  };
  expect_mistake("axiom: F\nF -> F[+F\n", "wrong.lsys:2:7: '[' is never closed");
  expect_mistake("axiom: F\nangel: 90\n", "wrong.lsys:2:1");
  expect_mistake("axiom: F\nF -> F\nF -> FF\n", "wrong.lsys:3:1");
  expect_mistake("axiom: A(1)\nA(x) -> A(y)\n", "wrong.lsys:2:11");
  expect_mistake("F -> FF\n", "wrong.lsys");
}

TEST_F(DeriveCommand, LeavesWhatWasThereWhenItCannotWrite) {
  write("kept/plant.obj", "old\n");
  {
    const SmallFilesOnly full(5'000);
    expect_refused({"derive", "tree.lsys", "--out", "kept/plant.obj"}, 3, "kept/plant");
  }
  EXPECT_EQ(read("kept/plant.obj"), "old\n");
  EXPECT_FALSE(exists("kept/plant.mtl"));
  EXPECT_EQ(run_on_full_disk({"derive", "island.lsys"}).code, 3);
}

TEST_F(DeriveCommand, StopsAtCtrlCAndLeavesNothing) {
  interrupt({"derive", "island.lsys", "--steps", "10"});  // a minute
  EXPECT_EQ(left_behind(), given_);
}

}  // namespace
}  // namespace phytobench
