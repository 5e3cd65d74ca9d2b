// SPDX-License-Identifier: MIT
// Tail probabilities, quantiles and shares beside closed forms and an exact algorithm.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <vector>

#include "core/statistics/chi_square.hpp"
#include "core/statistics/f_distribution.hpp"
#include "core/statistics/gini.hpp"
#include "core/statistics/kolmogorov_smirnov.hpp"
#include "core/statistics/log_relative_error.hpp"
#include "core/statistics/median_interval.hpp"
#include "core/statistics/order_statistics.hpp"
#include "core/statistics/power_law.hpp"
#include "core/statistics/reduced_major_axis.hpp"
#include "experiments/experiment.hpp"
#include "reference/oracles/exact_kolmogorov.hpp"

namespace phytobench::experiments::suite {

namespace {

constexpr double pi = std::numbers::pi;

/// How far the answers of one function are from exact ones.
class Comparison {
 public:
  void add(double computed, double exact) {
    ++values_;
    digits_ = std::min(digits_, log_relative_error(computed, exact));
    difference_ = std::max(difference_, std::abs(computed - exact));
  }

  /// exact/<name>/{digits,largest_difference,judge}.
  void record(ExperimentContext& context, const std::string& name, const std::string& judge) const {
    const std::string path = "exact/" + name;
    const auto put = [&](const char* what, double value, const char* unit) {
      context.record({.experiment = {},
                      .measurement = path + what,
                      .value = value,
                      .unit = unit,
                      .sample_size = values_});
    };
    put("/digits", std::floor(10.0 * digits_) / 10.0, "digits");
    put("/largest_difference", difference_, "1");
    context.record(path + "/judge", judge, "text");
  }

 private:
  std::int64_t values_ = 0;
  double digits_ = most_digits;
  double difference_ = 0.0;
};

/// Counts around 100 in some cells, and Pearson's statistic of them.
struct Counts {
  std::vector<std::int64_t> of_cells;
  double chi_square = 0.0;
};

Counts counts_off_by(std::size_t cells, std::int64_t off) {
  Counts counts{std::vector<std::int64_t>(cells, 100), 0.0};
  counts.of_cells.front() += off;
  counts.of_cells.back() -= off;
  counts.chi_square = 2.0 * static_cast<double>(off * off) / 100.0;
  return counts;
}

void record_chi_square(ExperimentContext& context) {
  Comparison one, two, four;
  for (std::int64_t off = 1; off <= 90; ++off) {
    const Counts in_2 = counts_off_by(2, off), in_3 = counts_off_by(3, off),
                 in_5 = counts_off_by(5, off);
    const double half = 0.5 * in_2.chi_square;
    one.add(uniformity_p_value(in_2.of_cells), std::erfc(std::sqrt(half)));
    two.add(uniformity_p_value(in_3.of_cells), std::exp(-half));
    four.add(uniformity_p_value(in_5.of_cells), std::exp(-half) * (1.0 + half));
  }
  one.record(context, "chi_square_tail/1_degree", "erfc(sqrt(x / 2))");
  two.record(context, "chi_square_tail/2_degrees", "exp(-x / 2)");
  four.record(context, "chi_square_tail/4_degrees", "exp(-x / 2) (1 + x / 2)");
}

void record_f(ExperimentContext& context) {
  Comparison tail, quantiles, cauchy_tail, cauchy_quantiles;
  for (const double m : {1.0, 2.0, 7.0, 30.0, 200.0})
    for (int k = -20; k <= 20; ++k) {
      const double x = std::exp(0.2 * k);
      const double exact = std::pow(1.0 + 2.0 * x / m, -0.5 * m);
      tail.add(f_tail(x, {2.0, m}), exact);
      if (exact > 0.001 && exact < 0.999)
        quantiles.add(f_quantile(1.0 - exact, {2.0, m}),
                      0.5 * m * std::expm1(-2.0 / m * std::log(1.0 - (1.0 - exact))));
    }
  for (int k = 1; k < 100; ++k) {
    const double p = k / 100.0, root = std::tan(0.5 * pi * p);
    cauchy_tail.add(f_tail(root * root, {1.0, 1.0}), 1.0 - p);
    cauchy_quantiles.add(f_quantile(p, {1.0, 1.0}), root * root);
  }
  tail.record(context, "f_tail/2_and_m_degrees", "(1 + 2 x / m)^(-m / 2)");
  quantiles.record(context, "f_quantile/2_and_m_degrees", "m / 2 ((1 - p)^(-2 / m) - 1)");
  cauchy_tail.record(context, "f_tail/1_and_1_degree", "1 - 2 / pi arctan(sqrt(x))");
  cauchy_quantiles.record(context, "f_quantile/1_and_1_degree", "tan(pi p / 2)^2");
}

/// Quantile of Student's t with 1, 2 or 4 degrees of freedom.
double student_quantile(int degrees, double p) {
  if (degrees == 1) return std::tan(pi * (p - 0.5));
  const double a = 4.0 * p * (1.0 - p);
  if (degrees == 2) return 2.0 * (p - 0.5) * std::sqrt(2.0 / a);
  return 2.0 * std::sqrt(std::cos(std::acos(std::sqrt(a)) / 3.0) / std::sqrt(a) - 1.0);
}

/// Half the interval of a power law's exponent over the standard error of the slope.
void record_student(ExperimentContext& context) {
  Comparison all;
  for (const int degrees : {1, 2, 4}) {
    std::vector<double> x, y, log_x, log_y;
    for (int i = 0; i < degrees + 2; ++i) {
      log_x.push_back(i);
      log_y.push_back(i % 2 == 0 ? 0.25 : -0.5);
      x.push_back(std::exp(log_x.back()));
      y.push_back(std::exp(log_y.back()));
    }
    const double error = least_squares_line(log_x, log_y).value().slope_error;
    for (const double confidence : {0.5, 0.8, 0.9, 0.95, 0.99, 0.999}) {
      const Estimate exponent = fit_power_law(x, y, confidence).value().exponent;
      all.add(0.5 * (exponent.high - exponent.low) / error,
              student_quantile(degrees, 0.5 + 0.5 * confidence));
    }
  }
  all.record(context, "student_interval/1_2_4_degrees", "closed forms of Student's quantile");
}

void record_order_statistics(ExperimentContext& context) {
  Comparison type_7, shares, coverage;
  for (int n = 2; n <= 50; ++n) {
    std::vector<double> values;  // 0 to n - 1, not in order
    for (int i = 0; i < n; ++i) values.push_back(i);
    std::reverse(values.begin(), values.begin() + n / 2);
    for (int k = 0; k <= 40; ++k) type_7.add(quantile(values, k / 40.0), k / 40.0 * (n - 1));
    for (double& value : values) value += 1.0;
    shares.add(gini_coefficient(values), (n - 1.0) / (3.0 * n));

    double sum = 0.0, term = std::exp2(-n);  // C(n, i) / 2^n; up to n = 50 all are exact
    std::vector<double> up_to;
    for (int i = 0; i <= n; ++i) {
      up_to.push_back(sum += term);
      term = term * (n - i) / (i + 1);
    }
    for (int low = 1; 2 * low <= n; ++low)
      coverage.add(
          median_coverage(static_cast<std::size_t>(n),
                          {static_cast<std::size_t>(low), static_cast<std::size_t>(n + 1 - low)}),
          up_to[static_cast<std::size_t>(n - low)] - up_to[static_cast<std::size_t>(low - 1)]);
  }
  type_7.record(context, "quantile/type_7", "p (n - 1) for the numbers 0 to n - 1");
  shares.record(context, "gini_coefficient/1_to_n", "(n - 1) / (3 n) for the numbers 1 to n");
  coverage.record(context, "median_coverage/2_to_50_values", "sums of C(n, i) / 2^n");
}

/// An approximation, and meant as one: its header says how far it may be off.
void record_kolmogorov(ExperimentContext& context) {
  for (const int n : {10, 25, 100}) {
    Comparison all, judged;
    for (int k = 1; k < 100; ++k) {
      const double d = k / 100.0;
      const double exact = 1.0 - oracles::kolmogorov_distribution(n, d);
      if (exact < 0.001) break;
      const double ours = kolmogorov_p_value(d, static_cast<std::size_t>(n));
      all.add(ours, exact);
      if (exact >= 0.01 && exact <= 0.1) judged.add(ours, exact);
    }
    const std::string count = std::to_string(n) + "_values";
    const std::string judge = "Durbin's matrix, exact (Marsaglia, Tsang and Wang 2003)";
    all.record(context, "kolmogorov_p_value/" + count, judge);
    judged.record(context, "kolmogorov_p_value/" + count + "_p_from_0.01_to_0.1", judge);
  }
}

void record_exact_distributions(ExperimentContext& context) {
  record_chi_square(context);
  record_f(context);
  record_student(context);
  record_order_statistics(context);
  record_kolmogorov(context);
}

}  // namespace

extern const ExperimentDescriptor exact_distributions;
constinit const ExperimentDescriptor exact_distributions{
    .id = "suite/exact-distributions",
    .question = "Are tail probabilities, quantiles and shares those of closed forms?",
    .source = "[closed forms]",
    .seconds = {0.1, 0.1, 0.1},
    .run = record_exact_distributions,
};

}  // namespace phytobench::experiments::suite
