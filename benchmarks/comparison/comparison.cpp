// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/comparison.hpp"

#include <cmath>

#include "core/contract/check.hpp"

namespace phytobench {

namespace {

double log_sum(const std::vector<double>& seconds) {
  PHYTOBENCH_EXPECT(seconds.size() == 2);
  double sum = 0.0;
  for (const double time_s : seconds) {
    PHYTOBENCH_EXPECT(std::isfinite(time_s) && time_s > 0.0);
    sum += std::log(time_s);
  }
  return sum;
}

}  // namespace

double BlockTimes::log_ratio() const {
  return 0.5 * (log_sum(other) - log_sum(base));
}

std::string_view name_of(SpeedVerdict verdict) {
  switch (verdict) {
    case SpeedVerdict::slower:
      return "slower";
    case SpeedVerdict::faster:
      return "faster";
    case SpeedVerdict::same:
      return "same";
    case SpeedVerdict::inconclusive:
      return "inconclusive";
    case SpeedVerdict::same_binary:
      return "same binary";
    case SpeedVerdict::nothing_measured:
      return "nothing measured";
    case SpeedVerdict::wrong_answer:
      return "wrong answer";
  }
  PHYTOBENCH_EXPECT(false);
  return {};
}

bool is_base_to_blame(const ConcludedBenchmark& benchmark) {
  return benchmark.verdict == SpeedVerdict::nothing_measured &&
         (benchmark.reason == only_new_has_it || benchmark.reason.starts_with(base_is_wrong));
}

}  // namespace phytobench
