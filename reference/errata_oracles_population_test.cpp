// SPDX-License-Identifier: MIT
#include "reference/errata_oracles.hpp"
#include "reference/oracles/alsweis_population.hpp"

namespace phytobench {

namespace {

namespace population = oracles::alsweis::population;

/// The largest count after some years: alpha, K, gamma, start, years. As printed each year is
/// (2.14), which takes any gamma below 1.
double checkerboard(const Arguments& a, bool as_printed) {
  const double alpha = a[0], beta = -(1.0 + alpha) / a[1], gamma = a[2];
  return population::largest_of_checkerboard(
      a[3], static_cast<int>(a[4]), [&](const population::CellCounts& N) {
        return as_printed ? population::equation_2_14(N, alpha, beta, gamma)
                          : population::grown_then_migrated(N, alpha, beta, gamma);
      });
}

OracleTable cells() {
  return {
      // r, K, N
      {"alsweis/equation-2.10",
       {3,
        [](const Arguments& a) { return population::equation_2_10_as_printed(a[0], a[1], a[2]); },
        [](const Arguments& a) { return population::equation_2_10_corrected(a[0], a[1], a[2]); }}},
      // alpha, K, gamma, start, years
      {"alsweis/equation-2.14-checkerboard",
       {5, [](const Arguments& a) { return checkerboard(a, true); },
        [](const Arguments& a) { return checkerboard(a, false); }}},
      // z
      {"alsweis/heaviside-operator",
       {1, [](const Arguments& a) { return population::heaviside_step(a[0]); },
        [](const Arguments& a) { return population::positive_part(a[0]); }}},
      // alpha; 1 is chaos
      {"alsweis/chaos-of-fertility",
       {1, [](const Arguments& a) { return a[0] >= 0.3 ? 1.0 : 0.0; },
        [](const Arguments& a) { return population::is_chaotic(a[0]) ? 1.0 : 0.0; }}},
  };
}

}  // namespace

OracleTable alsweis_population_oracles() {
  OracleTable all = cells();
  // r, lambda
  all["alsweis/equation-4.6"] = {
      2, [](const Arguments& a) { return population::equation_4_6_as_printed(a[0], a[1]); },
      [](const Arguments& a) { return population::equation_4_6_corrected(a[0], a[1]); }};
  return all;
}

}  // namespace phytobench
