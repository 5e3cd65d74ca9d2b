// SPDX-License-Identifier: MIT
// Two kinds of annual plants: bankers, a share of whose seeds rests in the soil, and non-bankers,
// all of whose seeds germinate at once.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/random/unit_stream.hpp"

namespace phytobench {

/// [Alsweis] sec. 4.6; only `crowding` is published. Shares lie in [0, 1], all else is at least 0.
struct SeedBankParameters {
  double seed_mortality = 0.1;        ///< pi: share of all seeds that dies each year
  double germination = 0.3;           ///< gamma: share of the resting seeds that wakes each year
  double dormancy = 0.4;              ///< sigma: share of the bankers' new seeds that goes to rest
  double seeds_per_banker = 8.0;      ///< b_B
  double seeds_per_non_banker = 8.0;  ///< b_N
  double largest_survival = 0.5;      ///< p: share of seedlings that survive where there are few
  double crowding = 0.01;             ///< v: what each seedling takes from that; per seedling
};

/// Throws InputError that names the first parameter out of range, where it stands and its range.
void check_parameters(const SeedBankParameters& parameters);

/// Densities of plants and of resting seeds; real numbers, at least 0.
struct SeedBankState {
  double bankers = 0.0;      ///< B
  double non_bankers = 0.0;  ///< N
  double resting = 0.0;      ///< S

  friend constexpr bool operator==(const SeedBankState&, const SeedBankState&) = default;
};

/// Where one year's seeds go: germinated + dead + resting = seeds.
struct SeedBudget {
  double seeds = 0.0;       ///< fresh ones and those at rest
  double dead = 0.0;        ///< of age, before they could do either
  double germinated = 0.0;  ///< the bracket of (4.9) times 1 - pi
  double resting = 0.0;     ///< S of the next year
};
SeedBudget seed_budget(const SeedBankParameters& parameters, const SeedBankState& state);

/// P, [Alsweis] (4.9): the share of seedlings that become plants, in a year in which `survival` is
/// the share where there are few.
double seedling_survival(const SeedBankParameters& parameters, const SeedBankState& state,
                         double survival);

/// The three maps of [Alsweis] sec. 4.6, one year.
SeedBankState next_year(const SeedBankParameters& parameters, const SeedBankState& state,
                        double survival);
/// The same with the parameters' own survival.
SeedBankState next_year(const SeedBankParameters& parameters, const SeedBankState& state);

/// p / (e v): no year has more plants, because x exp(-v x) has this maximum.
double largest_plant_density(const SeedBankParameters& parameters);

/// g: the share of the seeds at rest that germinate before they die, in whichever year:
/// gamma (1 - pi) / (1 - (1 - pi) (1 - gamma)); 0 where none ever wakes.
double share_waking(const SeedBankParameters& parameters);

/// E_B = b_B ((1 - sigma) + sigma g): how many of a banker's seeds that survive their first months
/// germinate in the end. What b_N is for non-bankers.
double effective_seeds_per_banker(const SeedBankParameters& parameters);

/// Equilibria with one kind alone, in a constant environment: ln R / (v (1 - pi) E) plants, where
/// R = p (1 - pi) E and E are the seeds of the kind; none where R <= 1. v > 0. That of the
/// non-bankers is Ricker's, stable for 1 < R < e^2.
SeedBankState non_banking_equilibrium(const SeedBankParameters& parameters);
/// Resting seeds (1 - pi) sigma b_B B / (1 - (1 - pi) (1 - gamma)); pi or gamma above 0.
SeedBankState banking_equilibrium(const SeedBankParameters& parameters);

/// By what a few plants of one kind multiply each year among many of the other at its equilibrium,
/// at which (1 - pi) P = 1 / E. They invade if it is above 1. Non-bankers: b_N / E_B. Bankers: the
/// larger eigenvalue of plants and resting seeds, above 1 just where E_B > b_N. So in a constant
/// environment the kind with more effective seeds excludes the other.
double non_banker_invasion(const SeedBankParameters& parameters);
double banker_invasion(const SeedBankParameters& parameters);

/// Survival of each of `years` years: 0 with probability `bad_years`, else the parameters' own.
/// Takes one number of the stream per year.
std::vector<double> survival_of_years(const SeedBankParameters& parameters, double bad_years,
                                      std::size_t years, UnitStream& stream);

/// All years from `start` on, one more than `survival` has.
std::vector<SeedBankState> seed_bank_run(const SeedBankParameters& parameters,
                                         const SeedBankState& start,
                                         std::span<const double> survival);

}  // namespace phytobench
