// SPDX-License-Identifier: MIT
#include "core/statistics/nist_sets.hpp"

#include <array>
#include <utility>

namespace phytobench {

namespace {

/// 1001 values: the middle, then low and high in turn.
UnivariateSet alternating(std::string name, double low, double middle, double high) {
  UnivariateSet set{.name = std::move(name),
                    .values = {middle},
                    .mean = middle,
                    .standard_deviation = 0.1,
                    .lag_1_autocorrelation = -0.999};
  for (int pair = 0; pair < 500; ++pair) {
    set.values.push_back(low);
    set.values.push_back(high);
  }
  return set;
}

/// What Wampler3 adds to the polynomial of Wampler1.
constexpr std::array<double, 21> wampler_residuals = {
    759,   -2048, 2048,  -2048, 2523,  -2048, 2048,  -2048, 1838,  -2048, 2048,
    -2048, 1838,  -2048, 2048,  -2048, 2523,  -2048, 2048,  -2048, 759};

/// A sum of powers of 0 to 20, from whole numbers: sum of base^(5 - d) * x^d over base^5. Exact for
/// base 1, rounded once for base 10.
RegressionSet wampler(std::string name, int base, double residual_factor) {
  RegressionSet set{.name = std::move(name), .degree = 5};
  for (int x = 0; x <= 20; ++x) {
    double sum = 0.0, divisor = 1.0;
    for (int d = 0; d <= set.degree; ++d) {
      double term = 1.0;
      for (int i = 0; i < set.degree; ++i) term *= i < d ? x : base;
      sum += term;
      if (d > 0) divisor *= base;
    }
    set.x.push_back(x);
    set.y.push_back(sum / divisor +
                    residual_factor * wampler_residuals[static_cast<std::size_t>(x)]);
  }
  return set;
}

/// Certified for a factor of 1; with the factor grow the residuals, and the deviations with them.
RegressionSet scattered_wampler(std::string name, double factor, double r_squared) {
  RegressionSet set = wampler(std::move(name), 1, factor);
  for (const double deviation : {2152.32624678170, 2363.55173469681, 779.343524331583,
                                 101.475507550350, 5.64566512170752, 0.112324854679312})
    set.coefficients.push_back({1.0, factor * deviation});
  set.residual_deviation = factor * 2360.14502379268;
  set.r_squared = r_squared;
  return set;
}

RegressionSet exact_wampler(std::string name, int base, const std::array<double, 6>& coefficients) {
  RegressionSet set = wampler(std::move(name), base, 0.0);
  for (const double coefficient : coefficients) set.coefficients.push_back({coefficient, 0.0});
  set.r_squared = 1.0;
  return set;
}

RegressionSet norris() {
  return {.name = "Norris",
          .degree = 1,
          .x = {0.2, 337.4, 118.2, 884.6, 10.1,  226.5, 666.3, 996.3, 448.6, 777.0, 558.2, 0.4,
                0.6, 775.5, 666.9, 338.0, 447.5, 11.6,  556.0, 228.1, 995.8, 887.6, 120.2, 0.3,
                0.3, 556.8, 339.1, 887.2, 999.0, 779.0, 11.1,  118.3, 229.2, 669.1, 448.9, 0.5},
          .y = {0.1, 338.8, 118.1, 888.0, 9.2,   228.1, 668.5, 998.5, 449.1, 778.9, 559.2, 0.3,
                0.1, 778.1, 668.8, 339.3, 448.9, 10.8,  557.7, 228.3, 998.0, 888.8, 119.6, 0.3,
                0.6, 557.6, 339.3, 888.0, 998.5, 778.9, 10.2,  117.6, 228.9, 668.4, 449.2, 0.2},
          .coefficients = {{-0.262323073774029, 0.232818234301152},
                           {1.00211681802045, 0.000429796848199937}},
          .residual_deviation = 0.884796396144373,
          .r_squared = 0.999993745883712};
}

}  // namespace

std::vector<UnivariateSet> nist_univariate_sets() {
  return {{.name = "NumAcc1",
           .values = {10000001, 10000003, 10000002},
           .mean = 10000002,
           .standard_deviation = 1,
           .lag_1_autocorrelation = -0.5},
          alternating("NumAcc2", 1.1, 1.2, 1.3),
          alternating("NumAcc3", 1000000.1, 1000000.2, 1000000.3),
          alternating("NumAcc4", 10000000.1, 10000000.2, 10000000.3)};
}

std::vector<RegressionSet> nist_regression_sets() {
  return {norris(),
          exact_wampler("Wampler1", 1, {1, 1, 1, 1, 1, 1}),
          exact_wampler("Wampler2", 10, {1, 0.1, 0.01, 0.001, 0.0001, 0.00001}),
          scattered_wampler("Wampler3", 1, 0.999995559025820),
          scattered_wampler("Wampler4", 100, 0.957478440825662),
          scattered_wampler("Wampler5", 10000, 0.00224668921574940)};
}

}  // namespace phytobench
