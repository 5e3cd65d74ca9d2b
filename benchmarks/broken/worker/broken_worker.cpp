// SPDX-License-Identifier: MIT
// For tests: `broken_worker once NAME` does what phytobench_worker does, with the broken engines
// among the benchmarks.
#include <cstdio>
#include <exception>

#include "benchmarks/broken/broken_engines.hpp"
#include "benchmarks/regression/callgrind_region.hpp"
#include "benchmarks/regression/worker_options.hpp"

int main(int argc, char** argv) {
  using namespace phytobench;
  try {
    const WorkerOptions options = worker_options({argv + 1, argv + argc});
    const auto all = watched_benchmarks({.extra_engines = broken_engines()});
    std::vector<VerifiedBenchmark> results;
    for (const WatchedBenchmark& benchmark : chosen_benchmarks(all, options.names))
      results.push_back(run_in_callgrind_region(benchmark));
    return std::fputs(to_json(results).c_str(), stdout) < 0 ? 3 : 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "phytobench_worker: %s\n", error.what());
    return 3;
  }
}
