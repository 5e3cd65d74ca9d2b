// SPDX-License-Identifier: MIT
// For tests: `broken_worker once NAME` and, in the preset 'counters', `broken_worker counters NAME`
// do what phytobench_worker does, with the broken engines among the benchmarks.
#include <cstdio>
#include <exception>

#include "benchmarks/broken/broken_engines.hpp"
#include "benchmarks/regression/callgrind_region.hpp"
#include "benchmarks/regression/sampling.hpp"
#include "benchmarks/regression/worker_options.hpp"
#include "core/contract/errors.hpp"

namespace phytobench {

namespace {

VerifiedBenchmark run(const std::string& command, const WatchedBenchmark& benchmark) {
  if (command == "once") return run_in_callgrind_region(benchmark);
  if (command != "counters") throw InputError("give once or counters");
  if (!counts_inner_loop)
    throw EnvironmentError("this worker was built without counters; use the preset 'counters'");
  return verify_benchmark(benchmark);
}

}  // namespace

}  // namespace phytobench

int main(int argc, char** argv) {
  using namespace phytobench;
  try {
    const WorkerOptions options = worker_options({argv + 1, argv + argc});
    const auto all = watched_benchmarks({.extra_engines = broken_engines()});
    std::vector<VerifiedBenchmark> results;
    for (const WatchedBenchmark& benchmark : chosen_benchmarks(all, options.names))
      results.push_back(run(options.command, benchmark));
    return std::fputs(to_json(results).c_str(), stdout) < 0 ? 3 : 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "phytobench_worker: %s\n", error.what());
    return 3;
  }
}
