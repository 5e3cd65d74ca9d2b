// SPDX-License-Identifier: MIT
#include "benchmarks/regression/callgrind_region.hpp"

#include "core/contract/errors.hpp"
#include "core/memory/keep_freed_memory.hpp"

#if __has_include(<valgrind/callgrind.h>)
#include <valgrind/callgrind.h>
#else
#define PHYTOBENCH_NO_CALLGRIND
#endif

namespace phytobench {

#ifdef PHYTOBENCH_NO_CALLGRIND

VerifiedBenchmark run_in_callgrind_region(const WatchedBenchmark&) {
  throw EnvironmentError(
      "built without callgrind's header; install the package valgrind and build again");
}

#else

VerifiedBenchmark run_in_callgrind_region(const WatchedBenchmark& benchmark) {
  keep_freed_memory();
  const std::unique_ptr<WatchedKernel> kernel = benchmark.prepare();
  kernel->run();
  CALLGRIND_START_INSTRUMENTATION;
  kernel->run();
  CALLGRIND_STOP_INSTRUMENTATION;
  return {.name = benchmark.name,
          .inputs = kernel->inputs(),
          .answer = kernel->answer(),
          .objection = "",
          .work = {}};
}

#endif

}  // namespace phytobench
