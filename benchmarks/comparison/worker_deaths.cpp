// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/worker_deaths.hpp"

#include <fmt/format.h>

namespace phytobench {

bool WorkerDeaths::is_tried_again(const std::vector<std::string>& benchmarks,
                                  const WorkerDeath& death) {
  int& deaths = benchmarks.size() == 1 ? alone_[benchmarks.front()] : together_;
  ++deaths;
  return deaths <= most_retries && !death.was_stopped;
}

void WorkerDeaths::survive(const std::vector<std::string>& benchmarks, const Attempt& attempt,
                           const Refuse& refuse) {
  if (benchmarks.empty()) return;
  std::optional<WorkerDeath> death;
  do {
    death = attempt(benchmarks);
  } while (death && is_tried_again(benchmarks, *death));
  if (!death) return;
  if (benchmarks.size() > 1) {
    for (const std::string& benchmark : benchmarks) survive({benchmark}, attempt, refuse);
    return;
  }
  const int deaths = alone_.at(benchmarks.front());
  if (deaths > 1) death->reason += fmt::format("; it happened {} times", deaths);
  refuse(benchmarks.front(), *death);
}

}  // namespace phytobench
