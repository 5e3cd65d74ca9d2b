// SPDX-License-Identifier: MIT
// Populations of the core beside the literal stand: every rule of [Alsweis], on the plane and on a
// torus, plant by plant and step by step.
#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/overlap/overlap_registry.hpp"
#include "core/population/population.hpp"
#include "core/random/counter_stream.hpp"
#include "reference/oracles/alsweis_stand.hpp"

namespace phytobench::oracles::alsweis::competition {
namespace {

constexpr int compared_steps = 60;
constexpr std::size_t plants_at_start = 100;

// Nurses that hardly grow, deep roots; seedlings; a species between them.
std::vector<Species> three_species() {
  std::vector<Species> species(3);
  species[0].name = "nurse";
  species[0].largest_radius = 0.5;
  species[0].growth_rate = 0.02;
  species[0].roots = {9.0, 9.0, 0.5};
  species[0].crown = {7.0, 7.0, 0.5};
  species[0].traits = {.crown_opacity = 0.4, .root_rank = 1.0};
  species[1].name = "seedling";
  species[1].largest_radius = 0.1;
  species[1].growth_rate = 0.01;
  species[1].roots = {20.0, 20.0, 1.0};
  species[1].crown = {5.0, 5.0, 0.5};
  species[1].traits = {.crown_opacity = 1.0, .root_rank = 0.0, .open_ground_stress = 0.2};
  species[2].name = "shrub";
  species[2].largest_radius = 0.3;
  species[2].growth_rate = 0.03;
  species[2].roots = {8.0, 8.0, 0.7};
  species[2].crown = {9.0, 9.0, 0.6};
  species[2].traits = {.crown_opacity = 0.9, .root_rank = 0.5};
  return species;
}

std::vector<StartPlant> scattered(const PopulationParameters& parameters, std::size_t count) {
  const double side = parameters.ground.width();
  CounterStream stream(21, 0);
  std::vector<StartPlant> plants;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t kind = i % 10 == 0 ? 0 : i % 10 < 7 ? 1 : 2;
    const double share = i % 5 == 0 ? 0.2 : stream.next_between(0.05, 0.4);  // some are equal
    plants.push_back({{stream.next_between(0, side), stream.next_between(0, side)},
                      share * parameters.species[kind].largest_radius,
                      static_cast<SpeciesIndex>(kind)});
  }
  return plants;
}

struct Case {
  std::string rule;
  bool is_torus = true;
  MortalityRule death = MortalityRule::none;
  TieRule ties = TieRule::share;
  double side = 40.0;  // m

  friend std::ostream& operator<<(std::ostream& out, const Case& c) {
    return out << c.rule << (c.is_torus ? "_torus" : "_plane") << static_cast<int>(c.death)
               << static_cast<int>(c.ties);
  }
};

bool uses_signs(const std::string& rule) {
  return rule == "influence_signs" || rule == "nurse" || rule == "combined";
}

PopulationParameters parameters_of(const Case& c) {
  PopulationParameters parameters;
  parameters.steps = compared_steps;
  parameters.ground = {{0, 0}, {c.side, c.side}};
  parameters.is_torus = c.is_torus;
  parameters.rule = c.rule;
  parameters.species = three_species();
  parameters.competition.above_share = 0.35;
  parameters.competition.ties = c.ties;
  parameters.competition.light_constant = 1.3;
  if (uses_signs(c.rule)) {
    using enum Influence;
    parameters.competition.influence_above = {harms, none, harms, harms, harms,
                                              harms, none, harms, helps};
    parameters.competition.influence_below = {harms, none,  harms, helps, harms,
                                              none,  harms, harms, harms};
  }
  parameters.mortality.rule = c.death;
  parameters.mortality.threshold = c.death == MortalityRule::mean_growth ? 0.0001
                                   : c.death == MortalityRule::mean_size ? 0.012
                                                                         : 0.005;
  parameters.illness.duration = 25;
  PopulationEvent ill, out;
  ill.step = 4;
  ill.plants = {0, 3, 8, 9, 20};
  out.kind = EventKind::removal;
  out.step = 11;
  out.plants = {10, 33};
  parameters.events = {ill, out};
  return parameters;
}

Death death_of(MortalityRule rule) {
  return rule == MortalityRule::none          ? Death::never
         : rule == MortalityRule::mean_growth ? Death::mean_growth
         : rule == MortalityRule::mean_size   ? Death::mean_size
                                              : Death::mean_relative_growth;
}

LiteralModel literal_of(const PopulationParameters& parameters) {
  const std::string& rule = parameters.rule;
  LiteralModel model;
  model.species.clear();
  for (const Species& s : parameters.species)
    model.species.push_back({.R_max = s.largest_radius,
                             .MGR = s.growth_rate,
                             .d_root = s.roots.rich_factor,
                             .b_root = s.roots.exponent,
                             .d_crown = s.crown.rich_factor,
                             .b_crown = s.crown.exponent,
                             .L = s.traits.crown_opacity,
                             .rank = s.traits.root_rank,
                             .stress = s.traits.open_ground_stress});
  if (parameters.is_torus) model.period_x = model.period_y = parameters.ground.width();
  const bool is_one = rule == "symmetric" || rule == "asymmetric" || rule == "mixture";
  model.zones = is_one ? Zones::one : Zones::two;
  model.p = rule == "symmetric" ? 0.0 : rule == "asymmetric" ? 1.0 : 0.35;
  const bool is_all = rule == "combined";
  model.has_light = is_all || rule == "light";
  model.k = parameters.competition.light_constant;
  model.has_roots = is_all || rule == "roots";
  model.has_illness = is_all || rule == "disease";
  model.has_stress = is_all || rule == "nurse";
  for (const Influence s : parameters.competition.influence_above)
    model.s1.push_back(static_cast<int>(s));
  for (const Influence s : parameters.competition.influence_below)
    model.s2.push_back(static_cast<int>(s));
  model.lower_wins = parameters.competition.ties == TieRule::lower_id_wins;
  model.illness_steps = parameters.illness.duration;
  model.death = death_of(parameters.mortality.rule);
  model.n = parameters.mortality.window;
  model.threshold = parameters.mortality.threshold;
  return model;
}

// Names the first plant that differs; empty if none does.
std::string difference(const Population& population, const LiteralStand& stand) {
  const Stand& ours = population.stand();
  std::vector<double> sizes(stand.plants().size(), NAN);
  for (std::size_t k = 0; k < ours.size(); ++k) sizes[ours.id[k]] = ours.stem_radius[k];
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const LiteralPlant& plant = stand.plants()[i];
    if (plant.is_dead != std::isnan(sizes[i])) return "life of plant " + std::to_string(i);
    if (!plant.is_dead && !(std::abs(sizes[i] - plant.R) <= 1e-12 * plant.R))
      return "size of plant " + std::to_string(i) + ": " + std::to_string(sizes[i]);
  }
  return "";
}

struct Trajectories {
  std::string difference;
  std::size_t survivors = 0;
  double overlap = 0.0;  // mean loss at the start
};

Trajectories compare(const PopulationParameters& parameters, LiteralModel model,
                     std::size_t count = plants_at_start) {
  const std::vector<StartPlant> start = scattered(parameters, count);
  Population population(parameters, sow(parameters, start), overlap_engine_named("all_pairs"));
  std::vector<LiteralPlant> plants;
  for (const StartPlant& plant : start)
    plants.push_back({plant.place.x, plant.place.y, plant.stem_radius, plant.species});
  LiteralStand stand(std::move(model), std::move(plants));
  Trajectories result;
  for (const double loss : stand.losses())
    result.overlap += std::abs(loss) / static_cast<double>(start.size());
  for (int t = 0; t < compared_steps && result.difference.empty(); ++t) {
    for (const PopulationEvent& event : parameters.events)
      for (const PlantId plant : event.plants)
        if (event.step == t)
          event.kind == EventKind::removal ? stand.remove(plant) : stand.fall_ill(plant);
    population.step();
    stand.step();
    result.difference = difference(population, stand);
    if (!result.difference.empty()) result.difference += " in step " + std::to_string(t);
  }
  result.survivors = population.stand().size();
  return result;
}

class PopulationOracle : public testing::TestWithParam<Case> {};

TEST_P(PopulationOracle, GoesTheWayOfTheLiteralStand) {
  const PopulationParameters parameters = parameters_of(GetParam());
  const Trajectories result = compare(parameters, literal_of(parameters));
  EXPECT_EQ(result.difference, "");
  EXPECT_GT(result.overlap, 0.05);                 // or nothing was compared
  const std::size_t before = plants_at_start - 2;  // two are taken out
  if (GetParam().death == MortalityRule::none)
    EXPECT_EQ(result.survivors, before);
  else
    EXPECT_LT(result.survivors, before);
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const char* rule : {"symmetric", "asymmetric", "mixture", "above_below", "influence_signs",
                           "light", "roots", "disease", "nurse", "combined"})
    for (const bool is_torus : {false, true}) all.push_back({rule, is_torus});
  for (const MortalityRule death :
       {MortalityRule::mean_growth, MortalityRule::mean_relative_growth, MortalityRule::mean_size})
    for (const char* rule : {"mixture", "combined"}) all.push_back({rule, true, death});
  for (const char* rule : {"mixture", "light"})
    all.push_back({rule, true, MortalityRule::none, TieRule::lower_id_wins});
  return all;
}

// Zones of nearly half the torus meet a neighbour across several borders at once.
TEST(SmallTorusOracle, PopulationsCountEveryImage) {
  for (const char* rule : {"mixture", "light", "combined"}) {
    PopulationParameters parameters = parameters_of({.rule = rule, .side = 13.0});
    parameters.events.clear();
    const Trajectories result = compare(parameters, literal_of(parameters), 12);
    EXPECT_EQ(result.difference, "") << rule;
    EXPECT_GT(result.overlap, 0.05);
  }
}

INSTANTIATE_TEST_SUITE_P(Rules, PopulationOracle, testing::ValuesIn(cases()),
                         testing::PrintToStringParamName());

// The comparison itself must see what is wrong.
TEST(PopulationComparisonOracle, SeesEveryMisprint) {
  const PopulationParameters mixture = parameters_of({.rule = "mixture"});
  const PopulationParameters all = parameters_of({.rule = "combined"});
  LiteralModel model = literal_of(mixture);
  model.as_printed.gain_as_loss = true;
  EXPECT_NE(compare(mixture, model).difference, "");
  for (bool AsPrinted::*misprint :
       {&AsPrinted::light_without_size, &AsPrinted::illness_from_2s, &AsPrinted::roots_of_pair}) {
    model = literal_of(all);
    model.as_printed.*misprint = true;
    EXPECT_NE(compare(all, model).difference, "");
  }
  model = literal_of(all);
  model.species[1].MGR *= 1.0 + 1e-11;
  EXPECT_NE(compare(all, model).difference, "");
}

}  // namespace
}  // namespace phytobench::oracles::alsweis::competition
