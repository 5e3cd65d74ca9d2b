// SPDX-License-Identifier: MIT
// Zones and shares of chapter 4: how far a plant reaches, and who gets how much of an overlap.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <fmt/format.h>

#include "core/population/size_growth.hpp"
#include "core/random/counter_stream.hpp"
#include "experiments/alsweis/few_plants.hpp"
#include "experiments/experiment.hpp"
#include "reference/oracles/alsweis_competition_shares.hpp"
#include "reference/oracles/alsweis_overlap.hpp"

namespace phytobench::experiments::alsweis {

namespace {

namespace oracles = phytobench::oracles::alsweis;

constexpr int draws = 2'000;

double area(double radius) {
  return std::numbers::pi * radius * radius;
}

double reach(double d, double b, double stem_radius) {
  return zone_radius({d, d, b}, stem_radius, 1.0);
}

void record_zone_law(ExperimentContext& context) {
  context.record("zone/root-of-stem", reach(10, 0.5, 0.1), "m");
  context.record("zone/in-proportion", reach(15, 1, 0.1), "m");
  context.record("zone/constant", reach(1, 0, 0.1), "m");
  CounterStream stream(context.seed(), 0);
  double off = 0.0, slope_error = 0.0;
  std::int64_t falls = 0;
  for (int i = 0; i < draws; ++i) {
    const double d = stream.next_between(1, 15), b = stream.next_unit(),
                 R = stream.next_between(0.001, 1);
    const double zone = reach(d, b, R);
    off = std::max(off, std::abs(zone / oracles::competition::equation_4_1(d, R, b) - 1));
    slope_error = std::max(slope_error, std::abs(std::log2(reach(d, b, 16 * R) / zone) / 4 - b));
    falls += !(reach(d, b, 1.01 * R) > zone);
  }
  context.record("zone/largest_difference_from_print", off);
  context.record("zone/largest_slope_error", slope_error);
  context.record("zone/falls", falls, "draws");
  context.record("zone/doubled_stem/exponent-0", reach(7, 0, 0.4) / reach(7, 0, 0.2));
  context.record("zone/doubled_stem/exponent-1", reach(7, 1, 0.4) / reach(7, 1, 0.2));
}

/// The zones of stems of 5 cm to 50 cm over the whole of the published ranges.
void record_range(ExperimentContext& context) {
  double least = INFINITY, largest = 0.0;
  for (int d = 1; d <= 15; ++d)
    for (int tenths = 0; tenths <= 10; ++tenths)
      for (const double R : {0.05, 0.1, 0.2, 0.35, 0.5}) {
        least = std::min(least, reach(d, tenths / 10.0, R));
        largest = std::max(largest, reach(d, tenths / 10.0, R));
      }
  context.record("zone/range/smallest", least, "m");
  context.record("zone/range/largest", largest, "m");
}

/// A small plant within a large one's zone, near its stem and far from it: the overlap is the same.
void record_circle(ExperimentContext& context) {
  for (const auto& [name, distance] : {std::pair{"near", 1.0}, std::pair{"far", 3.5}})
    for (const auto& [rule, who] : {std::pair{"symmetric", "halves"}, std::pair{"mixture", "mixed"},
                                    std::pair{"field_of_neighbourhood", "cited_field"}})
      context.record(fmt::format("circle/{}/{}", who, name),
                     two_plants_apart(distance, 1, 5).losses(rule)[0]);
}

/// What both of a random pair lose, in area.
struct LostAreas {
  double first, second, overlap;
  bool first_is_larger;
};

template <typename Use>
void for_pairs(ExperimentContext& context, std::string_view rule, const Use& use) {
  CounterStream stream(context.seed(), 1);
  for (int i = 0; i < draws; ++i) {
    const double r = stream.next_between(0.1, 2), s = stream.next_between(0.1, 2);
    const double low = std::abs(r - s), d = low + stream.next_between(0.0, 0.95) * (r + s - low);
    const auto loss = two_plants_apart(d, r, s).losses(rule);
    use(LostAreas{loss[0] * area(r), loss[1] * area(s), oracles::equation_a4_corrected(r, s, d),
                  r > s});
  }
}

void record_symmetric(ExperimentContext& context) {
  double unequal = 0.0, half_error = 0.0;
  for_pairs(context, "symmetric", [&](const LostAreas& lost) {
    unequal = std::max(unequal, std::abs(lost.first - lost.second) / lost.overlap);
    const double half = oracles::competition::equation_4_2(lost.overlap);
    half_error = std::max(half_error, std::abs(lost.first / half - 1));
  });
  context.record("symmetric/unit_circles",
                 two_plants_apart(1, 1, 1).losses("symmetric")[0] * area(1), "area");
  context.record("symmetric/largest_difference_of_both", unequal);
  context.record("symmetric/largest_error_of_a_half", half_error);
}

/// Gains: what is left to a plant of the overlap.
void record_asymmetric(ExperimentContext& context) {
  double sum_error = 0.0, winner_error = 0.0;
  for_pairs(context, "asymmetric", [&](const LostAreas& lost) {
    const double first = lost.overlap - lost.first, second = lost.overlap - lost.second;
    sum_error = std::max(sum_error, std::abs((first + second) / lost.overlap - 1));
    const double winner = lost.first_is_larger ? first : second;
    winner_error = std::max(winner_error, std::abs(winner / lost.overlap - 1));
  });
  context.record("asymmetric/largest_sum_error", sum_error);
  context.record("asymmetric/largest_winner_error", winner_error);
  const double overlap = oracles::equation_a4_corrected(1, 1, 1);
  for (const auto& [name, rule] :
       {std::pair{"share", TieRule::share}, std::pair{"lower_id", TieRule::lower_id_wins}}) {
    CompetitionParameters parameters = with_share(0.5);
    parameters.ties = rule;
    const auto loss = two_plants_apart(1, 1, 1).losses("asymmetric", parameters);
    context.record(fmt::format("ties/{}/first", name), 1 - loss[0] * area(1) / overlap);
    context.record(fmt::format("ties/{}/second", name), 1 - loss[1] * area(1) / overlap);
  }
  // "gamma_ij or 0", chosen by either plant for itself.
  for (const double chosen : {0.0, 1.0})
    context.record(fmt::format("ties/printed/both-{:.0f}", chosen),
                   2 * oracles::competition::equation_4_3_as_printed(1, 1, 1, chosen));
}

void record_mixture(ExperimentContext& context) {
  double sum_error = 0.0, share_error = 0.0;
  for (int i = 0; i <= 20; ++i) {
    const double p = i / 20.0, overlap = oracles::equation_a4_corrected(1, 2, 2);
    const auto loss = two_plants_apart(2, 1, 2).losses("mixture", with_share(p));
    const double loser = 1 - loss[0] * area(1) / overlap, winner = 1 - loss[1] * area(2) / overlap;
    sum_error = std::max(sum_error, std::abs(loser + winner - 1));
    share_error = std::max(
        {share_error, std::abs(winner - (p + (1 - p) / 2)), std::abs(loser - (1 - p) / 2)});
    if (i % 5 != 0) continue;
    context.record(fmt::format("mixture/p-{:03}/winner", 5 * i), winner);
    context.record(fmt::format("mixture/p-{:03}/loser", 5 * i), loser);
  }
  context.record("mixture/largest_sum_error", sum_error);
  context.record("mixture/largest_share_error", share_error);
}

/// How much of the mixture is either competition: its place between both.
void record_weights(ExperimentContext& context) {
  const FewPlants plants = two_plants_apart(2, 1, 2);
  const double symmetric = plants.losses("symmetric")[0], all = plants.losses("asymmetric")[0];
  for (const int percent : {25, 50, 75}) {
    const double mixed = plants.losses("mixture", with_share(percent / 100.0))[0];
    const double weight = (mixed - symmetric) / (all - symmetric);
    context.record(fmt::format("weight/p-{}/asymmetric", percent), weight);
    context.record(fmt::format("weight/p-{}/symmetric", percent), 1 - weight);
  }
}

/// What the smaller plant loses to either, in overlaps; and the p at which both cost it the same.
void record_balance(ExperimentContext& context) {
  const FewPlants plants = two_plants_apart(2, 1, 2);
  const double overlap = oracles::equation_a4_corrected(1, 2, 2) / area(1);
  const double symmetric = plants.losses("symmetric")[0] / overlap,
               asymmetric = plants.losses("asymmetric")[0] / overlap;
  context.record("balance/p-50/asymmetric", 0.5 * asymmetric, "overlaps");
  context.record("balance/p-50/symmetric", 0.5 * symmetric, "overlaps");
  double low = 0.0, high = 1.0;
  for (int i = 0; i < 60; ++i) {
    const double p = 0.5 * (low + high);
    (p * asymmetric < (1 - p) * symmetric ? low : high) = p;
  }
  context.record("balance/equal_at", low);
}

void run(ExperimentContext& context) {
  record_zone_law(context);
  record_range(context);
  record_circle(context);
  record_symmetric(context);
  record_asymmetric(context);
  record_mixture(context);
  record_weights(context);
  record_balance(context);
}

}  // namespace

extern const ExperimentDescriptor competition_shares;
constinit const ExperimentDescriptor competition_shares{
    .id = "alsweis/competition-shares",
    .question = "How far does a plant reach, and who gets how much of an overlap?",
    .source = "[Alsweis] sec. 4.2, eq. 4.1-4.4",
    .seconds = {1, 1, 1},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
