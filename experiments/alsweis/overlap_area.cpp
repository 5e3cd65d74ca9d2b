// SPDX-License-Identifier: MIT
// The area that two discs have in common: appendix A as printed and corrected, and the suite's own
// form against a hundred digits.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/overlap/lens.hpp"
#include "core/parallel/for_blocks.hpp"
#include "core/random/counter_stream.hpp"
#include "experiments/alsweis/lens_laws.hpp"
#include "experiments/experiment.hpp"
#include "reference/oracles/alsweis_exact_lens.hpp"
#include "reference/oracles/alsweis_overlap.hpp"

namespace phytobench::experiments::alsweis {

namespace {

namespace oracles = phytobench::oracles::alsweis;

/// Pairs with r <= s at which the three cases of (A.4) show what they are.
void record_examples(ExperimentContext& context) {
  struct Example {
    const char* name;
    double r, s, distance;
  };
  for (const Example& e : {Example{"equal", 1, 1, 1 + 1e-12}, Example{"three-and-five", 3, 5, 4},
                           Example{"two-and-five", 2, 5, 4}, Example{"nearly-inside", 1, 1.2, 0.9},
                           Example{"half-inside", 1, 1.5, 0.75},
                           Example{"mutation-killer", 1, std::numbers::sqrt2, 1}}) {
    const std::string name = std::string("examples/") + e.name;
    context.record(name + "/printed", oracles::equation_a4_as_printed(e.r, e.s, e.distance),
                   "area");
    context.record(name + "/lens", lens_area(e.r, e.s, e.distance), "area");
  }
}

/// How often the printed form is right, for radii uniform in (0, 1) and centers within reach.
void record_shares(ExperimentContext& context) {
  constexpr int draws = 200'000;
  CounterStream stream(context.seed(), 0);
  int right = 0, undefined = 0;
  for (int i = 0; i < draws; ++i) {
    const double a = stream.next_unit(), b = stream.next_unit();
    const double r = std::min(a, b), s = std::max(a, b), distance = (r + s) * stream.next_unit();
    const double printed = oracles::equation_a4_as_printed(r, s, distance);
    undefined += std::isnan(printed);
    right += std::abs(printed - lens_area(r, s, distance)) <= 1e-9 * r * r;
  }
  const auto share = [&](const char* name, int count) {
    context.record({.experiment = {},
                    .measurement = std::string("printed/") + name,
                    .value = static_cast<double>(count) / draws,
                    .sample_size = draws});
  };
  share("right", right);
  share("wrong", draws - right - undefined);
  share("undefined", undefined);
}

/// Both sides of the printed form's second boundary, d = r_i.
void record_jumps(ExperimentContext& context) {
  for (const int tenths : {10, 12, 15, 19}) {
    const double s = tenths / 10.0;
    const std::string name = fmt::format("jump/radius-{}", tenths);
    context.record(name + "/left", oracles::equation_a4_as_printed(1, s, 1), "area");
    context.record(name + "/right", oracles::equation_a4_as_printed(1, s, 1 + 1e-12), "area");
  }
}

int hard_cases(Tier tier) {
  return tier == Tier::full ? 1'000'000 : tier == Tier::quick ? 20'000 : 2'000;
}

struct Pair {
  double r, s, distance;
};

/// Radii from 1e-9 to 1e9, almost or nearly equal, alike or worlds apart.
Pair hard_pair(int number, CounterStream& stream) {
  const double r = std::pow(10.0, 18.0 * stream.next_unit() - 9.0);
  constexpr double spreads[] = {1e-10, 1e-3, 1.0, 18.0};
  const double spread = spreads[number / 6 % 4];
  const double s = std::clamp(r * std::pow(10.0, spread * (stream.next_unit() - 0.5)), 1e-9, 1e9);
  return {r, s, oracles::hard_distance(r, s, number, stream.next_unit())};
}

/// Of the suite's own form and of the textbook's, against a hundred digits.
void record_errors(ExperimentContext& context) {
  const int cases = hard_cases(context.tier());
  CounterStream stream(context.seed(), 1);
  std::vector<Pair> pairs;
  for (int i = 0; i < cases; ++i) pairs.push_back(hard_pair(i, stream));
  std::vector<double> errors(pairs.size()), textbook_errors(pairs.size());
  constexpr std::size_t batch = 16'384;
  for (std::size_t first = 0; first < pairs.size(); first += batch) {
    context.progress(fmt::format("pair {} of {}", first, cases));
    for_blocks(std::min(batch, pairs.size() - first), context.untimed_threads(),
               [&](std::size_t begin, std::size_t end) {
                 for (std::size_t i = first + begin; i < first + end; ++i) {
                   const auto [r, s, d] = pairs[i];
                   const double textbook = oracles::equation_a4_corrected(r, s, d);
                   errors[i] = oracles::lens_relative_error(r, s, d, lens_area(r, s, d));
                   textbook_errors[i] = oracles::lens_relative_error(r, s, d, textbook);
                 }
               });
  }
  double worst = 0.0;
  for (const double error : errors) keep_larger(worst, error);
  const auto textbook_off =
      std::ranges::count_if(textbook_errors, [](double error) { return !(error <= 1e-6); });
  context.record({.experiment = {},
                  .measurement = "agreement/largest_relative_difference",
                  .value = worst,
                  .sample_size = cases});
  context.record({.experiment = {},
                  .measurement = "errors/textbook_off_by_a_millionth",
                  .value = static_cast<double>(textbook_off) / cases,
                  .sample_size = cases});
}

/// Laws of the corrected form, on random pairs: largest violations.
void record_laws(ExperimentContext& context) {
  constexpr int pairs = 20'000;
  CounterStream stream(context.seed(), 2);
  const LensViolations worst = lens_violations(lens_area, stream, pairs);
  const auto record = [&](const char* name, double value, const char* unit = "1") {
    context.record({.experiment = {},
                    .measurement = std::string("laws/") + name,
                    .value = value,
                    .unit = unit,
                    .sample_size = pairs});
  };
  record("asymmetry", worst.asymmetry, "area");
  record("scaling_by_powers_of_two", worst.scaling_by_powers_of_two);
  record("scaling_by_three_over_bound", worst.scaling_by_three_over_bound);
  record("largest_condition", worst.largest_condition);
  record("rise_with_distance", worst.rise_with_distance);
  record("excess_over_small_disc", worst.excess_over_small_disc);
  record("step_over_bound", worst.step_over_bound);
}

/// The common chord as seen from both centers by (A.2), (A.3).
void record_chords(ExperimentContext& context) {
  constexpr int pairs = 20'000;
  CounterStream stream(context.seed(), 2);
  double difference = 0.0, over_bound = 0.0;
  for (int i = 0; i < pairs; ++i) {
    const CrossingCircles c = random_crossing(stream);
    const auto [r, s, d] = c;
    const double here = std::abs(2 * r * std::sin(oracles::equation_a2(r, s, d) / 2) -
                                 2 * s * std::sin(oracles::equation_a2(s, r, d) / 2));
    keep_larger(difference, here);
    keep_larger(over_bound, here / (chord_bound(c) + chord_bound({s, r, d})));
  }
  context.record("laws/chord_difference", difference, "length");
  context.record("laws/chord_difference_over_bound", over_bound);
}

/// Over all relative positions two discs have the product of their areas in common.
void record_sum_rule(ExperimentContext& context) {
  double worst = 0.0;
  for (const auto& [r, s] : {std::pair{1.0, 1.0}, std::pair{0.3, 2.0}, std::pair{1.0, 1.7}}) {
    constexpr int steps = 100'000;
    const double step = (r + s) / steps;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
      const double d = (i + 0.5) * step;
      sum += lens_area(r, s, d) * 2 * std::numbers::pi * d * step;
    }
    const double product = std::numbers::pi * r * r * std::numbers::pi * s * s;
    keep_larger(worst, std::abs(sum / product - 1));
  }
  context.record("sum_rule/largest_error", worst);
}

/// The distance at which two equal discs cover half of each other.
void record_half_cover(ExperimentContext& context) {
  double low = 0.0, high = 2.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (lens_area(1, 1, middle) > 0.5 * std::numbers::pi ? low : high) = middle;
  }
  context.record("equal/half_cover_distance", low, "radii");
  context.record("equal/unit_distance", lens_area(1, 1, 1), "area");
}

void run(ExperimentContext& context) {
  record_examples(context);
  record_shares(context);
  record_jumps(context);
  record_laws(context);
  record_chords(context);
  record_sum_rule(context);
  record_half_cover(context);
  record_errors(context);
}

}  // namespace

extern const ExperimentDescriptor overlap_area;
constinit const ExperimentDescriptor overlap_area{
    .id = "alsweis/overlap-area",
    .question = "Which area do two overlapping discs have in common, and which is printed?",
    .source = "[Alsweis] appendix A",
    .seconds = {1, 3, 120},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
