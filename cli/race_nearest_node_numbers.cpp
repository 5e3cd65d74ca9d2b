// SPDX-License-Identifier: MIT
#include "cli/race_nearest_node_numbers.hpp"

#include <algorithm>

#include "core/statistics/order_statistics.hpp"

namespace phytobench::cli {

std::uint64_t evaluations(const RaceEntry& entry) {
  return entry.work.search_evaluations + entry.work.kill_evaluations;
}

double median_of(const RaceEntry& entry, double PhaseSeconds::*phase) {
  return median(samples(entry, phase));
}

MedianOfRounds total_of(const RaceEntry& entry) {
  return median_of_rounds(samples(entry, &PhaseSeconds::total));
}

MedianOfRounds ratio_of(const RaceEntry& slower, const RaceEntry& faster) {
  return ratio_of_rounds(samples(slower, &PhaseSeconds::total),
                         samples(faster, &PhaseSeconds::total));
}

double median_reset(const RaceEntry& entry) {
  std::vector<double> seconds;
  for (const PhaseSeconds& round : entry.rounds) seconds.push_back(reset_seconds(round));
  return median(seconds);
}

std::vector<const RaceEntry*> ranking(const RaceResult& result) {
  std::vector<const RaceEntry*> timed;
  for (const RaceEntry& entry : result.entries)
    if (entry.state == RaceEntry::State::timed) timed.push_back(&entry);
  std::stable_sort(timed.begin(), timed.end(), [](const RaceEntry* a, const RaceEntry* b) {
    return median_of(*a, &PhaseSeconds::total) < median_of(*b, &PhaseSeconds::total);
  });
  return timed;
}

}  // namespace phytobench::cli
