// SPDX-License-Identifier: MIT
// phytobench_worker: the benchmarks of one build, for whoever counts or compares. What it is asked
// and answers: worker_protocol.hpp. It holds nothing of reports, experiments or the command line,
// and no commit, so that two builds of equal sources are the same program.
#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <iterator>
#include <memory>

#include <fmt/format.h>

#include "benchmarks/regression/callgrind_region.hpp"
#include "benchmarks/regression/sampling.hpp"
#include "benchmarks/regression/selftest_benchmarks.hpp"
#include "benchmarks/regression/worker_options.hpp"
#include "build_flags.hpp"
#include "core/contract/errors.hpp"
#include "core/memory/keep_freed_memory.hpp"
#include "core/nearest_node/plugin/engine_plugin.hpp"

namespace phytobench {

namespace {

/// Engines from files, and with them all benchmarks.
struct Loaded {
  std::vector<std::unique_ptr<EnginePlugin>> plugins;
  std::vector<WatchedBenchmark> benchmarks;
};

Loaded load(const WorkerOptions& options) {
  Loaded loaded;
  FamilyRequest request;
  for (const std::string& file : options.plugins) {
    loaded.plugins.push_back(std::make_unique<EnginePlugin>(file));
    request.extra_engines.push_back(&loaded.plugins.back()->descriptor());
  }
  loaded.benchmarks = watched_benchmarks(request);
  if (options.with_selftest)
    for (WatchedBenchmark& benchmark : selftest_benchmarks())
      loaded.benchmarks.push_back(std::move(benchmark));
  return loaded;
}

std::string described(const std::vector<WatchedBenchmark>& benchmarks) {
  WorkerDescription description{.compiler = build_flags::compiler,
                                .flags = build_flags::flags,
                                .counts_work = counts_inner_loop,
                                .benchmarks = {}};
  for (const WatchedBenchmark& one : benchmarks)
    description.benchmarks.push_back({one.name, one.summary, one.is_own});
  return to_json(description);
}

template <class Result, class Make>
std::string each(const std::vector<WatchedBenchmark>& benchmarks, const Make& make) {
  std::vector<Result> results;
  for (const WatchedBenchmark& benchmark : benchmarks) results.push_back(make(benchmark));
  return to_json(results);
}

std::string whole_standard_input() {
  return std::string(std::istreambuf_iterator<char>(std::cin), std::istreambuf_iterator<char>());
}

std::string answer_to(const WorkerOptions& options) {
  const Loaded loaded = load(options);
  if (options.command == "list") return described(loaded.benchmarks);
  if (options.command == "sample") {
    keep_freed_memory();
    const SamplePlan plan = sample_plan_from(whole_standard_input(), "standard input");
    return to_json(sample_benchmarks(loaded.benchmarks, plan, {.handicap = options.handicap}));
  }
  const auto chosen = chosen_benchmarks(loaded.benchmarks, options.names);
  if (options.command == "calibrate") {
    keep_freed_memory();
    return each<CalibratedBenchmark>(chosen, [&](const WatchedBenchmark& benchmark) {
      return calibrate_benchmark(benchmark, 1e-3 * options.sample_ms);
    });
  }
  if (options.command == "once") return each<VerifiedBenchmark>(chosen, run_in_callgrind_region);
  if (options.command == "counters" && !counts_inner_loop)
    throw EnvironmentError("this worker was built without counters; use the preset 'counters'");
  return each<VerifiedBenchmark>(chosen, verify_benchmark);
}

/// What plugins print must not get among the answers: from here on it goes to standard error.
/// Where answers go instead.
std::FILE* answers_apart() {
  const int apart = ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3);
  if (apart < 0 || ::dup2(STDERR_FILENO, STDOUT_FILENO) < 0) return nullptr;
  return ::fdopen(apart, "w");
}

int fail(int code, const std::exception& error) {
  std::fprintf(stderr, "phytobench_worker: %s\n", error.what());
  return code;
}

}  // namespace

}  // namespace phytobench

int main(int argc, char** argv) {
  using namespace phytobench;
  try {
    const WorkerOptions options = worker_options({argv + 1, argv + argc});
    std::FILE* const out = options.plugins.empty() ? stdout : answers_apart();
    if (out == nullptr) throw EnvironmentError("standard output cannot be kept from plugins");
    const std::string answer = answer_to(options);
    const bool is_written = std::fwrite(answer.data(), 1, answer.size(), out) == answer.size();
    if (!is_written || std::fflush(out) != 0)
      throw EnvironmentError("standard output cannot be written");
    // Destructors of plugins might hang, and nothing is left to be done.
    if (!options.plugins.empty()) std::_Exit(0);
    return 0;
  } catch (const InputError& error) {
    return fail(2, error);
  } catch (const NothingSelected& error) {
    return fail(4, error);
  } catch (const std::exception& error) {
    return fail(3, error);
  }
}
