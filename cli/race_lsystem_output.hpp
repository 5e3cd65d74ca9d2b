// SPDX-License-Identifier: MIT
// What `phytobench race lsystem` shows, as tables and as a document of phytobench/race-1:
//   workload.systems  name, derivations, segments, modules, planar, bound of each
//   engines           one entry for each system, lane, engine and number of threads
//   ratios            of string_rewriting to each other engine in the same lane and system
//   means             geometric mean of nanoseconds a segment over the systems, where all have one
//   derivations       derive() alone: modules of all words it makes, a second; bytes of the last
//   word
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "benchmarks/lsystem/derivation_race.hpp"
#include "benchmarks/lsystem/lsystem_race.hpp"
#include "cli/commands.hpp"

namespace phytobench::cli {

struct LSystemRaceResults {
  std::vector<LSystemWorkload> workloads;
  std::vector<DrawingRaceResult> drawings;  ///< one for each workload
  std::vector<DerivationEntry> derivations;

  bool all_right() const;
};

/// What others are compared with.
inline constexpr std::string_view baseline_engine = "string_rewriting";
/// The baseline's entry in the same lane, if it was timed.
const DrawingEntry* baseline_of(const DrawingRaceResult& result, const DrawingEntry& entry);
/// "memoised, 2 threads".
std::string full_name(const DrawingContestant& contestant);
std::size_t segment_bytes(const DrawingRaceResult& result);
/// Nanoseconds a segment of one contestant, as a geometric mean over all systems; none if it has no
/// time on one of them.
std::optional<double> mean_ns(const LSystemRaceResults& results, std::size_t entry);

nlohmann::ordered_json lsystem_document(const LSystemRaceResults& results,
                                        const LSystemRaceOptions& options);
std::string lsystem_tables(const LSystemRaceResults& results, const LSystemRaceOptions& options);

}  // namespace phytobench::cli
