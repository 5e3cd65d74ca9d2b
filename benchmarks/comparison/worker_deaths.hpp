// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "benchmarks/comparison/timed_side.hpp"

namespace phytobench {

/// The death of a worker that the action ends with, if it does.
template <class Action>
std::optional<WorkerDeath> death_in(const Action& action) {
  try {
    action();
  } catch (const WorkerDied& died) {
    return died.death();
  }
  return std::nullopt;
}

/// What is done about workers that die: whatever was measured together is measured together again,
/// and where that does not help each benchmark by itself, until the one to blame is found. Counts
/// through a whole measurement, so that it ends however often workers die.
class WorkerDeaths {
 public:
  /// Measures these benchmarks, all in the same way. After a death it must have kept nothing.
  using Attempt =
      std::function<std::optional<WorkerDeath>(const std::vector<std::string>& benchmarks)>;

  /// Told once of each benchmark that is given up.
  using Refuse = std::function<void(const std::string& benchmark, const WorkerDeath& death)>;

  /// Further tries of one benchmark alone, and of several together; all in all.
  static constexpr int most_retries = 2;

  /// Until each of the benchmarks is measured or refused. What was stopped at its limit of time is
  /// not tried again as it was.
  void survive(const std::vector<std::string>& benchmarks, const Attempt& attempt,
               const Refuse& refuse);

 private:
  bool is_tried_again(const std::vector<std::string>& benchmarks, const WorkerDeath& death);

  std::map<std::string, int> alone_;  ///< deaths in which no other benchmark took part
  int together_ = 0;                  ///< the others
};

}  // namespace phytobench
