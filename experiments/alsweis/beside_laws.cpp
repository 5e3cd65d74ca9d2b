// SPDX-License-Identifier: MIT
#include "experiments/alsweis/beside_laws.hpp"

#include <algorithm>
#include <numbers>
#include <span>

#include "core/statistics/kolmogorov_smirnov.hpp"

namespace phytobench::experiments::alsweis {

namespace {

constexpr double pi = std::numbers::pi;

/// Probability that the i-th arrival of a process of unit rate comes after x: fewer than i until
/// then. Also the tail of chi-square at 2 x with 2 i degrees of freedom.
double gamma_tail(std::int64_t i, double x) {
  double term = 1.0, sum = 1.0;
  for (std::int64_t k = 1; k < i; ++k) {
    term *= x / static_cast<double>(k);
    sum += term;
  }
  return std::exp(-x) * sum;
}

/// Cells of `width` numbers each, the outer two open; an odd number of them, because gamma_tail()
/// knows chi-square for even degrees of freedom only.
struct NumberCells {
  std::int64_t first, width, cells;

  std::size_t of(std::int64_t number) const {
    return static_cast<std::size_t>(
        std::clamp((number - first) / width, std::int64_t{0}, cells - 1));
  }
};

/// About four cells per standard deviation, to two of them on either side.
NumberCells number_cells(double mean) {
  const double deviation = std::sqrt(mean);
  const std::int64_t width = std::max(std::int64_t{1}, std::int64_t{std::lround(deviation / 4.0)});
  const auto half = static_cast<std::int64_t>(2.0 * deviation / static_cast<double>(width));
  const std::int64_t first = std::int64_t{std::lround(mean)} - half * width;
  return {std::max(std::int64_t{0}, first), width, 2 * half + 1};
}

/// Pearson's chi-square test of numbers against Poisson's law.
double poisson_p_value(std::span<const double> counts, double mean) {
  const NumberCells cells = number_cells(mean);
  std::vector<double> observed(static_cast<std::size_t>(cells.cells), 0.0), share = observed;
  for (const double count : counts) observed[cells.of(static_cast<std::int64_t>(count))] += 1.0;
  double probability = std::exp(-mean), rest = 1.0;
  for (std::int64_t k = 0; k < cells.first + cells.width * (cells.cells - 1); ++k) {
    share[cells.of(k)] += probability;
    rest -= probability;
    probability *= mean / static_cast<double>(k + 1);
  }
  share.back() = rest;
  double statistic = 0.0;
  for (std::size_t cell = 0; cell < share.size(); ++cell) {
    const double expected = share[cell] * static_cast<double>(counts.size());
    statistic += (observed[cell] - expected) * (observed[cell] - expected) / expected;
  }
  return gamma_tail((cells.cells - 1) / 2, 0.5 * statistic);
}

}  // namespace

Law gamma_law(double i) {
  return {i, i, 3.0 * i * i + 6.0 * i};
}

Law poisson_law(double mean) {
  return {mean, mean, mean + 3.0 * mean * mean};
}

Law distance_law(double i) {
  const auto raw = [i](double power) {
    return std::tgamma(i + 0.5 * power) / (std::tgamma(i) * std::pow(pi, 0.5 * power));
  };
  const double mean = raw(1), square = raw(2);
  return {mean, square - mean * mean,
          raw(4) - 4.0 * mean * raw(3) + 6.0 * mean * mean * square - 3.0 * std::pow(mean, 4)};
}

void record_of_sample(ExperimentContext& context, const std::string& name, double value,
                      std::int64_t size, const std::string& unit) {
  context.record({.experiment = {},
                  .measurement = name,
                  .value = value,
                  .unit = unit,
                  .sample_size = size,
                  .seed = context.seed()});
}

void record_moments(ExperimentContext& context, const Sample& sample, const Law& law) {
  const auto size = static_cast<std::int64_t>(sample.values.size());
  const auto n = static_cast<double>(size);
  double sum = 0.0, off_squared = 0.0;
  for (const double value : sample.values) sum += value;
  const double mean = sum / n;
  for (const double value : sample.values) off_squared += (value - mean) * (value - mean);
  const double variance = off_squared / (n - 1.0);
  const double mean_error = std::sqrt(law.variance / n);
  const double variance_error = std::sqrt((law.fourth - law.variance * law.variance) / n);
  const std::string squared_unit = sample.unit == "1" ? "1" : sample.unit + "^2";
  context.record({.experiment = {},
                  .measurement = sample.name + "/mean",
                  .value = mean,
                  .unit = sample.unit,
                  .sample_size = size,
                  .spread = std::sqrt(variance),
                  .seed = context.seed()});
  record_of_sample(context, sample.name + "/variance", variance, size, squared_unit);
  record_of_sample(context, sample.name + "/mean_deviation", (mean - law.mean) / mean_error, size,
                   "standard errors");
  record_of_sample(context, sample.name + "/variance_deviation",
                   (variance - law.variance) / variance_error, size, "standard errors");
}

void record_arrival_fit(ExperimentContext& context, const std::string& name, std::int64_t i,
                        std::vector<double> arrivals_of_i) {
  for (double& q : arrivals_of_i) q = 1.0 - gamma_tail(i, q);
  record_of_sample(context, name + "/ks_p_value", kolmogorov_uniformity_p_value(arrivals_of_i),
                   static_cast<std::int64_t>(arrivals_of_i.size()));
}

void record_numbers(ExperimentContext& context, const Sample& counts, double mean) {
  record_moments(context, counts, poisson_law(mean));
  record_of_sample(context, counts.name + "/chi_square_p_value",
                   poisson_p_value(counts.values, mean),
                   static_cast<std::int64_t>(counts.values.size()));
}

}  // namespace phytobench::experiments::alsweis
