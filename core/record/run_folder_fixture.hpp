// SPDX-License-Identifier: MIT
// For tests: runs made of two kinds of lines, and a folder to write them to.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/contract/text_file.hpp"
#include "core/record/digest_chain.hpp"
#include "core/record/run_writer.hpp"

namespace phytobench {

inline constexpr RunHeader quick_seven{.tier = Tier::quick, .seed = 7};

inline Record record_of(const std::string& experiment, const std::string& name, RecordValue value) {
  return {
      .experiment = experiment, .measurement = experiment + "/" + name, .value = std::move(value)};
}

inline TimingSample timing_of(const std::string& experiment, double seconds) {
  return {.experiment = experiment, .measurement = experiment + "/time", .value = seconds};
}

inline std::string record_line(const std::string& experiment, const std::string& name) {
  return to_json_line(record_of(experiment, name, std::int64_t{1})) + "\n";
}

inline std::string timing_line(const std::string& experiment, double seconds) {
  return to_json_line(timing_of(experiment, seconds)) + "\n";
}

/// What one experiment leaves behind.
inline std::vector<Record> records_of(const std::string& experiment) {
  return {record_of(experiment, "count", std::int64_t{3}), record_of(experiment, "share", 0.1),
          record_of(experiment, "hash", std::string("00ff"))};
}

inline std::vector<TimingSample> timings_of(const std::string& experiment) {
  return {timing_of(experiment, 0.5), timing_of(experiment, 0.25)};
}

inline void append_to(RunWriter& writer, const std::string& experiment) {
  writer.append(experiment, records_of(experiment), timings_of(experiment));
}

inline void append_text(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary | std::ios::app) << text;
}

/// Without waiting for the disk, which some file systems do for a file that was emptied.
inline void overwrite(const std::filesystem::path& file, const std::string& text) {
  append_text(file, "");
  std::fstream(file, std::ios::binary | std::ios::in | std::ios::out) << text;
  std::filesystem::resize_file(file, text.size());
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

/// The text of a file with right seals, whatever its lines say.
class SealedText {
 public:
  explicit SealedText(const std::string& first_object) { add("", first_object); }

  SealedText& add(const std::string& lines, const std::string& object) {
    text_ += lines + chain_.sealed(lines, object) + "\n";
    return *this;
  }

  const std::string& text() const { return text_; }

 private:
  DigestChain chain_;
  std::string text_;
};

/// A run's folder per test, not there at first and removed afterwards.
class RunFolder : public testing::Test {
 protected:
  void SetUp() override {
    const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
    base_ = std::filesystem::path(testing::TempDir()) /
            (std::string("phytobench-") + test->test_suite_name() + "-" + test->name() + "-" +
             std::to_string(::getpid()));
    std::filesystem::remove_all(base_);
    folder_ = base_ / "run";
  }

  void TearDown() override { std::filesystem::remove_all(base_); }

  std::filesystem::path records_file() const { return folder_ / "records.jsonl"; }
  std::filesystem::path timings_file() const { return folder_ / "timings.jsonl"; }
  std::filesystem::path environment_file() const { return folder_ / "environment.json"; }

  RunWriter start() const { return RunWriter(folder_, quick_seven, RunMode::fresh); }
  RunWriter resume() const { return RunWriter(folder_, quick_seven, RunMode::resume); }

  /// A run of these experiments that has ended.
  void write_run(const std::vector<std::string>& experiments) const {
    RunWriter writer = start();
    for (const std::string& experiment : experiments) append_to(writer, experiment);
  }

  /// What reading the folder says.
  std::string complaint() const {
    return input_error([this] { read_run(folder_); });
  }

  std::filesystem::path base_;
  std::filesystem::path folder_;
};

}  // namespace phytobench
