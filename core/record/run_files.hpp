// SPDX-License-Identifier: MIT
// What one run has left: records.jsonl, timings.jsonl, environment.json, artifacts/.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/record/record.hpp"

namespace phytobench {

/// What must agree between the parts of one resumed run.
struct RunHeader {
  Tier tier = Tier::quick;
  std::uint64_t seed = 0;
  friend bool operator==(const RunHeader&, const RunHeader&) = default;
};

/// Everything a finished or interrupted run left behind, without half-written experiments.
struct RunContents {
  RunHeader header;
  std::vector<Record> records;
  std::vector<TimingSample> timings;
  std::set<std::string> complete_experiments;
  /// Sealed files of complete experiments, by their path below artifacts/. Whatever else lies there
  /// is not of the run.
  std::set<std::string> artifacts;
  /// The experiment whose lines break off: the run was killed while it wrote them, or they were cut
  /// later. Unset where none breaks off, or too little of it is left to tell its name.
  std::optional<std::string> unfinished;
};

/// Whether it is the large version of a picture that is there in a size for pages, too
/// ("tree.full.jpg" of "tree.jpg"). It may be left out of a copy of a run; no report needs it.
bool is_full_size(const std::filesystem::path& artifact);

/// Reads a run's folder, also while the run goes on. Throws InputError with file and line for
/// anything that is not a run of this suite, or not as it was written: a foreign schema, lines that
/// were changed, lost, repeated or moved, files of different runs, another environment.json,
/// changed artifacts. Only what looks like an experiment that was being written when the program
/// died is left out; it is `unfinished` then.
RunContents read_run(const std::filesystem::path& folder);

/// environment.json of a run, or "{}" if it has none. read_run() says whether it is the run's.
std::string read_environment(const std::filesystem::path& folder);

}  // namespace phytobench
