// SPDX-License-Identifier: MIT
#include "core/record/run_files.hpp"

#include <unistd.h>

#include <fstream>
#include <limits>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/contract/text_file.hpp"

namespace phytobench {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

constexpr RunHeader quick_seven{.tier = Tier::quick, .seed = 7};
constexpr const char* header_line = R"({"schema":"phytobench/records-1","tier":"quick","seed":7})"
                                    "\n";

Record record_of(const std::string& experiment, const std::string& name, RecordValue value) {
  return {
      .experiment = experiment, .measurement = experiment + "/" + name, .value = std::move(value)};
}

TimingSample timing_of(const std::string& experiment, double seconds) {
  return {.experiment = experiment, .measurement = experiment + "/time", .value = seconds};
}

std::string record_line(const std::string& experiment, const std::string& name) {
  return to_json_line(record_of(experiment, name, std::int64_t{1})) + "\n";
}

std::string completion_line(const std::string& experiment, int records) {
  return R"({"experiment":")" + experiment + R"(","complete":true,"records":)" +
         std::to_string(records) + "}\n";
}

/// What one experiment leaves behind.
std::vector<Record> records_of(const std::string& experiment) {
  return {record_of(experiment, "count", std::int64_t{3}), record_of(experiment, "share", 0.1),
          record_of(experiment, "hash", std::string("00ff"))};
}

std::vector<TimingSample> timings_of(const std::string& experiment) {
  return {timing_of(experiment, 0.5), timing_of(experiment, 0.25)};
}

void append_to(RunWriter& writer, const std::string& experiment) {
  writer.append(experiment, records_of(experiment), timings_of(experiment));
}

void append_text(const fs::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary | std::ios::app) << text;
}

/// The message of the InputError that an action ends with.
template <class Action>
std::string input_error(const Action& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

/// A run's folder per test, not there at first and removed afterwards.
class RunFiles : public testing::Test {
 protected:
  void SetUp() override {
    const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
    base_ = fs::path(testing::TempDir()) / (std::string("phytobench-") + test->test_suite_name() +
                                            "-" + test->name() + "-" + std::to_string(::getpid()));
    fs::remove_all(base_);
    folder_ = base_ / "run";
  }

  void TearDown() override { fs::remove_all(base_); }

  fs::path records_file() const { return folder_ / "records.jsonl"; }
  fs::path timings_file() const { return folder_ / "timings.jsonl"; }

  RunWriter start() const { return RunWriter(folder_, quick_seven, RunMode::fresh); }
  RunWriter resume() const { return RunWriter(folder_, quick_seven, RunMode::resume); }

  /// What reading says about a run with these lines after the header; starts with the file's name.
  std::string complaint(const std::string& lines) const {
    write_file_atomically(records_file(), header_line + lines);
    return input_error([this] { read_run(folder_); });
  }

  /// "FILE:line: " of the records.
  std::string records_at(int line) const {
    return records_file().string() + ":" + std::to_string(line) + ": ";
  }

  fs::path base_;
  fs::path folder_;
};

TEST_F(RunFiles, ComeBackAsTheyWereWritten) {
  Record rich = record_of("p/one", "rich", 0.5);
  rich.unit = "degree";
  rich.sample_size = 30;
  rich.spread = 0.1;
  rich.seed = std::numeric_limits<std::uint64_t>::max();
  const TimingSample timing{.experiment = "p/one",
                            .measurement = "p/one/time",
                            .round = 3,
                            .position = 2,
                            .value = 1e-7,
                            .threads = 4};
  RunWriter writer = start();
  writer.append("p/one", std::vector<Record>{rich}, std::vector<TimingSample>{timing});

  const RunContents run = read_run(folder_);
  EXPECT_EQ(run.header, quick_seven);
  EXPECT_EQ(run.complete_experiments, std::set<std::string>{"p/one"});
  ASSERT_EQ(run.records.size(), 1u);
  EXPECT_EQ(run.records[0].experiment, "p/one");
  EXPECT_EQ(run.records[0].measurement, "p/one/rich");
  EXPECT_EQ(std::get<double>(run.records[0].value), 0.5);
  EXPECT_EQ(run.records[0].unit, "degree");
  EXPECT_EQ(run.records[0].sample_size, 30);
  ASSERT_TRUE(run.records[0].spread.has_value());
  EXPECT_EQ(*run.records[0].spread, 0.1);
  ASSERT_TRUE(run.records[0].seed.has_value());
  EXPECT_EQ(*run.records[0].seed, std::numeric_limits<std::uint64_t>::max());
  ASSERT_EQ(run.timings.size(), 1u);
  EXPECT_EQ(run.timings[0].experiment, "p/one");
  EXPECT_EQ(run.timings[0].measurement, "p/one/time");
  EXPECT_EQ(run.timings[0].round, 3);
  EXPECT_EQ(run.timings[0].position, 2);
  EXPECT_EQ(run.timings[0].value, 1e-7);
  EXPECT_EQ(run.timings[0].threads, 4);
}

TEST_F(RunFiles, ValuesKeepEveryBitAndTheirKind) {
  const std::vector<RecordValue> values{std::int64_t{0},
                                        std::numeric_limits<std::int64_t>::min(),
                                        std::numeric_limits<std::int64_t>::max(),
                                        0.1,
                                        3.0,
                                        1e300,
                                        std::numeric_limits<double>::max(),
                                        std::numeric_limits<double>::denorm_min(),
                                        1.0 / 3.0,
                                        std::string(),
                                        std::string("two\nlines, \"quotes\" and \\"),
                                        std::string("\xc3\xa4")};
  std::vector<Record> records;
  for (std::size_t i = 0; i < values.size(); ++i)
    records.push_back(record_of("p/one", std::to_string(i), values[i]));
  RunWriter writer = start();
  writer.append("p/one", records, {});
  const RunContents run = read_run(folder_);
  ASSERT_EQ(run.records.size(), values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    EXPECT_TRUE(run.records[i].value == values[i]) << "value " << i;
}

TEST_F(RunFiles, StartWithTheirSchemaTierAndSeed) {
  start();
  EXPECT_EQ(read_text_file(records_file()), header_line);
  EXPECT_EQ(read_text_file(timings_file()), "");
  const RunContents run = read_run(folder_);
  EXPECT_EQ(run.header, quick_seven);
  EXPECT_TRUE(run.records.empty());
  EXPECT_TRUE(run.complete_experiments.empty());
}

TEST_F(RunFiles, KnowWhichExperimentsAreComplete) {
  RunWriter writer = start();
  EXPECT_FALSE(writer.is_complete("p/one"));
  append_to(writer, "p/one");
  EXPECT_TRUE(writer.is_complete("p/one"));
  EXPECT_FALSE(writer.is_complete("p/two"));
  const RunWriter resumed = resume();
  EXPECT_TRUE(resumed.is_complete("p/one"));
  EXPECT_FALSE(resumed.is_complete("p/two"));
}

TEST_F(RunFiles, FreshRunOverRecordsIsAnInputError) {
  start();
  const std::string before = read_text_file(records_file());
  EXPECT_THAT(input_error([this] { start(); }), StartsWith(folder_.string() + ": already holds"));
  EXPECT_EQ(read_text_file(records_file()), before);
}

TEST_F(RunFiles, FreshRunMayUseAFolderWithoutRecords) {
  write_file_atomically(folder_ / "notes.txt", "kept");
  start();
  EXPECT_EQ(read_text_file(folder_ / "notes.txt"), "kept");
  EXPECT_EQ(read_run(folder_).header, quick_seven);
}

TEST_F(RunFiles, ResumeOfNothingStartsAFreshRun) {
  resume();
  EXPECT_EQ(read_text_file(records_file()), header_line);
}

TEST_F(RunFiles, ResumeWithAnotherSeedOrTierIsAnInputError) {
  RunWriter writer = start();
  append_to(writer, "p/one");
  const std::string before = read_text_file(records_file());
  for (const RunHeader& other : {RunHeader{Tier::quick, 8}, RunHeader{Tier::full, 7}}) {
    const auto resume_other = [&] { RunWriter(folder_, other, RunMode::resume); };
    EXPECT_THAT(input_error(resume_other), HasSubstr("--tier quick --seed 7"));
  }
  EXPECT_EQ(read_text_file(records_file()), before);
}

TEST_F(RunFiles, RunBelowAFileIsAnEnvironmentError) {
  write_file_atomically(base_ / "file", "kept");
  EXPECT_THROW(RunWriter(base_ / "file", quick_seven, RunMode::fresh), EnvironmentError);
  EXPECT_THROW(RunWriter(base_ / "file" / "run", quick_seven, RunMode::fresh), EnvironmentError);
  EXPECT_EQ(read_text_file(base_ / "file"), "kept");
}

TEST_F(RunFiles, AppendToAVanishedFolderIsAnEnvironmentError) {
  RunWriter writer = start();
  fs::remove_all(folder_);
  EXPECT_THROW(append_to(writer, "p/one"), EnvironmentError);
  EXPECT_FALSE(writer.is_complete("p/one"));
}

TEST_F(RunFiles, TruncatedLastLineIsDroppedAndItsExperimentIsNotComplete) {
  RunWriter writer = start();
  append_to(writer, "p/one");
  const std::string completion = completion_line("p/two", 1);
  append_text(records_file(),
              record_line("p/two", "count") + completion.substr(0, completion.size() - 1));
  const RunContents run = read_run(folder_);
  EXPECT_EQ(run.complete_experiments, std::set<std::string>{"p/one"});
  ASSERT_EQ(run.records.size(), 3u);
  for (const Record& record : run.records) EXPECT_EQ(record.experiment, "p/one");
  // Only the line end was missing.
  append_text(records_file(), "\n");
  EXPECT_EQ(read_run(folder_).records.size(), 4u);
}

TEST_F(RunFiles, LineBrokenOffInsideAWordIsDropped) {
  RunWriter writer = start();
  append_to(writer, "p/one");
  append_text(records_file(), record_line("p/two", "count") + R"({"experiment":"p/tw)");
  EXPECT_EQ(read_run(folder_).complete_experiments, std::set<std::string>{"p/one"});
}

TEST_F(RunFiles, BrokenLineInTheMiddleIsAnInputErrorAtThatLine) {
  for (const char* broken : {"{broken\n", "\n", "[]\n", "3\n", "{}\n",
                             R"({"experiment":"p/one"})"
                             "\n"})
    EXPECT_THAT(complaint(record_line("p/one", "count") + broken + completion_line("p/one", 1)),
                StartsWith(records_at(3)))
        << broken;
}

TEST_F(RunFiles, ValueThatIsNeitherNumberNorTextIsAnInputErrorAtItsLine) {
  for (const char* value : {"null", "true", "[1]", "{}"}) {
    const std::string line = R"({"experiment":"p/one","measurement":"p/one/m","value":)" +
                             std::string(value) + R"(,"unit":"1","n":1})" + "\n";
    EXPECT_THAT(complaint(line), StartsWith(records_at(2))) << value;
    EXPECT_THAT(complaint(line), HasSubstr("neither number nor text")) << value;
  }
}

TEST_F(RunFiles, ForeignSchemaIsAnInputErrorInTheFirstLine) {
  for (const char* first : {R"({"schema":"phytobench/records-2","tier":"quick","seed":7})",
                            R"({"tier":"quick","seed":7})",
                            R"({"schema":3,"tier":"quick","seed":7})", "[]", "3", "{}"}) {
    write_file_atomically(records_file(), std::string(first) + "\n");
    const std::string message = input_error([this] { read_run(folder_); });
    EXPECT_THAT(message, StartsWith(records_at(1))) << first;
    EXPECT_THAT(message, HasSubstr("phytobench/records-1")) << first;
  }
}

TEST_F(RunFiles, HeaderWithoutTierOrSeedIsAnInputErrorInTheFirstLine) {
  for (const char* first : {R"({"schema":"phytobench/records-1","tier":"quick"})",
                            R"({"schema":"phytobench/records-1","seed":7})",
                            R"({"schema":"phytobench/records-1","tier":"slow","seed":7})",
                            R"({"schema":"phytobench/records-1","tier":3,"seed":7})",
                            R"({"schema":"phytobench/records-1","tier":"quick","seed":"7"})"}) {
    write_file_atomically(records_file(), std::string(first) + "\n");
    EXPECT_THAT(input_error([this] { read_run(folder_); }), StartsWith(records_at(1))) << first;
  }
}

TEST_F(RunFiles, MissingFolderMissingRecordsAndEmptyRecordsAreInputErrors) {
  const auto read = [this] { read_run(folder_); };
  EXPECT_THAT(input_error(read), StartsWith(folder_.string() + ": no such folder"));
  make_folder(folder_);
  EXPECT_THAT(input_error(read), HasSubstr("holds no records.jsonl"));
  write_file_atomically(records_file(), "");
  EXPECT_THAT(input_error(read), HasSubstr("is empty"));
  // The header itself was being written.
  write_file_atomically(records_file(),
                        R"({"schema":"phytobench/records-1","tier":"quick","seed":7})");
  EXPECT_THAT(input_error(read), HasSubstr("is empty"));
}

TEST_F(RunFiles, DuplicateMeasurementIsAnInputError) {
  const std::string twice = record_line("p/one", "count") + record_line("p/one", "count");
  EXPECT_THAT(complaint(twice + completion_line("p/one", 2)),
              StartsWith(records_at(4) + "measurement 'p/one/count' stands here twice"));
  // The same name in another experiment.
  Record foreign = record_of("p/two", "count", std::int64_t{1});
  foreign.measurement = "p/one/count";
  EXPECT_THAT(complaint(record_line("p/one", "count") + completion_line("p/one", 1) +
                        to_json_line(foreign) + "\n" + completion_line("p/two", 1)),
              StartsWith(records_at(5) + "measurement 'p/one/count' stands here twice"));
}

TEST_F(RunFiles, CompletionWithAWrongNumberOfRecordsIsAnInputError) {
  for (const int number : {0, 2})
    EXPECT_THAT(complaint(record_line("p/one", "count") + completion_line("p/one", number)),
                StartsWith(records_at(3) + "experiment 'p/one' lost or gained records"));
  EXPECT_EQ(complaint(record_line("p/one", "count") + completion_line("p/one", 1)), "no error");
}

TEST_F(RunFiles, ExperimentCompletedTwiceIsAnInputError) {
  EXPECT_THAT(complaint(record_line("p/one", "a") + completion_line("p/one", 1) +
                        record_line("p/one", "b") + completion_line("p/one", 1)),
              StartsWith(records_at(5) + "experiment 'p/one' stands here twice"));
}

TEST_F(RunFiles, RecordsOfSeveralExperimentsMayInterleave) {
  EXPECT_EQ(
      complaint(record_line("p/one", "a") + record_line("p/two", "a") + record_line("p/one", "b") +
                completion_line("p/one", 2) + completion_line("p/two", 1)),
      "no error");
  EXPECT_EQ(read_run(folder_).records.size(), 3u);
}

TEST_F(RunFiles, TimingsOfIncompleteExperimentsAreDropped) {
  {
    RunWriter writer = start();
    append_to(writer, "p/one");
  }
  append_text(timings_file(), to_json_line(timing_of("p/two", 1.0)) + "\n");
  const RunContents run = read_run(folder_);
  ASSERT_EQ(run.timings.size(), 2u);
  for (const TimingSample& sample : run.timings) EXPECT_EQ(sample.experiment, "p/one");
  // Resuming takes them out of the file as well.
  resume();
  EXPECT_THAT(read_text_file(timings_file()), testing::Not(HasSubstr("p/two")));
  EXPECT_EQ(read_run(folder_).timings.size(), 2u);
}

TEST_F(RunFiles, TruncatedTimingIsDropped) {
  RunWriter writer = start();
  append_to(writer, "p/one");
  append_text(timings_file(), R"({"experiment":"p/one","measure)");
  EXPECT_EQ(read_run(folder_).timings.size(), 2u);
}

TEST_F(RunFiles, ImpossibleTimingIsAnInputErrorAtItsLine) {
  RunWriter writer = start();
  append_to(writer, "p/one");
  for (const double seconds : {0.0, -1.0}) {
    write_file_atomically(timings_file(), to_json_line(timing_of("p/one", 1.0)) + "\n" +
                                              to_json_line(timing_of("p/one", seconds)) + "\n");
    EXPECT_THAT(input_error([this] { read_run(folder_); }),
                StartsWith(timings_file().string() + ":2: "))
        << seconds;
  }
}

TEST_F(RunFiles, ResumeDropsTheHalfWrittenExperimentFromTheFile) {
  {
    RunWriter writer = start();
    append_to(writer, "p/one");
  }
  const std::string whole = read_text_file(records_file());
  append_text(records_file(), record_line("p/two", "count") + R"({"experiment":"p/two","compl)");
  const RunWriter resumed = resume();
  EXPECT_EQ(read_text_file(records_file()), whole);
  EXPECT_TRUE(resumed.is_complete("p/one"));
  EXPECT_FALSE(resumed.is_complete("p/two"));
}

TEST_F(RunFiles, ResumeOfABrokenRunIsAnInputErrorAndLeavesItAlone) {
  const std::string broken = std::string(header_line) + "{broken\n" + record_line("p/one", "count");
  write_file_atomically(records_file(), broken);
  EXPECT_THAT(input_error([this] { resume(); }), StartsWith(records_at(2)));
  EXPECT_EQ(read_text_file(records_file()), broken);
}

TEST_F(RunFiles, EnvironmentComesBackOrIsAnEmptyObject) {
  const RunWriter untouched = start();
  EXPECT_EQ(read_environment(folder_), "{}");
  RunWriter writer = resume();
  writer.write_environment(R"({"seed":7})");
  EXPECT_EQ(read_environment(folder_), R"({"seed":7})");
}

TEST_F(RunFiles, ArtifactsLieBelowTheirExperiment) {
  RunWriter writer = start();
  EXPECT_EQ(writer.folder(), folder_);
  writer.write_artifact("p/one", "tree.svg", "<svg/>");
  EXPECT_EQ(read_text_file(folder_ / "artifacts" / "p" / "one" / "tree.svg"), "<svg/>");
}

class RunFilesLaw : public RunFiles {};

TEST_F(RunFilesLaw, SameRecordsGiveTheSameBytes) {
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

TEST_F(RunFilesLaw, InterruptedAndResumedRunGivesTheSameBytes) {
  const fs::path other = base_ / "other";
  RunWriter uninterrupted(other, quick_seven, RunMode::fresh);
  append_to(uninterrupted, "p/one");
  append_to(uninterrupted, "p/two");
  {
    RunWriter writer = start();
    append_to(writer, "p/one");
  }
  append_text(timings_file(), to_json_line(timing_of("p/two", 0.5)) + "\n");
  append_text(records_file(), record_line("p/two", "count"));
  RunWriter resumed = resume();
  append_to(resumed, "p/two");
  EXPECT_EQ(read_text_file(records_file()), read_text_file(other / "records.jsonl"));
  EXPECT_EQ(read_text_file(timings_file()), read_text_file(other / "timings.jsonl"));
}

TEST_F(RunFilesLaw, ResumingTwiceChangesNothing) {
  RunWriter writer = start();
  append_to(writer, "p/one");
  append_to(writer, "p/two");
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
