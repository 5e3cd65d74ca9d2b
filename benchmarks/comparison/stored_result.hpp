// SPDX-License-Identifier: MIT
// Times that were measured before and kept: one side of a comparison. Three kinds of files hold
// them: "phytobench/result-1", which `phytobench bench measure --out FILE` writes; what a Google
// Benchmark program writes with --benchmark_out_format=json; and timings.jsonl of `phytobench run`.
//
// phytobench/result-1:
//   schema       "phytobench/result-1"
//   origin       {given, kind, commit, changed, compiler, flags, program_digest}
//   machine      {processor, logical_processors, kernel}
//   seed         of the order of measuring
//   reference    {name, seconds}: a kernel that never changes, timed in the same run; may be absent
//   benchmarks   [{name, inputs, answer, objection, processes: [[seconds, ...], ...]}]: an inner
//                list for each process, seconds per iteration; `objection` only where nothing was
//                timed
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "benchmarks/comparison/comparison.hpp"

namespace phytobench {

inline constexpr const char* stored_result_schema = "phytobench/result-1";

/// Where a result was measured, as far as its file says.
struct ResultMachine {
  std::string processor;       ///< empty if unknown, as in Google Benchmark's files
  int logical_processors = 0;  ///< 0 if unknown
  std::string kernel;          ///< of the operating system; empty if unknown
  std::string caches;          ///< "L1 Data 32768 x 1, ..."; Google Benchmark's files only
  double mhz = 0.0;            ///< at the start; Google Benchmark's files only
  std::string library_build;   ///< Google Benchmark's own: "debug" or "release"; empty for others
  std::string text;            ///< all that the file says, in one line
};

/// Positive seconds per iteration.
struct StoredBenchmark {
  std::string name;
  std::string inputs;     ///< SHA-256; empty if the file does not say
  std::string answer;     ///< SHA-256; empty if the file does not say
  std::string objection;  ///< why there are no times; empty if nothing is wrong
  /// One list for each process; a single one where the file does not say which process a sample is
  /// from.
  std::vector<std::vector<double>> processes;
  bool is_by_process = false;      ///< whether it says so
  bool is_aggregate_only = false;  ///< the file holds means and medians, but no sample

  /// What counts as one repetition: a process, by the median of its samples, where processes are
  /// known, because samples of one process are no independent ones; else a sample.
  std::vector<double> repetitions() const;
};

struct ReferenceTime {
  std::string name;
  double seconds = 0.0;
};

struct StoredResult {
  SideOrigin origin;  ///< of kind "result"
  ResultMachine machine;
  std::uint64_t seed = 0;
  std::optional<ReferenceTime> reference;
  std::vector<StoredBenchmark> benchmarks;  ///< names are unique
};

/// As phytobench/result-1, with a line end.
std::string to_json(const StoredResult& result);

/// Reads phytobench/result-1. Throws InputError beginning with `whose`.
StoredResult stored_result_from(const std::string& json, const std::string& whose);

/// Reads a file of any of the three kinds, or the folder of a run. Throws InputError that names
/// what is accepted where it is none of these.
StoredResult read_stored_result(const std::filesystem::path& path);

/// Throws InputError unless all times are positive and finite and no name is there twice.
void validate(const StoredResult& result, const std::string& whose);

}  // namespace phytobench
