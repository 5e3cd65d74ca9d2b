// SPDX-License-Identifier: MIT
// For tests: runs of experiments that are broken off.
#pragma once

#include "cli/command_line_fixture.hpp"
#include "core/record/run_files.hpp"

namespace phytobench {

/// Experiments that take a few seconds together and leave pictures, each less than one.
inline const Words cheap_run = {"run",
                                "alsweis/growth-steps",
                                "alsweis/plant-growth",
                                "alsweis/meadow-scene",
                                "alsweis/migration",
                                "alsweis/gap-response",
                                "alsweis/halftone",
                                "alsweis/shared-ground",
                                "alsweis/two-*",
                                "alsweis/seed-dispersal",
                                "alsweis/shade-of-the-day",
                                "alsweis/zones-of-influence",
                                "alsweis/local-dynamics",
                                "alsweis/lloyd-method",
                                "brzoska2019/equations",
                                "--tier",
                                "smoke"};

/// The same in a tenth of a second.
inline const Words short_run = {"run",
                                "alsweis/growth-steps",
                                "alsweis/plant-growth",
                                "alsweis/growing-pairs",
                                "alsweis/migration",
                                "--tier",
                                "smoke"};

class RunCommand : public CommandLine {
 protected:
  static Words with(Words arguments, const Words& more) {
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }

  std::filesystem::path stdout_file() const { return folder() / "stdout"; }
  std::filesystem::path stderr_file() const { return folder() / "stderr"; }

  /// A run that goes on while the test does something else; 0 if it did not start.
  pid_t start_run(const Words& arguments) const {
    return start(arguments, folder(), stdout_file(), stderr_file());
  }

  static bool has_ended(pid_t child) {
    siginfo_t ended{};
    ::waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOHANG | WNOWAIT);
    return ended.si_pid != 0;
  }

  /// Waits until a run has finished so many experiments, or has ended.
  void wait_for_experiments(const std::filesystem::path& run, std::size_t number,
                            pid_t child) const {
    while (complete_in(run) < number && !has_ended(child)) ::usleep(5000);
  }

  /// Experiments that a run has finished so far.
  std::size_t complete_in(const std::filesystem::path& run) const {
    if (!exists(run / "records.jsonl")) return 0;
    return read_run(folder() / run).complete_experiments.size();
  }

  /// Files of a temporary name below a folder.
  std::set<std::string> half_written_in(const std::filesystem::path& run) const {
    std::set<std::string> names;
    for (const std::filesystem::directory_entry& entry :
         std::filesystem::recursive_directory_iterator(folder() / run))
      if (entry.path().filename().string().find(".part") != std::string::npos)
        names.insert(entry.path().string());
    return names;
  }
};

}  // namespace phytobench
