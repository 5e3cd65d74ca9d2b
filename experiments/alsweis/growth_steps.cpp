// SPDX-License-Identifier: MIT
// The steps of time in which plants grow, the mean over the last of them, and the growth of a
// stem's radius.
#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "core/competition/competition_parameters.hpp"
#include "core/population/growth_integrators.hpp"
#include "core/population/richards_growth.hpp"
#include "experiments/alsweis/golden_section.hpp"
#include "experiments/experiment.hpp"
#include "reference/oracles/alsweis_growth.hpp"

namespace phytobench::experiments::alsweis {

namespace {

namespace oracles = phytobench::oracles::alsweis::growth;

// Of figure 4.5; the start is that of its smaller plant.
constexpr double k = 0.1, w = 10.0, start = 1.0;
constexpr RichardsGrowth logistic{k, w, 2.0};

/// (5.8) and (5.9).
void record_radius(ExperimentContext& context) {
  constexpr double highest = 0.05, largest = 0.5;  // MGR in m per step, R_max in m
  const auto rate = [&](double r) { return oracles::equation_5_8(highest, r, largest); };
  context.record("radius/rate_at_0", rate(0.0), "m per step");
  context.record("radius/rate_at_largest", rate(largest), "m per step");
  const double place = place_of_highest(rate, 0.0, largest);
  context.record("radius/fastest_radius", place, "m");
  context.record("radius/fastest_rate", rate(place), "m per step");
  context.record("radius/printed_highest_rate", highest, "m per step");
  const RichardsGrowth law = radius_growth(highest, largest);
  const double end = richards_size(law, 0.05, 60.0);
  context.record("radius/after-60", end, "m");
  context.record("radius/runge_kutta_difference",
                 std::abs(integrated(RungeKutta4{}, 0.05, 60.0, 6000, rate) / end - 1.0));
  double least = highest, most = 0.0, product = 0.0;
  for (int i = 0; i <= 100; ++i)
    for (int j = 0; j <= 100; ++j) {
      const double r = largest * i / 100.0, loss = j / 100.0;
      const double growth = rate(r) * growth_factor(loss);
      least = std::min(least, growth);
      most = std::max(most, growth);
      if (i == 0) continue;
      product = std::max(product, std::abs(richards_rate(law, r) * growth_factor(loss) - growth));
    }
  context.record("radius/least_growth", least, "m per step");
  context.record("radius/most_growth", most, "m per step");
  context.record("radius/suite_difference", product, "m per step");
}

/// (4.7) and (4.8): one step of a logistic plant of size 1, and means of a size that stays 1.
void record_steps(ExperimentContext& context) {
  const auto rate = [](double v) { return oracles::equation_2_1(v, k, w, 2.0); };
  context.record("step/explicit", ExplicitEuler{}(start, 1.0, rate));
  context.record("step/exact", richards_size(logistic, start, 1.0));
  context.record("step/as_printed", oracles::equation_4_7_as_printed(start, rate));
  context.record("step/implicit", implicit_euler_step(start, 1.0, rate).value_or(0.0));
  const double exact = richards_size(logistic, start, 20.0);
  for (const int steps : {200, 400, 800, 1600}) {
    double v = start;
    for (int i = 0; i < steps; ++i) v = implicit_euler_step(v, 20.0 / steps, rate).value_or(0.0);
    const std::string name = fmt::format("step-{}", steps);
    context.record(name + "/length", 20.0 / steps);
    context.record(name + "/implicit_error", std::abs(v - exact));
    context.record(
        name + "/explicit_error",
        std::abs(integrated(ExplicitEuler{}, start, 20.0, static_cast<std::size_t>(steps), rate) -
                 exact));
  }
  for (const std::size_t n : {1u, 5u, 10u}) {
    const std::vector<double> ones(n + 1, 1.0);
    context.record(fmt::format("mean-{}/as_printed", n), oracles::equation_4_8_as_printed(ones, n));
    context.record(fmt::format("mean-{}/corrected", n), oracles::equation_4_8_corrected(ones, n));
  }
}

void run(ExperimentContext& context) {
  record_radius(context);
  record_steps(context);
}

}  // namespace

extern const ExperimentDescriptor growth_steps;
constinit const ExperimentDescriptor growth_steps{
    .id = "alsweis/growth-steps",
    .question = "Which step do plants take, and how fast does a stem grow at most?",
    .source = "[Alsweis] (4.7), (4.8), (5.8), (5.9)",
    .seconds = {1, 1, 1},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
