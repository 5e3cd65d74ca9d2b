// SPDX-License-Identifier: MIT
// The format of timings.jsonl, schema phytobench/timings-2, which holds what differs between equal
// runs. Every line that is no timing is sealed: the first, which names the schema; one for each
// start of the run, with the SHA-256 of its environment.json; and one after each experiment's
// timings, with the seal of its records and the SHA-256 of its artifacts.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/record/record.hpp"
#include "core/record/sealed_file.hpp"

namespace phytobench {

inline constexpr const char* timings_name = "timings.jsonl";

/// SHA-256 of an experiment's artifacts, by their path below the run's folder.
using ArtifactDigests = std::map<std::string, std::string>;

std::string timings_header();
std::string timings_session(const std::string& environment_digest);
std::string timings_completion(const std::string& experiment, std::size_t timings,
                               const std::string& records_digest, const ArtifactDigests& artifacts);

/// What is complete in the file.
struct TimingsFile {
  struct Experiment {
    std::string name;
    std::string records_digest;
    ArtifactDigests artifacts;
    Seal before;              ///< where its timings begin
    std::size_t timings = 0;  ///< number of its timings
    int line = 0;             ///< in which it is said to be complete
  };
  struct Session {
    std::size_t experiments = 0;  ///< that were complete before
    std::string environment_digest;
  };
  std::vector<TimingSample> timings;
  std::vector<Experiment> experiments;  ///< in the order of the file
  std::vector<Session> sessions;        ///< in the order of the file
  Seal last;                            ///< after it comes what is unfinished
  /// The experiment whose whole lines stand there; unset where no whole line does.
  std::optional<std::string> unfinished;
};

/// Reads the content of `file`. Throws InputError with file and line.
TimingsFile parse_timings(const std::filesystem::path& file, std::string_view text);

}  // namespace phytobench
