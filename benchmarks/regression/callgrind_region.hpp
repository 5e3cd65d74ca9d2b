// SPDX-License-Identifier: MIT
#pragma once

#include "benchmarks/regression/worker_protocol.hpp"

namespace phytobench {

/// Runs a benchmark twice; the second run is what callgrind counts, if it was started with
/// --instr-atstart=no. Throws EnvironmentError where the program was built without callgrind's
/// header. The answer is told, but not judged. From then on the process keeps what it frees
/// (keep_freed_memory()): what the first run has taken from the system is there for the second,
/// whose count then does not depend on where the heap lies and ends.
VerifiedBenchmark run_in_callgrind_region(const WatchedBenchmark& benchmark);

}  // namespace phytobench
