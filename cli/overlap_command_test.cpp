// SPDX-License-Identifier: MIT
// phytobench overlap and race overlap as a user meets them. Never asserts on a time.
#include <cmath>
#include <numbers>
#include <sstream>

#include "cli/command_line_fixture.hpp"

namespace phytobench {
namespace {

using nlohmann::json;
using testing::HasSubstr;

constexpr double pi = std::numbers::pi;

class OverlapCommand : public CommandLine {
 protected:
  json document(const std::string& arguments) const {
    const Outcome outcome = run_line("overlap --json " + arguments);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return json::parse(outcome.out);
  }
};

TEST_F(OverlapCommand, GivesPairsPlantsAndCoveredGround) {
  const json d = document(file("two.csv", "x,y,r\n0,0,1\n1,0,1.4142135623730951\n9,9,0\n"));
  EXPECT_EQ(d["schema"], "phytobench/overlap-1");
  ASSERT_EQ(d["pairs"].size(), 1u);
  EXPECT_EQ(d["pairs"][0]["i"], 0);
  EXPECT_EQ(d["pairs"][0]["j"], 1);
  EXPECT_NEAR(d["pairs"][0]["area"].get<double>(), pi - 1, 1e-14);
  ASSERT_EQ(d["plants"].size(), 3u);
  EXPECT_NEAR(d["plants"][1]["area"].get<double>(), 2 * pi, 1e-14);
  EXPECT_NEAR(d["plants"][0]["overlap_sum"].get<double>(), pi - 1, 1e-14);
  EXPECT_NEAR(d["plants"][0]["covered"].get<double>(), pi - 1, 1e-14);
  EXPECT_EQ(d["plants"][2]["covered"], 0.0);
  ASSERT_EQ(d["covered"].size(), 2u);
  EXPECT_EQ(d["covered"][0]["times"], 1);
  EXPECT_NEAR(d["covered"][1]["area"].get<double>(), pi - 1, 1e-14);
  EXPECT_TRUE(d["window"].is_null());
}

TEST_F(OverlapCommand, TakesRadiiFromAnyColumn) {
  const std::string stand = file("stand.csv", "x,y,radius,root_radius\n0,0,0.1,1\n1,0,0.1,1\n");
  EXPECT_EQ(document(stand + " --radius root_radius")["pairs"].size(), 1u);
  EXPECT_EQ(document(stand + " --radius radius")["pairs"].size(), 0u);
  EXPECT_EQ(run_line("overlap " + stand + " --radius crown").code, 2);
}

// As compete and terrain write tables of plants.
TEST_F(OverlapCommand, TakesAColumnCalledRadiusWhereThereIsNoR) {
  const std::string plants = file("plants.csv", "x,y,radius\n0,0,1\n1,0,1\n");
  const json d = document(plants);
  EXPECT_EQ(d["pairs"].size(), 1u);
  EXPECT_EQ(d["radius_column"], "radius");
  EXPECT_THAT(output_of({"overlap", plants}),
              HasSubstr("2 discs, radii in column radius, open plane"));
  const json both = document(file("both.csv", "x,y,radius,r\n0,0,1,0.2\n1,0,1,0.2\n"));
  EXPECT_TRUE(both["pairs"].empty());
  EXPECT_EQ(both["radius_column"], "r");
  // Only where nothing is asked for.
  expect_refused_line("overlap " + plants + " --radius r", "no column 'r'");
  expect_refused_line("overlap " + file("none.csv", "x,y,crown\n0,0,1\n"), "no column 'r'");
  EXPECT_EQ(run_line("race overlap --engines sweep --rounds 2 --discs " + plants).code, 0);
}

TEST_F(OverlapCommand, CountsBareGroundInAWindowAndJoinsItsSides) {
  const std::string discs = file("b.csv", "r,x,y\n1,0.5,5\n1,9.5,5\n");
  const json open = document(discs + " --window 0,0,10,10");
  EXPECT_TRUE(open["pairs"].empty());
  EXPECT_EQ(open["covered"][0]["times"], 0);
  const json torus = document(discs + " --window 0,0,10,10 --torus");
  ASSERT_EQ(torus["pairs"].size(), 1u);
  EXPECT_NEAR(torus["covered"][0]["area"].get<double>(),
              100 - 2 * pi + torus["pairs"][0]["area"].get<double>(), 1e-12);
}

TEST_F(OverlapCommand, SameBytesForAnyEngineAndNumberOfThreads) {
  std::string csv = "x,y,r\n";
  for (int i = 0; i < 700; ++i)
    csv += std::to_string(i % 31 + 0.01 * (i % 7)) + "," + std::to_string(i % 29) + "," +
           std::to_string(0.3 + 0.02 * (i % 50)) + "\n";
  const std::string discs = file("c.csv", csv) + " --window 0,0,32,30 --torus --json";
  const std::string first = run_line("overlap " + discs).out;
  EXPECT_GT(first.size(), 10'000u);
  EXPECT_EQ(run_line("overlap --threads 3 " + discs).out, first);
  std::string other = run_line("overlap --engine sweep " + discs).out;
  const auto at = other.find("\"sweep\"");
  ASSERT_NE(at, std::string::npos);
  EXPECT_EQ(other.replace(at, 7, "\"layered_grid\""), first);
}

TEST_F(OverlapCommand, TableSaysWhatTheDocumentSays) {
  const Outcome outcome = run_line("overlap " + file("d.csv", "x,y,r\n0,0,1\n0.1,0,5\n0.2,0,5\n"));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("overlapping pairs"));
  EXPECT_THAT(outcome.out, HasSubstr("times covered"));
  EXPECT_THAT(outcome.out, HasSubstr("100.00%"));
}

TEST_F(OverlapCommand, TakesOddFilesThatHaveAnAnswer) {
  EXPECT_TRUE(document(file("one.csv", "\xef\xbb\xbfx,y,r\r\n1,2,3\r\n"))["pairs"].empty());
  std::string same = "x,y,r\n";
  for (int i = 0; i < 50; ++i) same += "4,4,2\n";
  const json d = document(file("same.csv", same));
  EXPECT_EQ(d["pairs"].size(), 1225u);
  EXPECT_NEAR(d["covered"].back()["area"].get<double>(), 4 * pi, 1e-12);
}

TEST_F(OverlapCommand, RefusesWrongInput) {
  const auto with = [&](const char* text) { return "overlap " + file("w.csv", text); };
  expect_refused_line("overlap", "discs");
  expect_refused_line("overlap " + (folder() / "no.csv").string(), "no such file");
  expect_refused_line(with(""), "w.csv: is empty");
  expect_refused_line(with("x,y\n1,2\n"), "w.csv:1: no column 'r'");
  expect_refused_line(with("x,y,r\n1,2,three\n"), "w.csv:2: r = 'three'");
  expect_refused_line(with("x,y,r\n1,nan,3\n"), "w.csv:2: y = 'nan'");
  expect_refused_line(with("x,y,r\n1,2,3\n\n1,2,-3\n"), "w.csv:4: radius -3 is negative");
  expect_refused_line(with("x,y,r\n1e80,2,3\n"), "w.csv:2: center");
  const std::string good = with("x,y,r\n1,2,3\n");
  expect_refused_line(good + " --torus", "--torus needs --window");
  expect_refused_line(good + " --torus --window 0,0,5,5", "w.csv:2: diameter 6");
  expect_refused_line(good + " --torus --window 2,0,50,50", "w.csv:2: center (1, 2) lies outside");
  for (const char* window : {"0,0,1", "0,0,1,nan", "1,0,0,1", "0,0,1,1,2", "a", "0,0,0,1"})
    expect_refused_line(good + " --window " + window, "--window");
  expect_refused_line(good + " --engine cell_grit", "unknown engine");
  expect_refused_line(good + " --most-pairs 0", "most-pairs");
  expect_refused_line(with("x,y,r\n1,2,3\n1,2,3\n1,2,3\n") + " --most-pairs 2",
                      "more than 2 pairs");
}

TEST_F(OverlapCommand, RacesEngines) {
  const Outcome outcome =
      run_line("race overlap --size 3000 --sizes uniform --torus --rounds 3 --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json d = json::parse(outcome.out);
  EXPECT_EQ(d["schema"], "phytobench/race-1");
  EXPECT_EQ(d["workload"]["discs"], 3000);
  ASSERT_GE(d["engines"].size(), 8u);
  for (const json& engine : d["engines"]) {
    if (engine["built"] == false) continue;
    EXPECT_EQ(engine["exact"], true) << engine.dump();
    EXPECT_GT(engine["median_s"].get<double>(), 0.0);
    EXPECT_GE(engine["distance_evaluations"], d["workload"]["pairs"]);
  }
  EXPECT_EQ(d["lens"].size(), 3u);
  const Outcome own = run_line("race overlap --engines layered_grid,sweep --rounds 3 --discs " +
                               file("own.csv", "x,y,r\n1,2,3\n2,3,4\n"));
  EXPECT_EQ(own.code, 0) << own.err;
  EXPECT_THAT(own.out, HasSubstr("1 overlapping pairs"));
}

TEST_F(OverlapCommand, RaceSaysOnceAndLastWhatFewRoundsHaveInsteadOfIntervals) {
  const std::string discs = file("few.csv", "x,y,r\n1,2,3\n2,3,4\n");
  const auto race = [&](const std::string& rounds) {
    return run_line("race overlap --engines sweep --discs " + discs + " --rounds " + rounds).out;
  };
  const std::string few = race("5");
  const auto note = few.find("\nOf 5 rounds, with the least and the most");
  ASSERT_NE(note, std::string::npos) << few;
  EXPECT_EQ(few.rfind("Of 5 rounds"), note + 1);
  EXPECT_EQ(few.find("areas alone", note), std::string::npos) << "below all tables:\n" << few;
  EXPECT_NE(few.find("areas alone"), std::string::npos);
  EXPECT_EQ(race("6").find("with the least"), std::string::npos);
}

TEST_F(OverlapCommand, RaceTakesSizesWorldsApart) {
  const Outcome outcome =
      run_line("race overlap --engines layered_grid,sweep --rounds 2 --discs " +
               file("rim.csv", "x,y,r\n0,0,1e7\n1e7,0,0.5\n0,1e7,1\n1e7,0.3,0.4\n"));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
}

TEST_F(OverlapCommand, RaceRefusesWrongInput) {
  expect_refused_line("race overlap --window 0,0,1,1", "--window says");
  expect_refused_line("race", "cannot race");
  expect_refused_line("race overlapp", "did you mean 'overlap'");
  expect_refused_line("race overlap --sizes huge", "unknown sizes");
  expect_refused_line("race overlap --engines grid", "unknown engine");
  expect_refused_line("race overlap --size 0", "size");
  expect_refused_line("race overlap --torus --discs " + file("t.csv", "x,y,r\n1,2,3\n"),
                      "--window");
}

}  // namespace
}  // namespace phytobench
