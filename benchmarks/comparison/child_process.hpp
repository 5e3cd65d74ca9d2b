// SPDX-License-Identifier: MIT
// Starts another program and waits for it without using the processor: a timed program may run
// beside the waiting one.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace phytobench {

/// What a program gets of our environment besides the changes that are asked for.
enum class InheritedEnvironment { everything, nothing };

/// How the end of a program is noticed. A descriptor wakes the waiting program when it happens;
/// where the system has none (Linux before 5.3, some containers), it looks every 5 ms.
enum class ChildWait { by_descriptor, by_looking };

/// A variable's name and its value; without a value the variable is taken away.
using EnvironmentChange = std::pair<std::string, std::optional<std::string>>;

struct ChildOptions {
  std::vector<std::string> command;   ///< program, then arguments; looked for on PATH without a '/'
  std::filesystem::path folder = {};  ///< it works in; empty: the current one
  std::string input = {};             ///< its standard input
  std::vector<EnvironmentChange> environment = {};
  InheritedEnvironment inherited = InheritedEnvironment::everything;
  double limit_s = 600.0;  ///< it is ended then; > 0
  double grace_s = 2.0;    ///< that it gets to end before it is killed; >= 0
  /// Its output and error messages are appended to this file instead of being returned.
  std::filesystem::path log = {};
  /// The processor it is kept on; see processor_split.hpp. Nothing: any.
  std::optional<int> processor = std::nullopt;
  /// Asked about ten times a second, and when a signal arrives. Nothing: never interrupted.
  std::function<bool()> is_interrupted = {};
  ChildWait wait = ChildWait::by_descriptor;
};

struct ChildResult {
  int exit_code = -1;      ///< -1 if a signal ended it
  int signal = 0;          ///< that ended it; 0 if it ended by itself
  bool timed_out = false;  ///< it was killed because of its limit
  std::string out;
  std::string err;
  double wall_s = 0.0;  ///< from its start until its end was noticed
  double user_s = 0.0;  ///< processor time in user mode, with that of its own children

  bool is_ok() const { return exit_code == 0 && !timed_out; }
};

/// Runs the program to its end. It is the first of a process group of its own, of which nothing is
/// left when this returns or throws: at the limit and when interrupted, all of the group are asked
/// to end; when the program has, or its grace is over, what is left of the group is killed. Throws
/// Interrupted; EnvironmentError if the program is missing or cannot be started. Its own failure is
/// a result.
ChildResult run_child(const ChildOptions& options);

/// "ended with exit code 3", "was killed by signal 11 (Segmentation fault)", "took longer than 5
/// s".
std::string ending_of(const ChildResult& result, double limit_s);

/// The last line that is not empty, as one_line(): what a program that failed has to say.
std::string last_line(const std::string& text);

}  // namespace phytobench
