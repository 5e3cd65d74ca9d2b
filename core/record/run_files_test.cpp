// SPDX-License-Identifier: MIT
#include "core/record/run_files.hpp"

#include <limits>

#include "core/record/run_folder_fixture.hpp"

namespace phytobench {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

class RunFiles : public RunFolder {
 protected:
  /// "FILE:line: ".
  static std::string at(const fs::path& file, int line) {
    return file.string() + ":" + std::to_string(line) + ": ";
  }

  /// Of two experiments, with an environment and an artifact.
  void write_rich_run() const {
    RunWriter writer = start();
    writer.write_environment("{\"machine\":\"a\"}\n");
    append_to(writer, "p/one");
    writer.write_artifact("p/two", "tree.svg", "<svg/>");
    append_to(writer, "p/two");
  }
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

TEST_F(RunFiles, TellWhatIsNoRun) {
  EXPECT_THAT(complaint(), StartsWith(folder_.string() + ": no such folder"));
  make_folder(folder_);
  EXPECT_THAT(complaint(), HasSubstr("holds no records.jsonl"));
  make_folder(records_file());
  EXPECT_THAT(complaint(), StartsWith(records_file().string() + ": is a folder"));
  fs::remove(records_file());
  overwrite(records_file(), R"({"schema":"other/1"})"
                            "\n");
  EXPECT_THAT(complaint(), StartsWith(at(records_file(), 1) + "not a run of this suite"));
  overwrite(folder_ / "file", "");
  EXPECT_THAT(input_error([this] { read_run(folder_ / "file"); }),
              StartsWith((folder_ / "file").string() + ": is a file; give the folder of its run, " +
                         folder_.string()));
  overwrite(base_ / "file", "");
  EXPECT_THAT(input_error([this] { read_run(base_ / "file"); }),
              StartsWith((base_ / "file").string() + ": is a file; give a folder that phytobench"));
}

TEST_F(RunFiles, LeaveOutAnExperimentThatWasBeingWritten) {
  write_run({"p/one"});
  const std::string records = read_text_file(records_file());
  const std::string timings = read_text_file(timings_file());
  {
    RunWriter writer = resume();
    append_to(writer, "p/two");
  }
  const std::string more_timings = read_text_file(timings_file());
  // The timings are written first, at any length, and then the records.
  for (std::size_t cut = timings.size(); cut <= more_timings.size(); cut += 7) {
    overwrite(timings_file(), more_timings.substr(0, cut));
    overwrite(records_file(), records);
    const RunContents run = read_run(folder_);
    EXPECT_EQ(run.complete_experiments, std::set<std::string>{"p/one"}) << cut;
    EXPECT_EQ(run.records.size(), 3u) << cut;
    EXPECT_EQ(run.timings.size(), 2u) << cut;
    // Of less than a line the name cannot be told.
    const bool has_name =
        more_timings.substr(timings.size(), cut - timings.size()).find('\n') != std::string::npos;
    EXPECT_EQ(run.unfinished, has_name ? std::optional<std::string>("p/two") : std::nullopt) << cut;
  }
  overwrite(timings_file(), more_timings);
  append_text(records_file(), record_line("p/two", "count") + R"({"experiment":"p/tw)");
  EXPECT_EQ(read_run(folder_).complete_experiments, std::set<std::string>{"p/one"});
  EXPECT_EQ(read_run(folder_).unfinished, "p/two");
  overwrite(timings_file(), timings);
  EXPECT_EQ(read_run(folder_).unfinished, "p/two");
  overwrite(records_file(), records);
  EXPECT_EQ(read_run(folder_).unfinished, std::nullopt);
}

TEST_F(RunFiles, HaveTheArtifactsThatCompleteExperimentsSealed) {
  const std::set<std::string> sealed{"p/two/a/leaf.svg", "p/two/tree.svg"};
  {
    RunWriter writer = start();
    append_to(writer, "p/one");
    for (const char* name : {"tree.svg", "a/leaf.svg"})
      writer.write_artifact("p/two", name, "<svg/>");
    append_to(writer, "p/two");
    writer.write_artifact("p/three", "tree.svg", "<svg/>");  // and is killed
  }
  write_file_atomically(folder_ / "artifacts/p/one/fake.svg", "<svg/>");
  write_file_atomically(folder_ / "artifacts/p/never/fake.svg", "<svg/>");
  EXPECT_EQ(read_run(folder_).artifacts, sealed);
  const std::string records = read_text_file(records_file());
  {
    RunWriter writer = resume();
    writer.write_artifact("p/three", "tree.svg", "<svg/>");
    append_to(writer, "p/three");
  }
  EXPECT_EQ(read_run(folder_).artifacts.size(), 3u);
  overwrite(records_file(), records);  // its timings alone do not make it complete
  EXPECT_EQ(read_run(folder_).artifacts, sealed);
}

TEST_F(RunFiles, ChangedDigitIsAnInputErrorThatNamesItsSection) {
  write_rich_run();
  std::string text = read_text_file(records_file());
  const std::size_t digit = text.find("0.1");
  text[digit + 2] = '2';
  overwrite(records_file(), text);
  EXPECT_THAT(complaint(), StartsWith(at(records_file(), 5) + "lines 2 to 5 were changed"));
  EXPECT_THAT(complaint(), HasSubstr("run the experiments again"));
}

TEST_F(RunFiles, LostRecordsOrTimingsAreAnInputError) {
  write_run({"p/one", "p/two", "p/three"});
  const std::string records = read_text_file(records_file());
  const std::string timings = read_text_file(timings_file());
  const auto first_lines = [](const std::string& text, int lines) {
    std::size_t end = 0;
    while (lines-- > 0) end = text.find('\n', end) + 1;
    return text.substr(0, end);
  };
  overwrite(records_file(), first_lines(records, 5));
  EXPECT_THAT(complaint(), StartsWith(at(records_file(), 5) + "the records of 'p/two' are lost"));
  overwrite(records_file(), records);
  overwrite(timings_file(), first_lines(timings, 4));
  EXPECT_THAT(complaint(), StartsWith(at(timings_file(), 4) + "the timings of 'p/two' are lost"));
  fs::remove(timings_file());
  EXPECT_THAT(complaint(), StartsWith(timings_file().string() + ": is lost"));
}

TEST_F(RunFiles, TimingsOfOtherRecordsAreAnInputError) {
  write_run({"p/one"});
  const std::string timings = read_text_file(timings_file());
  fs::remove_all(folder_);
  {
    RunWriter writer(folder_, {Tier::quick, 8}, RunMode::fresh);
    append_to(writer, "p/one");
  }
  overwrite(timings_file(), timings);
  EXPECT_THAT(complaint(),
              StartsWith(at(timings_file(), 4) + "the timings of 'p/one' belong to other records"));
}

TEST_F(RunFiles, OtherEnvironmentIsAnInputError) {
  write_rich_run();
  EXPECT_EQ(complaint(), "no error");
  EXPECT_EQ(read_environment(folder_), "{\"machine\":\"a\"}\n");
  overwrite(environment_file(), "{\"machine\":\"b\"}\n");
  EXPECT_THAT(complaint(), StartsWith(environment_file().string() + ": was changed"));
  fs::remove(environment_file());
  EXPECT_THAT(complaint(), StartsWith(environment_file().string() + ": is lost"));
}

TEST_F(RunFiles, EnvironmentThatNobodyWroteIsAnInputError) {
  write_run({"p/one"});
  EXPECT_EQ(read_environment(folder_), "{}");
  overwrite(environment_file(), "{}");
  EXPECT_THAT(complaint(), StartsWith(environment_file().string() + ": was changed"));
}

TEST_F(RunFiles, EnvironmentIsThatOfTheLastStartThatMeasured) {
  write_rich_run();
  const std::string first = read_text_file(environment_file());
  {
    RunWriter writer = resume();
    writer.write_environment("second");
  }
  EXPECT_EQ(complaint(), "no error");
  overwrite(environment_file(), first);  // killed before it was replaced
  EXPECT_EQ(complaint(), "no error");
  {
    RunWriter writer = resume();
    writer.write_environment("third");
    append_to(writer, "p/three");
  }
  EXPECT_EQ(complaint(), "no error");
  for (const std::string& earlier : {first, std::string("second")}) {
    overwrite(environment_file(), earlier);
    EXPECT_THAT(complaint(), StartsWith(environment_file().string() + ": was changed")) << earlier;
  }
}

TEST_F(RunFiles, ChangedOrLostArtifactIsAnInputError) {
  write_rich_run();
  const fs::path artifact = folder_ / "artifacts" / "p" / "two" / "tree.svg";
  overwrite(artifact, "<svG/>");
  EXPECT_THAT(complaint(), StartsWith(artifact.string() + ": was changed since 'p/two' wrote it"));
  fs::remove(artifact);
  EXPECT_THAT(complaint(), StartsWith(artifact.string() + ": is lost since 'p/two' wrote it"));
}

TEST_F(RunFiles, FullSizePicturesMayBeLeftOutButNotChanged) {
  {
    RunWriter writer = start();
    writer.write_artifact("p/one", "tree.jpg", "small");
    writer.write_artifact("p/one", "tree.full.jpg", "large");
    append_to(writer, "p/one");
  }
  const fs::path folder = folder_ / "artifacts" / "p" / "one";
  overwrite(folder / "tree.full.jpg", "other");
  EXPECT_THAT(complaint(), StartsWith((folder / "tree.full.jpg").string() + ": was changed"));
  fs::remove(folder / "tree.full.jpg");
  EXPECT_EQ(complaint(), "no error");
  EXPECT_EQ(read_run(folder_).artifacts, std::set<std::string>{"p/one/tree.jpg"});
  fs::remove(folder / "tree.jpg");
  EXPECT_THAT(complaint(), StartsWith((folder / "tree.jpg").string() + ": is lost"));
}

TEST_F(RunFiles, CanBeReadWhileTheyAreWritten) {
  RunWriter writer = start();
  EXPECT_TRUE(read_run(folder_).complete_experiments.empty());
  append_to(writer, "p/one");
  EXPECT_EQ(read_run(folder_).complete_experiments.size(), 1u);
}

TEST(RunFilesSlow, AHundredThousandRecordsAndTimingsAreRead) {
  const fs::path folder =
      fs::path(testing::TempDir()) / ("phytobench-many-records-" + std::to_string(::getpid()));
  fs::remove_all(folder);
  constexpr int experiments = 100, records_each = 1000;
  {
    RunWriter writer(folder, quick_seven, RunMode::fresh);
    for (int e = 0; e < experiments; ++e) {
      const std::string name = "p/" + std::to_string(e);
      std::vector<Record> records;
      std::vector<TimingSample> timings;
      for (int i = 0; i < records_each; ++i) {
        records.push_back(record_of(name, std::to_string(i), 1.0 / (i + 1)));
        timings.push_back(timing_of(name, 0.5 + i));
      }
      writer.append(name, records, timings);
    }
  }
  const RunContents run = read_run(folder);
  fs::remove_all(folder);
  EXPECT_EQ(run.records.size(), std::size_t{experiments * records_each});
  EXPECT_EQ(run.timings.size(), std::size_t{experiments * records_each});
}

}  // namespace
}  // namespace phytobench
