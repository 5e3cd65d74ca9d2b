// SPDX-License-Identifier: MIT
// For tests: a folder for histories, and runs to put into them.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmarks/history/history_file.hpp"

namespace phytobench {

inline HistoryRun history_run_of(const std::string& commit,
                                 const std::string& processor = "Model 1") {
  return {.utc = "2026-11-27T22:16:00Z",
          .commit = commit,
          .compiler = "GNU 12",
          .flags = "-O3",
          .processor = processor,
          .logical_processors = 2,
          .command = "phytobench history append x.json"};
}

inline HistoryValue instructions_of(const std::string& benchmark, std::uint64_t count,
                                    const std::string& inputs = "i") {
  return HistoryValue::counted(benchmark, inputs, HistoryQuantity::instructions(), count);
}

inline HistoryValue counter_of(const std::string& benchmark, std::uint64_t count) {
  return HistoryValue::counted(benchmark, "i", HistoryQuantity::counter("evaluations"), count);
}

/// A folder per test, removed afterwards.
class HistoryFolder : public testing::Test {
 protected:
  HistoryFolder()
      : folder_(std::filesystem::path(testing::TempDir()) /
                ("phytobench_history_" + std::to_string(::getpid()))) {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  ~HistoryFolder() override {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  std::filesystem::path file() const { return folder_ / "below" / "history.sqlite"; }
  HistoryFile open() const { return HistoryFile(file(), HistoryAccess::append); }

  std::filesystem::path folder_;
};

}  // namespace phytobench
