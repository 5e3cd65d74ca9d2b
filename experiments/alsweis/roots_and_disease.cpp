// SPDX-License-Identifier: MIT
// Figures 7.8 and 7.10 for whole stands: plants with deep and with flat roots among each other, and
// an epidemic that strikes a fifth of all plants.
#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/point_pattern/window.hpp"
#include "core/random/counter_stream.hpp"
#include "experiments/alsweis/ecosystem.hpp"
#include "experiments/alsweis/plant_fates.hpp"
#include "experiments/alsweis/stand_panels.hpp"

namespace phytobench::experiments::alsweis {

namespace {

constexpr double side = 200.0;
constexpr int steps = 60;
constexpr double zone_factor = 15.0;
/// As many as a square lattice of 14 x 14 holds: neighbours meet before they are half grown.
constexpr std::size_t lattice = 14, count = lattice * lattice;

/// Woody plants of one size on a torus that compete for nutrients only; none dies.
PopulationParameters woody_plants(const char* rule, std::size_t species, std::uint64_t seed) {
  PopulationParameters parameters;
  parameters.seed = seed;
  parameters.ground = {{0.0, 0.0}, {side, side}};
  parameters.rule = rule;
  parameters.competition.above_share = 0.0;
  parameters.species.resize(species);
  for (Species& one : parameters.species) one.roots = one.crown = zone_of(zone_factor);
  return parameters;
}

/// Who stands where.
enum class Arrangement { random, alternating, halves };

struct Stands {
  const char* name;
  Arrangement arrangement;
};

constexpr std::array all_stands = {Stands{"random", Arrangement::random},
                                   Stands{"alternating", Arrangement::alternating},
                                   Stands{"halves", Arrangement::halves}};

/// Places and sizes from the seed alone; of the two species half each.
std::vector<StartPlant> placed(Arrangement arrangement, std::uint64_t seed) {
  CounterStream stream(seed, 0);
  std::vector<StartPlant> plants;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t column = k % lattice, row = k / lattice;
    const double u = stream.next_unit(), v = stream.next_unit();
    StartPlant plant;
    plant.stem_radius = stream.next_between(0.03, 0.07);
    constexpr double spacing = side / lattice;
    const bool is_lattice = arrangement == Arrangement::alternating;
    // In the middle half of its cell.
    plant.place = is_lattice ? spacing * Point2{static_cast<double>(column) + 0.25 + 0.5 * u,
                                                static_cast<double>(row) + 0.25 + 0.5 * v}
                             : side * Point2{u, v};
    const bool is_second = is_lattice                           ? (column + row) % 2 == 1
                           : arrangement == Arrangement::halves ? plant.place.x > 0.5 * side
                                                                : k % 2 == 1;
    plant.species = is_second ? 1 : 0;
    plants.push_back(plant);
  }
  return plants;
}

/// Ranks of the roots of both species: 0 flat, 1 deep.
Population with_roots(Arrangement arrangement, double first, double second, std::uint64_t seed) {
  PopulationParameters parameters = woody_plants("roots", 2, seed);
  parameters.species[0].name = first > 0.0 ? "first deep roots" : "first flat roots";
  parameters.species[1].name = second > 0.0 ? "second deep roots" : "second flat roots";
  parameters.species[0].traits.root_rank = first;
  parameters.species[1].traits.root_rank = second;
  return population_of(parameters, placed(arrangement, seed));
}

double mean_radius(const Stand& stand, SpeciesIndex species) {
  double sum = 0.0;
  std::size_t plants = 0;
  for (const std::size_t i : order_of_ids(stand))
    if (stand.species[i] == species) {
      sum += stand.stem_radius[i];
      ++plants;
    }
  return sum / static_cast<double>(plants);
}

/// Mean loss of either species.
std::array<double, 2> mean_losses(Population& population) {
  const std::vector<double> loss = population.losses();
  const Stand& stand = population.stand();
  std::array<double, 2> sum{}, plants{};
  for (const std::size_t i : order_of_ids(stand)) {
    sum.at(stand.species[i]) += loss[i];
    plants.at(stand.species[i]) += 1.0;
  }
  return {sum[0] / plants[0], sum[1] / plants[1]};
}

std::size_t seeds_of(Tier tier) {
  return tier == Tier::full ? 100 : 20;
}

/// Every plant once with deep and once with flat roots among the same neighbours' places, so that
/// luck with places falls out: mean radius of all plants as the one and as the other.
void record_mixed_stand(ExperimentContext& context, const Stands& stands) {
  const std::size_t seeds = seeds_of(context.tier());
  std::vector<double> deep(seeds), flat(seeds), all_deep(seeds), all_flat(seeds);
  std::vector<double> deep_loss(seeds), flat_loss(seeds);
  for_runs(context, fmt::format("roots, {}", stands.name), seeds, [&](std::size_t run) {
    const std::uint64_t seed = seed_of_run(context, question_roots, run);
    const auto grown = [&](double first, double second) {
      Population population = with_roots(stands.arrangement, first, second, seed);
      for (int t = 0; t < steps; ++t) population.step();
      return std::array{mean_radius(population.stand(), 0), mean_radius(population.stand(), 1)};
    };
    const auto lost = [&](double first, double second) {
      Population population = with_roots(stands.arrangement, first, second, seed);
      return mean_losses(population);
    };
    const auto one_loss = lost(1.0, 0.0), other_loss = lost(0.0, 1.0);
    deep_loss[run] = 0.5 * (one_loss[0] + other_loss[1]);
    flat_loss[run] = 0.5 * (one_loss[1] + other_loss[0]);
    const auto one = grown(1.0, 0.0), other = grown(0.0, 1.0);
    deep[run] = 0.5 * (one[0] + other[1]);
    flat[run] = 0.5 * (one[1] + other[0]);
    const auto both_deep = grown(1.0, 1.0), both_flat = grown(0.0, 0.0);
    all_deep[run] = 0.5 * (both_deep[0] + both_deep[1]);
    all_flat[run] = 0.5 * (both_flat[0] + both_flat[1]);
  });
  const std::string group = fmt::format("roots/{}", stands.name);
  record_mean(context, group + "/deep/mean_radius", deep, "m");
  record_mean(context, group + "/flat/mean_radius", flat, "m");
  record_mean(context, group + "/all-deep/mean_radius", all_deep, "m");
  record_mean(context, group + "/all-flat/mean_radius", all_flat, "m");
  record_paired(context, group + "/deep_over_flat", deep, flat, "m");
  record_paired(context, group + "/loss_at_start_deep_over_flat", deep_loss, flat_loss);
  record_paired(context, group + "/all_flat_over_all_deep", all_flat, all_deep, "m");
}

constexpr int onset = 20;

Population epidemic(std::uint64_t seed, double share, std::int32_t duration) {
  PopulationParameters parameters = woody_plants("disease", 1, seed);
  parameters.species[0].name = "woody plant";
  parameters.illness = {.duration = duration, .is_deadly = false};
  if (share > 0.0)
    parameters.events = {{.kind = EventKind::disease, .step = onset, .share = share}};
  std::vector<StartPlant> plants = placed(Arrangement::random, seed);
  for (StartPlant& plant : plants) plant.species = 0;
  return population_of(parameters, plants);
}

/// For each plant by id whether it falls ill, and how many of those whose roots it meets then do.
struct Struck {
  std::vector<bool> is_ill;
  std::vector<int> ill_neighbours;
};

/// Of a population that has just done the step of the onset.
Struck struck_of(const Population& population) {
  const Stand& stand = population.stand();
  const Window window = Window::torus(population.parameters().ground);
  const std::vector<double> zone = population.root_radii();
  Struck struck{std::vector<bool>(stand.size()), std::vector<int>(stand.size(), 0)};
  for (std::size_t i = 0; i < stand.size(); ++i) {
    const auto id = static_cast<std::size_t>(stand.id[i]);
    struck.is_ill.at(id) = stand.ill_since[i] != healthy;
    for (std::size_t j = 0; j < stand.size(); ++j)
      if (j != i && stand.ill_since[j] != healthy &&
          norm(window.difference(stand.place(i), stand.place(j))) < zone[i] + zone[j])
        ++struck.ill_neighbours[id];
  }
  return struck;
}

/// How much larger healthy plants are, on average, than in the same stand without disease, by the
/// number of their ill neighbours: none, one, or more.
struct Gains {
  std::array<double, 3> by_neighbours{};
  double of_neighbours = 0.0;  ///< of all with one or more
};

Gains gains_of(const Population& with, const Population& without, const Struck& struck) {
  Fates ill = fates_at_start(with.stand()), control = fates_at_start(without.stand());
  std::array<double, 3> sum{}, plants{};
  for (std::size_t id = 0; id < ill.size(); ++id) {
    if (struck.is_ill[id]) continue;
    const auto group = static_cast<std::size_t>(std::min(struck.ill_neighbours[id], 2));
    sum[group] += ill.radius[id] - control.radius[id];
    plants[group] += 1.0;
  }
  Gains gains;
  for (std::size_t k = 0; k < sum.size(); ++k) gains.by_neighbours[k] = sum[k] / plants[k];
  gains.of_neighbours = (sum[1] + sum[2]) / (plants[1] + plants[2]);
  return gains;
}

/// Steps from onset to no influence: the shorter, the more severe at any moment.
constexpr std::array<std::int32_t, 3> durations = {80, 40, 20};
constexpr std::array<int, 2> moments = {40, steps};

void record_epidemic(ExperimentContext& context) {
  const std::size_t seeds = seeds_of(context.tier());
  // gains[duration][moment][seed]
  std::array<std::array<std::vector<Gains>, moments.size()>, durations.size()> gains;
  for (auto& of_duration : gains)
    for (auto& of_moment : of_duration) of_moment.resize(seeds);
  for_runs(context, "epidemic", seeds, [&](std::size_t run) {
    const std::uint64_t seed = seed_of_run(context, question_epidemic, run);
    Population without = epidemic(seed, 0.0, 1);
    std::vector<Population> with;
    for (const std::int32_t duration : durations) with.push_back(epidemic(seed, 0.2, duration));
    Struck struck;
    for (std::size_t m = 0; m < moments.size(); ++m) {
      while (without.state().step < moments[m]) {
        without.step();
        for (Population& ill : with) ill.step();
        // The same plants in all of them, and as large still.
        if (without.state().step == onset + 1) struck = struck_of(with[0]);
      }
      for (std::size_t d = 0; d < durations.size(); ++d)
        gains[d][m][run] = gains_of(with[d], without, struck);
    }
  });
  const auto values = [&](const std::vector<Gains>& all, const auto& value) {
    std::vector<double> result;
    for (const Gains& one : all) result.push_back(value(one));
    return result;
  };
  const auto of_neighbours = [](const Gains& g) { return g.of_neighbours; };
  const std::vector<double> nothing(seeds, 0.0);
  for (std::size_t m = 0; m < moments.size(); ++m) {
    const std::string at = fmt::format("epidemic/step-{}", moments[m]);
    for (std::size_t d = 0; d < durations.size(); ++d) {
      const std::string group = fmt::format("{}/duration-{}", at, durations[d]);
      record_paired(context, group + "/neighbours_over_no_disease",
                    values(gains[d][m], of_neighbours), nothing, "m");
      for (const std::size_t k : {0u, 1u, 2u})
        record_mean(context, fmt::format("{}/gain_with_{}_ill", group, k),
                    values(gains[d][m], [k](const Gains& g) { return g.by_neighbours[k]; }), "m");
      for (const std::size_t k : {1u, 2u})
        record_paired(context, fmt::format("{}/{}_over_{}_ill", group, k, k - 1),
                      values(gains[d][m], [k](const Gains& g) { return g.by_neighbours[k]; }),
                      values(gains[d][m], [k](const Gains& g) { return g.by_neighbours[k - 1]; }),
                      "m");
      if (d > 0)
        record_paired(
            context, fmt::format("{}/duration-{}-over-{}", at, durations[d], durations[d - 1]),
            values(gains[d][m], of_neighbours), values(gains[d - 1][m], of_neighbours), "m");
    }
  }
}

StandMap map_of_stand() {
  return {.ground = {{0.0, 0.0}, {side, side}}, .is_torus = true};
}

void draw_roots(ExperimentContext& context) {
  std::vector<StandPanel> panels;
  for (const Stands& stands : all_stands) {
    Population population =
        with_roots(stands.arrangement, 1.0, 0.0, seed_of_run(context, question_roots, 0));
    for (int t = 0; t < steps; ++t) population.step();
    StandPanel panel;
    for (const SpeciesIndex species : {SpeciesIndex{0}, SpeciesIndex{1}}) {
      StandLayer stems = stems_of(population, species, 4.0);
      stems.name = "";
      for (StandLayer layer : {root_zones_of(population, species), stems}) {
        layer.colour = species == 0 ? 1 : 0;
        if (!layer.name.empty()) layer.name = species == 0 ? "deep roots" : "flat roots";
        panel.layers.push_back(layer);
      }
    }
    panel.caption =
        fmt::format("{}: deep {:.3f} m, flat {:.3f} m", stands.name,
                    mean_radius(population.stand(), 0), mean_radius(population.stand(), 1));
    panels.push_back(panel);
  }
  context.artifact(
      "figure-7.8.svg",
      stand_panels_svg(map_of_stand(), panels,
                       "Figure 7.8: stands of deeply and flatly rooted plants after "
                       "60 steps, with mean radii of stems, drawn four times as wide"));
}

StandPanel panel_of(const Population& population, const std::string& caption) {
  const StandLayer zones = root_zones_of(population, 0);
  const Stand& stand = population.stand();
  StandLayer well{.name = "root zone of a healthy plant",
                  .places = {},
                  .radii = {},
                  .mark = StandMark::ring,
                  .colour = 2};
  StandLayer ill = well;
  ill.name = "of an ill plant";
  ill.colour = 4;
  for (std::size_t i = 0; i < stand.size(); ++i) {
    StandLayer& layer = stand.ill_since[i] == healthy ? well : ill;
    layer.places.push_back(zones.places[i]);
    layer.radii.push_back(zones.radii[i]);
  }
  StandLayer stems = stems_of(population, 0, 4.0);
  stems.name = "stem, four times as wide";
  stems.colour = 1;
  return {.layers = {well, ill, stems}, .caption = caption};
}

void draw_epidemic(ExperimentContext& context) {
  const std::uint64_t seed = seed_of_run(context, question_epidemic, 0);
  Population with = epidemic(seed, 0.2, 20), without = epidemic(seed, 0.0, 1);
  std::vector<StandPanel> panels;
  while (with.state().step < onset + 1) with.step();
  panels.push_back(panel_of(with, fmt::format("step {}: a fifth has fallen ill", onset)));
  while (with.state().step < steps) with.step();
  panels.push_back(panel_of(with, fmt::format("step {}", steps)));
  while (without.state().step < steps) without.step();
  panels.push_back(panel_of(without, fmt::format("step {} without disease", steps)));
  context.artifact("figure-7.10.svg",
                   stand_panels_svg(map_of_stand(), panels,
                                    "Figure 7.10: an epidemic among 196 plants, and the same stand "
                                    "without it"));
}

void run(ExperimentContext& context) {
  for (const Stands& stands : all_stands) record_mixed_stand(context, stands);
  record_epidemic(context);
  draw_roots(context);
  draw_epidemic(context);
}

}  // namespace

extern const ExperimentDescriptor roots_and_disease;
constinit const ExperimentDescriptor roots_and_disease{
    .id = "alsweis/roots-and-disease",
    .question = "Do deeply rooted plants win in whole stands, and neighbours of ill plants, too?",
    .source = "[Alsweis] sec. 7.3, 7.5, 7.6, figures 7.8 and 7.10",
    .seconds = {1, 1, 5},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
