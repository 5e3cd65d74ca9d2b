// SPDX-License-Identifier: MIT
// The files of one run: records.jsonl, timings.jsonl, environment.json, artifacts/.
#pragma once

#include <cstdint>
#include <filesystem>
#include <set>
#include <span>
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
};

/// Reads a run's folder. Throws InputError with file and line for anything that is not a run of
/// this suite: a foreign schema, a broken line that is not the last, a duplicate measurement.
RunContents read_run(const std::filesystem::path& folder);

/// environment.json of a run, or "{}" if it has none.
std::string read_environment(const std::filesystem::path& folder);

enum class RunMode {
  fresh,   ///< the folder must hold no records yet
  resume,  ///< finished experiments are kept, a half-written one is dropped
};

class RunWriter {
 public:
  /// Opens or continues a run. Throws InputError if the mode does not fit what is there,
  /// EnvironmentError if nothing can be written.
  RunWriter(std::filesystem::path folder, const RunHeader& header, RunMode mode);

  bool is_complete(const std::string& experiment) const { return complete_.contains(experiment); }

  /// Appends all of an experiment at once and marks it complete. On failure the files are cut back
  /// to what they were.
  void append(const std::string& experiment, std::span<const Record> records,
              std::span<const TimingSample> timings);

  void write_environment(const std::string& json);

  /// artifacts/<experiment>/<name>.
  void write_artifact(const std::string& experiment, const std::string& name,
                      const std::string& content);

  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
  std::set<std::string> complete_;
};

}  // namespace phytobench
