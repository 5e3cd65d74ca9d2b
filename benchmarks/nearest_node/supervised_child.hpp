// SPDX-License-Identifier: MIT
// The child's side of run_supervised(), and what crosses the border between both processes.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>

#include <sys/types.h>

#include "benchmarks/nearest_node/supervised.hpp"

namespace phytobench {

/// What the work ended with.
enum class WorkEnding : int {
  none,  ///< it never ended
  returned,
  input_error,
  environment_error,
  nothing_selected,
  interrupted,
  misbehaved,
  violation,
};

/// Lies in memory that both processes see.
struct SharedWithChild {
  PluginPulse pulse;
  std::atomic<WorkEnding> ending{WorkEnding::none};
  std::atomic<std::uint64_t> output_bytes{0};  ///< of what the pipe should bring
};

/// Does the work in a process that has just been forked by `parent`, writes its output (or what it
/// threw) to the pipe, and leaves without the program's exit handlers.
[[noreturn]] void be_child(const SupervisedWork& work, SharedWithChild& shared, int pipe,
                           pid_t parent);

/// In the parent: throws what the work threw.
[[noreturn]] void rethrow(WorkEnding ending, const std::string& what);

}  // namespace phytobench
