// SPDX-License-Identifier: MIT
// Whether plants die of being small, as section 4.5 has it, or of not growing.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/overlap/overlap_registry.hpp"
#include "core/population/population.hpp"
#include "experiments/experiment.hpp"

namespace phytobench::experiments::alsweis {

namespace {

constexpr int window = 5;

struct Rule {
  const char* name;
  MortalityRule rule;
  double threshold;
};

/// Dead if the last five sizes are below 10 cm on average, a fifth of the largest; or if the last
/// five growths are below 0.2 mm.
constexpr Rule rules[] = {{"size", MortalityRule::mean_size, 0.1},
                          {"growth", MortalityRule::mean_growth, 0.0002}};

PopulationParameters woody(const Rule& rule) {
  PopulationParameters parameters;
  parameters.ground = {{0, 0}, {1000, 1000}};
  parameters.rule = "asymmetric";
  parameters.species.resize(1);
  parameters.species[0].name = "plant";
  parameters.mortality = {.rule = rule.rule, .window = window, .threshold = rule.threshold};
  return parameters;
}

/// A hundred seedlings of 5 cm that no other plant reaches; or each beside the stem of a large one.
std::vector<StartPlant> seedlings(bool are_covered) {
  std::vector<StartPlant> plants;
  for (int i = 0; i < 10; ++i)
    for (int j = 0; j < 10; ++j) {
      const Point2 place{100.0 * i + 50.0, 100.0 * j + 50.0};
      plants.push_back({place, 0.05, 0});
      if (are_covered) plants.push_back({{place.x + 1.0, place.y}, 0.45, 0});
    }
  return plants;
}

/// How many of the hundred are dead after the first window.
void record_deaths(ExperimentContext& context) {
  for (const Rule& rule : rules)
    for (const bool are_covered : {false, true}) {
      const PopulationParameters parameters = woody(rule);
      Population population(parameters, sow(parameters, seedlings(are_covered)),
                            overlap_engine_named("layered_grid"));
      for (int t = 0; t < window; ++t) population.step();
      const std::string name = fmt::format("{}/{}/", rule.name, are_covered ? "covered" : "alone");
      const auto alive = static_cast<std::int64_t>(population.stand().size());
      context.record(name + "dead", (are_covered ? 200 : 100) - alive, "plants");
    }
}

/// Mean sizes over the last steps of plants that lose more and less than the median, in a crowd
/// that began alike.
void record_risk(ExperimentContext& context) {
  PopulationParameters parameters = woody({"none", MortalityRule::none, 0.0});
  parameters.seed = context.seed();
  parameters.ground = {{0, 0}, {200, 200}};
  parameters.rule = "mixture";
  parameters.species[0].count = 400;
  parameters.species[0].start_radius_low = parameters.species[0].start_radius_high = 0.05;
  Population population(parameters, sow(parameters), overlap_engine_named("layered_grid"));
  for (int t = 0; t < 30; ++t) population.step();
  const std::vector<double> losses = population.losses();
  std::vector<double> ordered = losses;
  std::nth_element(ordered.begin(), ordered.begin() + 200, ordered.end());
  double pressed = 0.0, free = 0.0;
  for (std::size_t k = 0; k < losses.size(); ++k)
    (losses[k] >= ordered[200] ? pressed : free) += population.stand().stem_radius[k] / 200.0;
  context.record("risk/mean_size/pressed", pressed, "m");
  context.record("risk/mean_size/free", free, "m");
}

void run(ExperimentContext& context) {
  record_deaths(context);
  record_risk(context);
}

}  // namespace

extern const ExperimentDescriptor mortality_by_size;
constinit const ExperimentDescriptor mortality_by_size{
    .id = "alsweis/mortality-by-size",
    .question = "Does a plant die of being small, or of not growing?",
    .source = "[Alsweis] sec. 4.5",
    .seconds = {1, 1, 1},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
