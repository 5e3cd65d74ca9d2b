// SPDX-License-Identifier: MIT
// Runs that are killed at random moments and resumed until they are complete, and runs of which
// random bits are damaged. What is random may be set: PHYTOBENCH_FAULT_KILLS (6),
// PHYTOBENCH_FAULT_FLIPS (100), PHYTOBENCH_FAULT_SEED (1).
#include <chrono>
#include <cstdlib>
#include <iostream>

#include "cli/run_fixture.hpp"
#include "core/contract/errors.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

std::uint64_t from_environment(const char* name, std::uint64_t otherwise) {
  const char* const text = std::getenv(name);
  return text != nullptr ? std::stoull(text) : otherwise;
}

class RunFaultSlow : public RunCommand {
 protected:
  void SetUp() override {
    const auto start = std::chrono::steady_clock::now();
    output_of(with(cheap_run, {"--out", "whole"}));
    const std::chrono::duration<double, std::micro> passed =
        std::chrono::steady_clock::now() - start;
    longest_us_ = passed.count() / 3.0;
    records_ = read("whole/records.jsonl");
  }

  /// Starts or resumes the run and kills it after a random time; whether that came in time.
  bool kill_once(const std::filesystem::path& run) {
    const pid_t child = start_run(with(cheap_run, {"--resume", "--out", run.string()}));
    if (child == 0) return false;  // a signal to 0 would reach the tests themselves
    ::usleep(static_cast<useconds_t>(moments_.next_between(0.0, longest_us_)));
    ::kill(child, SIGKILL);
    const int code = exit_code_of(child);
    EXPECT_TRUE(code == -1 || code == 0) << read("stderr");
    return code == -1;
  }

  /// Takes up the run to its end.
  void expect_complete(const std::filesystem::path& run) const {
    output_of(with(cheap_run, {"--resume", "--out", run.string()}));
    EXPECT_TRUE(read(run / "records.jsonl") == records_) << run << ": other bytes";
    EXPECT_EQ(complete_in(run), complete_in("whole"));
    EXPECT_TRUE(half_written_in(run).empty());
  }

  /// The path of every file of the run that took no fault.
  std::vector<std::filesystem::path> files_of_whole() const {
    std::set<std::filesystem::path> files;  // in the same order everywhere
    for (const std::filesystem::directory_entry& entry :
         std::filesystem::recursive_directory_iterator(folder() / "whole"))
      if (entry.is_regular_file()) files.insert(entry.path());
    return {files.begin(), files.end()};
  }

  std::size_t random_below(std::size_t count) {
    return static_cast<std::size_t>(moments_.next_unit() * static_cast<double>(count));
  }

  std::string records_;
  double longest_us_ = 0.0;
  CounterStream moments_{from_environment("PHYTOBENCH_FAULT_SEED", 1), 0};
};

TEST_F(RunFaultSlow, KilledAndResumedItLosesAtMostTheRunningExperimentAndLeavesTheSameRecords) {
  const std::uint64_t wanted = from_environment("PHYTOBENCH_FAULT_KILLS", 6);
  std::uint64_t kills = 0;
  for (int runs = 0; kills < wanted && !HasFailure(); ++runs) {
    const std::string run = "broken-" + std::to_string(runs);
    std::size_t complete = 0;
    while (kills < wanted && kill_once(run)) {
      ++kills;
      const std::size_t left = complete_in(run);  // whatever is there can be read
      EXPECT_GE(left, complete) << "a finished experiment is lost";
      complete = left;
    }
    expect_complete(run);
    std::cout << run << ": " << kills << " of " << wanted << " kills so far, " << complete
              << " experiments complete at the last\n";
  }
}

TEST_F(RunFaultSlow, FlippedBitIsRefusedInEveryFile) {
  const std::vector<std::filesystem::path> files = files_of_whole();
  EXPECT_GT(files.size(), 10u) << "records, timings, environment and pictures";
  const std::uint64_t flips = from_environment("PHYTOBENCH_FAULT_FLIPS", 100);
  for (std::uint64_t i = 0; i < flips; ++i) {
    // Half of them where the records are.
    const std::filesystem::path file =
        i % 2 == 0 ? folder() / "whole/records.jsonl" : files[random_below(files.size())];
    const std::string text = content_of(file);
    std::string damaged = text;
    const std::size_t byte = random_below(text.size());
    damaged[byte] = static_cast<char>(damaged[byte] ^ (1 << random_below(8)));
    write(file, damaged);
    try {
      read_run(folder() / "whole");
      ADD_FAILURE() << file << ": byte " << byte << " was changed";
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::StartsWith(file.string() + ":"));
    }
    write(file, text);
  }
  EXPECT_GT(complete_in("whole"), 10u) << "undamaged it can be read";
}

}  // namespace
}  // namespace phytobench
