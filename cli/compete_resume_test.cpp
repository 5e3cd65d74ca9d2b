// SPDX-License-Identifier: MIT
// Runs of phytobench compete that end early: killed, interrupted, out of disk, and taken up again.
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include "cli/compete_fixture.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;

class CompeteResume : public CompeteCommand {};

const std::string many_frames = "lively.toml --steps 90 --frames 1 --frame-format svg ";

TEST_F(CompeteResume, KilledAndResumedItLeavesTheSameFiles) {
  const std::string options = many_frames + "--checkpoint 7 --every 2 ";
  expect_done(options + "--out whole");
  int kills = 0;
  const auto kill = [&](const std::string& more, const std::string& frame, int milliseconds) {
    const Outcome outcome = run_and_signal(SIGKILL, options + "--out broken" + more,
                                           "broken/frames/" + frame, milliseconds);
    kills += outcome.code == -1;
  };
  kill("", "00008.svg", 0);
  kill(" --resume", "00030.svg", 1);
  kill(" --resume", "00060.svg", 3);
  EXPECT_GT(kills, 0);
  expect_done(options + "--out broken --resume");
  expect_same_files("whole", "broken");
}

TEST_F(CompeteResume, FilesOfOthersStay) {
  for (const char* name : {"survey.csv.part1", "stand.json.part02", "notes.txt.part3"})
    write(std::string("mine/") + name, "mine");
  write("mine/steps.csv.part77", "half-written");
  expect_done("lively.toml --steps 3 --out mine");
  for (const char* name : {"survey.csv.part1", "stand.json.part02", "notes.txt.part3"})
    EXPECT_TRUE(exists(std::string("mine/") + name)) << name;
  EXPECT_FALSE(exists("mine/steps.csv.part77"));
}

TEST_F(CompeteResume, TwoRunsDoNotShareAFolder) {
  expect_done("lively.toml --steps 3 --checkpoint 1 --out shared");
  const int folder = ::open((this->folder() / "shared").c_str(), O_RDONLY | O_DIRECTORY);
  ASSERT_EQ(::flock(folder, LOCK_EX), 0);
  expect_refused_line("compete lively.toml --steps 9 --checkpoint 1 --out shared --resume",
                      "another run is writing there");
  ::close(folder);
  expect_done("lively.toml --steps 9 --checkpoint 1 --out shared --resume");
}

TEST_F(CompeteResume, InterruptedItSaysHowToGoOn) {
  const Outcome outcome =
      run_and_signal(SIGINT, many_frames + "--out broken", "broken/frames/00003.svg", 0);
  ASSERT_EQ(outcome.code, 130) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(line_count(outcome.err), 1) << outcome.err;
  EXPECT_THAT(outcome.err,
              HasSubstr("broken/checkpoint.bin, go on with the same command and --resume"));
  expect_done(many_frames + "--out broken --resume --threads 2");
  expect_done(many_frames + "--out whole");
  expect_same_files("whole", "broken");
}

TEST_F(CompeteResume, GoesOnToMoreSteps) {
  const std::string options =
      "lively.toml --frames 7 --frame-format svg --every 3 --checkpoint 10 ";
  expect_done(options + "--steps 24 --out longer");
  expect_done(options + "--steps 40 --out longer --resume");
  expect_done(options + "--steps 40 --out whole");
  expect_same_files("whole", "longer");
  const std::string steps = read("longer/steps.csv");
  expect_refused_line("compete " + options + "--steps 39 --out longer --resume",
                      "is at step 40, beyond the 39 steps");
  EXPECT_EQ(read("longer/steps.csv"), steps);
}

TEST_F(CompeteResume, RemovesWhatAKilledRunLeftHalfWritten) {
  expect_done("lively.toml --out run --checkpoint 10 --steps 20");
  write("run/stand.png.part123", "half");
  write("run/frames/00002.png.part9", "half");
  write("run/notes.part", "mine");
  expect_done("lively.toml --out run --checkpoint 10 --steps 20 --resume");
  EXPECT_FALSE(exists("run/stand.png.part123"));
  EXPECT_FALSE(exists("run/frames/00002.png.part9"));
  EXPECT_EQ(read("run/notes.part"), "mine");
}

TEST_F(CompeteResume, TouchesAnOlderRunOnlyToResumeIt) {
  expect_done("lively.toml --out run --checkpoint 10 --steps 20");
  const auto files = files_below("run");
  expect_refused_line("compete lively.toml --out run", "run: already holds checkpoint.bin");
  const std::string again = "compete lively.toml --out run --steps 30 --resume ";
  expect_refused_line(again + "--seed 5", "seed = 3, not 5");
  expect_refused_line(again + "--rule none", "competition.rule = combined, not none");
  expect_refused_line(again + "--every 2", "--every = 1, not 2");
  write("more.toml", lively + std::string("[[species]]\nname = \"tree\"\n"));
  expect_refused_line("compete more.toml --out run --resume", "species = annual, shrub, not");
  EXPECT_EQ(files_below("run"), files);

  std::string changed = read("run/steps.csv");
  changed[200] = '7';
  write("run/steps.csv", changed);
  expect_refused_line(again, "run/steps.csv: was changed");
  write("run/checkpoint.bin", read("run/checkpoint.bin").substr(0, 1000));
  expect_refused_line(again, "run/checkpoint.bin: is damaged");
}

TEST_F(CompeteResume, RefusesToResumeNothing) {
  expect_refused_line("compete lively.toml --resume", "--resume needs --out");
  expect_refused_line("compete lively.toml --out absent --resume", "start without --resume");
  expect_done("lively.toml --out run --steps 2");
  EXPECT_FALSE(exists("run/checkpoint.bin"));
  expect_refused_line("compete lively.toml --out run --resume", "that run is finished");
  write("mine/plants.csv", "x,y,radius,species\n1,9,0.1,shrub\n");
  expect_refused_line("compete lively.toml --plants mine/plants.csv --out mine",
                      "already holds plants.csv");
  EXPECT_EQ(left_behind(), (std::set<std::string>{"lively.toml", "mine", "run"}));
}

TEST_F(CompeteResume, AFullDiskLeavesNothingHalfWritten) {
  {
    const SmallFilesOnly no_room(1000);
    expect_refused({"compete", "lively.toml", "--out", "none"}, 3, "none/checkpoint.bin");
  }
  EXPECT_TRUE(files_below("none").empty());
  {
    const SmallFilesOnly little_room(30'000);  // no picture fits
    expect_refused({"compete", "lively.toml", "--out", "some"}, 3, "cannot write some/");
  }
  for (const auto& [name, content] : files_below("some")) {
    EXPECT_TRUE(name == "checkpoint.bin" || name == "parameters.toml" || name == "steps.csv")
        << name;
    EXPECT_EQ(content.find(".part"), std::string::npos);
  }
  expect_done("lively.toml --out some --resume");
  expect_done("lively.toml --out whole");
  expect_same_files("whole", "some");
}

}  // namespace
}  // namespace phytobench
