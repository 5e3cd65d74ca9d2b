// SPDX-License-Identifier: MIT
// The files that a history is made of:
//   phytobench/counters-1      counter_gate.hpp; with `origin` if bench counters --out wrote it
//   phytobench/instructions-1  {schema, base, new, benchmarks: [{name, new: {instructions, inputs},
//                              ...}]}, of which that of `new` is kept; or of one build
//                              {schema, origin, machine, benchmarks: [{name, instructions,
//                              inputs}]}
//   phytobench/result-1        stored_result.hpp; kept as ratios to its reference kernel
// `origin`, `new` and `machine` are as in stored_result.hpp. In the first two files they may be
// missing, as `inputs` may in the second.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "benchmarks/comparison/stored_result.hpp"
#include "benchmarks/history/history_file.hpp"

namespace phytobench {

struct HistoryInput {
  std::optional<SideOrigin> origin;      ///< unset where the file does not say
  std::optional<ResultMachine> machine;  ///< the same
  std::vector<HistoryValue> values;
};

/// Throws InputError that names what is accepted where the file is none of these, or where a
/// result has no reference kernel; NothingSelected where it holds no value.
HistoryInput read_history_input(const std::filesystem::path& file);

struct HistoryEntry {
  HistoryRun run;
  std::vector<HistoryValue> values;
};

/// The run that all files together are, one after the other. What none of them says is taken from
/// `here`. Throws InputError naming the file that is of another build or machine than one before.
HistoryEntry history_entry_of(const std::vector<std::string>& files, const HistoryRun& here);

}  // namespace phytobench
