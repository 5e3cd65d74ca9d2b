// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <optional>

namespace phytobench {

/// What an experiment took, preparation and checks included.
struct ExperimentCost {
  double seconds = 0.0;                        ///< of the clock on the wall, more than 0
  std::optional<double> peak_memory_mib = {};  ///< of the whole program while it ran
};

/// Measures from its construction on. Before that it gives freed memory back to the system, so
/// that an experiment does not pay for, nor profit from, what ran before it. The peak of resident
/// memory is the system's high-water mark, reset at the start (man 5 proc, clear_refs); there is
/// none where that is not allowed.
class CostMeter {
 public:
  CostMeter();

  ExperimentCost cost() const;

 private:
  bool is_mark_fresh_ = false;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace phytobench
