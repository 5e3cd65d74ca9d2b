// SPDX-License-Identifier: MIT
#include "experiments/time_estimate.hpp"

#include <cmath>

#include <fmt/format.h>

namespace phytobench {

void TimeEstimate::learn(const ExperimentDescriptor& experiment, double seconds) {
  foretold_s_ += experiment.seconds[static_cast<std::size_t>(tier_)];
  taken_s_ += seconds;
}

double TimeEstimate::seconds_of(const ExperimentDescriptor& experiment) const {
  return experiment.seconds[static_cast<std::size_t>(tier_)] * taken_s_ / foretold_s_;
}

double TimeEstimate::seconds_of(std::span<const ExperimentDescriptor* const> experiments) const {
  double seconds = 0.0;
  for (const ExperimentDescriptor* experiment : experiments) seconds += seconds_of(*experiment);
  return seconds;
}

std::string shown_duration(double seconds) {
  if (seconds < 9.95) return fmt::format("{:.2g} s", seconds);
  const long long whole = std::llround(seconds);
  if (whole < 100) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} h {} min", whole / 3600, whole / 60 % 60);
}

}  // namespace phytobench
