// SPDX-License-Identifier: MIT
// Plants with and without a seed bank: where each kind settles, which of them excludes the other,
// and what changes when some years are bad.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/population/seed_bank.hpp"
#include "core/random/counter_stream.hpp"
#include "experiments/experiment.hpp"
#include "experiments/plot_artifacts.hpp"
#include "reference/oracles/alsweis_population.hpp"

namespace phytobench::experiments::alsweis {

namespace {

namespace oracles = phytobench::oracles::alsweis::population;

enum Stream : std::uint64_t {
  parameters_of_laws,
  years_of_figure,
  years_of_runs = 1'000,  // and those after it
};

/// Ours: the dissertation publishes the coefficient 0.01 only.
constexpr SeedBankParameters usual{.seed_mortality = 0.1,
                                   .germination = 0.3,
                                   .dormancy = 0.4,
                                   .seeds_per_banker = 8.0,
                                   .seeds_per_non_banker = 8.0,
                                   .largest_survival = 0.5,
                                   .crowding = 0.01};
constexpr SeedBankState ten_of_each{10.0, 10.0, 10.0};

oracles::SeedBankLetters letters_of(const SeedBankParameters& p) {
  return {.pi = p.seed_mortality,
          .gamma = p.germination,
          .sigma = p.dormancy,
          .b_B = p.seeds_per_banker,
          .b_N = p.seeds_per_non_banker,
          .p = p.largest_survival,
          .v = p.crowding};
}

SeedBankParameters random_parameters(UnitStream& stream) {
  return {.seed_mortality = stream.next_unit(),
          .germination = stream.next_unit(),
          .dormancy = stream.next_unit(),
          .seeds_per_banker = 20.0 * stream.next_unit(),
          .seeds_per_non_banker = 20.0 * stream.next_unit(),
          .largest_survival = 1.0 - stream.next_unit(),
          .crowding = 0.01};
}

/// What the maps keep to, over 10,000 years: 100 random kinds for 100 years each.
struct Laws {
  double disagreement = 0.0;  ///< of the suite and the literal maps
  double identity = 0.0;      ///< B + N against p T exp(-v T)
  double imbalance = 0.0;     ///< of seeds that germinate, die and rest, over all
  double share_of_bound = 0.0;
  double least_survival = 1.0, largest_share_of_p = 0.0;

  void add(const SeedBankParameters& parameters, const SeedBankState& state) {
    const double p = parameters.largest_survival, v = parameters.crowding;
    const oracles::SeedBank literal = oracles::section_4_6(
        {state.bankers, state.non_bankers, state.resting}, letters_of(parameters));
    const SeedBankState next = next_year(parameters, state);
    disagreement = std::max({disagreement, std::abs(next.bankers - literal.B),
                             std::abs(next.non_bankers - literal.N),
                             std::abs(next.resting - literal.S) / std::max(1.0, literal.S)});
    const SeedBudget budget = seed_budget(parameters, state);
    const double T = budget.germinated;
    identity = std::max(identity, std::abs(literal.B + literal.N - p * T * std::exp(-v * T)));
    if (budget.seeds > 0.0)
      imbalance = std::max(
          imbalance,
          std::abs(budget.germinated + budget.dead + budget.resting - budget.seeds) / budget.seeds);
    share_of_bound =
        std::max(share_of_bound, (literal.B + literal.N) / largest_plant_density(parameters));
    const double P = oracles::equation_4_9({state.bankers, state.non_bankers, state.resting},
                                           letters_of(parameters));
    least_survival = std::min(least_survival, P);
    largest_share_of_p = std::max(largest_share_of_p, P / p);
  }
};

void record_laws(ExperimentContext& context) {
  CounterStream stream(context.seed(), parameters_of_laws);
  Laws laws;
  for (int run = 0; run < 100; ++run) {
    const SeedBankParameters parameters = random_parameters(stream);
    SeedBankState state{100.0 * stream.next_unit(), 100.0 * stream.next_unit(),
                        1000.0 * stream.next_unit()};
    for (int t = 0; t < 100; ++t) {
      laws.add(parameters, state);
      state = next_year(parameters, state);
    }
  }
  const auto record = [&](const char* name, double value) {
    context.record({.experiment = {},
                    .measurement = std::string("laws/") + name,
                    .value = value,
                    .sample_size = 10'000,
                    .seed = context.seed()});
  };
  record("difference_from_printed_maps", laws.disagreement);
  record("difference_of_plants_from_survivors", laws.identity);
  record("imbalance_of_seeds", laws.imbalance);
  record("largest_share_of_bound", laws.share_of_bound);
  record("least_survival", laws.least_survival);
  record("largest_share_of_p", laws.largest_share_of_p);
  SeedBankParameters all_survive = usual;
  all_survive.largest_survival = 1.0;
  context.record("bound/plants_at_p_1", largest_plant_density(all_survive), "plants");
}

SeedBankState after(const SeedBankParameters& parameters, const SeedBankState& start,
                    std::size_t years) {
  const std::vector<double> survival(years, parameters.largest_survival);
  return seed_bank_run(parameters, start, survival).back();
}

void record_equilibria(ExperimentContext& context) {
  const SeedBankState non_banking = non_banking_equilibrium(usual);
  const SeedBankState run = after(usual, {.non_bankers = 1.0}, 2000);
  context.record("equilibrium/non_bankers", non_banking.non_bankers, "plants");
  context.record("equilibrium/non_bankers_after_2000_years", run.non_bankers, "plants");
  const SeedBankState banking = banking_equilibrium(usual);
  const SeedBankState banked = after(usual, {.bankers = 1.0}, 2000);
  context.record("equilibrium/share_waking", share_waking(usual));
  context.record("equilibrium/effective_seeds", effective_seeds_per_banker(usual), "seeds");
  context.record("equilibrium/bankers", banking.bankers, "plants");
  context.record("equilibrium/resting", banking.resting, "seeds");
  context.record("equilibrium/bankers_after_2000_years", banked.bankers, "plants");
  context.record("equilibrium/resting_after_2000_years", banked.resting, "seeds");
}

/// Both kinds from ten plants each, in a constant environment.
void record_competition(ExperimentContext& context) {
  for (const double factor : {0.9, 0.98, 1.02, 1.1}) {
    SeedBankParameters parameters = usual;
    parameters.seeds_per_non_banker = factor * effective_seeds_per_banker(usual);
    const SeedBankState end = after(parameters, ten_of_each, 6000);
    const std::string name = fmt::format("competition/factor-{}", factor);
    context.record(name + "/bankers", end.bankers, "plants");
    context.record(name + "/non_bankers", end.non_bankers, "plants");
    context.record(name + "/banker_invasion", banker_invasion(parameters), "1/year");
    context.record(name + "/non_banker_invasion", non_banker_invasion(parameters), "1/year");
  }
  const SeedBankState equal = after(usual, ten_of_each, 3000);
  context.record("constant/equal_seeds/bankers", equal.bankers, "plants");
  context.record("constant/equal_seeds/non_bankers", equal.non_bankers, "plants");
  // Of one seed, over all years: what dormancy does to its chance.
  const double alive = 1.0 - usual.seed_mortality;
  context.record("constant/chance_to_germinate/banker",
                 alive * effective_seeds_per_banker(usual) / usual.seeds_per_banker);
  context.record("constant/chance_to_germinate/non_banker", alive);
}

/// One banker and none else: where its seeds go in a year.
void record_ways_of_seeds(ExperimentContext& context) {
  const SeedBudget budget = seed_budget(usual, {.bankers = 1.0});
  context.record("ways/germinate_at_once", budget.germinated / budget.seeds);
  context.record("ways/rest", budget.resting / budget.seeds);
  context.record("ways/die", budget.dead / budget.seeds);
  SeedBankParameters without_loss = usual;
  without_loss.seed_mortality = 0.0;
  const SeedBudget kept = seed_budget(without_loss, {.bankers = 1.0});
  context.record("ways/without_mortality/germinate_at_once", kept.germinated / kept.seeds);
  context.record("ways/without_mortality/rest", kept.resting / kept.seeds);
}

struct Persistence {
  double bankers = 0.0;
  double non_bankers = 0.0;
};

/// Shares of runs of 300 years after which more than a millionth is left: of plants, or for bankers
/// of seeds.
Persistence persistence_of(const ExperimentContext& context, double bad_years, int runs) {
  int bankers = 0, non_bankers = 0;
  for (int run = 0; run < runs; ++run) {
    CounterStream stream(context.seed(), years_of_runs + static_cast<std::uint64_t>(run));
    const auto survival = survival_of_years(usual, bad_years, 300, stream);
    const SeedBankState end = seed_bank_run(usual, ten_of_each, survival).back();
    bankers += std::max(end.bankers, end.resting) > 1e-6;
    non_bankers += end.non_bankers > 1e-6;
  }
  return {static_cast<double>(bankers) / runs, static_cast<double>(non_bankers) / runs};
}

void record_bad_years(ExperimentContext& context) {
  const int runs = context.tier() == Tier::full ? 40'000 : 4'000;
  for (const double share : {0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7}) {
    context.progress(fmt::format("bad years {}", share));
    const Persistence persistence = persistence_of(context, share, runs);
    const auto record = [&](const char* name, double value) {
      context.record({.experiment = {},
                      .measurement = fmt::format("bad-years/share-{}/{}", share, name),
                      .value = value,
                      .sample_size = runs,
                      .seed = context.seed()});
    };
    record("bankers_persist", persistence.bankers);
    record("non_bankers_persist", persistence.non_bankers);
  }
}

PlotPanel years_panel(const std::vector<double>& survival, std::string caption) {
  PlotCurve bankers{.name = "with seed bank"}, others{.name = "without seed bank"};
  const std::vector<SeedBankState> states = seed_bank_run(usual, ten_of_each, survival);
  for (std::size_t t = 0; t < states.size(); ++t) {
    for (PlotCurve* curve : {&bankers, &others}) curve->x.push_back(static_cast<double>(t));
    bankers.y.push_back(states[t].bankers);
    others.y.push_back(states[t].non_bankers);
  }
  return {.curves = {bankers, others},
          .caption = std::move(caption),
          .x_label = "years",
          .y_label = "plants",
          .y_range = AxisRange{0.0, 20.0}};
}

void draw_figure(ExperimentContext& context) {
  CounterStream stream(context.seed(), years_of_figure);
  const std::vector<double> constant(120, usual.largest_survival);
  const auto changing = survival_of_years(usual, 0.15, 120, stream);
  PlotCurve bankers{.name = "with seed bank"}, others{.name = "without seed bank"};
  for (int percent = 0; percent <= 80; percent += 4) {
    const Persistence shares = persistence_of(context, percent / 100.0, 500);
    for (PlotCurve* curve : {&bankers, &others}) curve->x.push_back(percent);
    bankers.y.push_back(100.0 * shares.bankers);
    others.y.push_back(100.0 * shares.non_bankers);
  }
  const PlotPanel persistence{.curves = {bankers, others},
                              .caption = "left after 300 years",
                              .x_label = "bad years, %",
                              .y_label = "% of runs",
                              .y_range = AxisRange{0.0, 100.0}};
  add_plot(context, "seed-bank",
           {.title = "Seed-banking and other plants of equal fecundity",
            .description = "Plants of both kinds over the years, all alike and with 15 % bad ones, "
                           "and the share of runs that still have each kind after 300 years, over "
                           "the share of bad years.",
            .panels = {years_panel(constant, "all years alike"),
                       years_panel(changing, "15 % bad years"), persistence}});
}

void run(ExperimentContext& context) {
  record_laws(context);
  record_equilibria(context);
  record_competition(context);
  record_ways_of_seeds(context);
  record_bad_years(context);
  draw_figure(context);
}

}  // namespace

extern const ExperimentDescriptor seed_bank;
constinit const ExperimentDescriptor seed_bank{
    .id = "alsweis/seed-bank",
    .question = "Does a seed bank help plants that compete with others without one?",
    .source = "[Alsweis] sec. 4.6, (4.9)",
    .seconds = {1, 1, 5},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
