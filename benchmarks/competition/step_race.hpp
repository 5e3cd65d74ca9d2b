// SPDX-License-Identifier: MIT
// One step of a population under each rule of competition: proven, then timed in turns.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/competition/competition_rule.hpp"
#include "core/population/population_parameters.hpp"

namespace phytobench {

struct StepContestant {
  const CompetitionRuleDescriptor* rule = nullptr;
  int threads = 1;
};

struct StepEntry : StepContestant {
  std::string objection;          ///< why it got no time; empty if it did
  std::vector<double> seconds;    ///< of a whole step
  std::vector<double> search;     ///< of finding all overlaps of the zones that the rule reads
  std::uint64_t pairs = 0;        ///< overlaps in one step
  double bytes_per_plant = -1.0;  ///< of the population while it steps; negative if unknown
};

struct StepRaceRequest {
  std::int64_t plants = 100'000;
  double pairs_per_plant = 5.0;  ///< of root zones
  std::vector<StepContestant> contestants;
  int rounds = 7;
  std::uint64_t seed = 0;
  std::function<void(const std::string&)> show_progress = {};
  std::function<bool()> is_interrupted = {};
};

/// Large and small plants, three to seven, at random on a torus, that hardly grow and never die:
/// every step has the same work. Every trait that rules know is there.
PopulationParameters stepping_population(std::int64_t plants, double pairs_per_plant,
                                         std::uint64_t seed);

/// What is wrong with losses that should be others up to rounding; empty if nothing.
std::string objection_to_losses(std::span<const double> found, std::span<const double> expected);

/// Before a rule is timed, its losses with this race's engine must be those with all pairs tried,
/// on a stand of 1,500 plants, and on the whole stand every number of threads must give the same
/// bits, and some plants what they lose to their neighbours alone. Throws Interrupted when asked to
/// stop.
std::vector<StepEntry> race_steps(const StepRaceRequest& request);

}  // namespace phytobench
