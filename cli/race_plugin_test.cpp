// SPDX-License-Identifier: MIT
// phytobench race nearest-node --plugin as the author of an engine meets it.
#include <map>

#include "cli/command_line_fixture.hpp"

namespace phytobench {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class RacePlugin : public CommandLine {
 protected:
  static std::string good() { return PHYTOBENCH_EXAMPLE_PLUGINS "/nearest_scan.so"; }
  static std::string faulty(const std::string& name) {
    return PHYTOBENCH_EXAMPLE_PLUGINS "/faulty/" + name + ".so";
  }

  /// One short race against an engine of the program.
  Outcome race(const std::string& plugins, const std::string& more = "", int points = 1500) const {
    return run_line("race nearest-node --engines node_driven --options dn --rounds 1 --plugin " +
                    plugins + " --points " + std::to_string(points) + more);
  }

  static json entry_of(const json& document, const std::string& file) {
    for (const json& entry : document["engines"])
      if (text_at(entry, "plugin") == file) return entry;
    ADD_FAILURE() << file << " has no entry";
    return {};
  }
};

TEST_F(RacePlugin, HasALaneBesideTheOthers) {
  const Outcome outcome = race(good(), " --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json document = json::parse(outcome.out);
  ASSERT_EQ(document["engines"].size(), 2u);
  const json &own = document["engines"][0], &plugin = document["engines"][1];
  EXPECT_FALSE(own.contains("plugin"));
  EXPECT_FALSE(own["distance_evaluations"].is_null());
  EXPECT_EQ(plugin["name"], "nearest_scan");
  EXPECT_EQ(plugin["plugin"], good());
  EXPECT_EQ(plugin["trial"]["verdict"], "exact");
  EXPECT_THAT(text_at(plugin["trial"], "detail"), HasSubstr("every answer"));
  EXPECT_EQ(plugin["state"], "timed");
  EXPECT_EQ(plugin["tree_hash"], own["tree_hash"]);
  EXPECT_GT(plugin["median_s"], 0.0);
  EXPECT_TRUE(plugin["distance_evaluations"].is_null()) << "nobody counts inside a plugin";
  EXPECT_EQ(document["ratios"].size(), 1u);
}

TEST_F(RacePlugin, ShowsItsVerdictAndItsRow) {
  const Outcome outcome = race(good());
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, testing::StartsWith("plugin " + good() + ": exact, every answer"));
  EXPECT_THAT(outcome.out, HasSubstr("\nnearest_scan dn "));
}

TEST_F(RacePlugin, GetsNoTimeUnlessItIsExact) {
  std::string files, separator;
  std::map<std::string, std::string> verdicts = {
      {"wrong", "wrong"}, {"crashing", "crashed"}, {"hanging", "hangs"}};
#ifndef __SANITIZE_ADDRESS__  // which does not tell what is allocated
  verdicts["leaking"] = "leaks";
#endif
  for (const auto& [name, verdict] : verdicts) {
    files += separator + faulty(name);
    separator = ",";
  }
  const Outcome outcome = race(files, " --plugin-limit 1 --json");
  EXPECT_EQ(outcome.code, 1);
  const json document = json::parse(outcome.out);
  EXPECT_EQ(document["engines"].size(), 1 + verdicts.size());
  EXPECT_EQ(document["engines"][0]["state"], "timed");
  for (const auto& [name, verdict] : verdicts) {
    const json entry = entry_of(document, faulty(name));
    EXPECT_EQ(entry["state"], "failed trial") << name;
    EXPECT_EQ(entry["trial"]["verdict"], verdict);
    EXPECT_TRUE(entry["median_s"].is_null()) << name;
  }
}

TEST_F(RacePlugin, SaysInItsRowWhyThereIsNoTime) {
  const Outcome outcome = race(faulty("crashing"));
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.out, testing::ContainsRegex("\ncrashing.so +no time, crashed: SIGSEGV in "
                                                  "associate\\(\\) in iteration 2\n"));
  EXPECT_THAT(outcome.out, HasSubstr("\nnode_driven dn ")) << "the others are raced all the same";
}

// They were right on small trees; the race of the others must come to its end.
TEST_F(RacePlugin, MayStillFailInTheRaceItself) {
  struct Case {
    const char* name;
    const char* verdict;
    const char* what;
    const char* detail;
  };
  for (const Case& late : {Case{"late_crash", "crashed", "crashed", "SIGSEGV in create()"},
                           Case{"dies_when_timed", "crashed", "crashed", "SIGSEGV in create()"},
                           Case{"changes_when_timed", "wrong", "answered wrongly",
                                "grew another tree while it was timed"}}) {
    SCOPED_TRACE(late.name);
    const Outcome outcome = race(faulty(late.name) + "," + good(), " --json", 6000);
    EXPECT_EQ(outcome.code, 1);
    EXPECT_EQ(line_count(outcome.err), 1) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(std::string(late.name) + ".so' " + late.what +
                                       " while it was raced: " + late.detail));
    EXPECT_THAT(outcome.err, HasSubstr("; the race is restarted without it"));
    const json document = json::parse(outcome.out);
    ASSERT_EQ(document["engines"].size(), 3u);
    EXPECT_EQ(document["engines"][0]["state"], "timed");
    EXPECT_EQ(entry_of(document, good())["state"], "timed");
    const json entry = entry_of(document, faulty(late.name));
    EXPECT_EQ(entry["state"], "failed race");
    EXPECT_EQ(entry["trial"]["verdict"], "exact");
    EXPECT_EQ(entry["race"]["verdict"], late.verdict);
    EXPECT_THAT(text_at(entry["race"], "detail"), HasSubstr(late.detail));
    EXPECT_THAT(text_at(entry["race"], "detail"), HasSubstr("the race was restarted without it"));
    EXPECT_TRUE(entry["median_s"].is_null());
  }
}

TEST_F(RacePlugin, SaysInItsRowThatTheRaceWasRestarted) {
  const Outcome outcome =
      race(faulty("dies_when_timed") + "," + faulty("changes_when_timed"), "", 6000);
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(line_count(outcome.err), 2) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("\nnode_driven dn "));
  EXPECT_THAT(outcome.out,
              testing::ContainsRegex("\ndies_when_timed.so +no time, crashed in the race: SIGSEGV "
                                     "in create\\(\\); the race was restarted without it\n"));
  EXPECT_THAT(outcome.out,
              testing::ContainsRegex("\nchanges_when_timed.so +no time, wrong in the race: grew "));
}

TEST_F(RacePlugin, MayStillAnswerNonsenseInTheRaceItself) {
  const Outcome outcome = race(faulty("late_failure"), "", 6000);
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.out, HasSubstr("create() failed: out of memory"));
  EXPECT_THAT(outcome.out, HasSubstr("\nnode_driven dn "));
}

TEST_F(RacePlugin, GetsNoTimeIfItChangesHowOthersRound) {
  const Outcome outcome = race(faulty("flushes_denormals"));
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.out, HasSubstr("changes the floating-point environment"));
  EXPECT_THAT(outcome.out, HasSubstr("\nnode_driven dn ")) << "the others are raced all the same";
}

// Ends of children must be seen whatever the caller does about its own.
TEST_F(RacePlugin, IsWaitedForEvenIfEndsOfChildrenAreIgnored) {
  const auto before = std::signal(SIGCHLD, SIG_IGN);
  const pid_t child = start({"race", "nearest-node", "--engines", "node_driven", "--options", "dn",
                             "--rounds", "1", "--points", "1500", "--plugin", good()},
                            folder(), folder() / "out", folder() / "err");
  std::signal(SIGCHLD, before);  // inherited by the program, but this process waits for it
  EXPECT_EQ(exit_code_of(child), 0);
}

TEST_F(RacePlugin, IsRefusedInOneLine) {
  const std::string common = "race nearest-node --engines node_driven --plugin ";
  expect_refused_line(common + "nothing.so", "plugin 'nothing.so': there is no such file");
  expect_refused_line(common + faulty("wrong_abi"), "version 2 of the interface");
  expect_refused_line(common + faulty("no_symbol"), "exports no function");
  expect_refused_line(common + file("text.so", "no library\n"), "cannot be loaded");
  expect_refused_line(common + good() + "," + good(), "both call their engine 'nearest_scan'");
  expect_refused_line(common + good() + " --plugin-limit 0", "plugin-limit");
}

}  // namespace
}  // namespace phytobench
