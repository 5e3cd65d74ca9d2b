// SPDX-License-Identifier: MIT
#include "reference/errata_oracles.hpp"
#include "reference/oracles/alsweis_growth.hpp"

namespace phytobench {

namespace {

namespace growth = oracles::alsweis::growth;

constexpr double step = 0.01;  // of runs; the printed one is not smooth and keeps to it

/// All of one size.
double mean_of_equal_sizes(const Arguments& a, bool as_printed) {
  const auto n = static_cast<std::size_t>(a[0]);
  const std::vector<double> history(n + 1, a[1]);
  return as_printed ? growth::equation_4_8_as_printed(history, n)
                    : growth::equation_4_8_corrected(history, n);
}

OracleTable single_plants() {
  return {
      // delta, v, k, w
      {"alsweis/relative-growth-rate",
       {4, [](const Arguments& a) { return growth::initial_rate_as_printed(a[2], a[0]); },
        [](const Arguments& a) { return growth::relative_rate(a[1], a[2], a[3], a[0]); }}},
      // b, D_m
      {"alsweis/meaning-of-b",
       {2, [](const Arguments& a) { return growth::meaning_of_B_as_printed(a[1]); },
        [](const Arguments& a) { return growth::meaning_of_B_corrected(a[0]); }}},
      // n, size
      {"alsweis/equation-4.8",
       {2, [](const Arguments& a) { return mean_of_equal_sizes(a, true); },
        [](const Arguments& a) { return mean_of_equal_sizes(a, false); }}},
      // MGR
      {"alsweis/highest-growth-rate",
       {1, [](const Arguments& a) { return a[0]; },
        [](const Arguments& a) { return growth::highest_rate_5_8(a[0]); }}},
  };
}

OracleTable plants_of_section_4_3() {
  return {
      // time: the smaller of two plants, at first 1 and 2; k = 0.1, w = 10, p = 1
      {"alsweis/smaller-of-two",
       {1,
        [](const Arguments& a) {
          return growth::run_4_3({1, 2}, 0.1, 10, 1, a[0], step, true).v_1;
        },
        [](const Arguments& a) {
          return growth::run_4_3({1, 2}, 0.1, 10, 1, a[0], step, false).v_1;
        }}},
      // v, k, w, delta, a: growth without neighbours
      {"alsweis/growth-without-neighbours",
       {5,
        [](const Arguments& a) {
          return growth::section_4_3(a[0], growth::sum_4_3_as_printed({}, 0), a[1], a[2], a[3],
                                     a[4]);
        },
        [](const Arguments& a) {
          return growth::section_4_3(a[0], growth::sum_4_3_corrected(a[0], {}, {}), a[1], a[2],
                                     a[3], a[4]);
        }}},
      // sizes and shares of two neighbours: their part of the sum
      {"alsweis/sum-over-neighbours",
       {4,
        [](const Arguments& a) {
          return growth::sum_4_3_as_printed({a[0], a[2]}, a[1] + a[3]);
        },
        [](const Arguments& a) {
          return growth::sum_4_3_corrected(0, {a[0], a[2]}, {a[1], a[3]});
        }}},
      // k, delta
      {"alsweis/growth-rate-without-competition",
       {2, [](const Arguments& a) { return a[0] / (1 - a[1]); },
        [](const Arguments& a) { return a[0] / (a[1] - 1); }}},
      // overlap, own area, size of the neighbour, w: the bracket for delta = 2, without the plant
      // itself
      {"alsweis/growth-bracket",
       {4, [](const Arguments& a) { return 1 - growth::sum_4_3_as_printed({a[2]}, a[0]) / a[3]; },
        [](const Arguments& a) {
          return 1 - growth::sum_4_3_corrected(0, {a[2]}, {a[0] / a[1]}) / a[3];
        }}},
      // time: the smaller plant of the dashed line, with a = 1 as printed and with a = 2
      {"alsweis/figure-4.5-dashed",
       {1,
        [](const Arguments& a) {
          return growth::run_figure_4_5({1, 2}, 0.0667, 10, 2, 1, a[0], step).v_1;
        },
        [](const Arguments& a) {
          return growth::run_figure_4_5({1, 2}, 0.0667, 10, 2, 2, a[0], step).v_1;
        }}},
  };
}

}  // namespace

OracleTable alsweis_growth_oracles() {
  OracleTable all = single_plants();
  all.merge(plants_of_section_4_3());
  return all;
}

}  // namespace phytobench
