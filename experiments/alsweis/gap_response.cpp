// SPDX-License-Identifier: MIT
// What plants gain by the death of their neighbours: the same stand with two plants and without
// them.
#include <algorithm>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/overlap/overlap_registry.hpp"
#include "core/point_pattern/window.hpp"
#include "core/population/population_events.hpp"
#include "core/population/stand_statistics.hpp"
#include "experiments/alsweis/paired_runs.hpp"
#include "experiments/alsweis/stand_panels.hpp"

namespace phytobench::experiments::alsweis {

namespace {

constexpr int steps_before = 30, steps_after = 15;
/// Of the nearer of the removed plants; such plants were within their zones or nearly so.
constexpr double neighbourhood_m = 10.0;

PopulationParameters plants_of(std::int64_t count, std::uint64_t seed) {
  PopulationParameters parameters;
  parameters.seed = seed;
  parameters.rule = "asymmetric";
  parameters.species = {{.name = "plant", .count = count}};
  return parameters;
}

/// The same plants, with the two largest and without them.
struct Removal {
  Population with_all, without_two;
  std::vector<Point2> removed;

  Removal(std::int64_t count, std::uint64_t seed)
      : with_all(lived(plants_of(count, seed), steps_before)), without_two(with_two_out(with_all)) {
    for (std::size_t i = 0; i < with_all.stand().size(); ++i)
      if (std::find(without_two.stand().id.begin(), without_two.stand().id.end(),
                    with_all.stand().id[i]) == without_two.stand().id.end())
        removed.push_back(with_all.stand().place(i));
  }

  void step() {
    with_all.step();
    without_two.step();
  }

  static Population with_two_out(const Population& population) {
    PopulationParameters parameters = population.parameters();
    PopulationState state = population.state();
    parameters.events = {
        {.kind = EventKind::removal, .step = state.step, .species = 0, .largest = 2}};
    apply_events(state, parameters);
    parameters.events.clear();
    return {parameters, state, overlap_engine_named("layered_grid")};
  }
};

bool is_neighbour(const Removal& removal, const Point2& place) {
  const Window ground = Window::torus(removal.with_all.parameters().ground);
  return std::any_of(removal.removed.begin(), removal.removed.end(), [&](const Point2& p) {
    return squared_norm(ground.difference(p, place)) <= neighbourhood_m * neighbourhood_m;
  });
}

/// After removal, against the same plants without it.
struct Response {
  double largest_rise_of_loss = -std::numeric_limits<double>::infinity();
  std::int64_t relieved = 0, grown_less_in_one_step = 0;
  std::int64_t neighbours = 0, neighbours_gained = 0, neighbours_lost = 0;
  /// Neighbours that nobody else keeps from growing.
  std::int64_t freed = 0, freed_gained = 0;
  std::int64_t others = 0, others_lost = 0;
  double least_factor = std::numeric_limits<double>::infinity(), largest_factor = 0.0;

  void add(const Response& more) {
    largest_rise_of_loss = std::max(largest_rise_of_loss, more.largest_rise_of_loss);
    relieved += more.relieved;
    grown_less_in_one_step += more.grown_less_in_one_step;
    neighbours += more.neighbours;
    neighbours_gained += more.neighbours_gained;
    neighbours_lost += more.neighbours_lost;
    freed += more.freed;
    freed_gained += more.freed_gained;
    others += more.others;
    others_lost += more.others_lost;
    least_factor = std::min(least_factor, more.least_factor);
    largest_factor = std::max(largest_factor, more.largest_factor);
  }
};

/// One run's response, and what its neighbours' stems measure on average in the end, m.
struct Outcome {
  Response response;
  std::set<PlantId> dominated = {};  ///< that others still keep from growing
  double mean_with = 0.0, mean_without = 0.0;
};

void respond_at_once(Removal& removal, Outcome& outcome) {
  Response& response = outcome.response;
  const ByPlant before = by_plant(removal.with_all.stand(), removal.with_all.losses());
  for (const auto& [id, loss] :
       by_plant(removal.without_two.stand(), removal.without_two.losses())) {
    response.largest_rise_of_loss = std::max(response.largest_rise_of_loss, loss - before.at(id));
    response.relieved += loss < before.at(id) - 1e-9 ? 1 : 0;
    if (is_oppressed(loss)) outcome.dominated.insert(id);
  }
  removal.step();
  const Stand& stand = removal.without_two.stand();
  const ByPlant control = by_plant(removal.with_all.stand(), removal.with_all.stand().stem_radius);
  for (std::size_t i = 0; i < stand.size(); ++i)
    response.grown_less_in_one_step +=
        stand.stem_radius[i] < control.at(stand.id[i]) - 1e-12 ? 1 : 0;
}

void respond_in_time(Removal& removal, Outcome& outcome) {
  Response& response = outcome.response;
  for (int t = 1; t < steps_after; ++t) removal.step();
  const Stand& stand = removal.without_two.stand();
  const ByPlant control = by_plant(removal.with_all.stand(), removal.with_all.stand().stem_radius);
  for (std::size_t i = 0; i < stand.size(); ++i) {
    const double radius = stand.stem_radius[i], other = control.at(stand.id[i]);
    if (!is_neighbour(removal, stand.place(i))) {
      ++response.others;
      response.others_lost += radius < other - 1e-12 ? 1 : 0;
      continue;
    }
    ++response.neighbours;
    const bool has_gained = radius > other, is_freed = !outcome.dominated.contains(stand.id[i]);
    response.neighbours_gained += has_gained ? 1 : 0;
    response.neighbours_lost += radius < other ? 1 : 0;
    response.freed += is_freed ? 1 : 0;
    response.freed_gained += is_freed && has_gained ? 1 : 0;
    response.least_factor = std::min(response.least_factor, radius / other);
    response.largest_factor = std::max(response.largest_factor, radius / other);
    outcome.mean_without += radius;
    outcome.mean_with += other;
  }
  if (response.neighbours == 0) return;
  outcome.mean_with /= static_cast<double>(response.neighbours);
  outcome.mean_without /= static_cast<double>(response.neighbours);
}

void record_response(ExperimentContext& context, const Response& all) {
  context.record("one_step/largest_rise_of_loss", all.largest_rise_of_loss);
  context.record("one_step/relieved", all.relieved, "plants");
  context.record("one_step/grown_less", all.grown_less_in_one_step, "plants");
  context.record("neighbours", all.neighbours, "plants");
  context.record("neighbours_gained", all.neighbours_gained, "plants");
  context.record("neighbours_lost", all.neighbours_lost, "plants");
  context.record("freed", all.freed, "plants");
  context.record("freed_gained", all.freed_gained, "plants");
  context.record("freed_share_gained",
                 static_cast<double>(all.freed_gained) / static_cast<double>(all.freed));
  context.record("least_factor", all.least_factor);
  context.record("largest_factor", all.largest_factor);
  context.record("others", all.others, "plants");
  context.record("others_lost", all.others_lost, "plants");
}

void record_removal(ExperimentContext& context) {
  constexpr std::size_t runs = 60;
  std::vector<Outcome> outcomes(runs);
  for_runs(context, "two plants removed", runs, [&](std::size_t s) {
    Removal removal(100, seed_of_run(context, Question::removed_plants, s));
    respond_at_once(removal, outcomes[s]);
    respond_in_time(removal, outcomes[s]);
  });
  Response all;
  std::vector<double> with_all, without_two;
  for (const Outcome& one : outcomes) {
    all.add(one.response);
    if (one.response.neighbours == 0) continue;
    with_all.push_back(one.mean_with);
    without_two.push_back(one.mean_without);
  }
  record_response(context, all);
  record_paired(context, "neighbours_grow_on", without_two, with_all, "m");
}

/// A plant's stem, five times as thick as it is, and its zone.
void add_plant(const Population& population, double zone, std::size_t plant, StandLayer& stems,
               StandLayer& zones) {
  const Stand& stand = population.stand();
  for (StandLayer* layer : {&stems, &zones}) layer->places.push_back(stand.place(plant));
  stems.radii.push_back(5.0 * stand.stem_radius[plant]);
  zones.radii.push_back(zone);
}

/// Plants that the deaths set free apart from the rest; the dying ones with their zones, later
/// crosses where they stood.
StandPanel panel_of(const Removal& removal, const Population& population, const ByPlant& gain,
                    const std::string& caption) {
  StandLayer rest{.name = "other plant", .places = {}, .radii = {}, .colour = 1};
  StandLayer freed{.name = "neighbour set free", .places = {}, .radii = {}, .colour = 2};
  StandLayer dying{
      .name = "plant that dies, its zone dashed", .places = {}, .radii = {}, .colour = 3};
  StandLayer zones{
      .name = "root zone", .places = {}, .radii = {}, .mark = StandMark::ring, .colour = 0};
  StandLayer last_zones{
      .name = {}, .places = {}, .radii = {}, .mark = StandMark::dashed_ring, .colour = 3};
  const std::vector<double> zone = population.root_radii();
  for (std::size_t i = 0; i < zone.size(); ++i) {
    const auto own = gain.find(population.stand().id[i]);
    const bool dies = own == gain.end();
    StandLayer& stems = dies ? dying : own->second > 0.01 ? freed : rest;
    add_plant(population, zone[i], i, stems, dies ? last_zones : zones);
  }
  if (dying.places.empty()) {
    dying.places = removal.removed;
    dying.radii.assign(removal.removed.size(), 1.5);
    dying.mark = StandMark::cross;
    dying.name = {};
  }
  return {.layers = {zones, last_zones, rest, freed, dying}, .caption = caption};
}

/// A part of the ground around a place, moved inside.
Rectangle surroundings(const Rectangle& ground, const Point2& place, double side) {
  const Point2 low{std::clamp(place.x - 0.5 * side, ground.low.x, ground.high.x - side),
                   std::clamp(place.y - 0.5 * side, ground.low.y, ground.high.y - side)};
  return {low, low + Point2{side, side}};
}

/// How much larger plants are that live on, m.
ByPlant gains(const Removal& removal) {
  const Stand &with_all = removal.with_all.stand(), &stand = removal.without_two.stand();
  const ByPlant control = by_plant(with_all, with_all.stem_radius);
  ByPlant result = by_plant(stand, stand.stem_radius);
  for (auto& [id, radius] : result) radius -= control.at(id);
  return result;
}

/// Figure 4.11: around the plant that gains most.
void draw_removal(ExperimentContext& context) {
  constexpr int last_step = 60;
  const std::uint64_t seed = seed_of_run(context, Question::removed_plants, 0);
  Removal removal(150, seed), again(150, seed);
  for (int step = steps_before; step < last_step; ++step) removal.step();
  const ByPlant gain = gains(removal);
  const auto most = std::max_element(
      gain.begin(), gain.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  const Stand& end = removal.without_two.stand();
  const auto at = std::find(end.id.begin(), end.id.end(), most->first) - end.id.begin();
  const Rectangle part = surroundings(removal.with_all.parameters().ground,
                                      end.place(static_cast<std::size_t>(at)), 70.0);

  std::vector<StandPanel> panels = {
      panel_of(again, again.with_all, gain, "step 30, before the death")};
  for (int step = steps_before + 1; step <= last_step; ++step) {
    again.step();
    if (step % steps_after == 0)
      panels.push_back(
          panel_of(again, again.without_two, gain, fmt::format("step {}, cross: dead", step)));
  }
  context.artifact("figure-4.11.svg",
                   stand_panels_svg({.ground = part}, panels,
                                    "Figure 4.11: neighbours grow on after a death, 70 m by 70 m"));
}

void run(ExperimentContext& context) {
  record_removal(context);
  draw_removal(context);
}

}  // namespace

extern const ExperimentDescriptor gap_response;
constinit const ExperimentDescriptor gap_response{
    .id = "alsweis/gap-response",
    .question = "What do plants gain by the death of their neighbours?",
    .source = "[Alsweis] sec. 4.7, figure 4.11",
    .seconds = {1, 1, 1},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
