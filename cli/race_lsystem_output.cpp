// SPDX-License-Identifier: MIT
#include "cli/race_lsystem_output.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/statistics/order_statistics.hpp"

namespace phytobench::cli {

using DrawingState = DrawingEntry::State;

bool LSystemRaceResults::all_right() const {
  for (const DrawingRaceResult& result : drawings)
    for (const DrawingEntry& entry : result.entries)
      if (entry.state == DrawingState::wrong) return false;
  return std::all_of(derivations.begin(), derivations.end(),
                     [](const DerivationEntry& entry) { return entry.objection.empty(); });
}

const DrawingEntry* baseline_of(const DrawingRaceResult& result, const DrawingEntry& entry) {
  for (const DrawingEntry& other : result.entries)
    if (other.engine->name == baseline_engine && other.lane == entry.lane &&
        other.state == DrawingState::timed)
      return &other;
  return nullptr;
}

std::string full_name(const DrawingContestant& c) {
  return c.threads == 1 ? std::string(c.engine->name)
                        : fmt::format("{}, {} threads", c.engine->name, c.threads);
}

std::size_t segment_bytes(const DrawingRaceResult& result) {
  return result.planar ? sizeof(PlanarSegment) : sizeof(SpatialSegment);
}

std::optional<double> mean_ns(const LSystemRaceResults& results, std::size_t entry) {
  double sum = 0.0;
  for (std::size_t s = 0; s < results.drawings.size(); ++s) {
    const DrawingEntry& e = results.drawings[s].entries[entry];
    if (e.state != DrawingState::timed) return std::nullopt;
    sum += std::log(1e9 * median(e.seconds) / static_cast<double>(results.workloads[s].segments));
  }
  return std::exp(sum / static_cast<double>(results.drawings.size()));
}

}  // namespace phytobench::cli
