// SPDX-License-Identifier: MIT
#include "core/statistics/bootstrap.hpp"

#include <vector>

#include "core/contract/check.hpp"
#include "core/random/counter_stream.hpp"
#include "core/statistics/order_statistics.hpp"

namespace phytobench {

Estimate median_estimate(std::span<const double> samples, const BootstrapSettings& settings) {
  PHYTOBENCH_EXPECT(!samples.empty());
  PHYTOBENCH_EXPECT(settings.resamples > 0 && settings.confidence > 0.0 &&
                    settings.confidence < 1.0);
  CounterStream stream(settings.seed, 0);
  std::vector<double> resample(samples.size());
  std::vector<double> medians;
  medians.reserve(static_cast<std::size_t>(settings.resamples));
  for (int i = 0; i < settings.resamples; ++i) {
    for (double& value : resample)
      value = samples[static_cast<std::size_t>(stream.next_unit() *
                                               static_cast<double>(samples.size()))];
    medians.push_back(median(resample));
  }
  const double tail = 0.5 * (1.0 - settings.confidence);
  return {median(samples), quantile(medians, tail), quantile(medians, 1.0 - tail)};
}

}  // namespace phytobench
