// SPDX-License-Identifier: MIT
// `phytobench bench instructions` as a user runs it, and what else compares builds of two sides.
#include "cli/command_line_fixture.hpp"

namespace phytobench {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

class BenchInstructionsCommand : public CommandLine {};

const std::string build_folder = fs::path(PHYTOBENCH_PROGRAM).parent_path().string();

TEST_F(BenchInstructionsCommand, InstructionsOfTheSameBinaryNeedNoRun) {
  const auto json = json_of({"bench", "instructions", "--base", build_folder, "--json",
                             "--markdown", "summary.md", "--junit", "summary.xml"},
                            "phytobench/instructions-1");
  ASSERT_FALSE(json["benchmarks"].empty());
  for (const auto& benchmark : json["benchmarks"]) EXPECT_EQ(benchmark["verdict"], "same binary");
  EXPECT_THAT(read("summary.md"), HasSubstr("same binary"));
  EXPECT_THAT(read("summary.xml"), HasSubstr("failures=\"0\""));
}

TEST_F(BenchInstructionsCommand, InstructionsWithoutABaseIsNoPassUnlessAllowed) {
  write("old/phytobench", "");
  const Outcome refused = run({"bench", "instructions", "--base", "old"});
  EXPECT_EQ(refused.code, 4);
  EXPECT_THAT(refused.err, HasSubstr("nothing to compare with"));
  const Outcome allowed =
      run({"bench", "instructions", "--base", "old", "--allow-no-base", "--junit", "summary.xml"});
  EXPECT_EQ(allowed.code, 0) << allowed.err;
  EXPECT_THAT(allowed.out, HasSubstr("nothing to compare with"));
  EXPECT_THAT(read("summary.xml"), HasSubstr("skipped=\"1\""));
}

TEST_F(BenchInstructionsCommand, InstructionsRefusesWhatItCannotCompare) {
  EXPECT_EQ(run({"bench", "instructions", "--base", "no-such-thing", "--allow-no-base"}).code, 2);
  write("old.json", "{}");
  expect_refused_line("bench instructions --base old.json", "revisions and build folders only");
  write("accepted.toml", "[[accepted]]\nbenchmark = \"*\"\n");
  expect_refused({"bench", "instructions", "--base", build_folder, "--accepted", "accepted.toml"},
                 2, "accepted.toml:1: [[accepted]] has no percent");
}

class BenchInstructions : public CommandLine {
 protected:
  /// Of this build against itself.
  static Words with(const Words& more) {
    Words words = {"bench", "instructions", "--base", build_folder};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
};

TEST_F(BenchInstructions, FilesThatAreNotWhatTheyShouldBeAreRefused) {
  write("folder/file", "no history, and no table of TOML");
  expect_refused(with({"--accepted", "nowhere.toml"}), 2, "nowhere.toml: no such file");
  expect_refused(with({"--accepted", "folder"}), 2, "folder: is a folder");
  expect_refused(with({"--history", "nowhere.sqlite"}), 2, "nowhere.sqlite: no such file");
  expect_refused(with({"--history", "nowhere/h.sqlite"}), 2, "nowhere/h.sqlite: no such file");
  expect_refused(with({"--history", "folder"}), 2, "folder: is a folder");
  expect_refused(with({"--history", "folder/file"}), 2, "folder/file: is no SQLite file");
  expect_refused(with({"--junit", "folder"}), 2, "folder: is a folder");
  expect_refused(with({"--markdown", "folder/file/x.md"}), 3, "folder/file is no folder");
  EXPECT_EQ(left_behind(), (std::set<std::string>{"folder"}));
}

TEST_F(BenchInstructions, WithACacheItSaysWhereNoMissesWereCounted) {
  EXPECT_THAT(output_of(with({"--cache"})), HasSubstr("no misses were counted"));
  EXPECT_THAT(output_of(with({})), Not(HasSubstr("misses")));
}

class CompareBlocks : public CommandLine {
 protected:
  Outcome compare(const Words& more) const {
    Words words = {"compare", build_folder, build_folder, "--benchmarks", "tree/*"};
    words.insert(words.end(), more.begin(), more.end());
    return run(words);
  }
};

TEST_F(CompareBlocks, FewerThanAnythingIsConcludedOfAreRefused) {
  for (const char* option : {"--least-blocks", "--most-blocks"})
    for (const char* value : {"6", "7", "1001"}) {
      const Outcome outcome = compare({option, value});
      EXPECT_EQ(outcome.code, 2) << outcome.out;
      EXPECT_EQ(line_count(outcome.err), 1) << outcome.err;
      EXPECT_THAT(outcome.err, testing::AllOf(HasSubstr(option), HasSubstr(value), HasSubstr("8"),
                                              HasSubstr("1000")));
    }
}

TEST_F(CompareBlocks, TheMostAreNotLessThanTheLeast) {
  const Outcome outcome = compare({"--least-blocks", "20", "--most-blocks", "10"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("--most-blocks 10: is less than --least-blocks 20"));
  EXPECT_EQ(compare({"--least-blocks", "100"}).code, 0) << "the most follow the least";
}

}  // namespace
}  // namespace phytobench
