// SPDX-License-Identifier: MIT
// Figure 7.8 for whole stands: plants with deep and with flat roots among each other, side by side,
// and alternating.
#include <array>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/random/counter_stream.hpp"
#include "experiments/alsweis/ecosystem.hpp"
#include "experiments/alsweis/stand_panels.hpp"

namespace phytobench::experiments::alsweis {

namespace {

constexpr double side = 200.0;
constexpr int steps = 60;
constexpr double zone_factor = 15.0;
/// As many as a square lattice of 14 x 14 holds: neighbours meet before they are half grown.
constexpr std::size_t lattice = 14, count = lattice * lattice;

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

/// Woody plants of one size on a torus that compete for nutrients only; none dies. `first` and
/// `second` are ranks of roots: 0 flat, 1 deep.
Population with_roots(Arrangement arrangement, double first, double second, std::uint64_t seed) {
  PopulationParameters parameters;
  parameters.seed = seed;
  parameters.ground = {{0.0, 0.0}, {side, side}};
  parameters.rule = "roots";
  parameters.competition.above_share = 0.0;
  parameters.species.resize(2);
  for (Species& species : parameters.species) species.roots = species.crown = zone_of(zone_factor);
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

/// Of either species.
struct Outcome {
  std::array<double, 2> loss_at_start, mean_radius;
};

Outcome outcome_of(Arrangement arrangement, double first, double second, std::uint64_t seed) {
  Population population = with_roots(arrangement, first, second, seed);
  Outcome outcome{.loss_at_start = mean_losses(population), .mean_radius = {}};
  for (int t = 0; t < steps; ++t) population.step();
  outcome.mean_radius = {mean_radius(population.stand(), 0), mean_radius(population.stand(), 1)};
  return outcome;
}

/// Of plants with deep and with flat roots in one stand, and of stands that have one kind only.
/// Every plant is once the one and once the other, so that luck with places falls out.
struct Depths {
  double deep, flat, all_deep, all_flat, deep_loss, flat_loss;
};

Depths depths_of(Arrangement arrangement, std::uint64_t seed) {
  const Outcome one = outcome_of(arrangement, 1.0, 0.0, seed);
  const Outcome other = outcome_of(arrangement, 0.0, 1.0, seed);
  const auto both = [&](double rank) {
    const auto radius = outcome_of(arrangement, rank, rank, seed).mean_radius;
    return 0.5 * (radius[0] + radius[1]);
  };
  return {.deep = 0.5 * (one.mean_radius[0] + other.mean_radius[1]),
          .flat = 0.5 * (one.mean_radius[1] + other.mean_radius[0]),
          .all_deep = both(1.0),
          .all_flat = both(0.0),
          .deep_loss = 0.5 * (one.loss_at_start[0] + other.loss_at_start[1]),
          .flat_loss = 0.5 * (one.loss_at_start[1] + other.loss_at_start[0])};
}

void record_mixed_stand(ExperimentContext& context, const Stands& stands) {
  std::vector<Depths> seeds(context.tier() == Tier::full ? 100 : 20);
  for_runs(context, fmt::format("roots, {}", stands.name), seeds.size(), [&](std::size_t run) {
    seeds[run] = depths_of(stands.arrangement, seed_of_run(context, question_roots, run));
  });
  const auto all = [&](double Depths::*value) {
    std::vector<double> values;
    for (const Depths& depths : seeds) values.push_back(depths.*value);
    return values;
  };
  const std::string group = stands.name;
  record_mean(context, group + "/deep/mean_radius", all(&Depths::deep), "m");
  record_mean(context, group + "/flat/mean_radius", all(&Depths::flat), "m");
  record_mean(context, group + "/all-deep/mean_radius", all(&Depths::all_deep), "m");
  record_mean(context, group + "/all-flat/mean_radius", all(&Depths::all_flat), "m");
  record_order(context, group + "/deep_over_flat", all(&Depths::deep), all(&Depths::flat), "m");
  record_order(context, group + "/loss_at_start_deep_over_flat", all(&Depths::deep_loss),
               all(&Depths::flat_loss));
  record_order(context, group + "/all_flat_over_all_deep", all(&Depths::all_flat),
               all(&Depths::all_deep), "m");
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

void run(ExperimentContext& context) {
  for (const Stands& stands : all_stands) record_mixed_stand(context, stands);
  draw_roots(context);
}

}  // namespace

extern const ExperimentDescriptor root_systems;
constinit const ExperimentDescriptor root_systems{
    .id = "alsweis/root-systems",
    .question = "Do deeply rooted plants outgrow flatly rooted ones in whole stands?",
    .source = "[Alsweis] sec. 7.3, 7.6, figure 7.8",
    .seconds = {1, 1, 4},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
