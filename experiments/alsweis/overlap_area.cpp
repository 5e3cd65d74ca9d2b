// SPDX-License-Identifier: MIT
// The area that two discs have in common: appendix A as printed and corrected, and the suite's own
// form against a hundred digits.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/overlap/lens.hpp"
#include "core/random/counter_stream.hpp"
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

void record_errors(ExperimentContext& context) {
  const int cases = hard_cases(context.tier());
  CounterStream stream(context.seed(), 1);
  double worst = 0.0;
  int textbook_off = 0;
  for (int i = 0; i < cases; ++i) {
    if (i % 1000 == 0) context.progress(fmt::format("pair {} of {}", i, cases));
    const auto [r, s, d] = hard_pair(i, stream);
    worst = std::max(worst, oracles::lens_relative_error(r, s, d, lens_area(r, s, d)));
    const double textbook = oracles::equation_a4_corrected(r, s, d);
    textbook_off += !(oracles::lens_relative_error(r, s, d, textbook) <= 1e-6);
  }
  context.record({.experiment = {},
                  .measurement = "errors/largest_relative_error",
                  .value = worst,
                  .sample_size = cases});
  context.record({.experiment = {},
                  .measurement = "errors/textbook_off_by_a_millionth",
                  .value = static_cast<double>(textbook_off) / cases,
                  .sample_size = cases});
}

/// Laws of the corrected form, on random pairs: largest violations.
void record_laws(ExperimentContext& context) {
  CounterStream stream(context.seed(), 2);
  double chord = 0.0, symmetry = 0.0, scaling = 0.0, rise = 0.0, excess = 0.0;
  for (int i = 0; i < 20'000; ++i) {
    const double r = 0.01 + stream.next_unit(), s = 0.01 + stream.next_unit();
    const double low = std::abs(r - s);
    const double d = low + (0.001 + 0.998 * stream.next_unit()) * (r + s - low);
    const double area = lens_area(r, s, d),
                 disc = std::numbers::pi * std::min(r, s) * std::min(r, s);
    chord = std::max(chord, std::abs(2 * r * std::sin(oracles::equation_a2(r, s, d) / 2) -
                                     2 * s * std::sin(oracles::equation_a2(s, r, d) / 2)));
    symmetry = std::max(symmetry, std::abs(area - lens_area(s, r, d)));
    scaling = std::max(scaling, std::abs(lens_area(3 * r, 3 * s, 3 * d) / (9 * area) - 1));
    rise = std::max(rise, lens_area(r, s, d * (1 + 1e-9)) / area - 1);
    excess = std::max(excess, area / disc - 1);
  }
  context.record("laws/chord_difference", chord, "length");
  context.record("laws/asymmetry", symmetry, "area");
  context.record("laws/scaling_error", scaling);
  context.record("laws/rise_with_distance", rise);
  context.record("laws/excess_over_small_disc", excess);
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
    worst = std::max(worst, std::abs(sum / product - 1));
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
    .seconds = {1, 3, 220},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
