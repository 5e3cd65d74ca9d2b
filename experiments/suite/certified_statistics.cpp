// SPDX-License-Identifier: MIT
// The statistics that judge all else, judged themselves: reference data sets with certified
// answers.
#include <cctype>
#include <cmath>

#include "core/statistics/log_relative_error.hpp"
#include "core/statistics/moments.hpp"
#include "core/statistics/nist_sets.hpp"
#include "core/statistics/power_law.hpp"
#include "core/statistics/reduced_major_axis.hpp"
#include "core/statistics/running_moments.hpp"
#include "experiments/experiment.hpp"

namespace phytobench::experiments::suite {

namespace {

/// "NumAcc1" -> "num_acc_1".
std::string key_of(const std::string& name) {
  std::string key;
  for (const char letter : name) {
    const auto byte = static_cast<unsigned char>(letter);
    if (!key.empty() && (std::isupper(byte) || std::isdigit(byte))) key += '_';
    key += static_cast<char>(std::tolower(byte));
  }
  return key;
}

/// Tenths are enough, and the same whatever logarithm the machine has.
double in_tenths(double digits) {
  return std::floor(10.0 * digits) / 10.0;
}

/// Where the answers of one function on one set go: nist/<set>/<statistic>/<function>/...
struct Place {
  ExperimentContext& context;
  std::string set;
  std::string function;

  void record(const std::string& statistic, double computed, double certified) const {
    const std::string name = path(statistic);
    context.record(name + "/certified", certified);
    context.record(name + "/computed", computed);
    context.record(name + "/digits", in_tenths(log_relative_error(computed, certified)), "digits");
  }

  /// Digits that the set's values still hold as doubles.
  void record_reachable(const std::string& statistic, long double exact, double certified) const {
    const double digits = log_relative_error(static_cast<double>(exact), certified);
    context.record(path(statistic) + "/reachable_digits", in_tenths(digits), "digits");
  }

 private:
  std::string path(const std::string& statistic) const {
    return "nist/" + key_of(set) + "/" + statistic + "/" + function;
  }
};

constexpr const char* mean_name = "mean";
constexpr const char* deviation_name = "standard_deviation";
constexpr const char* autocorrelation_name = "lag_1_autocorrelation";

/// The same in arithmetic so precise that only the rounding of the values themselves is left.
void record_reachable_moments(const Place& place, const UnivariateSet& set) {
  const auto n = static_cast<long double>(set.values.size());
  long double mean = 0.0L, squares = 0.0L, products = 0.0L, before = 0.0L;
  for (const double value : set.values) mean += value;
  mean /= n;
  for (const double value : set.values) {
    squares += (value - mean) * (value - mean);
    products += before * (value - mean);
    before = value - mean;
  }
  place.record_reachable(mean_name, mean, set.mean);
  place.record_reachable(deviation_name, std::sqrt(squares / (n - 1.0L)), set.standard_deviation);
  place.record_reachable(autocorrelation_name, products / squares, set.lag_1_autocorrelation);
}

/// The textbook's formula, which the suite does not use: what too few digits look like.
void record_sums_of_squares(const Place& place, const UnivariateSet& set) {
  double sum = 0.0, squares = 0.0;
  for (const double value : set.values) {
    sum += value;
    squares += value * value;
  }
  const auto n = static_cast<double>(set.values.size());
  const double variance = (squares - sum * sum / n) / (n - 1.0);
  place.record(mean_name, sum / n, set.mean);
  place.record(deviation_name, std::sqrt(std::max(0.0, variance)), set.standard_deviation);
}

void record_moments(ExperimentContext& context, const UnivariateSet& set) {
  const Place in_memory{context, set.name, "moments"};
  in_memory.record(mean_name, mean(set.values), set.mean);
  in_memory.record(deviation_name, standard_deviation(set.values), set.standard_deviation);
  in_memory.record(autocorrelation_name, lag_1_autocorrelation(set.values),
                   set.lag_1_autocorrelation);
  record_reachable_moments(in_memory, set);

  RunningMoments moments;
  for (const double value : set.values) moments.add(value);
  const Place one_by_one{context, set.name, "running_moments"};
  one_by_one.record(mean_name, moments.mean(), set.mean);
  one_by_one.record(deviation_name, moments.deviation(), set.standard_deviation);

  record_sums_of_squares({context, set.name, "sums_of_squares"}, set);
}

void record_regression(ExperimentContext& context, const RegressionSet& set) {
  const Place place{context, set.name, "polynomial_regression"};
  const LinearRegression fit = polynomial_regression(set.x, set.y, set.degree).value();
  for (std::size_t j = 0; j < set.coefficients.size(); ++j) {
    const std::string number = std::to_string(j);
    const RegressionCoefficient& certified = set.coefficients[j];
    place.record("coefficient_" + number, fit.coefficients[j].value, certified.value);
    place.record("deviation_" + number, fit.coefficients[j].standard_deviation,
                 certified.standard_deviation);
  }
  place.record("residual_deviation", fit.residual_deviation, set.residual_deviation);
  place.record("r_squared", fit.r_squared, set.r_squared);
}

/// The straight lines that the suite's experiments and its judge fit.
void record_lines(ExperimentContext& context, const RegressionSet& set) {
  const RegressionCoefficient& slope = set.coefficients[1];
  const StraightLine line = least_squares_line(set.x, set.y).value();
  const Place least_squares{context, set.name, "least_squares_line"};
  least_squares.record("slope", line.slope, slope.value);
  least_squares.record("slope_error", line.slope_error, slope.standard_deviation);
  least_squares.record("intercept", line.intercept, set.coefficients[0].value);
  least_squares.record("r_squared", line.r_squared, set.r_squared);

  // Its slope is that of least squares over the correlation.
  Place{context, set.name, "reduced_major_axis"}.record(
      "slope", reduced_major_axis(set.x, set.y).value().slope,
      slope.value / std::sqrt(set.r_squared));

  std::vector<double> x, y;  // halves keep e^y within the range of doubles
  for (const double value : set.x) x.push_back(std::exp(0.5 * value));
  for (const double value : set.y) y.push_back(std::exp(0.5 * value));
  const PowerLaw law = fit_power_law(x, y).value();
  constexpr double student_0975_34 = 2.032244509317719;  // R 4.2: qt(0.975, 34)
  const Place power_law{context, set.name, "power_law"};
  power_law.record("slope", law.exponent.value, slope.value);
  power_law.record("half_width", 0.5 * (law.exponent.high - law.exponent.low),
                   student_0975_34 * slope.standard_deviation);
}

void record_certified_statistics(ExperimentContext& context) {
  for (const UnivariateSet& set : nist_univariate_sets()) record_moments(context, set);
  for (const RegressionSet& set : nist_regression_sets()) {
    record_regression(context, set);
    if (set.degree == 1) record_lines(context, set);
  }
}

}  // namespace

extern const ExperimentDescriptor certified_statistics;
constinit const ExperimentDescriptor certified_statistics{
    .id = "suite/certified-statistics",
    .question =
        "In how many digits do means, deviations and regressions agree with certified "
        "values?",
    .source = "[NIST StRD] NumAcc1-4, Norris, Wampler1-5",
    .seconds = {0.1, 0.1, 0.1},
    .run = record_certified_statistics,
};

}  // namespace phytobench::experiments::suite
