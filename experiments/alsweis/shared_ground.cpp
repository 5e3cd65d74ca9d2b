// SPDX-License-Identifier: MIT
// What plants win of ground that several cover: exactly, and by sums over pairs, which count it
// more than once.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/overlap/coverage.hpp"
#include "core/overlap/lens.hpp"
#include "core/picture/svg_text.hpp"
#include "core/random/counter_stream.hpp"
#include "core/statistics/running_moments.hpp"
#include "experiments/alsweis/zone_stand.hpp"
#include "experiments/experiment.hpp"

namespace phytobench::experiments::alsweis {

namespace {

/// Two circles, and n neighbours at one place.
void record_pairs(ExperimentContext& context) {
  ZoneStand two;
  two.add(0, 0, 1);
  two.add(1, 0, 1);
  context.record("two/overlap", lens_area(1, 1, 1), "area");
  for (const auto& [name, rule] : {std::pair{"pairs", "symmetric"}, {"exact", "exact_shares"}}) {
    const std::vector<double> loss = two.losses(rule);
    context.record(fmt::format("two/{}/first", name), loss[0]);
    context.record(fmt::format("two/{}/second", name), loss[1]);
  }
  ZoneStand coincident;
  coincident.add(2, 1, 1);
  for (int n = 1; n <= 4; ++n) {
    coincident.add(2, 1, 1);
    context.record(fmt::format("coincident/pairs/{}", n), coincident.losses("symmetric")[0]);
    context.record(fmt::format("coincident/exact/{}", n), coincident.losses("exact_shares")[0]);
  }
}

/// Over random pairs: the least and most that one neighbour takes, what a unit of length changes,
/// and how the overlap is divided.
void record_random_pairs(ExperimentContext& context) {
  CounterStream stream(context.seed(), 0);
  RunningMoments loss;
  double scaling = 0.0, unequal = 0.0, loser = 0.0, sum = 0.0;
  for (int k = 0; k < 2'000; ++k) {
    ZoneStand two;
    const double r = 0.1 + stream.next_unit(), s = 0.1 + stream.next_unit();
    two.add(0, 0, r);
    two.add(1.05 * (r + s) * stream.next_unit(), 0, s);
    const std::vector<double> by_pairs = two.losses("symmetric");
    for (const double l : by_pairs) loss.add(l);
    ZoneStand scaled = two;
    for (std::vector<double>* lengths : {&scaled.x, &scaled.y, &scaled.radius})
      for (double& length : *lengths) length *= 1000.0;
    scaling = std::max(scaling, std::abs(scaled.losses("symmetric")[0] - by_pairs[0]));
    const double overlap = lens_area(r, s, two.x[1]);
    const std::vector<double> halves = two.losses("exact_shares"),
                              all = two.losses("exact_shares", winner_takes_all);
    const auto gains = [&](const std::vector<double>& losses, std::size_t i) {
      return overlap - losses[i] * two.area(i);
    };
    const std::size_t smaller = r < s ? 0 : 1;
    unequal = std::max(unequal, std::abs(gains(halves, 0) - gains(halves, 1)));
    loser = std::max(loser, std::abs(gains(all, smaller)));
    for (const auto& losses : {halves, all})
      sum = std::max(sum, std::abs(gains(losses, 0) + gains(losses, 1) - overlap));
  }
  context.record("random-pairs/least_loss", loss.least());
  context.record("random-pairs/largest_loss", loss.largest());
  context.record("random-pairs/scaling_difference", scaling);
  context.record("random-pairs/unequal_halves", unequal, "area");
  context.record("random-pairs/left_to_the_loser", loser, "area");
  context.record("random-pairs/sum_error", sum, "area");
}

void record_five_plants(ExperimentContext& context) {
  const ZoneStand stand = five_plants();
  const Coverage ground = coverage(stand.zones(), {});
  for (std::size_t k = 1; k < ground.by_times.size(); ++k)
    context.record(fmt::format("five-plants/covered/times-{}", k), ground.by_times[k], "m2");
  for (const Division& division : divisions) {
    const std::vector<double> exact = stand.losses("exact_shares", division.exponent);
    const std::vector<double> pairs = stand.losses("asymmetry_exponent", division.exponent);
    for (std::size_t i = 0; i < stand.size(); ++i) {
      const std::string name = fmt::format("five-plants/{}/plant-{}", division.name, i + 1);
      context.record(name + "/exact", exact[i]);
      context.record(name + "/pairs", pairs[i]);
      context.record(name + "/excess", pairs[i] - exact[i]);
    }
  }
}

constexpr double panel_width = 300.0, gap = 20.0, top = 6.0;
constexpr Rectangle shown{{-0.1, 0.7}, {6.8, 6.4}};

constexpr double scale = panel_width / shown.width();

Point2 on_panel(const Point2& ground, double left) {
  return {left + scale * (ground.x - shown.low.x), top + scale * (shown.high.y - ground.y)};
}

/// Those of the plants, where few others cover them.
std::string numbers(double left) {
  constexpr Point2 places[] = {{2.4, 2.1}, {5.8, 3.1}, {4.0, 5.6}, {0.9, 4.6}, {3.893, 3.47}};
  std::string svg;
  for (std::size_t i = 0; i < std::size(places); ++i) {
    const Point2 at = on_panel(places[i], left);
    svg += svg_text(at.x, at.y, "middle", std::to_string(i + 1));
  }
  return svg;
}

/// One circle of a panel that begins at `left`.
std::string circle(const ZoneStand& stand, std::size_t i, double left, const std::string& paint) {
  const Point2 center = on_panel({stand.x[i], stand.y[i]}, left);
  return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" {}/>\n", center.x, center.y,
                     scale * stand.radius[i], paint);
}

constexpr const char* outline =
    "fill=\"none\" stroke=\"currentColor\" stroke-width=\".8\" stroke-dasharray=\"4 3\"";

/// Zones on top of each other: the darker, the more of them.
std::string multiplicity_panel(const ZoneStand& stand, double left) {
  std::string svg;
  for (std::size_t i = 0; i < stand.size(); ++i)
    svg += circle(stand, i, left, "fill=\"#247be0\" fill-opacity=\".3\"");
  for (std::size_t i = 0; i < stand.size(); ++i) svg += circle(stand, i, left, outline);
  return svg + numbers(left);
}

/// Every place in the colour of the largest plant that covers it: larger ones are painted later.
std::string winner_panel(const ZoneStand& stand, double left) {
  constexpr const char* colours[] = {"#247be0", "#ca5b0b", "#238e50", "#9e60ca", "#d84a46"};
  std::vector<std::size_t> order = {0, 1, 2, 3, 4};
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t j) { return stand.radius[i] < stand.radius[j]; });
  std::string svg;
  for (const std::size_t i : order)
    svg += circle(stand, i, left, fmt::format("fill=\"{}\"", colours[i]));
  for (std::size_t i = 0; i < stand.size(); ++i) svg += circle(stand, i, left, outline);
  return svg;
}

void draw_five_plants(ExperimentContext& context) {
  const ZoneStand stand = five_plants();
  const double height = scale * shown.height(), right = panel_width + gap;
  const std::string title = "Five plants: how many cover a place, and which of them is the largest";
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" role=\"img\" "
      "aria-label=\"{2}\" fill=\"currentColor\" font-size=\"12\" font-family=\"sans-serif\">\n"
      "<title>{2}</title>\n",
      right + panel_width, top + height + 30.0, title);
  svg += multiplicity_panel(stand, 0.0) + winner_panel(stand, right);
  svg += svg_text(0.5 * panel_width, top + height + 20.0, "middle",
                  "a) covered by one to four plants");
  svg += svg_text(right + 0.5 * panel_width, top + height + 20.0, "middle",
                  "b) all to the largest: 5 wins nothing");
  context.artifact("five-plants.svg", svg + "</svg>\n");
}

void run(ExperimentContext& context) {
  record_pairs(context);
  record_random_pairs(context);
  record_five_plants(context);
  draw_five_plants(context);
}

}  // namespace

extern const ExperimentDescriptor shared_ground;
constinit const ExperimentDescriptor shared_ground{
    .id = "alsweis/shared-ground",
    .question = "What do plants lose where more than two cover the same ground?",
    .source = "[Alsweis] sec. 1.2, eq. 5.1",
    .seconds = {1, 1, 1},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
