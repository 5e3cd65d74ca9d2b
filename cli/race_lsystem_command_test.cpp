// SPDX-License-Identifier: MIT
// phytobench race lsystem as a user meets it. Never asserts on a time.
#include "cli/command_line_fixture.hpp"

namespace phytobench {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class RaceLSystemCommand : public CommandLine {
 protected:
  Outcome race(const std::string& arguments) const { return run_line("race lsystem " + arguments); }
  void expect_refused(const std::string& arguments, const std::string& part) const {
    expect_refused_line("race lsystem " + arguments, part);
  }
};

TEST_F(RaceLSystemCommand, GivesOneVerifiedDocument) {
  const Outcome outcome = race(
      "--systems koch_island,plant --segments 3000 --modules 20000 --threads 1,2 --rounds 3 "
      "--json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json document = json::parse(outcome.out);
  EXPECT_EQ(document["schema"], "phytobench/race-1");
  const json& systems = document["workload"]["systems"];
  ASSERT_EQ(systems.size(), 2u);
  EXPECT_EQ(systems[0]["segments"], 2048);
  EXPECT_EQ(systems[0]["bound"], 0.0);
  std::set<std::string> names;
  for (const json& engine : document["engines"]) {
    EXPECT_EQ(engine["exact"], true) << engine;
    EXPECT_EQ(engine["rounds"], 3);
    EXPECT_GT(engine["segments_per_s"], 0.0);
    EXPECT_LE(engine["ci95_s"][0], engine["median_s"]);
    EXPECT_LE(engine["median_s"], engine["ci95_s"][1]);
    names.insert(text_at(engine, "name") + " " + text_at(engine, "lane"));
  }
  EXPECT_EQ(names.size(), 6u);
  // Per system: two of string_rewriting, four of module_by_module, three of memoised.
  EXPECT_EQ(document["engines"].size(), 18u);
  EXPECT_EQ(document["ratios"].size(), 14u);
  EXPECT_EQ(document["means"].size(), 9u);
  // The tree is too large for so few modules: bush and plant, twice each, and the row.
  ASSERT_EQ(document["derivations"].size(), 10u);
  for (const json& derivation : document["derivations"]) EXPECT_EQ(derivation["exact"], true);
}

TEST_F(RaceLSystemCommand, RacesWhatOthersHaveTimed) {
  const Outcome outcome =
      race("--systems published --segments 5000 --modules 0 --engines memoised --rounds 2 --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json document = json::parse(outcome.out);
  std::set<std::string> names;
  for (const json& system : document["workload"]["systems"]) names.insert(text_at(system, "name"));
  EXPECT_EQ(names.size(), 7u);
  EXPECT_TRUE(names.count("pentaplexity"));
}

TEST_F(RaceLSystemCommand, ShowsTables) {
  const std::string shown = race("--systems bush --segments 1000 --modules 3000 --rounds 2").out;
  EXPECT_THAT(shown, HasSubstr("bush: 4 derivations, 625 segments"));
  EXPECT_THAT(shown, HasSubstr("memoised"));
  EXPECT_THAT(shown, HasSubstr("derivation alone"));
  EXPECT_THAT(shown, HasSubstr("Of 2 rounds, with the least and the most"));
}

TEST_F(RaceLSystemCommand, TakesYourOwnSystem) {
  const std::string own = file("own.lsys", "axiom: F\nF -> F[/&F]F\nangle: 30\n");
  const Outcome outcome =
      race("--systems " + own + " --segments 500 --modules 0 --engines memoised --rounds 2 --json");
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const json document = json::parse(outcome.out);
  EXPECT_EQ(document["workload"]["systems"][0]["segments"], 243);
  EXPECT_EQ(document["workload"]["systems"][0]["planar"], false);
  EXPECT_TRUE(document["derivations"].empty());
}

TEST_F(RaceLSystemCommand, RefusesWrongInput) {
  expect_refused("--segments nan", "--segments");
  expect_refused("--modules nan", "--modules");
  expect_refused("--systems koch_iland", "did you mean 'koch_island'");
  expect_refused("--engines memoized", "did you mean 'memoised'");
  expect_refused("--segments 0", "segments");
  expect_refused("--systems koch_island --segments 2", "draws nothing, or more than");
  expect_refused("--rounds 0", "rounds");
  expect_refused("--threads 0", "threads");
  expect_refused("--systems " + file("p.lsys", "axiom: A(1)\nA(x) -> F(x)A(x + 1)\n"),
                 "has parameters");
  expect_refused("--systems " + file("b.lsys", "axiom: F[\n"), "b.lsys:1");
}

}  // namespace
}  // namespace phytobench
