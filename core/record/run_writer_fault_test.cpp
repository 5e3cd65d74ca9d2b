// SPDX-License-Identifier: MIT
// A program that does nothing but write runs, killed at random moments: most of them fall into a
// write. PHYTOBENCH_FAULT_KILLS sets their number (15).
#include <sys/wait.h>

#include <csignal>
#include <cstdlib>

#include "core/random/counter_stream.hpp"
#include "core/record/run_folder_fixture.hpp"

namespace phytobench {
namespace {

namespace fs = std::filesystem;

constexpr int experiments = 60;

std::string name_of_experiment(int number) {
  return "p/" + std::to_string(1000 + number);
}

/// Writes what is missing of a run.
void write_all(const fs::path& folder) {
  RunWriter writer(folder, quick_seven, RunMode::resume);
  writer.write_environment("{\"process\":" + std::to_string(::getpid()) + "}\n");
  for (int i = 0; i < experiments; ++i) {
    const std::string name = name_of_experiment(i);
    if (writer.is_complete(name)) continue;
    writer.write_artifact(name, "tree.svg", std::string(5000, 'x'));
    append_to(writer, name);
  }
}

/// Writes in a process of its own and kills that after so many microseconds; its exit code, or -1
/// if it was killed.
int write_and_kill(const fs::path& folder, double microseconds) {
  const pid_t child = ::fork();
  if (child == 0) {
    int code = 1;
    try {
      write_all(folder);
      code = 0;
    } catch (const std::exception& error) {
      std::fprintf(stderr, "%s\n", error.what());
    }
    ::_exit(code);
  }
  ::usleep(static_cast<useconds_t>(microseconds));
  if (child > 0) ::kill(child, SIGKILL);
  int status = 0;
  EXPECT_EQ(::waitpid(child, &status, 0), child);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

class RunWriterFaultSlow : public RunFolder {
 protected:
  /// What is there can be read and is the beginning of the run; number of experiments.
  std::size_t expect_beginning() const {
    if (!fs::exists(records_file())) return 0;
    const RunContents run = read_run(folder_);
    const std::size_t complete = run.complete_experiments.size();
    EXPECT_EQ(run.records.size(), 3 * complete);
    EXPECT_EQ(run.timings.size(), 2 * complete);
    for (std::size_t i = 0; i < complete; ++i)
      EXPECT_TRUE(run.complete_experiments.contains(name_of_experiment(static_cast<int>(i)))) << i;
    return complete;
  }

  int half_written() const {
    int number = 0;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder_))
      number += entry.path().filename().string().find(".part") != std::string::npos;
    return number;
  }
};

TEST_F(RunWriterFaultSlow, KilledAtAnyMomentItLeavesAWholeBeginning) {
  const char* const wish = std::getenv("PHYTOBENCH_FAULT_KILLS");
  const int wanted = wish != nullptr ? std::stoi(wish) : 15;
  write_all(base_ / "whole");
  const std::string records = read_text_file(base_ / "whole" / "records.jsonl");
  CounterStream moments(1, 0);
  int kills = 0;
  while (kills < wanted && !HasFailure()) {
    fs::remove_all(folder_);
    std::size_t complete = 0;
    for (int code = -1; code == -1 && kills < wanted;) {
      code = write_and_kill(folder_, moments.next_between(0.0, 50'000.0));
      EXPECT_TRUE(code == -1 || code == 0) << code;
      kills += code == -1;
      const std::size_t left = expect_beginning();
      EXPECT_GE(left, complete) << "a finished experiment is lost";
      complete = left;
    }
    write_all(folder_);
    EXPECT_TRUE(read_text_file(records_file()) == records);
    EXPECT_EQ(expect_beginning(), std::size_t{experiments});
    EXPECT_EQ(half_written(), 0);
  }
}

}  // namespace
}  // namespace phytobench
