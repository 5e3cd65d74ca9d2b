// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "experiments/experiment.hpp"

namespace phytobench {

/// Guesses how long experiments take: what their descriptors say, times the pace of this machine,
/// which it learns from those that are finished. Long ones count more.
class TimeEstimate {
 public:
  explicit TimeEstimate(Tier tier) : tier_(tier) {}

  void learn(const ExperimentDescriptor& experiment, double seconds);

  double seconds_of(const ExperimentDescriptor& experiment) const;
  double seconds_of(std::span<const ExperimentDescriptor* const> experiments) const;

 private:
  /// As if so many seconds had been foretold and come true: the first, short experiments say
  /// little.
  static constexpr double weight_of_descriptors_s = 5.0;

  Tier tier_;
  double foretold_s_ = weight_of_descriptors_s;
  double taken_s_ = weight_of_descriptors_s;
};

/// "0.25 s", "42 s", "3 min 5 s", "2 h 7 min".
std::string shown_duration(double seconds);

}  // namespace phytobench
