// SPDX-License-Identifier: MIT
#include "core/record/run_writer.hpp"

#include "core/record/run_folder_fixture.hpp"

namespace phytobench {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

class RunWriting : public RunFolder {};

TEST_F(RunWriting, StartsWithSchemaTierAndSeed) {
  start();
  EXPECT_THAT(read_text_file(records_file()),
              StartsWith(R"({"schema":"phytobench/records-2","tier":"quick","seed":7,"sha256":")"));
  EXPECT_THAT(read_text_file(timings_file()),
              StartsWith(R"({"schema":"phytobench/timings-2","sha256":")"));
  const RunContents run = read_run(folder_);
  EXPECT_EQ(run.header, quick_seven);
  EXPECT_TRUE(run.records.empty());
  EXPECT_TRUE(run.complete_experiments.empty());
}

TEST_F(RunWriting, KnowsWhichExperimentsAreComplete) {
  {
    RunWriter writer = start();
    EXPECT_FALSE(writer.is_complete("p/one"));
    append_to(writer, "p/one");
    EXPECT_TRUE(writer.is_complete("p/one"));
    EXPECT_FALSE(writer.is_complete("p/two"));
  }
  const RunWriter resumed = resume();
  EXPECT_TRUE(resumed.is_complete("p/one"));
  EXPECT_FALSE(resumed.is_complete("p/two"));
}

TEST_F(RunWriting, FreshRunOverRecordsIsAnInputError) {
  start();
  const std::string before = read_text_file(records_file());
  EXPECT_THAT(input_error([this] { start(); }), StartsWith(folder_.string() + ": already holds"));
  EXPECT_EQ(read_text_file(records_file()), before);
}

TEST_F(RunWriting, FreshRunMayUseAFolderWithoutRecords) {
  write_file_atomically(folder_ / "notes.txt", "kept");
  write_file_atomically(environment_file(), "of a run whose records are gone");
  RunWriter writer = start();
  append_to(writer, "p/one");
  EXPECT_EQ(read_text_file(folder_ / "notes.txt"), "kept");
  EXPECT_EQ(read_run(folder_).header, quick_seven);
  EXPECT_FALSE(fs::exists(environment_file()));
}

TEST_F(RunWriting, RestOfARunWhoseRecordsAreGoneIsAnInputErrorAndStays) {
  write_run({"p/one"});
  write_file_atomically(environment_file(), "{}");
  const std::string timings = read_text_file(timings_file());
  fs::rename(records_file(), base_ / "aside");
  const auto expect_refused = [this](const std::string& found) {
    for (const RunMode mode : {RunMode::fresh, RunMode::resume})
      EXPECT_THAT(input_error([&] { RunWriter(folder_, quick_seven, mode); }),
                  StartsWith(folder_.string() + ": holds " + found +
                             " of a run but no records.jsonl; put that back"));
    EXPECT_FALSE(fs::exists(records_file()));
    EXPECT_TRUE(fs::exists(environment_file()));
  };
  expect_refused("timings.jsonl");
  EXPECT_EQ(read_text_file(timings_file()), timings);
  fs::remove(timings_file());
  write_file_atomically(folder_ / "artifacts" / "p" / "one" / "tree.svg", "<svg/>");
  expect_refused("artifacts");
  EXPECT_FALSE(fs::exists(timings_file()));
}

TEST_F(RunWriting, WhatARunLeavesThatIsKilledAtItsStartDoesNotHinderTheNext) {
  start();
  fs::remove(records_file());  // which is written last
  make_folder(folder_ / "artifacts");
  EXPECT_EQ(input_error([this] { start(); }), "no error");
  fs::remove(records_file());
  EXPECT_EQ(input_error([this] { resume(); }), "no error");
  EXPECT_EQ(read_run(folder_).header, quick_seven);
}

TEST_F(RunWriting, ResumeOfNothingStartsAFreshRun) {
  resume();
  EXPECT_EQ(read_run(folder_).header, quick_seven);
}

TEST_F(RunWriting, ResumeWithAnotherSeedOrTierIsAnInputError) {
  write_run({"p/one"});
  const std::string before = read_text_file(records_file());
  for (const RunHeader& other : {RunHeader{Tier::quick, 8}, RunHeader{Tier::full, 7}}) {
    const auto resume_other = [&] { RunWriter(folder_, other, RunMode::resume); };
    EXPECT_THAT(input_error(resume_other), HasSubstr("--tier quick --seed 7"));
  }
  EXPECT_EQ(read_text_file(records_file()), before);
}

TEST_F(RunWriting, TwoWritersDoNotShareAFolder) {
  RunWriter writer = start();
  for (const RunMode mode : {RunMode::fresh, RunMode::resume})
    EXPECT_THAT(input_error([&] { RunWriter(folder_, quick_seven, mode); }),
                StartsWith(folder_.string() + ": another run is writing there"));
  append_to(writer, "p/one");
  EXPECT_EQ(read_run(folder_).complete_experiments.size(), 1u);
}

TEST_F(RunWriting, RunBelowAFileIsAnEnvironmentError) {
  write_file_atomically(base_ / "file", "kept");
  EXPECT_THROW(RunWriter(base_ / "file", quick_seven, RunMode::fresh), EnvironmentError);
  EXPECT_THROW(RunWriter(base_ / "file" / "run", quick_seven, RunMode::fresh), EnvironmentError);
  EXPECT_EQ(read_text_file(base_ / "file"), "kept");
}

TEST_F(RunWriting, FolderInThePlaceOfRecordsIsAnInputErrorAndStays) {
  make_folder(records_file());
  EXPECT_THAT(input_error([this] { start(); }), HasSubstr("already holds records"));
  EXPECT_THAT(input_error([this] { resume(); }),
              StartsWith(records_file().string() + ": is a folder"));
  EXPECT_TRUE(fs::is_directory(records_file()));
}

TEST_F(RunWriting, AppendToAVanishedFolderIsAnEnvironmentError) {
  RunWriter writer = start();
  fs::remove_all(folder_);
  EXPECT_THROW(append_to(writer, "p/one"), EnvironmentError);
  EXPECT_FALSE(writer.is_complete("p/one"));
}

TEST_F(RunWriting, AppendThatFailsLeavesBothFilesAsTheyWere) {
  RunWriter writer = start();
  append_to(writer, "p/one");
  const std::string timings = read_text_file(timings_file());
  const std::string records = read_text_file(records_file());
  fs::rename(records_file(), folder_ / "aside");
  make_folder(records_file());  // nothing can be appended to that
  EXPECT_THROW(append_to(writer, "p/two"), EnvironmentError);
  EXPECT_FALSE(writer.is_complete("p/two"));
  EXPECT_EQ(read_text_file(timings_file()), timings);
  fs::remove(records_file());
  fs::rename(folder_ / "aside", records_file());
  EXPECT_EQ(read_text_file(records_file()), records);
  append_to(writer, "p/two");
  EXPECT_EQ(read_run(folder_).complete_experiments.size(), 2u);
}

TEST_F(RunWriting, EnvironmentStaysUntilTheTimingsKnowTheNextOne) {
  RunWriter writer = start();
  writer.write_environment("first");
  append_to(writer, "p/one");
  fs::rename(timings_file(), folder_ / "aside");
  make_folder(timings_file());  // nothing can be appended to that
  EXPECT_THROW(writer.write_environment("second"), EnvironmentError);
  fs::remove(timings_file());
  fs::rename(folder_ / "aside", timings_file());
  EXPECT_EQ(read_environment(folder_), "first");
  EXPECT_EQ(complaint(), "no error");
}

TEST_F(RunWriting, MeasurementRecordedTwiceIsABug) {
  RunWriter writer = start();
  const std::vector<Record> twice{record_of("p/one", "a", 1.0), record_of("p/one", "a", 2.0)};
  EXPECT_THROW(writer.append("p/one", twice, {}), ContractViolation);
  append_to(writer, "p/one");
  EXPECT_THROW(append_to(writer, "p/one"), ContractViolation);
  EXPECT_EQ(read_run(folder_).records.size(), 3u);
}

TEST_F(RunWriting, ResumeDropsTheHalfWrittenExperimentFromTheFiles) {
  write_run({"p/one"});
  const std::string records = read_text_file(records_file());
  const std::string timings = read_text_file(timings_file());
  append_text(timings_file(), timing_line("p/two", 0.5));
  append_text(records_file(), record_line("p/two", "count") + R"({"experiment":"p/two","compl)");
  const RunWriter resumed = resume();
  EXPECT_EQ(read_text_file(records_file()), records);
  EXPECT_EQ(read_text_file(timings_file()), timings);
  EXPECT_TRUE(resumed.is_complete("p/one"));
  EXPECT_FALSE(resumed.is_complete("p/two"));
}

TEST_F(RunWriting, ResumeOfADamagedRunIsAnInputErrorAndLeavesItAlone) {
  write_run({"p/one", "p/two"});
  std::string records = read_text_file(records_file());
  records[records.find("0.1")] = '7';
  overwrite(records_file(), records);
  append_text(timings_file(), timing_line("p/three", 0.5));
  const std::string timings = read_text_file(timings_file());
  EXPECT_THAT(input_error([this] { resume(); }), StartsWith(records_file().string() + ":5: "));
  EXPECT_EQ(read_text_file(records_file()), records);
  EXPECT_EQ(read_text_file(timings_file()), timings);
}

TEST_F(RunWriting, RemovesItsOwnLeftoversOnly) {
  start();
  for (const char* name : {"records.jsonl.part1", "timings.jsonl.part23", "environment.json.part4",
                           "artifacts/p/one/tree.svg.part5", "mine.txt.part6", "notes.part"})
    write_file_atomically(folder_ / name, "half-wri");
  resume();
  for (const char* gone : {"records.jsonl.part1", "timings.jsonl.part23", "environment.json.part4",
                           "artifacts/p/one/tree.svg.part5"})
    EXPECT_FALSE(fs::exists(folder_ / gone)) << gone;
  for (const char* kept : {"mine.txt.part6", "notes.part"})
    EXPECT_TRUE(fs::exists(folder_ / kept)) << kept;
}

TEST_F(RunWriting, ArtifactsLieBelowTheirExperiment) {
  RunWriter writer = start();
  EXPECT_EQ(writer.folder(), folder_);
  writer.write_artifact("p/one", "tree.svg", "<svg/>");
  EXPECT_EQ(read_text_file(folder_ / "artifacts" / "p" / "one" / "tree.svg"), "<svg/>");
}

class RunWriterLaw : public RunFolder {};

TEST_F(RunWriterLaw, SameRecordsGiveTheSameBytes) {
  const fs::path other = base_ / "other";
  for (const fs::path& folder : {folder_, other}) {
    RunWriter writer(folder, quick_seven, RunMode::fresh);
    append_to(writer, "p/one");
    append_to(writer, "p/two");
  }
  EXPECT_EQ(read_text_file(other / "records.jsonl"), read_text_file(records_file()));
  EXPECT_EQ(read_text_file(other / "timings.jsonl"), read_text_file(timings_file()));
  EXPECT_THAT(read_text_file(records_file()), HasSubstr("p/two/share"));
}

TEST_F(RunWriterLaw, TimingsEnvironmentAndArtifactsLeaveTheRecordsAsTheyAre) {
  const fs::path other = base_ / "other";
  write_run({"p/one"});
  RunWriter writer(other, quick_seven, RunMode::fresh);
  writer.write_environment("{}");
  writer.write_artifact("p/one", "a", "b");
  writer.append("p/one", records_of("p/one"), std::vector{timing_of("p/one", 17.0)});
  EXPECT_EQ(read_text_file(other / "records.jsonl"), read_text_file(records_file()));
}

TEST_F(RunWriterLaw, InterruptedAndResumedRunGivesTheSameBytes) {
  const fs::path other = base_ / "other";
  RunWriter uninterrupted(other, quick_seven, RunMode::fresh);
  append_to(uninterrupted, "p/one");
  append_to(uninterrupted, "p/two");
  write_run({"p/one"});
  append_text(timings_file(), timing_line("p/two", 0.5));
  append_text(records_file(), record_line("p/two", "count"));
  RunWriter resumed = resume();
  append_to(resumed, "p/two");
  EXPECT_EQ(read_text_file(records_file()), read_text_file(other / "records.jsonl"));
  EXPECT_EQ(read_text_file(timings_file()), read_text_file(other / "timings.jsonl"));
}

TEST_F(RunWriterLaw, ResumingTwiceChangesNothing) {
  write_run({"p/one", "p/two"});
  const std::string records = read_text_file(records_file());
  const std::string timings = read_text_file(timings_file());
  for (int i = 0; i < 2; ++i) {
    EXPECT_TRUE(resume().is_complete("p/two"));
    EXPECT_EQ(read_text_file(records_file()), records);
    EXPECT_EQ(read_text_file(timings_file()), timings);
  }
}

}  // namespace
}  // namespace phytobench
