// SPDX-License-Identifier: MIT
#include "benchmarks/competition/step_race.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <numbers>

#include <fmt/format.h>

#include "benchmarks/resident_memory.hpp"
#include "core/competition/competition_registry.hpp"
#include "core/contract/errors.hpp"
#include "core/overlap/overlap_registry.hpp"
#include "core/population/population.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {

namespace {

constexpr std::string_view engine_name = "layered_grid";

template <class Work>
double seconds_of(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

Population population_of(const PopulationParameters& parameters, std::string_view engine,
                         int threads) {
  return {parameters, sow(parameters), overlap_engine_named(engine), threads};
}

std::vector<double> losses_of(const PopulationParameters& parameters, std::string_view engine,
                              int threads) {
  return population_of(parameters, engine, threads).losses();
}

PopulationParameters with_rule(PopulationParameters parameters,
                               const CompetitionRuleDescriptor& rule) {
  parameters.rule = rule.name;
  return parameters;
}

/// Side of a square torus on which zones of these radii overlap so often.
double side_for(const std::vector<double>& radii, double pairs_per_plant) {
  double sum = 0.0, squares = 0.0;
  for (const double r : radii) {
    sum += r;
    squares += r * r;
  }
  const double n = static_cast<double>(radii.size());
  // Two plants overlap with probability pi (r + s)^2 / area; there are n / 2 pairs per plant.
  const double mean_square_of_sum = 2.0 * squares / n + 2.0 * (sum / n) * (sum / n);
  return std::sqrt(0.5 * n * std::numbers::pi * mean_square_of_sum / pairs_per_plant);
}

class StepRace {
 public:
  explicit StepRace(const StepRaceRequest& request)
      : request_(request),
        parameters_(stepping_population(request.plants, request.pairs_per_plant, request.seed)) {}

  std::vector<StepEntry> run() {
    for (const StepContestant& contestant : request_.contestants)
      static_cast<StepContestant&>(entries_.emplace_back()) = contestant;
    for (StepEntry& entry : entries_) {
      progress("checking " + std::string(entry.rule->name));
      entry.objection = objection_to_rule(*entry.rule, entry.threads);
    }
    for (StepEntry& entry : entries_) measure_memory(entry);
    time_in_turns();
    return std::move(entries_);
  }

 private:
  void progress(const std::string& what) const {
    if (request_.is_interrupted && request_.is_interrupted()) throw Interrupted("no result");
    if (request_.show_progress) request_.show_progress(what);
  }

  std::string objection_to_rule(const CompetitionRuleDescriptor& rule, int threads) const {
    const PopulationParameters few =
        with_rule(stepping_population(std::min<std::int64_t>(request_.plants, 1'500),
                                      request_.pairs_per_plant, request_.seed),
                  rule);
    const std::string on_few =
        objection_to_losses(losses_of(few, engine_name, threads), losses_of(few, "all_pairs", 1));
    if (!on_few.empty()) return on_few + " than with all pairs tried";
    const PopulationParameters all = with_rule(parameters_, rule);
    const std::vector<double> found = losses_of(all, engine_name, threads);
    if (threads > 1 && found != losses_of(all, engine_name, 1))
      return "another result with another number of threads";
    return objection_to_neighbourhoods(all, found);
  }

  /// Some plants again, each among its neighbours alone.
  std::string objection_to_neighbourhoods(const PopulationParameters& parameters,
                                          const std::vector<double>& losses) const {
    constexpr std::size_t looked_at = 20;
    const PopulationState state = sow(parameters);
    CounterStream stream(request_.seed, 7);
    for (std::size_t k = 0; k < looked_at && state.stand.size() > 0; ++k) {
      const auto i =
          static_cast<std::size_t>(stream.next_unit() * static_cast<double>(state.stand.size()));
      const auto [alone, place] = neighbourhood(parameters, state, i);
      const double again =
          Population(parameters, alone, overlap_engine_named("all_pairs")).losses()[place];
      const std::string objection =
          objection_to_losses(std::span(&losses[i], 1), std::span(&again, 1));
      if (!objection.empty())
        return fmt::format("plant {}: {} than among its neighbours alone", i, objection);
    }
    return "";
  }

  /// The plants around plant i that its zones may meet, and where i is among them.
  static std::pair<PopulationState, std::size_t> neighbourhood(
      const PopulationParameters& parameters, const PopulationState& state, std::size_t i) {
    const double reach = 20.0;  // m; the largest zone has 4
    PopulationState near;
    near.recent_growth.resize(state.recent_growth.size());
    near.born.assign(state.born.size(), 0);
    near.died = near.born;
    std::size_t place = 0;
    const auto apart = [](double a, double b, double side) {
      const double d = std::abs(a - b);
      return std::min(d, side - d);
    };
    for (std::size_t j = 0; j < state.stand.size(); ++j) {
      if (apart(state.stand.x[i], state.stand.x[j], parameters.ground.width()) > reach ||
          apart(state.stand.y[i], state.stand.y[j], parameters.ground.height()) > reach)
        continue;
      if (j == i) place = near.stand.size();
      add_plant(near, state.stand.place(j), state.stand.stem_radius[j], state.stand.species[j]);
    }
    return {std::move(near), place};
  }

  void measure_memory(StepEntry& entry) const {
    if (!entry.objection.empty()) return;
    progress("memory of " + std::string(entry.rule->name));
    if (!reset_peak_memory()) return;
    const auto before = resident_bytes();
    Population population =
        population_of(with_rule(parameters_, *entry.rule), engine_name, entry.threads);
    population.step();
    population.step();
    const auto peak = peak_resident_bytes();
    if (before && peak)
      entry.bytes_per_plant =
          static_cast<double>(*peak - *before) / static_cast<double>(request_.plants);
  }

  struct Runner {
    StepEntry* entry;
    std::unique_ptr<Population> population;
  };

  void time_in_turns() {
    std::vector<Runner> runners;
    for (StepEntry& entry : entries_) {
      if (!entry.objection.empty()) continue;
      runners.push_back(
          {&entry, std::make_unique<Population>(population_of(with_rule(parameters_, *entry.rule),
                                                              engine_name, entry.threads))});
      runners.back().population->step();  // asks for all memory, and orders the plants
    }
    for (int round = 0; round < request_.rounds; ++round) {
      progress(fmt::format("round {} of {}", round + 1, request_.rounds));
      CounterStream order(request_.seed, 1000 + static_cast<std::uint64_t>(round));
      for (const std::size_t turn : random_order(runners.size(), order)) time_one(runners[turn]);
    }
  }

  void time_one(Runner& runner) {
    Population& population = *runner.population;
    const std::uint64_t before = population.pairs_found();
    runner.entry->seconds.push_back(seconds_of([&] { population.step(); }));
    runner.entry->pairs = population.pairs_found() - before;
    if (runner.entry->rule->uses_below) runner.entry->search.push_back(search_seconds(runner));
  }

  /// The same search without a rule that reads what it finds.
  double search_seconds(const Runner& runner) const {
    const Population& population = *runner.population;
    const Stand& stand = population.stand();
    PairSearch search(overlap_engine_named(engine_name),
                      {.threads = runner.entry->threads, .most_pairs = most_pairs_of_a_step});
    const Ground ground{.torus = parameters_.ground};
    const std::vector<double> roots = population.root_radii(), crowns = population.crown_radii();
    const auto find = [&] {
      search.for_each_part({stand.x, stand.y, roots}, ground, [](std::span<const OverlapPairs>) {});
      if (runner.entry->rule->uses_above)
        search.for_each_part({stand.x, stand.y, crowns}, ground,
                             [](std::span<const OverlapPairs>) {});
    };
    find();  // asks for its memory
    return seconds_of(find);
  }

  const StepRaceRequest& request_;
  PopulationParameters parameters_;
  std::vector<StepEntry> entries_;
};

}  // namespace

PopulationParameters stepping_population(std::int64_t plants, double pairs_per_plant,
                                         std::uint64_t seed) {
  PopulationParameters parameters;
  parameters.seed = seed;
  parameters.species.resize(2);
  Species &large = parameters.species[0], &small = parameters.species[1];
  large.name = "large";
  large.count = plants * 3 / 10;
  large.crown = {.poor_factor = 12.0, .rich_factor = 12.0};
  large.traits = {.crown_opacity = 0.8, .root_rank = 1.0};
  small = large;
  small.name = "small";
  small.count = plants - large.count;
  small.roots = {.poor_factor = 8.0, .rich_factor = 8.0};
  small.crown = {.poor_factor = 6.0, .rich_factor = 6.0};
  small.traits = {.crown_opacity = 0.3, .root_rank = 0.0, .open_ground_stress = 0.01};
  for (Species& species : parameters.species) species.growth_rate = 1e-9;
  parameters.mortality = {.rule = MortalityRule::mean_size, .threshold = 1e-12};
  std::vector<double> radii;
  for (const Species& species : parameters.species)
    for (int k = 0; k < 1000 * (species.name == "large" ? 3 : 7); ++k) {
      const double share = (k + 0.5) / (1000.0 * (species.name == "large" ? 3 : 7));
      const double stem =
          species.start_radius_low + share * (species.start_radius_high - species.start_radius_low);
      radii.push_back(species.roots.poor_factor * std::sqrt(stem));
    }
  const double side = side_for(radii, pairs_per_plant) *
                      std::sqrt(static_cast<double>(plants) / static_cast<double>(radii.size()));
  parameters.ground = {{0.0, 0.0}, {std::max(side, 20.0), std::max(side, 20.0)}};
  return parameters;
}

std::string objection_to_losses(std::span<const double> found, std::span<const double> expected) {
  if (found.size() != expected.size())
    return fmt::format("{} losses instead of {}", found.size(), expected.size());
  constexpr double rounding = 1e-10;
  for (std::size_t i = 0; i < found.size(); ++i)
    if (!(std::abs(found[i] - expected[i]) <= rounding * std::max(1.0, std::abs(expected[i]))))
      return fmt::format("plant {} loses {:.17g} instead of {:.17g}", i, found[i], expected[i]);
  return "";
}

std::vector<StepEntry> race_steps(const StepRaceRequest& request) {
  return StepRace(request).run();
}

}  // namespace phytobench
