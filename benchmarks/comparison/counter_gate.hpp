// SPDX-License-Identifier: MIT
// Work counters against those in a committed file. They are integers and the same on every machine,
// so any difference is a change of what the program does; a change that is wanted comes with the
// changed file.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "benchmarks/comparison/comparison.hpp"
#include "benchmarks/regression/worker_protocol.hpp"

namespace phytobench {

/// What is kept of one benchmark.
struct CountedBenchmark {
  std::string inputs;  ///< SHA-256, 64 digits: counters of other inputs say nothing
  WorkCounts counters;
  friend bool operator==(const CountedBenchmark&, const CountedBenchmark&) = default;
};

/// By the benchmark's name.
using CounterBaseline = std::map<std::string, CountedBenchmark>;

/// Counters and the build that they were counted of. The committed file does not say: it is right
/// for every build of its sources.
struct CounterDocument {
  std::optional<SideOrigin> origin;
  CounterBaseline benchmarks;
};

enum class CounterChangeKind {
  other_value,         ///< the counter went from `before` to `after`
  counter_appeared,    ///< it has only `after`
  counter_gone,        ///< it has only `before`
  inputs_changed,      ///< of the whole benchmark; other counters follow from that
  benchmark_appeared,  ///< the file does not have it
  benchmark_gone,      ///< only the file has it
};

struct CounterChange {
  CounterChangeKind kind = CounterChangeKind::other_value;
  std::string benchmark;
  std::string counter;  ///< empty where the whole benchmark is meant
  std::uint64_t before = 0;
  std::uint64_t after = 0;
  friend bool operator==(const CounterChange&, const CounterChange&) = default;
};

/// "nearest-node/voxel_grid/dn: node 3 instead of 2" for each answer that its oracle objects to.
std::vector<std::string> wrong_answers(const std::vector<VerifiedBenchmark>& verified);

/// What a worker has answered to `counters`; demands right answers. Throws InputError that begins
/// with `whose` for a benchmark without counters, and for one answered twice.
CounterBaseline counted(const std::vector<VerifiedBenchmark>& verified, const std::string& whose);

/// Every difference, in the order of names; none if they are equal. Pure.
std::vector<CounterChange> counter_changes(const CounterBaseline& before,
                                           const CounterBaseline& after);

/// "nearest-node/voxel_grid/dn search_evaluations 1,234,567 -> 1,296,295 (+5.0 %)", without an end
/// of line.
std::string text_of(const CounterChange& change);

/// "1,234,567".
std::string with_thousands(std::uint64_t number);

/// The file's content: sorted, one counter a line.
std::string to_json(const CounterBaseline& baseline);

/// Throws InputError that begins with `file` for anything but what to_json() writes, so that a
/// merge that left a counter twice is not read as if nothing were.
CounterBaseline counter_baseline_from(const std::string& json, const std::string& file);

/// The same with "origin" (result_document.hpp) where it is known, to be kept.
std::string to_json(const CounterDocument& document);
CounterDocument counter_document_from(const std::string& json, const std::string& file);

/// Throws InputError, naming both and what builds again, where a worker that nobody has named is of
/// another commit than the program, or only one of them has changes of it. Of two builds with
/// changes it cannot tell whether these are the same.
void refuse_stale_worker(const SideOrigin& worker, const SideOrigin& program);

}  // namespace phytobench
