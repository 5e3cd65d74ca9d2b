// SPDX-License-Identifier: MIT
// What density does to numbers and weight of plants: the laws of sections 2.2 and 2.5.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/overlap/lens.hpp"
#include "core/population/density_laws.hpp"
#include "core/random/counter_stream.hpp"
#include "core/statistics/reduced_major_axis.hpp"
#include "experiments/experiment.hpp"
#include "reference/oracles/alsweis_growth.hpp"

namespace phytobench::experiments::alsweis {

namespace {

namespace oracles = phytobench::oracles::alsweis::growth;

/// Relative to the second, or to 1 where that is smaller.
double difference(double value, double exact) {
  return std::abs(value - exact) / std::max(1.0, std::abs(exact));
}

/// The suite's laws beside the literal ones, at random points.
void record_agreement(ExperimentContext& context) {
  CounterStream stream(context.seed(), 0);
  const auto draw = [&](double low, double high) {
    return low + (high - low) * stream.next_unit();
  };
  double crowding = 0.0, both = 0.0, weight = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const double x = draw(0, 1000), m_d = draw(0, 0.1), m_i = draw(0, 1);
    crowding =
        std::max(crowding, difference(surviving_density(x, m_d), oracles::equation_2_2(x, m_d)));
    both = std::max(both,
                    difference(surviving_density(x, m_d, m_i), oracles::equation_2_3(x, m_d, m_i)));
    const double density = draw(0.01, 100), b = draw(0.1, 100), k = draw(0.5, 3);
    weight = std::max(
        weight, difference(thinned_weight({b, k}, density), oracles::equation_2_15(density, b, k)));
  }
  context.record("agreement/crowding_difference", crowding);
  context.record("agreement/both_deaths_difference", both);
  context.record("agreement/weight_difference", weight);
}

/// (2.2) with m_d = 0.01, so that no more than 100 plants are left.
void record_crowding(ExperimentContext& context) {
  constexpr double m_d = 0.01;
  context.record("crowding/of-1000", oracles::equation_2_2(1000, m_d), "plants");
  context.record("crowding/of-inverse", oracles::equation_2_2(1.0 / m_d, m_d), "plants");
  context.record("crowding/of-1e15", oracles::equation_2_2(1e15, m_d), "plants");
  context.record("crowding/twice-of-1000",
                 oracles::equation_2_2(oracles::equation_2_2(1000, m_d), m_d), "plants");
  int not_above = 0;
  double row = 0.0;
  for (int i = 1; i <= 1000; ++i) {
    not_above += !(oracles::equation_2_2(i, m_d) > oracles::equation_2_2(i - 1, m_d));
    double x = i;
    for (int n = 1; n <= 20; ++n) {
      x = oracles::equation_2_2(x, m_d);
      row = std::max(row, difference(x, oracles::equation_2_2(i, n * m_d)));
    }
  }
  context.record("crowding/not_above", not_above);
  context.record("crowding/row_difference", row);
}

/// (2.3): deaths for other reasons before those of crowding, and in the other order.
void record_other_deaths(ExperimentContext& context) {
  constexpr double m_d = 0.01;
  double composed = 0.0, with_all = 0.0;
  int not_above = 0;
  for (int i = 1; i <= 100; ++i)
    for (const double x : {1.0, 50.0, 1000.0}) {
      const double m_i = i / 100.0, left = oracles::equation_2_3(x, m_d, m_i);
      composed = std::max(composed, difference(left, oracles::equation_2_2(m_i * x, m_d)));
      not_above += !(left > oracles::equation_2_3(x, m_d, m_i - 0.01));
      with_all = std::max(
          with_all, difference(oracles::equation_2_3(x, m_d, 1.0), oracles::equation_2_2(x, m_d)));
    }
  context.record("other-deaths/difference_from_crowding_of_rest", composed);
  context.record("other-deaths/difference_without", with_all);
  context.record("other-deaths/not_above", not_above);
  context.record("other-deaths/of-1000", oracles::equation_2_3(1000, m_d, 0.5), "plants");
  context.record("other-deaths/other_order_of-1000", 0.5 * oracles::equation_2_2(1000, m_d),
                 "plants");
  context.record("other-deaths/of-1e15", oracles::equation_2_3(1e15, m_d, 0.5), "plants");
  context.record("other-deaths/slope_at_0", oracles::equation_2_3(1e-9, m_d, 0.5) / 1e-9);
}

/// The share that dies of raindrops: half of all seedlings are hit; of those a small one always
/// dies, a large one in one of four cases.
double share_killed(const std::vector<bool>& is_small) {
  double dead = 0.0;
  for (const bool small : is_small) dead += 0.5 * (small ? 1.0 : 0.25);
  return dead / static_cast<double>(is_small.size());
}

/// Whether deaths that depend on size must depend on density.
void record_raindrops(ExperimentContext& context) {
  for (const std::size_t plants : {4u, 64u, 1024u}) {
    std::vector<bool> as_elsewhere(plants), kept_small(plants, true);
    for (std::size_t i = 0; i < plants; ++i) as_elsewhere[i] = i % 2 == 0;
    kept_small[0] = false;  // one has the upper hand, the others stay small
    const std::string name = fmt::format("raindrops/plants-{}", plants);
    context.record(name + "/sizes_as_elsewhere", share_killed(as_elsewhere));
    context.record(name + "/sizes_kept_small", share_killed(kept_small));
  }
}

/// Part of its zone that a plant loses to one twice as large 2.5 m away, both scaled: (5.1).
void record_sizes(ExperimentContext& context) {
  for (const double scale : {0.9, 1.0, 1.2, 1.5, 2.0}) {
    const double overlap = lens_area(scale, 2.0 * scale, 2.5);
    context.record(fmt::format("size/scale-{}/loss", scale),
                   overlap / (2.0 * std::numbers::pi * scale * scale));
  }
}

/// (2.15) to (2.17): slopes of logarithms, and B.
void record_thinning(ExperimentContext& context) {
  constexpr double b = 80.0, k = 1.5;
  std::vector<double> log_density, log_weight, log_yield;
  double logarithms = 0.0, constant = 0.0;
  for (int i = 0; i <= 40; ++i) {
    const double density = std::pow(10.0, -2.0 + 0.1 * i),
                 weight = oracles::equation_2_15(density, b, k);
    log_density.push_back(std::log10(density));
    log_weight.push_back(std::log10(weight));
    log_yield.push_back(std::log10(weight * density));
    logarithms =
        std::max(logarithms, difference(log_weight.back(), oracles::equation_2_16(density, b, k)));
    constant = std::max(constant, difference(oracles::equation_2_17(weight, density, k),
                                             oracles::meaning_of_B_corrected(b)));
  }
  context.record("thinning/slope_of_weight", least_squares_line(log_density, log_weight)->slope);
  context.record("thinning/slope_of_yield", least_squares_line(log_density, log_yield)->slope);
  context.record("thinning/logarithm_difference", logarithms);
  context.record("thinning/constant_difference", constant);
  context.record("thinning/example/b", oracles::equation_2_17(10.0, 4.0, k));
  context.record("thinning/example/log_of_factor", oracles::meaning_of_B_corrected(b));
  context.record("thinning/example/log_of_density", oracles::meaning_of_B_as_printed(4.0));
}

void run(ExperimentContext& context) {
  record_agreement(context);
  record_crowding(context);
  record_other_deaths(context);
  record_raindrops(context);
  record_sizes(context);
  record_thinning(context);
}

}  // namespace

extern const ExperimentDescriptor density_laws;
constinit const ExperimentDescriptor density_laws{
    .id = "alsweis/density-laws",
    .question = "How many plants are left in a crowd, and how heavy are they?",
    .source = "[Alsweis] (2.2), (2.3), (2.15) to (2.17)",
    .seconds = {1, 1, 1},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
