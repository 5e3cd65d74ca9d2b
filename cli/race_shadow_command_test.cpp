// SPDX-License-Identifier: MIT
// phytobench race shadow as a user meets it. Never asserts on a time.
#include "cli/command_line_fixture.hpp"

namespace phytobench {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

class RaceShadowCommand : public CommandLine {};

TEST_F(RaceShadowCommand, GivesOneVerifiedDocument) {
  const Outcome outcome =
      run_line("race shadow --size 90 --hours 7 --relief 900 --rounds 3 --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json document = json::parse(outcome.out);
  EXPECT_EQ(document["schema"], "phytobench/race-1");
  EXPECT_EQ(document["workload"]["vertex_hours"], 7 * 90 * 90);
  EXPECT_GT(document["workload"]["lit"], 0);
  EXPECT_EQ(document["workload"]["judge"], "exact traversal of every ray");
  ASSERT_EQ(document["engines"].size(), 7u);
  std::size_t exact = 0;
  for (const json& engine : document["engines"]) {
    EXPECT_EQ(engine["state"], "timed") << engine;
    EXPECT_EQ(engine["rounds"], 3);
    EXPECT_LE(engine["ci95_s"][0], engine["median_s"]);
    EXPECT_LE(engine["median_s"], engine["ci95_s"][1]);
    EXPECT_GT(engine["vertex_hours_per_second_and_thread"], 0.0);
    EXPECT_GT(engine["factor_over_printed_rate"], 0.0);
    EXPECT_TRUE(engine["peak_bytes"].is_number() || engine["peak_bytes"].is_null());
    EXPECT_EQ(engine["exact"].get<bool>(), engine["wrong_share"] == 0.0) << engine;
    exact += engine["exact"].get<bool>();
  }
  EXPECT_EQ(exact, 3u);
  EXPECT_EQ(document["ratios"].size(), 6u);
  EXPECT_TRUE(document["environment"].contains("command_line"));
}

TEST_F(RaceShadowCommand, RacesThreadsOnTheUsersTerrain) {
  std::string grid = "ncols 6\nnrows 5\nxllcorner 0\nyllcorner 0\ncellsize 10\nNODATA_value -9\n";
  for (int row = 0; row < 5; ++row) grid += "0 50 0 -9 0 7\n";
  const Outcome outcome = run_line(
      "race shadow --engines exact_traversal,max_pyramid --threads 1,2 --rounds 2 --json "
      "--terrain " +
      file("map.asc", grid));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json document = json::parse(outcome.out);
  EXPECT_EQ(document["workload"]["columns"], 6);
  EXPECT_EQ(document["workload"]["rows"], 5);
  ASSERT_EQ(document["engines"].size(), 4u);
  EXPECT_EQ(document["engines"][1]["threads"], 2);
  EXPECT_EQ(document["engines"][1]["samples"], document["engines"][0]["samples"]);
}

TEST_F(RaceShadowCommand, SaysWhatIsNotTimedAndWhy) {
  const std::string large = "race shadow --size 520 --hours 1 --rounds 1 ";
  const Outcome all = run_line(large);
  ASSERT_EQ(all.code, 0) << all.err;
  EXPECT_THAT(all.out, HasSubstr("printed_march               left out"));
  EXPECT_THAT(all.out, HasSubstr("exact/this, least, most"));
  EXPECT_THAT(all.out, HasSubstr("Of 1 round, with the least and the most"));
  const Outcome none = run_line(large + "--engines line_sweep,printed_march --budget 1e-6");
  ASSERT_EQ(none.code, 0) << none.err;
  EXPECT_THAT(none.out, HasSubstr("printed_march               skipped: predicted "));
  EXPECT_THAT(none.out, Not(HasSubstr("left out")));
}

TEST_F(RaceShadowCommand, RefusesWrongInput) {
  expect_refused_line("race shadow --engines max_piramid", "did you mean 'max_pyramid'");
  expect_refused_line("race shadow --size 1", "size");
  expect_refused_line("race shadow --hours 0", "hours");
  expect_refused_line("race shadow --terrain nowhere.asc", "nowhere.asc");
  expect_refused_line("race shadows", "did you mean 'shadow'");
}

}  // namespace
}  // namespace phytobench
