// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

#include "benchmarks/comparison/child_process.hpp"
#include "benchmarks/comparison/child_streams.hpp"

namespace phytobench {

/// The new process, once the program runs in it: first of a group of its own, with default signals,
/// and killed if this thread ends. Throws EnvironmentError if the program is missing or cannot be
/// started. Of the options, limits and interruptions do not matter here.
pid_t start_child(const ChildOptions& options, const ChildStreams& streams);

}  // namespace phytobench
