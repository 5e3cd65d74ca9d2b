// SPDX-License-Identifier: MIT
// Competition above and below ground, chapter 5: rings of a crown, signs of an influence, and what
// is left of growth.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <set>
#include <string>

#include <fmt/format.h>

#include "core/competition/zone_laws.hpp"
#include "core/population/size_growth.hpp"
#include "core/random/counter_stream.hpp"
#include "experiments/alsweis/few_plants.hpp"
#include "experiments/experiment.hpp"
#include "experiments/plot_artifacts.hpp"
#include "reference/oracles/alsweis_competition_shares.hpp"
#include "reference/oracles/alsweis_competition_zones.hpp"
#include "reference/oracles/alsweis_overlap.hpp"

namespace phytobench::experiments::alsweis {

namespace {

namespace oracles = phytobench::oracles::alsweis;
namespace print = phytobench::oracles::alsweis::competition;

constexpr int draws = 2'000;

double reach(double d, double b, double stem_radius) {
  return zone_radius({d, d, b}, stem_radius, 1.0);
}

/// The ranges of (4.1) in sections 4.2 and 5.2, and what the latter make of stems of 5 to 50 cm.
void record_ranges(ExperimentContext& context) {
  double least_d = INFINITY, largest_d = 0.0, least_b = INFINITY, largest_b = 0.0;
  double smallest = INFINITY, largest = 0.0, least_of_stem = INFINITY;
  for (int d = 10; d <= 100; ++d)
    for (int tenths = 10; tenths <= 30; ++tenths) {
      const double b = tenths / 10.0;
      for (const double R : {0.05, 0.1, 0.2, 0.35, 0.5}) {
        smallest = std::min(smallest, reach(d, b, R));
        largest = std::max(largest, reach(d, b, R));
        least_of_stem = std::min(least_of_stem, reach(d, b, R) / R);
      }
      if (d > 15 || b > 1.0) continue;
      least_d = std::min<double>(least_d, d), largest_d = std::max<double>(largest_d, d);
      least_b = std::min(least_b, b), largest_b = std::max(largest_b, b);
    }
  context.record("ranges/common/least_factor", least_d);
  context.record("ranges/common/largest_factor", largest_d);
  context.record("ranges/common/least_exponent", least_b);
  context.record("ranges/common/largest_exponent", largest_b);
  context.record("ranges/smallest_zone", smallest, "m");
  context.record("ranges/largest_zone", largest, "m");
  context.record("ranges/smallest_zone_over_stem", least_of_stem);
}

/// A larger exponent, as poor soil should have it.
void record_poor_soil(ExperimentContext& context) {
  for (const int b : {1, 2, 3})
    for (const auto& [name, R] : {std::pair{"10-cm", 0.1}, std::pair{"20-cm", 0.2}})
      context.record(fmt::format("poor_soil/{}/exponent-{}", name, b), reach(10, b, R), "m");
}

/// Two plants 10 m apart on soils of falling richness: their roots reach ever farther.
void record_richness(ExperimentContext& context) {
  for (const auto& [name, d] : {std::pair{"08", 8.0}, std::pair{"10", 10.0},
                                std::pair{"12-5", 12.5}, std::pair{"15", 15.0}}) {
    const double zone = reach(d, 0.5, 0.4);
    context.record(fmt::format("richness/factor-{}/loss", name),
                   two_plants_apart(10, zone, zone).losses("symmetric")[0]);
  }
}

/// Neighbours of a stand by roots that reach farther than crowns.
void record_reach(ExperimentContext& context) {
  CounterStream stream(context.seed(), 0);
  std::vector<double> x, y, root, crown;
  for (int i = 0; i < 400; ++i) {
    const double R = stream.next_between(0.03, 0.2);
    x.push_back(stream.next_between(0, 100)), y.push_back(stream.next_between(0, 100));
    root.push_back(reach(12, 0.5, R)), crown.push_back(reach(10, 0.5, R));
  }
  PairSearch search(overlap_engine_named("all_pairs"), {});
  const auto crowns = search.find({x, y, crown}, {}).size();
  const OverlapPairs& pairs = search.find({x, y, root}, {});
  context.record("reach/pairs_by_crowns", static_cast<std::int64_t>(crowns), "pairs");
  context.record("reach/pairs_by_roots", static_cast<std::int64_t>(pairs.size()), "pairs");
  std::int64_t beyond = 0;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const auto i = static_cast<std::size_t>(pairs.first()[k]),
               j = static_cast<std::size_t>(pairs.second()[k]);
    beyond += std::hypot(x[i] - x[j], y[i] - y[j]) >= crown[i] + crown[j];
  }
  context.record("reach/pairs_by_roots_alone", beyond, "pairs");
}

/// Which of both costs a random pair more, in the sum of both plants' losses: halves by roots, or
/// all for the larger crown. `ratio`: of root to crown zones.
void record_stronger(ExperimentContext& context) {
  for (const auto& [name, ratio] :
       {std::pair{"1", 1.0}, std::pair{"1-2", 1.2}, std::pair{"1-5", 1.5}, std::pair{"2", 2.0}}) {
    constexpr int pairs = 20'000;
    CounterStream stream(context.seed(), 1);
    std::int64_t below = 0;
    for (int i = 0; i < pairs; ++i) {
      const double r = stream.next_between(0.1, 2), s = stream.next_between(0.1, 2);
      FewPlants plants;
      plants.add(0.0, ratio * r, r);
      plants.add(stream.next_unit() * ratio * (r + s), ratio * s, s);
      const auto roots = plants.losses("above_below", with_share(0)),
                 crowns = plants.losses("above_below", with_share(1));
      below += roots[0] + roots[1] > crowns[0] + crowns[1];
    }
    context.record({.experiment = {},
                    .measurement = fmt::format("stronger/ratio-{}/below", name),
                    .value = static_cast<double>(below) / pairs,
                    .sample_size = pairs,
                    .seed = context.seed()});
    if (ratio == 1.0) context.record("stronger/equal_zones/below", below, "pairs");
  }
}

/// The same with all weights 1, so that only halves and all are compared.
void record_stronger_unweighted(ExperimentContext& context) {
  CounterStream stream(context.seed(), 2);
  std::int64_t below = 0;
  for (int i = 0; i < 20'000; ++i) {
    const double r = stream.next_between(0.1, 2), s = stream.next_between(0.1, 2);
    const FewPlants plants = two_plants_apart(stream.next_unit() * (r + s), r, s);
    const auto halves = plants.losses("symmetric"), all = plants.losses("asymmetric");
    below += halves[0] + halves[1] > (all[0] + all[1]) * (1 + 1e-12);
  }
  context.record("stronger/without_rings/below", below, "pairs");
}

/// A small crown, ring by ring from outside, and the pairs of figure 5.3.
void record_rings(ExperimentContext& context) {
  for (const auto& [name, distance] :
       {std::pair{"5-5", 5.5}, std::pair{"4-5", 4.5}, std::pair{"3-5", 3.5}, std::pair{"3-0", 3.0},
        std::pair{"2-0", 2.0}})
    context.record(fmt::format("rings/distance-{}", name),
                   static_cast<std::int64_t>(zone_index(distance, 1, 5)), "ring");
  CounterStream stream(context.seed(), 3);
  std::int64_t others = 0;
  for (int i = 0; i < draws; ++i) {
    const double r = stream.next_between(0.1, 2), s = stream.next_between(0.1, 2),
                 d = stream.next_unit() * (r + s);
    others += zone_index(d, std::min(r, s), std::max(r, s)) != print::zone_index_F(d, r, s);
  }
  context.record("rings/other_than_print", others, "pairs");
  for (const auto& [name, distance] :
       {std::pair{"a", 1.9}, std::pair{"b", 1.7}, std::pair{"c", 1.5}}) {
    std::string inside;
    for (int F = 5; F >= 1; --F)
      if (print::overlap_in_ring(F, distance, 1, 1) > 1e-12) inside += std::to_string(F);
    context.record(fmt::format("figure-5.3/{}/ring", name),
                   static_cast<std::int64_t>(zone_index(distance, 1, 1)), "ring");
    context.record(fmt::format("figure-5.3/{}/rings_of_overlap", name), inside);
  }
}

/// What both plants of a contact in every ring lose, in overlaps.
void record_ring_weights(ExperimentContext& context) {
  for (int F = 1; F <= 5; ++F) {
    const double distance = F - 0.5 + 0.4;  // a crown of 0.4 that reaches into the middle of ring F
    const double overlap = oracles::equation_a4_corrected(0.4, 5, distance);
    const auto loss = two_plants_apart(distance, 0.4, 5).losses("above_below", with_share(1));
    context.record(fmt::format("weights/ring-{}/smaller", F), loss[0] * disc_area(0.4) / overlap,
                   "overlaps");
    context.record(fmt::format("weights/ring-{}/larger", F), loss[1] * disc_area(5) / overlap,
                   "overlaps");
  }
}

double above_loss(double distance) {
  return two_plants_apart(distance, 1, 5).losses("above_below", with_share(1))[0];
}

void record_jumps(ExperimentContext& context) {
  context.record("jump/outside-4", above_loss(4.0001));
  context.record("jump/inside-4", above_loss(3.9999));
  context.record("jump/factor-4-to-3", above_loss(4 - 1e-9) / above_loss(4 + 1e-9));
  context.record("jump/factor-5-to-4", above_loss(5 - 1e-9) / above_loss(5 + 1e-9));
  context.record("jump/ringwise/outside-4", print::ringwise_5_3_and_5_4(4.0001, 1, 5));
  context.record("jump/ringwise/inside-4", print::ringwise_5_3_and_5_4(3.9999, 1, 5));
}

void draw_jumps(ExperimentContext& context) {
  PlotCurve printed{.name = "one ring counts (printed)", .x = {}, .y = {}, .colour = 0};
  PlotCurve ringwise{
      .name = "each part by its ring", .x = {}, .y = {}, .style = PlotStyle::dashed, .colour = 1};
  for (int i = 0; i <= 1200; ++i) {
    const double distance = i / 200.0;
    for (PlotCurve* curve : {&printed, &ringwise}) curve->x.push_back(distance);
    printed.y.push_back(above_loss(distance));
    ringwise.y.push_back(print::ringwise_5_3_and_5_4(distance, 1, 5));
  }
  add_plot(context, "ring-weights",
           {.title = "Loss of light of a small crown against its distance from a large one",
            .description = "Where one ring counts, as printed, the loss jumps at the rim of every "
                           "ring; weighted part by part it is continuous.",
            .panels = {{.curves = {printed, ringwise},
                        .caption = "A crown of radius 1 under one of radius 5",
                        .x_label = "distance of stems, m",
                        .y_label = "loss of light"}}});
}

/// (5.2) is (4.3) seen from the other plant.
void record_mirror(ExperimentContext& context) {
  CounterStream stream(context.seed(), 4);
  double printed = 0.0, suite = 0.0;
  for (int i = 0; i < draws; ++i) {
    const double r = stream.next_between(0.1, 2), s = stream.next_between(0.1, 2);
    const double d = std::abs(r - s) + 0.9 * stream.next_unit() * (r + s - std::abs(r - s));
    const double gamma = oracles::equation_a4_corrected(r, s, d), A = disc_area(r),
                 B = disc_area(s);
    const double beta = print::equation_5_2(A, B, gamma);
    printed =
        std::max(printed, std::abs(gamma - print::equation_4_3_as_printed(A, B, gamma) - beta));
    suite = std::max(suite, std::abs(two_plants_apart(d, r, s).losses("asymmetric")[0] * A - beta));
  }
  context.record("mirror/printed/largest_difference", printed, "area");
  context.record("mirror/suite/largest_difference", suite, "area");
  for (const auto& [name, rule] :
       {std::pair{"share", TieRule::share}, std::pair{"lower_id", TieRule::lower_id_wins}}) {
    CompetitionParameters parameters = with_share(0.5);
    parameters.ties = rule;
    const auto loss = two_plants_apart(0, 1, 1).losses("asymmetric", parameters);
    context.record(fmt::format("ties/{}/first", name), loss[0], "overlaps");
    context.record(fmt::format("ties/{}/second", name), loss[1], "overlaps");
  }
  for (const double chosen : {0.0, 1.0})
    context.record(fmt::format("ties/printed/both-{:.0f}", chosen),
                   2 * print::equation_5_2(1, 1, 1, chosen), "overlaps");
}

void run(ExperimentContext& context) {
  record_ranges(context);
  record_poor_soil(context);
  record_richness(context);
  record_reach(context);
  record_stronger(context);
  record_stronger_unweighted(context);
  record_rings(context);
  record_ring_weights(context);
  record_jumps(context);
  draw_jumps(context);
  record_mirror(context);
}

}  // namespace

extern const ExperimentDescriptor zones_of_influence;
constinit const ExperimentDescriptor zones_of_influence{
    .id = "alsweis/zones-of-influence",
    .question = "How far do roots and crowns reach, and what does a contact in each ring cost?",
    .source = "[Alsweis] sec. 5.2, eq. 5.1-5.4",
    .seconds = {1, 1, 1},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
