// SPDX-License-Identifier: MIT
// phytobench compare as a user meets it. Never asserts on what a timing says.
#include "cli/command_line_fixture.hpp"

namespace phytobench {
namespace {

using nlohmann::json;
using testing::AnyOf;
using testing::HasSubstr;
using testing::StartsWith;

class CompareCommand : public CommandLine {
 protected:
  /// The build that is tested: the folder of the program.
  const std::string build_ = std::filesystem::path(PHYTOBENCH_PROGRAM).parent_path().string();

  Words compare(const Words& more) const {
    Words arguments = {"compare", build_, build_};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }

  /// Of one benchmark, in as little time as it takes.
  Words quick(const Words& more) const {
    Words arguments = compare(
        {"--time-anyway", "--benchmarks", "tree/*", "--budget", "0.01", "--sample-ms", "0.1"});
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }

  void expect_refused_comparison(const Words& more, const std::string& part) const {
    expect_refused(compare(more), 2, part);
  }
};

TEST_F(CompareCommand, TimesNothingWhereBothSidesAreTheSameProgram) {
  const Outcome outcome = run(compare({"--benchmarks", "tree/*"}));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("same binary"));
  EXPECT_THAT(outcome.out, HasSubstr("--time-anyway"));
  EXPECT_THAT(outcome.out, StartsWith("base: " + build_));
}

TEST_F(CompareCommand, GivesOneDocumentWithEveryBlock) {
  const Outcome outcome = run(quick({"--json"}));
  EXPECT_THAT(outcome.code, AnyOf(0, 1)) << outcome.err;
  const json document = json::parse(outcome.out);
  EXPECT_EQ(document["schema"], "phytobench/comparison-1");
  EXPECT_EQ(document["base"]["kind"], "build");
  EXPECT_NE(document["base"]["flags"], "");
  EXPECT_EQ(document["same_program"], false);
  ASSERT_FALSE(document["benchmarks"].empty());
  for (const json& benchmark : document["benchmarks"]) {
    ASSERT_EQ(benchmark["objection"], "") << benchmark["name"];
    for (const char* blocks : {"blocks", "control_blocks"}) {
      ASSERT_FALSE(benchmark[blocks].empty());
      for (const json& block : benchmark[blocks]) {
        EXPECT_EQ(block["base_s"].size(), 2u);
        EXPECT_EQ(block["new_s"].size(), 2u);
        EXPECT_EQ(block["processes"].size(), 4u);
      }
    }
  }
}

TEST_F(CompareCommand, WritesAllDocumentsAtOnce) {
  std::filesystem::create_directories(folder() / "r");
  const Outcome outcome =
      run(quick({"--out", "r/c.json", "--markdown", "c.md", "--junit", "c.xml"}));
  EXPECT_THAT(outcome.code, AnyOf(0, 1)) << outcome.err;
  EXPECT_EQ(json::parse(read("r/c.json"))["schema"], "phytobench/comparison-1");
  EXPECT_THAT(read("c.md"), StartsWith("**phytobench compare: "));
  EXPECT_THAT(read("c.xml"), StartsWith("<?xml"));
  EXPECT_EQ(left_behind(), (std::set<std::string>{"c.md", "c.xml", "r"}));
}

TEST_F(CompareCommand, ExitsWith5UnderStrictWhereTooLittleWasMeasured) {
  const Outcome outcome = run(quick({"--strict"}));
  EXPECT_EQ(outcome.code, 5) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("inconclusive"));
}

TEST_F(CompareCommand, KeepsWhatItTimedBesideAStoredResult) {
  ASSERT_EQ(run_line("bench measure overlap/sweep --processes 9 --samples 1 --sample-ms 0.5 "
                     "--out before.json")
                .code,
            0);
  const Outcome outcome = run({"compare", "before.json", build_, "--benchmarks", "overlap/sweep",
                               "--samples", "2", "--sample-ms", "0.5", "--out", "c.json"});
  EXPECT_THAT(outcome.code, AnyOf(0, 1)) << outcome.err;
  const json results = json::parse(read("c.json"))["results"];
  EXPECT_TRUE(results["base"].is_null()) << "it is kept already";
  ASSERT_EQ(results["new"]["schema"], "phytobench/result-1");
  ASSERT_EQ(results["new"]["benchmarks"].size(), 1u);
  EXPECT_EQ(results["new"]["benchmarks"][0]["processes"].size(), 12u);
  EXPECT_EQ(results["new"]["benchmarks"][0]["processes"][0].size(), 2u);
  write("new.json", results["new"].dump());
  EXPECT_EQ(run_line("compare new.json new.json").code, 0) << "it is a side like any other";
}

TEST_F(CompareCommand, RefusesWhatIsNoSide) {
  const Outcome outcome = run_line("compare no-such-side HEAD");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("no-such-side"));
  EXPECT_EQ(line_count(outcome.err), 1);
  std::filesystem::create_directories(folder() / "empty");
  expect_refused({"compare", "empty", build_}, 2, "empty");
  write("broken.json", "{");
  expect_refused({"compare", "broken.json", build_}, 2, "broken.json");
}

TEST_F(CompareCommand, RefusesOptionsThatMakeNoSense) {
  expect_refused_comparison({"--tolerance", "0"}, "tolerance");
  expect_refused_comparison({"--tolerance", "-3"}, "tolerance");
  expect_refused_comparison({"--budget", "-1"}, "--budget");
  expect_refused_comparison({"--plugin-limit", "0"}, "--plugin-limit");
  expect_refused_comparison({"--benchmarks", "tree/nonesuch"}, "unknown benchmark");
  expect_refused(compare({"--benchmarks", "nonesuch*"}), 4, "nonesuch");
  expect_refused_comparison({"--out", "a", "--junit", "./a"}, "two documents");
  expect_refused_comparison({"--out", "."}, "folder");
  expect_refused_comparison({"--out", "typo/c.json"}, "there is no folder typo");
}

TEST_F(CompareCommand, ComparesStoredResultsAndSaysWhatTheyLack) {
  const std::string head =
      R"({"schema":"phytobench/result-1","origin":{"commit":"","compiler":""},)"
      R"("machine":{"processor":"p","logical_processors":2,"kernel":"k"},)"
      R"("seed":1,"benchmarks":[{"name":"a","inputs":"i","answer":"x",)"
      R"("processes":[)";
  std::string base, other;
  for (int i = 0; i < 20; ++i) {
    const std::string comma = i == 0 ? "" : ",";
    base += comma + "[" + std::to_string(1.0 + 0.001 * (i % 5)) + "]";
    other += comma + "[" + std::to_string(2.0 + 0.002 * (i % 5)) + "]";
  }
  write("base.json", head + base + "]}]}");
  write("other.json", head + other + "]}]}");
  const Outcome slower = run_line("compare base.json other.json");
  EXPECT_EQ(slower.code, 1) << slower.err;
  EXPECT_THAT(slower.out, HasSubstr("slower"));
  EXPECT_THAT(slower.out, HasSubstr("not timed in turns"));
  EXPECT_EQ(run_line("compare base.json base.json").code, 0);
  EXPECT_EQ(run_line("compare other.json base.json").code, 0) << "faster is no failure";
}

}  // namespace
}  // namespace phytobench
