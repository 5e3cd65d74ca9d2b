// SPDX-License-Identifier: MIT
#include "core/population/seed_bank.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/contract/check.hpp"
#include "core/contract/errors.hpp"

namespace phytobench {

namespace {

/// 1 - pi.
double alive(const SeedBankParameters& p) {
  return 1.0 - p.seed_mortality;
}

/// (1 - pi) (1 - gamma): share of the resting seeds that still rest a year later.
double still_resting(const SeedBankParameters& p) {
  return alive(p) * (1.0 - p.germination);
}

/// Seedlings of the bankers: from fresh seeds and from resting ones.
double banker_seedlings(const SeedBankParameters& p, const SeedBankState& s) {
  return alive(p) *
         ((1.0 - p.dormancy) * p.seeds_per_banker * s.bankers + p.germination * s.resting);
}

double non_banker_seedlings(const SeedBankParameters& p, const SeedBankState& s) {
  return alive(p) * p.seeds_per_non_banker * s.non_bankers;
}

double resting_next_year(const SeedBankParameters& p, const SeedBankState& s) {
  return still_resting(p) * s.resting + alive(p) * p.dormancy * p.seeds_per_banker * s.bankers;
}

double survival_among(const SeedBankParameters& p, double seedlings, double survival) {
  return survival * std::exp(-p.crowding * seedlings);
}

/// Plants of one kind alone whose seedlings are `seeds` each.
double plants_at_equilibrium(const SeedBankParameters& p, double seeds) {
  PHYTOBENCH_EXPECT(p.crowding > 0.0);
  const double sparse_growth = p.largest_survival * alive(p) * seeds;
  return sparse_growth > 1.0 ? std::log(sparse_growth) / (p.crowding * alive(p) * seeds) : 0.0;
}

}  // namespace

void check_parameters(const SeedBankParameters& parameters) {
  const auto share = [](const char* name, double value) {
    if (!(value >= 0.0 && value <= 1.0))
      throw InputError(
          fmt::format("{} of the seed bank is {}; give a share from 0 to 1", name, value));
  };
  const auto amount = [](const char* name, double value) {
    if (!(value >= 0.0 && std::isfinite(value)))
      throw InputError(
          fmt::format("{} of the seed bank is {}; give a number from 0 on", name, value));
  };
  share("seed_mortality", parameters.seed_mortality);
  share("germination", parameters.germination);
  share("dormancy", parameters.dormancy);
  share("largest_survival", parameters.largest_survival);
  amount("seeds_per_banker", parameters.seeds_per_banker);
  amount("seeds_per_non_banker", parameters.seeds_per_non_banker);
  amount("crowding", parameters.crowding);
}

SeedBudget seed_budget(const SeedBankParameters& parameters, const SeedBankState& state) {
  const double seeds = parameters.seeds_per_banker * state.bankers +
                       parameters.seeds_per_non_banker * state.non_bankers + state.resting;
  return {
      .seeds = seeds,
      .dead = parameters.seed_mortality * seeds,
      .germinated = banker_seedlings(parameters, state) + non_banker_seedlings(parameters, state),
      .resting = resting_next_year(parameters, state)};
}

double seedling_survival(const SeedBankParameters& parameters, const SeedBankState& state,
                         double survival) {
  return survival_among(
      parameters, banker_seedlings(parameters, state) + non_banker_seedlings(parameters, state),
      survival);
}

SeedBankState next_year(const SeedBankParameters& parameters, const SeedBankState& state,
                        double survival) {
  const double bankers = banker_seedlings(parameters, state);
  const double non_bankers = non_banker_seedlings(parameters, state);
  const double share = survival_among(parameters, bankers + non_bankers, survival);
  return {.bankers = share * bankers,
          .non_bankers = share * non_bankers,
          .resting = resting_next_year(parameters, state)};
}

SeedBankState next_year(const SeedBankParameters& parameters, const SeedBankState& state) {
  return next_year(parameters, state, parameters.largest_survival);
}

double largest_plant_density(const SeedBankParameters& parameters) {
  PHYTOBENCH_EXPECT(parameters.crowding > 0.0);
  return parameters.largest_survival / (std::numbers::e * parameters.crowding);
}

double share_waking(const SeedBankParameters& parameters) {
  const double wake = parameters.germination * alive(parameters);
  return wake > 0.0 ? wake / (1.0 - still_resting(parameters)) : 0.0;
}

double effective_seeds_per_banker(const SeedBankParameters& parameters) {
  const double at_once = 1.0 - parameters.dormancy;
  return parameters.seeds_per_banker * (at_once + parameters.dormancy * share_waking(parameters));
}

SeedBankState non_banking_equilibrium(const SeedBankParameters& parameters) {
  return {.non_bankers = plants_at_equilibrium(parameters, parameters.seeds_per_non_banker)};
}

SeedBankState banking_equilibrium(const SeedBankParameters& parameters) {
  PHYTOBENCH_EXPECT(still_resting(parameters) < 1.0);
  const double bankers = plants_at_equilibrium(parameters, effective_seeds_per_banker(parameters));
  const double fresh =
      alive(parameters) * parameters.dormancy * parameters.seeds_per_banker * bankers;
  return {.bankers = bankers, .resting = fresh / (1.0 - still_resting(parameters))};
}

double non_banker_invasion(const SeedBankParameters& parameters) {
  const double effective = effective_seeds_per_banker(parameters);
  PHYTOBENCH_EXPECT(effective > 0.0);
  return parameters.seeds_per_non_banker / effective;
}

double banker_invasion(const SeedBankParameters& parameters) {
  PHYTOBENCH_EXPECT(parameters.seeds_per_non_banker > 0.0);
  // Plants and resting seeds of the next year from those of this one.
  const double at_once =
      (1.0 - parameters.dormancy) * parameters.seeds_per_banker / parameters.seeds_per_non_banker;
  const double rest = still_resting(parameters);
  const double way_round = parameters.germination * alive(parameters) * parameters.dormancy *
                           parameters.seeds_per_banker / parameters.seeds_per_non_banker;
  const double half_gap = 0.5 * (at_once - rest);
  return 0.5 * (at_once + rest) + std::sqrt(half_gap * half_gap + way_round);
}

std::vector<double> survival_of_years(const SeedBankParameters& parameters, double bad_years,
                                      std::size_t years, UnitStream& stream) {
  PHYTOBENCH_EXPECT(bad_years >= 0.0 && bad_years <= 1.0);
  std::vector<double> survival(years);
  for (double& year : survival)
    year = stream.next_unit() < bad_years ? 0.0 : parameters.largest_survival;
  return survival;
}

std::vector<SeedBankState> seed_bank_run(const SeedBankParameters& parameters,
                                         const SeedBankState& start,
                                         std::span<const double> survival) {
  std::vector<SeedBankState> states{start};
  states.reserve(survival.size() + 1);
  for (const double year : survival) states.push_back(next_year(parameters, states.back(), year));
  return states;
}

}  // namespace phytobench
