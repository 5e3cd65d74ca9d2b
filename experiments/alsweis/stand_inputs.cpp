// SPDX-License-Identifier: MIT
// What a population is started with, and what is kept of each plant.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/contract/check.hpp"
#include "core/overlap/overlap_registry.hpp"
#include "core/population/mortality.hpp"
#include "core/population/population.hpp"
#include "core/population/population_file.hpp"
#include "core/population/seed_production.hpp"
#include "experiments/experiment.hpp"

namespace phytobench::experiments::alsweis {

namespace {

/// Two species that bear seeds, as a user writes it down.
constexpr std::string_view stand_file = R"(
steps = 30
[ground]
size = [80.0, 80.0]
[competition]
rule = "influence_signs"
[[species]]
name = "shrub"
count = 40
largest_radius = 0.5
growth_rate = 0.05
root_factor_poor = 15.0
root_factor_rich = 8.0
crown_factor_poor = 12.0
crown_factor_rich = 6.0
[species.reproduction]
threshold = 0.1
seeds_per_metre = 0.5
seedling_radius = 0.02
[[species]]
name = "herb"
count = 60
start_radius = [0.005, 0.01]
largest_radius = 0.05
growth_rate = 0.01
[[influence]]
of = "*"
on = "*"
above = "harms"
below = "harms"
)";

std::string with(std::string_view line, std::string_view other_line) {
  std::string text(stand_file);
  const std::size_t place = text.find(line);
  PHYTOBENCH_EXPECT(place != std::string::npos);
  return text.replace(place, line.size(), other_line);
}

Population population_of(const PopulationParameters& parameters) {
  return {parameters, sow(parameters), overlap_engine_named("layered_grid")};
}

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

/// What a stand file leads to.
void record_outcome(ExperimentContext& context, const std::string& name,
                    const PopulationParameters& parameters) {
  Population population = population_of(parameters);
  context.record(name + "/mean_loss_at_start", mean(population.losses()));
  context.record(name + "/mean_root_zone_at_start", mean(population.root_radii()), "m");
  context.record(name + "/mean_crown_zone_at_start", mean(population.crown_radii()), "m");
  context.record(name + "/plants_at_start", static_cast<std::int64_t>(population.stand().size()),
                 "plants");
  for (int t = 0; t < parameters.steps; ++t) population.step();
  const std::vector<double>& stems = population.stand().stem_radius;
  const auto born = static_cast<std::int64_t>(population.state().born[0]) - 40;
  context.record(name + "/seedlings", born, "plants");
  context.record(name + "/largest_stem", *std::max_element(stems.begin(), stems.end()), "m");
  context.record(name + "/mean_stem", mean(stems), "m");
}

/// Every input of sections 4.7 and 5.5 changed alone.
void record_inputs(ExperimentContext& context) {
  const auto parsed = [](const std::string& text) {
    return parse_population(text, "stand.toml").parameters;
  };
  record_outcome(context, "inputs/as_written", parsed(std::string(stand_file)));
  const std::pair<const char*, std::string> changes[] = {
      {"twice_the_plants", with("count = 60", "count = 120")},
      {"twice_the_seeds", with("seeds_per_metre = 0.5", "seeds_per_metre = 1.0")},
      {"smaller_size", with("largest_radius = 0.5", "largest_radius = 0.3")},
      {"slower_growth", with("growth_rate = 0.05", "growth_rate = 0.03")},
      {"crowns_do_nothing", with("above = \"harms\"", "above = \"none\"")},
      {"roots_help", with("below = \"harms\"", "below = \"helps\"")}};
  for (const auto& [name, text] : changes)
    record_outcome(context, fmt::format("inputs/{}", name), parsed(text));
  PopulationParameters poor = parsed(std::string(stand_file));
  const ResourceMap halves(2, 1, {0.0, 0.5}, poor.ground);
  poor.nutrients = halves;
  record_outcome(context, "inputs/grey_soil", poor);
  poor.nutrients = {};
  poor.light = halves;
  record_outcome(context, "inputs/grey_light", poor);
}

/// The five regions of figure 4.6 from rich to poor, side by side: root zones of one stem.
void record_regions(ExperimentContext& context) {
  PopulationParameters parameters;
  parameters.ground = {{0, 0}, {100, 100}};
  parameters.species.resize(1);
  parameters.species[0].name = "plant";
  parameters.species[0].roots = {15.0, 6.0, 0.5};
  std::vector<double> resource;
  for (const double d : {6.0, 8.0, 10.0, 12.5, 15.0}) resource.push_back((15.0 - d) / 9.0);
  parameters.nutrients = ResourceMap(5, 1, resource, parameters.ground);
  std::vector<StartPlant> plants;
  for (const double x : {10.0, 30.0, 50.0, 70.0, 90.0}) plants.push_back({{x, 50}, 0.1, 0});
  const Population population(parameters, sow(parameters, plants),
                              overlap_engine_named("all_pairs"));
  const char* const regions[] = {"i", "iii", "ii", "iv", "vi"};
  const std::vector<double> radii = population.root_radii();
  for (std::size_t k = 0; k < radii.size(); ++k)
    context.record(fmt::format("regions/{}/root_zone", regions[population.stand().id[k]]), radii[k],
                   "m");
}

/// What the suite kept of a plant after every step so far.
struct Kept {
  std::vector<double> stems;
  double root_zone = 0.0, crown_zone = 0.0, loss = 0.0;
  std::int32_t age = 0;
  SpeciesIndex species = 0;
};

/// Counts what changed since the step before, plant by plant.
class Follower {
 public:
  void follow(Population& population) {
    const Stand& stand = population.stand();
    const auto losses = population.losses();
    const auto roots = population.root_radii(), crowns = population.crown_radii();
    for (std::size_t k = 0; k < stand.size(); ++k) {
      Kept& before = kept_[stand.id[k]];
      if (!before.stems.empty()) {
        ++updates_;
        const bool has_grown = stand.stem_radius[k] > before.stems.back();
        sizes_ += has_grown == (before.loss < 0.5);
        zones_ += (roots[k] > before.root_zone) == has_grown &&
                  (crowns[k] > before.crown_zone) == has_grown;
        ages_ += stand.age[k] == before.age + 1;
        species_ += stand.species[k] == before.species;
      }
      before.stems.push_back(stand.stem_radius[k]);
      before.root_zone = roots[k], before.crown_zone = crowns[k], before.loss = losses[k];
      before.age = stand.age[k], before.species = stand.species[k];
      look_at_vitality(population.state(), k, before.stems);
    }
  }

  void record(ExperimentContext& context) const {
    for (const auto& [name, count] :
         {std::pair{"grows_unless_oppressed", sizes_}, std::pair{"zones_follow_size", zones_},
          std::pair{"one_step_older", ages_}, std::pair{"same_species", species_}})
      context.record({.experiment = {},
                      .measurement = fmt::format("kept/{}", name),
                      .value = static_cast<double>(count) / static_cast<double>(updates_),
                      .sample_size = updates_});
    context.record("kept/vitality/largest_difference", vitality_off_, "m per step");
    context.record("kept/vitality/compared", vitalities_, "values");
  }

 private:
  /// (4.8), read as growth: the suite's mean over the window beside what was seen.
  void look_at_vitality(const PopulationState& state, std::size_t k,
                        const std::vector<double>& stems) {
    const std::size_t window = state.recent_growth.size();
    if (stems.size() <= window) return;
    const double seen =
        (stems.back() - stems[stems.size() - 1 - window]) / static_cast<double>(window);
    vitality_off_ = std::max(vitality_off_, std::abs(mean_recent_growth(state, k) - seen));
    ++vitalities_;
  }

  std::map<PlantId, Kept> kept_;
  std::int64_t updates_ = 0, sizes_ = 0, zones_ = 0, ages_ = 0, species_ = 0, vitalities_ = 0;
  double vitality_off_ = 0.0;
};

/// Whether everything that is kept follows the plants from step to step; and the seeds, whose
/// number is a function of species and size, beside what was sown.
void record_what_is_kept(ExperimentContext& context) {
  const PopulationParameters parameters = parse_population(stand_file, "stand.toml").parameters;
  const Species& shrub = parameters.species[0];
  const SeedProduction seeds{shrub.reproduction.threshold, shrub.reproduction.seeds_per_metre,
                             shrub.largest_radius};
  Population population = population_of(parameters);
  Follower follower;
  follower.follow(population);
  double expected = 0.0;
  for (int t = 0; t < parameters.steps; ++t) {
    population.step();
    follower.follow(population);
    const Stand& stand = population.stand();
    for (std::size_t k = 0; k < stand.size(); ++k)
      if (stand.species[k] == 0 && stand.age[k] > 0)
        expected += seeds.expected_seeds(stand.stem_radius[k]);
  }
  follower.record(context);
  const auto sown = static_cast<double>(population.state().born[0]) - 40.0;
  context.record("kept/seeds/expected", expected, "seeds");
  context.record("kept/seeds/sown", sown, "seeds");
  context.record("kept/seeds/deviation", (sown - expected) / std::sqrt(expected),
                 "standard errors");
}

/// How many different values there are of each of a plant's properties, some time after a third of
/// the plants fell ill.
void record_properties(ExperimentContext& context) {
  PopulationParameters parameters = parse_population(stand_file, "stand.toml").parameters;
  parameters.events = {{.kind = EventKind::disease, .step = 10, .share = 0.3}};
  Population population = population_of(parameters);
  for (int t = 0; t < parameters.steps; ++t) population.step();
  const Stand& stand = population.stand();
  const auto count = [&](const char* name, std::size_t number) {
    context.record(fmt::format("properties/{}", name), static_cast<std::int64_t>(number), "values");
  };
  std::set<std::pair<double, double>> places;
  std::set<bool> states;
  for (std::size_t k = 0; k < stand.size(); ++k) {
    places.insert({stand.x[k], stand.y[k]});
    states.insert(stand.ill_since[k] != healthy);
  }
  count("plants", stand.size());
  count("states", states.size());
  count("species", std::set(stand.species.begin(), stand.species.end()).size());
  count("sizes", std::set(stand.stem_radius.begin(), stand.stem_radius.end()).size());
  count("ages", std::set(stand.age.begin(), stand.age.end()).size());
  count("places", places.size());
}

void run(ExperimentContext& context) {
  record_inputs(context);
  record_regions(context);
  record_what_is_kept(context);
  record_properties(context);
}

}  // namespace

extern const ExperimentDescriptor stand_inputs;
constinit const ExperimentDescriptor stand_inputs{
    .id = "alsweis/stand-inputs",
    .question = "What is a population started with, and what is kept of each plant?",
    .source = "[Alsweis] sec. 4.7, 5.1, 5.5, fig. 4.6",
    .seconds = {1, 1, 1},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
