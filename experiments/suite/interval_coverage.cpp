// SPDX-License-Identifier: MIT
// How often 95 % intervals hold the truth, on made-up times of which it is known.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <fmt/format.h>

#include "core/random/counter_stream.hpp"
#include "core/random/distributions.hpp"
#include "core/statistics/bootstrap.hpp"
#include "core/statistics/median_interval.hpp"
#include "core/statistics/order_statistics.hpp"
#include "core/statistics/power_law.hpp"
#include "experiments/experiment.hpp"

namespace phytobench::experiments::suite {

namespace {

using Values = std::vector<double>;

constexpr double scatter = 0.05;  // of a logarithm: times of the suite's runs have 0.03 to 0.08

int data_sets(Tier tier) {
  return tier == Tier::full ? 100'000 : tier == Tier::quick ? 20'000 : 4'000;
}

/// A law of times whose median is 1, each drawn after the one before.
struct Law {
  const char* name;
  void (*fill)(Values&, UnitStream&);
};

void fill_normal(Values& values, UnitStream& stream) {
  for (double& value : values) value = 1.0 + scatter * random_normal(stream);
}

void fill_lognormal(Values& values, UnitStream& stream) {
  for (double& value : values) value = std::exp(scatter * random_normal(stream));
}

/// One time in ten is prolonged, by as much again on average; such were above 1 before.
void fill_with_outliers(Values& values, UnitStream& stream) {
  fill_lognormal(values, stream);
  for (double& value : values)
    if (value > 1.0 && stream.next_unit() < 0.2) value *= 1.0 + random_exponential(stream);
}

/// A fastest time and an exponential delay.
void fill_skewed(Values& values, UnitStream& stream) {
  for (double& value : values)
    value = 1.0 + scatter * (random_exponential(stream) - std::numbers::ln2);
}

/// Logarithms that remember half of the one before: neighbours are correlated by 0.5.
void fill_autocorrelated(Values& values, UnitStream& stream) {
  constexpr double memory = 0.5;
  double log = random_normal(stream);
  for (double& value : values) {
    value = std::exp(scatter * log);
    log = memory * log + std::sqrt(1.0 - memory * memory) * random_normal(stream);
  }
}

constexpr Law laws[] = {{"normal", fill_normal},
                        {"lognormal", fill_lognormal},
                        {"outliers", fill_with_outliers},
                        {"skewed", fill_skewed},
                        {"autocorrelated", fill_autocorrelated}};

/// 1.5 times as long as the others of the same rounds, which share a mood with them.
void fill_ratios(Values& ratios, const Law& law, UnitStream& stream) {
  Values others(ratios.size());
  law.fill(ratios, stream);
  law.fill(others, stream);
  for (std::size_t i = 0; i < ratios.size(); ++i) {
    const double mood = std::exp(0.2 * random_normal(stream));
    ratios[i] = (1.5 * mood * ratios[i]) / (mood * others[i]);
  }
}

/// How often a resample of `count` values has a median of at most this rank; count is odd.
double share_of_medians_up_to(std::size_t rank, std::size_t count) {
  const auto n = static_cast<double>(count), share = static_cast<double>(rank) / n;
  double sum = 0.0, choices = 1.0;
  for (std::size_t i = 0; i <= count; ++i) {
    const auto below = static_cast<double>(i);
    if (2 * i > count) sum += choices * std::pow(share, below) * std::pow(1.0 - share, n - below);
    choices *= (n - below) / (below + 1.0);
  }
  return sum;
}

/// The ranks at which the bootstrap's 95 % interval of a median ends if it resamples often enough:
/// a median of an odd number of values is one of them.
RankInterval bootstrap_ranks(std::size_t count) {
  std::size_t low = 1;
  while (share_of_medians_up_to(low, count) < 0.025) ++low;
  return {low, count + 1 - low};
}

bool holds(const Values& sorted, const RankInterval& ranks, double truth) {
  return sorted[ranks.low - 1] <= truth && truth <= sorted[ranks.high - 1];
}

class Coverage {
 public:
  explicit Coverage(ExperimentContext& context)
      : context_(context), sets_(data_sets(context.tier())) {}

  void measure() {
    for (const std::size_t count : {3u, 5u, 7u, 9u, 11u, 13u, 15u, 17u, 19u, 21u, 23u, 25u})
      measure_ranks(count);
    for (const std::size_t count : {3u, 5u, 9u, 25u})
      for (const Law& law : laws) measure_medians(count, law);
    for (const std::size_t count : {5u, 9u})
      for (const Law& law : laws) measure_exponents(count, law);
  }

 private:
  /// Exact coverage of both intervals, and how often the bootstrap itself, with as many resamples
  /// as it takes, ends at other ranks.
  void measure_ranks(std::size_t count) {
    context_.progress(fmt::format("ranks of {} values", count));
    const std::string name = fmt::format("ranks/{:02}", count);
    const RankInterval bootstrap = bootstrap_ranks(count);
    record_ranks(name + "/bootstrap", count, bootstrap);
    if (const auto exact = median_ranks(count))
      record_ranks(name + "/order_statistics", count, *exact);

    const std::int64_t tried = sets_ / 2000;
    CounterStream stream = next_stream();
    Values values(count);
    std::int64_t others = 0;
    for (std::int64_t i = 0; i < tried; ++i) {
      fill_skewed(values, stream);
      const Estimate estimate = median_estimate(values);
      std::sort(values.begin(), values.end());
      others +=
          estimate.low != values[bootstrap.low - 1] || estimate.high != values[bootstrap.high - 1];
    }
    record_count(name + "/bootstrap/other_ends", others, tried);
  }

  void record_ranks(const std::string& name, std::size_t count, const RankInterval& ranks) {
    context_.record(name + "/low", static_cast<std::int64_t>(ranks.low), "rank");
    context_.record(name + "/high", static_cast<std::int64_t>(ranks.high), "rank");
    context_.record(name + "/coverage", median_coverage(count, ranks));
  }

  void measure_medians(std::size_t count, const Law& law) {
    const auto exact = median_ranks(count);
    const RankInterval bootstrap = bootstrap_ranks(count);
    for (const bool paired : {false, true}) {
      const std::string name =
          fmt::format("{}/{:02}/{}", paired ? "paired_ratio" : "median", count, law.name);
      context_.progress(name);
      CounterStream stream = next_stream();
      const double truth = paired ? 1.5 : 1.0;
      std::int64_t by_bootstrap = 0, by_order = 0;
      Values values(count);
      for (std::int64_t i = 0; i < sets_; ++i) {
        paired ? fill_ratios(values, law, stream) : law.fill(values, stream);
        std::sort(values.begin(), values.end());
        by_bootstrap += holds(values, bootstrap, truth);
        by_order += exact && holds(values, *exact, truth);
      }
      record_count(name + "/bootstrap/covered", by_bootstrap, sets_);
      if (exact) record_count(name + "/order_statistics/covered", by_order, sets_);
    }
  }

  /// Times of sizes that double, which grow as the power 1.3.
  void measure_exponents(std::size_t count, const Law& law) {
    const std::string name = fmt::format("exponent/{:02}/{}", count, law.name);
    context_.progress(name);
    constexpr double truth = 1.3;
    CounterStream stream = next_stream();
    Values sizes(count), times(count);
    for (std::size_t i = 0; i < count; ++i) sizes[i] = std::exp2(10.0 + static_cast<double>(i));
    std::int64_t covered = 0;
    for (std::int64_t i = 0; i < sets_; ++i) {
      law.fill(times, stream);
      for (std::size_t k = 0; k < count; ++k) times[k] *= std::pow(sizes[k], truth);
      const Estimate exponent = fit_power_law(sizes, times).value().exponent;
      covered += exponent.low <= truth && truth <= exponent.high;
    }
    record_count(name + "/student/covered", covered, sets_);
  }

  void record_count(const std::string& name, std::int64_t count, std::int64_t of) {
    context_.record({.experiment = {},
                     .measurement = name,
                     .value = count,
                     .unit = "data sets",
                     .sample_size = of,
                     .seed = context_.seed()});
  }

  CounterStream next_stream() { return {context_.seed(), streams_++}; }

  ExperimentContext& context_;
  std::int64_t sets_;
  std::uint64_t streams_ = 0;
};

void record_interval_coverage(ExperimentContext& context) {
  Coverage(context).measure();
}

}  // namespace

extern const ExperimentDescriptor interval_coverage;
constinit const ExperimentDescriptor interval_coverage{
    .id = "suite/interval-coverage",
    .question =
        "Do 95 % intervals of medians, ratios and exponents hold the truth as often as "
        "they say?",
    .source = "[simulation]",
    .seconds = {1, 4, 20},
    .run = record_interval_coverage,
};

}  // namespace phytobench::experiments::suite
