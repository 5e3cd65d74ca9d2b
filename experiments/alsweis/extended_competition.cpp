// SPDX-License-Identifier: MIT
// Chapter 7: crowns that let light through, roots of three kinds, ill plants and nurses.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/competition/zone_laws.hpp"
#include "core/random/counter_stream.hpp"
#include "experiments/alsweis/few_plants.hpp"
#include "experiments/experiment.hpp"
#include "reference/oracles/alsweis_competition_extended.hpp"
#include "reference/oracles/alsweis_overlap.hpp"

namespace phytobench::experiments::alsweis {

namespace {

namespace oracles = phytobench::oracles::alsweis;
namespace print = phytobench::oracles::alsweis::competition;

/// A small plant that lies with its crown in the middle of ring F of a large one and is covered by
/// both of its zones.
FewPlants covered_in_ring(int F) {
  FewPlants plants;
  plants.add(F - 0.5 + 0.2, 0.2, 0.2);
  plants.add(0.0, 8.0, 5.0);
  return plants;
}

CompetitionParameters with_light(double p, double constant, double opacity) {
  CompetitionParameters parameters = with_share(p);
  parameters.light_constant = constant;
  parameters.species[0].crown_opacity = opacity;
  return parameters;
}

void record_light_weights(ExperimentContext& context) {
  for (const int k : {1, 3})
    for (int F = 1; F <= 5; ++F)
      context.record(fmt::format("light/k-{}/ring-{}", k, F),
                     covered_in_ring(F).losses("light", with_light(1, k, 1))[0], "overlaps");
}

/// What both plants lose of their overlap, by the opacity of the larger; and as printed.
void record_opacity(ExperimentContext& context) {
  const double overlap = oracles::equation_a4_corrected(1, 5, 1.5);
  double line_error = 0.0;
  for (int percent = 0; percent <= 100; percent += 5) {
    const double L = percent / 100.0;
    const auto loss = two_plants_apart(1.5, 1, 5).losses("light", with_light(1, 1, L));
    const double smaller = loss[0] * disc_area(1) / overlap,
                 larger = loss[1] * disc_area(5) / overlap;
    line_error = std::max(line_error, std::abs(smaller - print::equation_7_2_as_printed(1, L, 1)));
    if (percent % 25 != 0) continue;
    const std::string name = fmt::format("opacity/{:03}/", percent);
    context.record(name + "smaller", smaller, "overlaps");
    context.record(name + "larger", larger, "overlaps");
    context.record(name + "pair", smaller + larger, "overlaps");
    context.record(name + "printed_pair", 2 * print::equation_7_2_as_printed(1, L, 1), "overlaps");
  }
  context.record("opacity/largest_difference_from_print", line_error, "overlaps");
}

/// Growth of a plant under a tree that lets half of the light through, and under one that lets
/// none.
void record_under_trees(ExperimentContext& context) {
  for (const int k : {1, 3})
    for (int F = 1; F <= 5; ++F)
      for (const auto& [name, L] : {std::pair{"open", 0.0}, std::pair{"dense", 1.0}})
        context.record(fmt::format("under_tree/k-{}/ring-{}/{}", k, F, name),
                       growth_factor(covered_in_ring(F).losses("light", with_light(1, k, L))[0]));
}

/// The k / F for which plants grow under the one and not under the other.
void record_window(ExperimentContext& context) {
  constexpr double hardly = 1e-9;
  double least = INFINITY, largest = 0.0;
  for (int F = 1; F <= 5; ++F)
    for (int percent = 1; percent <= 600; ++percent) {
      const double k = percent / 100.0;
      const auto factor = [&](double L) {
        return growth_factor(covered_in_ring(F).losses("light", with_light(1, k, L))[0]);
      };
      if (factor(0) <= hardly || factor(1) > hardly) continue;
      least = std::min(least, k / F);
      largest = std::max(largest, k / F);
    }
  context.record("window/least", least, "k / F");
  context.record("window/largest", largest, "k / F");
  double best = 0.0;  // with k / F = 1 no share of the roots helps, which cover it, too
  for (int percent = 0; percent <= 100; ++percent)
    best = std::max(best, growth_factor(covered_in_ring(1).losses(
                              "light", with_light(percent / 100.0, 1, 0))[0]));
  context.record("window/with_roots/largest_factor", best);
}

constexpr std::pair<char, double> kinds_of_roots[] = {{'f', 0.0}, {'c', 0.5}, {'t', 1.0}};

/// Two equal plants with roots of either kind, at p = 0.
std::vector<double> losses_of_roots(double own_rank, double rank_of_neighbour) {
  CompetitionParameters parameters = with_share(0);
  parameters.species = {{.root_rank = own_rank}, {.root_rank = rank_of_neighbour}};
  FewPlants plants = two_plants_apart(1, 1, 1);
  plants.species = {0, 1};
  return plants.losses("roots", parameters);
}

void record_roots(ExperimentContext& context) {
  const double healthy = two_plants_apart(1, 1, 1).losses("above_below", with_share(0))[0];
  std::set<std::pair<double, double>> states;
  for (const auto& [own, own_rank] : kinds_of_roots)
    for (const auto& [other, other_rank] : kinds_of_roots) {
      const auto loss = losses_of_roots(own_rank, other_rank);
      states.insert({loss[0], loss[1]});
      const std::string name = fmt::format("roots/{}{}/", own, other);
      context.record(name + "own", loss[0] / healthy, "halves of the overlap");
      context.record(name + "neighbour", loss[1] / healthy, "halves of the overlap");
    }
  context.record("roots/different_states", static_cast<std::int64_t>(states.size()), "states");
  double least = INFINITY, largest = 0.0, off = 0.0;
  CounterStream stream(context.seed(), 0);
  for (int i = 0; i < 2'000; ++i) {
    const double rank = i < 2 ? i : stream.next_unit();
    const double sigma = losses_of_roots(0.3, rank)[0];
    least = std::min(least, sigma / healthy);
    largest = std::max(largest, sigma / healthy);
    const double gamma = oracles::equation_a4_corrected(1, 1, 1);
    off = std::max(off, std::abs(sigma - print::equation_7_3(gamma, disc_area(1), 7 * rank, 7)));
  }
  context.record("roots/least", least, "halves of the overlap");
  context.record("roots/largest", largest, "halves of the overlap");
  context.record("roots/largest_difference_from_print", off);
}

/// What an ill neighbour costs when it falls ill and when illness has run its course.
void record_illness(ExperimentContext& context) {
  const double gamma = oracles::equation_a4_corrected(1, 1, 1), A = disc_area(1),
               healthy = two_plants_apart(1, 1, 1).losses("above_below", with_share(0))[0];
  for (const auto& [name, elapsed] :
       {std::pair{"first", 0.0}, std::pair{"half", 20.0}, std::pair{"last", 40.0}}) {
    const double printed = print::equation_7_4(gamma, A, print::T_k_as_printed(1, elapsed, 40), 1);
    FewPlants plants = two_plants_apart(1, 1, 1);
    plants.weakening = {0.0, elapsed / 40};
    const double suite = plants.losses("disease", with_share(0))[0];
    for (const auto& [who, sigma] : {std::pair{"printed", printed}, std::pair{"suite", suite}}) {
      context.record(fmt::format("illness/{}/{}/loss", who, name), sigma / healthy,
                     "halves of the overlap");
      context.record(fmt::format("illness/{}/{}/factor", who, name), growth_factor(sigma));
    }
  }
}

/// phi of (7.5): how much of it is light and nutrients.
void record_mixture(ExperimentContext& context) {
  CounterStream stream(context.seed(), 1);
  double off = 0.0;
  for (int i = 0; i < 2'000; ++i) {
    FewPlants plants;
    plants.add(0.0, stream.next_between(0.5, 2), stream.next_between(0.5, 2));
    plants.add(stream.next_unit(), stream.next_between(0.5, 2), stream.next_between(0.5, 2));
    const double p = stream.next_unit(), L = stream.next_unit();
    const double phi = plants.losses("light", with_light(p, 1, L))[0],
                 alpha = plants.losses("light", with_light(1, 1, L))[0],
                 sigma = plants.losses("light", with_light(0, 1, L))[0];
    off = std::max(off, std::abs(phi - print::equation_7_5(p, alpha, sigma)));
  }
  context.record("mixture/largest_difference_from_print", off);
  const FewPlants plants = covered_in_ring(1);
  const double light = plants.losses("light", with_light(1, 1, 1))[0],
               roots = plants.losses("light", with_light(0, 1, 1))[0],
               mixed = plants.losses("light", with_light(0.25, 1, 1))[0];
  context.record("mixture/p-25/light", (mixed - roots) / (light - roots));
  context.record("mixture/p-25/nutrients", (mixed - light) / (roots - light));
}

/// (7.6) beside (5.6), and the p up to which a nurse helps a plant that it covers.
void record_nurse(ExperimentContext& context) {
  CounterStream stream(context.seed(), 2);
  double off_signs = 0.0, off_print = 0.0;
  for (int i = 0; i < 2'000; ++i) {
    FewPlants plants;
    plants.add(0.0, stream.next_between(0.5, 2), stream.next_between(0.5, 2));
    plants.add(stream.next_unit(), stream.next_between(0.5, 2), stream.next_between(0.5, 2));
    const double p = stream.next_unit();
    CompetitionParameters pn = with_share(p);
    pn.influence_above = {Influence::harms};
    pn.influence_below = {Influence::helps};
    const double nurse = plants.losses("nurse", with_share(p))[0],
                 alpha = plants.losses("above_below", with_share(1))[0],
                 sigma = plants.losses("above_below", with_share(0))[0];
    off_signs = std::max(off_signs, std::abs(nurse - plants.losses("influence_signs", pn)[0]));
    off_print =
        std::max(off_print, std::abs(nurse - print::equation_7_6_as_printed(p, alpha, sigma)));
  }
  context.record("nurse/largest_difference_from_signs", off_signs);
  context.record("nurse/largest_difference_from_print", off_print);
  for (const int F : {1, 4, 5}) {
    double low = 0.0, high = 1.0;
    for (int i = 0; i < 60; ++i) {
      const double p = 0.5 * (low + high);
      (covered_in_ring(F).losses("nurse", with_share(p))[0] < 0 ? low : high) = p;
    }
    context.record(fmt::format("nurse/ring-{}/helps_up_to", F), low);
  }
}

/// Which of a nurse's zones protects: one meets the seedling, the other does not.
void record_protection(ExperimentContext& context) {
  for (const auto& [name, roots, crown] :
       {std::tuple{"crowns_only", 0.5, 3.0}, std::tuple{"roots_only", 3.0, 0.5}}) {
    FewPlants plants;
    plants.add(0.0, 0.5, 0.5);
    plants.add(2.0, roots, crown);
    context.record(fmt::format("nurse/{}/loss", name), plants.losses("nurse", with_share(0.25))[0]);
  }
}

/// Seedlings harm each other, nurses help them and are left alone.
void record_mutual(ExperimentContext& context) {
  using enum Influence;
  CompetitionParameters parameters = with_share(0.25);
  parameters.species.resize(2);
  parameters.influence_above = {none, none, harms, harms};
  parameters.influence_below = {none, none, helps, harms};
  FewPlants seedlings = two_plants_apart(0.5, 1, 1), nursed = two_plants_apart(0.5, 4, 1);
  seedlings.species = {1, 1};
  nursed.species = {0, 1};
  context.record("mutual/seedling_by_seedling", seedlings.losses("nurse", parameters)[0]);
  context.record("mutual/seedling_by_nurse", nursed.losses("nurse", parameters)[1]);
  context.record("mutual/nurse_by_seedling", nursed.losses("nurse", parameters)[0]);
}

void run(ExperimentContext& context) {
  record_light_weights(context);
  record_opacity(context);
  record_under_trees(context);
  record_window(context);
  record_roots(context);
  record_illness(context);
  record_mixture(context);
  record_nurse(context);
  record_protection(context);
  record_mutual(context);
}

}  // namespace

extern const ExperimentDescriptor extended_competition;
constinit const ExperimentDescriptor extended_competition{
    .id = "alsweis/extended-competition",
    .question = "What do open crowns, deep roots, illness and nurses change?",
    .source = "[Alsweis] ch. 7, eq. 7.1-7.6, table 7.1",
    .seconds = {1, 1, 1},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
