// SPDX-License-Identifier: MIT
// phytobench run where something is in its way, and what it says meanwhile.
#include <stdlib.h>

#include "cli/run_fixture.hpp"

namespace phytobench {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

TEST_F(RunCommand, TwoRunsDoNotShareAFolder) {
  const pid_t first = start_run(with(cheap_run, {"--out", "shared"}));
  ASSERT_NE(first, 0);
  wait_for_experiments("shared", 1, first);
  for (const Words& more : std::vector<Words>{{}, {"--resume"}})
    expect_refused(with(with(cheap_run, {"--out", "shared"}), more), 2,
                   "shared: another run is writing there");
  ::kill(first, SIGKILL);
  EXPECT_EQ(exit_code_of(first), -1) << "it had ended before";
  expect_refused(with(cheap_run, {"--out", "shared"}), 2, "shared: already holds records");
}

TEST_F(RunCommand, InterruptedItKeepsWhatIsFinishedAndSaysHowToGoOn) {
  const pid_t child = start_run(with(cheap_run, {"--out", "broken"}));
  ASSERT_NE(child, 0);
  wait_for_experiments("broken", 3, child);
  ::kill(child, SIGINT);
  ASSERT_EQ(exit_code_of(child), 130) << read("stderr");
  EXPECT_EQ(read("stdout"), "");
  EXPECT_EQ(line_count(read("stderr")), 1);
  EXPECT_THAT(read("stderr"), HasSubstr(" experiments are finished and kept, go on with the same "
                                        "command and --resume"));
  const std::size_t complete = complete_in("broken");
  EXPECT_GE(complete, 3u);
  EXPECT_THAT(output_of(with(cheap_run, {"--out", "broken", "--resume", "--dry-run"})),
              HasSubstr(std::to_string(complete) + " experiments are complete and skipped"));
}

TEST_F(RunCommand, ResumedItSaysWhatItSkips) {
  output_of({"run", "alsweis/growth-steps", "--tier", "smoke", "--out", "run"});
  EXPECT_THAT(output_of(with(short_run, {"--out", "run", "--resume"})),
              testing::StartsWith("1 experiments are complete and skipped; left: 3, about "));
}

TEST_F(RunCommand, SaysWhatItCost) {
  const std::string said = output_of(with(short_run, {"--out", "run"}));
  EXPECT_THAT(said, HasSubstr(" in all; slowest: "));
  EXPECT_THAT(said, HasSubstr("alsweis/growth-steps "));
  EXPECT_THAT(said, HasSubstr("4 experiments in run; next: phytobench report run\n"));
}

TEST_F(RunCommand, DryRunSaysWhatAResumedRunNeedNotDo) {
  output_of({"run", "alsweis/growth-steps", "--tier", "smoke", "--out", "run"});
  const std::string records = read("run/records.jsonl");
  const std::string plan = output_of(with(short_run, {"--out", "run", "--resume", "--dry-run"}));
  EXPECT_THAT(plan, testing::ContainsRegex("alsweis/growth-steps +complete"));
  EXPECT_THAT(plan, testing::ContainsRegex("alsweis/migration +about"));
  EXPECT_THAT(plan, HasSubstr("\n3 experiments, tier smoke"));
  EXPECT_EQ(read("run/records.jsonl"), records);
  expect_refused({"run", "--tier", "full", "--out", "run", "--resume", "--dry-run"}, 2,
                 "--tier smoke");
}

TEST_F(RunCommand, ShowsItsPlaceOnATerminal) {
  const int terminal = ::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK);
  if (terminal < 0 || ::grantpt(terminal) != 0 || ::unlockpt(terminal) != 0)
    GTEST_SKIP() << "this system has no pseudo-terminals";
  const fs::path name = ::ptsname(terminal);
  // A terminal that nobody holds open forgets what was written to it.
  const int held = ::open(name.c_str(), O_RDWR | O_NOCTTY);
  EXPECT_EQ(exit_code_of(with(short_run, {"--out", "run"}), folder(), stdout_file(), name), 0);
  std::string shown(4096, '\0');
  const ssize_t bytes = ::read(terminal, shown.data(), shown.size());
  shown.resize(bytes > 0 ? static_cast<std::size_t>(bytes) : 0);
  ::close(held);
  ::close(terminal);
  EXPECT_THAT(shown, testing::ContainsRegex(R"(\[1/4\] [0-9]+ s elapsed, about )"));
  EXPECT_THAT(shown, HasSubstr(" left: alsweis/"));
  EXPECT_TRUE(shown.ends_with("\r\x1b[K")) << "the line goes away";
}

TEST_F(RunCommand, FullDiskKeepsWhatIsFinished) {
  output_of(with(short_run, {"--out", "whole"}));
  for (const rlim_t bytes : {250u, 1000u, 2000u, 8000u, 20'000u}) {
    SCOPED_TRACE(bytes);
    const std::string run = "full-" + std::to_string(bytes);
    {
      const SmallFilesOnly little_room(bytes);
      expect_refused(with(short_run, {"--out", run}), 3, "cannot write " + run);
    }
    EXPECT_TRUE(half_written_in(run).empty());
    EXPECT_LT(complete_in(run), 4u);
    output_of(with(short_run, {"--out", run, "--resume"}));
    EXPECT_TRUE(read(fs::path(run) / "records.jsonl") == read("whole/records.jsonl"));
  }
}

TEST_F(RunCommand, RefusesWhereItCannotWrite) {
  write("regular", "a file\n");
  expect_refused(with(short_run, {"--out", "regular"}), 3, "regular");
  expect_refused(with(short_run, {"--out", "regular/run", "--resume"}), 3, "regular");
  expect_refused(with(short_run, {"--out", "/proc/run"}), 3, "/proc/run");
  fs::create_directories(folder() / "odd/records.jsonl");
  expect_refused(with(short_run, {"--out", "odd"}), 2, "odd: already holds records");
  expect_refused(with(short_run, {"--out", "odd", "--resume"}), 2, "records.jsonl: is a folder");
  write("odder/timings.jsonl/file", "");
  expect_refused(with(short_run, {"--out", "odder"}), 3, "odder/timings.jsonl");
  write("oddest/environment.json/file", "");
  expect_refused(with(short_run, {"--out", "oddest"}), 2, "environment.json: is a folder");
}

TEST_F(RunCommand, DamagedRunIsNeitherResumedNorJudged) {
  output_of(with(short_run, {"--out", "run"}));
  std::string records = read("run/records.jsonl");
  const std::size_t value = records.find("\"value\":") + 8;
  records[value] = records[value] == '1' ? '2' : '1';
  write("run/records.jsonl", records);
  expect_refused(with(short_run, {"--out", "run", "--resume"}), 2, "run/records.jsonl:");
  expect_refused({"report", "run"}, 2, "run/records.jsonl:");
  EXPECT_FALSE(exists("run/report"));
  EXPECT_EQ(read("run/records.jsonl"), records);
}

TEST_F(RunCommand, ForgedEnvironmentIsNotReported) {
  output_of(with(short_run, {"--out", "run"}));
  std::string environment = read("run/environment.json");
  environment.replace(environment.find("\"processor\": \"") + 14, 1, "Z");
  write("run/environment.json", environment);
  expect_refused({"report", "run"}, 2, "run/environment.json: was changed");
  EXPECT_FALSE(exists("run/report"));
}

TEST_F(RunCommand, OlderSchemaIsSaidToBeOne) {
  write("old/records.jsonl", R"({"schema":"phytobench/records-1","tier":"quick","seed":0})"
                             "\n");
  write("old/timings.jsonl", "");
  expect_refused({"report", "old"}, 2,
                 "old/records.jsonl:1: this run has the schema "
                 "phytobench/records-1 of another version");
  expect_refused(with(short_run, {"--out", "old", "--resume"}), 2, "run the experiments again");
}

}  // namespace
}  // namespace phytobench
