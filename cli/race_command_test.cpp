// SPDX-License-Identifier: MIT
// phytobench race as a user meets it. Never asserts on a time.
#include <sstream>

#include "cli/command_line_fixture.hpp"

namespace phytobench {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

class RaceCommand : public CommandLine {
 protected:
  Outcome race(const std::string& arguments) const { return run_line("race " + arguments); }
  void expect_refused(const std::string& arguments, const std::string& part) const {
    expect_refused_line("race " + arguments, part);
  }
};

TEST_F(RaceCommand, GivesOneVerifiedDocument) {
  const Outcome outcome = race(
      "nearest-node --points 1500 --engines node_driven,squared_scan,voxel_grid --options S,DN "
      "--rounds 3 --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json document = json::parse(outcome.out);
  EXPECT_EQ(document["schema"], "phytobench/race-1");
  EXPECT_EQ(document["workload"]["points"], 1500);
  EXPECT_GT(document["workload"]["nodes"], 10);
  EXPECT_GT(document["workload"]["floor"]["association_pairs"], 0);
  ASSERT_EQ(document["engines"].size(), 6u);
  std::set<std::string> trees;
  for (const json& engine : document["engines"]) {
    EXPECT_TRUE(engine["built"]);
    EXPECT_EQ(engine["exact"], true);
    EXPECT_EQ(engine["threads"], 1);
    EXPECT_EQ(engine["rounds"], 3);
    EXPECT_LE(engine["ci95_s"][0], engine["median_s"]);
    EXPECT_LE(engine["median_s"], engine["ci95_s"][1]);
    EXPECT_GE(engine["evaluations_over_floor"], 1.0) << engine["name"];
    for (const char* phase : {"build_s", "search_s", "kill_s", "growth_s"})
      EXPECT_GE(engine["phases"][phase], 0.0) << engine["name"];
    trees.insert(engine["tree_hash"]);
  }
  EXPECT_EQ(trees.size(), 1u);
  ASSERT_EQ(document["ratios"].size(), 5u);
  for (const json& ratio : document["ratios"]) {
    EXPECT_LE(ratio["ci95"][0], ratio["ci95"][1]);
    EXPECT_EQ(ratio["rounds"], 3);
  }
}

TEST_F(RaceCommand, CallsTheRangeOfFewRoundsNoInterval) {
  const std::string few = race("hopkins --size 500 --rounds 5").out;
  EXPECT_THAT(few, HasSubstr("least"));
  EXPECT_THAT(few, HasSubstr("Of 5 rounds, with the least and the most"));
  EXPECT_THAT(few, Not(HasSubstr("95 %")));
  EXPECT_THAT(race("hopkins --size 500 --rounds 6").out, HasSubstr("95 % from"));
}

TEST_F(RaceCommand, SkipsWhatWouldTakeTooLongAndSaysHowLong) {
  const Outcome outcome = race(
      "nearest-node --points 6000 --engines euclidean_scan,node_driven --options s --rounds 3 "
      "--budget 1e-6 --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json document = json::parse(outcome.out);
  for (const json& engine : document["engines"]) {
    EXPECT_EQ(engine["state"], "skipped");
    EXPECT_GT(engine["predicted_s"], 1e-6);
    EXPECT_TRUE(engine["median_s"].is_null());
  }
}

// What only comes close is shown beside the race, never in it.
TEST_F(RaceCommand, KeepsApproximateEnginesInALaneOfTheirOwn) {
  const std::string common = "nearest-node --points 2000 --options dn --rounds 1 --json --engines ";
  const json plain = json::parse(race(common + "node_driven").out);
  EXPECT_TRUE(plain["approximate"].empty());
  const json document = json::parse(race(common + "node_driven,approximate").out);
  ASSERT_EQ(document["engines"].size(), 1u);
  EXPECT_TRUE(document["ratios"].empty()) << "one exact engine has nobody to be compared with";
  ASSERT_EQ(document["approximate"].size(), 3u);
  for (const json& engine : document["approximate"]) {
    EXPECT_EQ(engine["exact"], false);
    if (!engine["built"]) continue;
    EXPECT_GT(engine["median_s"], 0.0);
    EXPECT_GE(engine["tree_difference"], 0.0);
    EXPECT_LE(engine["tree_difference"], 1.0);
    EXPECT_LE(engine["wrong_answers"], 1.0);
  }
}

TEST_F(RaceCommand, RacesNumbersOfThreadsAgainstEachOther) {
  const Outcome outcome = race(
      "nearest-node --points 1500 --engines node_driven --options dn --threads 1,2 --rounds 3 "
      "--json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json document = json::parse(outcome.out);
  ASSERT_EQ(document["engines"].size(), 2u);
  EXPECT_EQ(document["engines"][0]["threads"], 1);
  EXPECT_EQ(document["engines"][1]["threads"], 2);
  EXPECT_EQ(document["engines"][0]["tree_hash"], document["engines"][1]["tree_hash"]);
  EXPECT_EQ(document["ratios"].size(), 1u);
}

TEST_F(RaceCommand, TakesTheUsersPoints) {
  std::string csv = "name,z,x,y\n";
  for (int i = 0; i < 400; ++i)
    csv += "p," + std::to_string(i % 7) + "," + std::to_string(i % 11) + "," +
           std::to_string(i % 13) + "\n";
  const Outcome outcome = race(
      "nearest-node --engines squared_scan,node_driven --options s,d,n,dn "
      "--rounds 3 --json --cloud " +
      file("points.csv", csv));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json document = json::parse(outcome.out);
  EXPECT_EQ(document["workload"]["points"], 400);
  for (const json& engine : document["engines"]) EXPECT_EQ(engine["exact"], true);
}

TEST_F(RaceCommand, ComparesWaysToTheHopkinsIndex) {
  for (const char* pattern : {"random", "clustered"}) {
    const Outcome outcome = race(std::string("hopkins --size 4000 --rounds 2 --threads 2 --json ") +
                                 "--pattern " + pattern);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const json document = json::parse(outcome.out);
    EXPECT_EQ(document["schema"], "phytobench/race-1");
    ASSERT_EQ(document["engines"].size(), 4u);
    EXPECT_EQ(document["engines"][0]["exact"], true);
    EXPECT_EQ(document["engines"][0]["mean_ratio"], document["engines"][1]["mean_ratio"]);
  }
  EXPECT_THAT(race("hopkins --size 3000 --rounds 1").out, HasSubstr("sampled, cell grid"));
}

TEST_F(RaceCommand, RefusesWrongInput) {
  expect_refused("hopkins --pattern odd", "unknown pattern");
  expect_refused("hopkins --size 1", "size");
  expect_refused("farthest-node", "cannot race");
  expect_refused("nearest-nod", "did you mean");
  expect_refused("nearest-node --engines voxel_grit", "unknown engine");
  expect_refused("nearest-node --options x", "unknown loop option");
  expect_refused("nearest-node --points 0", "points");
  expect_refused("nearest-node --points nan", "points");
  expect_refused("nearest-node --seed 1099511627776", "--seed");
  expect_refused("nearest-node --threads 1,0", "threads");
  expect_refused("nearest-node --cloud " + file("e.csv", "x,y,z\n0,0,0\n0,1e-95,0\n"),
                 "smaller unit");
  expect_refused("nearest-node --threads 0", "threads");
  expect_refused("nearest-node --budget -1", "budget");
  expect_refused("nearest-node --cloud " + (folder() / "nothing.csv").string(), "nothing.csv");
  expect_refused("nearest-node --cloud " + file("a.csv", "x,y\n1,2\n"), "a.csv:1: no column 'z'");
  expect_refused("nearest-node --cloud " + file("b.csv", "x,y,z\n1,2,nan\n"), "b.csv:2: z = 'nan'");
  expect_refused("nearest-node --cloud " + file("c.csv", "x,y,z\n1,2\n"), "c.csv:2: 2 fields");
  expect_refused("nearest-node --cloud " + file("d.csv", "x,y,z\n1,2,1e200\n"), "beyond");
}

}  // namespace
}  // namespace phytobench
