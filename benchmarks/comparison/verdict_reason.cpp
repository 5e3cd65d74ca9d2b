// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/verdict_reason.hpp"

#include <cmath>

#include <fmt/format.h>

#include "benchmarks/comparison/change_bounds.hpp"

namespace phytobench {

namespace {

/// To a tenth of a percent; 0.0 is added so that no "-0.0" is shown.
double percent(double ratio) {
  return std::round(1000.0 * (ratio - 1.0)) / 10.0 + 0.0;
}

std::string what_does_not_matter(const VerdictSettings& settings) {
  return fmt::format("the {:g} % that do not matter", 100.0 * settings.tolerance);
}

std::string noise(const ConcludedBenchmark& benchmark) {
  return fmt::format("the same build differs from itself by up to {:.1f} %",
                     100.0 * benchmark.noise_floor);
}

std::string not_significant(const ConcludedBenchmark& benchmark, const VerdictSettings& settings,
                            std::size_t tested) {
  const int needed = blocks_needed(tested, settings);
  if (benchmark.blocks < static_cast<std::size_t>(needed))
    return fmt::format("but {} blocks are too few to judge {} benchmarks together, it takes {}",
                       benchmark.blocks, tested, needed);
  return fmt::format("but p is {:.2g} and must be below {:g}", benchmark.p, settings.alpha);
}

}  // namespace

std::string change_text(const Estimate& ratio) {
  return fmt::format("{:+.1f} % [{:.1f}, {:.1f}]", percent(ratio.value), percent(ratio.low),
                     percent(ratio.high));
}

std::string beyond_doubt(const ConcludedBenchmark& benchmark, const VerdictSettings& settings) {
  return fmt::format("{}, more than {} and the noise of {:.1f} %", change_text(*benchmark.ratio),
                     what_does_not_matter(settings), 100.0 * benchmark.noise_floor);
}

std::string within_tolerance(const ConcludedBenchmark& benchmark, const VerdictSettings& settings) {
  return fmt::format("{}, within {}", change_text(*benchmark.ratio),
                     what_does_not_matter(settings));
}

std::string doubt(const ConcludedBenchmark& benchmark, const VerdictSettings& settings,
                  std::size_t tested) {
  const std::string change = change_text(*benchmark.ratio);
  const double surely = least_change(*benchmark.ratio);
  const double noise_limit = settings.noise_factor * benchmark.noise_floor;
  if (surely > settings.tolerance && surely > noise_limit)
    return fmt::format("{}, {}", change, not_significant(benchmark, settings, tested));
  if (surely > settings.tolerance)
    return fmt::format("{}, but here it must exceed {:.1f} %: {}", change, 100.0 * noise_limit,
                       noise(benchmark));
  if (largest_change(*benchmark.ratio) <= settings.tolerance)
    return fmt::format("{}, but {}, more than {}", change, noise(benchmark),
                       what_does_not_matter(settings));
  if (surely > 0.0)
    return fmt::format("{}, perhaps within {}", change, what_does_not_matter(settings));
  return fmt::format("{}, too wide to exclude a change of {:g} %", change,
                     100.0 * settings.tolerance);
}

std::string broken_instrument(const Estimate& control) {
  return fmt::format("the same build differs from itself by {}: this measurement is biased",
                     change_text(control));
}

}  // namespace phytobench
