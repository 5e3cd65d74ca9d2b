// SPDX-License-Identifier: MIT
// What the Google Benchmark programs share: how a benchmark is registered, and main().
#pragma once

#include <string>
#include <utility>

#include <benchmark/benchmark.h>

#include "core/memory/keep_freed_memory.hpp"

namespace phytobench {

/// Joins the suite; its times are shown in milliseconds.
template <class Function>
benchmark::internal::Benchmark* register_benchmark(const std::string& name, Function function) {
  return benchmark::RegisterBenchmark(name.c_str(), std::move(function))
      ->Unit(benchmark::kMillisecond);
}

/// Skips the benchmark if there is an objection to it: true if it must not be timed.
inline bool is_skipped(benchmark::State& state, const std::string& objection) {
  if (objection.empty()) return false;
  state.SkipWithError(objection.c_str());
  return true;
}

/// The program's exit code. Nothing is registered before memory is set up.
inline int run_suite(int argc, char** argv, void (*register_all)()) {
  keep_freed_memory();
  register_all();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}

}  // namespace phytobench
