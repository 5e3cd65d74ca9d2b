// SPDX-License-Identifier: MIT
#include "core/population/seed_bank.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

constexpr SeedBankState ten_of_each{10.0, 10.0, 10.0};

/// Kinds and environments of every sort.
SeedBankParameters random_parameters(UnitStream& stream) {
  return {.seed_mortality = 0.9 * stream.next_unit(),
          .germination = stream.next_unit(),
          .dormancy = stream.next_unit(),
          .seeds_per_banker = 20.0 * stream.next_unit(),
          .seeds_per_non_banker = 20.0 * stream.next_unit(),
          .largest_survival = stream.next_unit(),
          .crowding = 0.001 + 0.1 * stream.next_unit()};
}

/// Calls use(parameters, state) for 10,000 years: 100 runs of 100.
void for_random_years(
    const std::function<void(const SeedBankParameters&, const SeedBankState&)>& use) {
  CounterStream stream(4, 0);
  for (int run = 0; run < 100; ++run) {
    const SeedBankParameters parameters = random_parameters(stream);
    SeedBankState state{100.0 * stream.next_unit(), 100.0 * stream.next_unit(),
                        1000.0 * stream.next_unit()};
    for (int t = 0; t < 100; ++t) {
      use(parameters, state);
      state = next_year(parameters, state);
    }
  }
}

SeedBankState after(const SeedBankParameters& parameters, const SeedBankState& start,
                    std::size_t years) {
  SeedBankState state = start;
  for (std::size_t t = 0; t < years; ++t) state = next_year(parameters, state);
  return state;
}

TEST(SeedBankLaw, EverySeedGerminatesDiesOrRests) {
  for_random_years([](const SeedBankParameters& parameters, const SeedBankState& state) {
    const SeedBudget budget = seed_budget(parameters, state);
    ASSERT_NEAR(budget.germinated + budget.dead + budget.resting, budget.seeds,
                1e-13 * budget.seeds);
    ASSERT_EQ(budget.resting, next_year(parameters, state).resting);
  });
}

TEST(SeedBankLaw, PlantsAreTheSeedlingsThatSurvive) {
  for_random_years([](const SeedBankParameters& parameters, const SeedBankState& state) {
    const double seedlings = seed_budget(parameters, state).germinated;
    const SeedBankState next = next_year(parameters, state);
    const double p = parameters.largest_survival;
    const double plants = p * seedlings * std::exp(-parameters.crowding * seedlings);
    ASSERT_NEAR(next.bankers + next.non_bankers, plants, 1e-12 * std::max(1.0, plants));
    const double survival = seedling_survival(parameters, state, p);
    ASSERT_GE(survival, 0.0);
    ASSERT_LE(survival, p);
  });
}

TEST(SeedBankLaw, NoYearHasMorePlantsThanTheBound) {
  double fullest = 0.0;
  for_random_years([&](const SeedBankParameters& parameters, const SeedBankState& state) {
    const SeedBankState next = next_year(parameters, state);
    const double share = (next.bankers + next.non_bankers) / largest_plant_density(parameters);
    ASSERT_LE(share, 1.0 + 1e-14);
    fullest = std::max(fullest, share);
  });
  EXPECT_GT(fullest, 0.999);  // the bound is sharp
  EXPECT_NEAR(largest_plant_density({}), 0.5 * 100.0 / std::numbers::e, 1e-12);
}

TEST(SeedBankLaw, NonBankersAloneFollowRicker) {
  const SeedBankParameters parameters;
  SeedBankState state{.non_bankers = 3.0};
  for (int t = 0; t < 100; ++t) {
    const double seedlings = 0.9 * 8.0 * state.non_bankers;
    state = next_year(parameters, state);
    ASSERT_NEAR(state.non_bankers, 0.5 * seedlings * std::exp(-0.01 * seedlings), 1e-12);
    ASSERT_EQ(state.bankers, 0.0);
    ASSERT_EQ(state.resting, 0.0);
  }
}

// Bankers that rest nothing, and have nothing at rest, are non-bankers.
TEST(SeedBankLaw, KindsThatDoTheSameKeepTheirShares) {
  SeedBankParameters parameters;
  parameters.dormancy = 0.0;
  SeedBankState state{6.0, 2.0, 0.0};
  for (int t = 0; t < 1000; ++t) {
    state = next_year(parameters, state);
    ASSERT_NEAR(state.bankers / state.non_bankers, 3.0, 1e-10);
  }
  EXPECT_EQ(effective_seeds_per_banker(parameters), parameters.seeds_per_banker);
}

TEST(SeedBank, EquilibriaAreThoseOfTheClosedForms) {
  const SeedBankParameters parameters;
  EXPECT_NEAR(share_waking(parameters), 0.729730, 1e-6);
  EXPECT_NEAR(effective_seeds_per_banker(parameters), 7.135135, 1e-6);
  EXPECT_NEAR(non_banking_equilibrium(parameters).non_bankers, 17.790748, 1e-6);
  const SeedBankState banking = banking_equilibrium(parameters);
  EXPECT_NEAR(banking.bankers, 18.165559, 1e-6);
  EXPECT_NEAR(banking.resting, 141.396787, 1e-6);
}

TEST(SeedBankLaw, EquilibriaStayAndAttract) {
  CounterStream stream(5, 0);
  int tried = 0;
  for (int i = 0; i < 400; ++i) {
    const SeedBankParameters parameters = random_parameters(stream);
    const SeedBankState non_banking = non_banking_equilibrium(parameters);
    const SeedBankState banking = banking_equilibrium(parameters);
    const double scale = 1.0 / parameters.crowding;
    EXPECT_NEAR(next_year(parameters, non_banking).non_bankers, non_banking.non_bankers,
                1e-12 * scale);
    const SeedBankState next = next_year(parameters, banking);
    EXPECT_NEAR(next.bankers, banking.bankers, 1e-12 * scale);
    EXPECT_NEAR(next.resting, banking.resting, 1e-12 * scale + 1e-14 * banking.resting);
    // Ricker's map swings beyond e^2, and is slow near 1.
    const double growth = parameters.largest_survival * (1.0 - parameters.seed_mortality) *
                          parameters.seeds_per_non_banker;
    if (growth < 1.2 || growth > 7.0) continue;
    ++tried;
    EXPECT_NEAR(after(parameters, {.non_bankers = 0.1}, 2000).non_bankers, non_banking.non_bankers,
                1e-9 * scale);
  }
  EXPECT_GT(tried, 50);
  const SeedBankState run = after({}, {.bankers = 1.0}, 2000), fixed = banking_equilibrium({});
  EXPECT_NEAR(run.bankers, fixed.bankers, 1e-12);
  EXPECT_NEAR(run.resting, fixed.resting, 1e-11);
}

TEST(SeedBank, NobodyLivesWhereASeedHasLessThanOneOffspring) {
  SeedBankParameters parameters;
  parameters.largest_survival = 0.13;  // 0.13 * 0.9 * 8 < 1
  EXPECT_EQ(non_banking_equilibrium(parameters), SeedBankState{});
  EXPECT_EQ(banking_equilibrium(parameters), SeedBankState{});
  const SeedBankState end = after(parameters, ten_of_each, 2000);
  EXPECT_LT(std::max({end.bankers, end.non_bankers, end.resting}), 1e-12);
}

TEST(SeedBank, SeedsThatNeverDieWakeInTheEnd) {
  SeedBankParameters parameters;
  parameters.seed_mortality = 0.0;
  EXPECT_NEAR(share_waking(parameters), 1.0, 1e-15);
  parameters.germination = 0.0;
  EXPECT_EQ(share_waking(parameters), 0.0);
  EXPECT_THROW(banking_equilibrium(parameters), ContractViolation);
}

// What the criterion says of a few happens: multiplied by it each year, in the long run.
TEST(SeedBankLaw, InvadersMultiplyByTheCriterion) {
  for (const double seeds : {5.0, 7.0, 8.0, 12.0}) {
    SeedBankParameters parameters;
    parameters.seeds_per_non_banker = seeds;
    SeedBankState state = banking_equilibrium(parameters);
    state.non_bankers = 1e-12;
    EXPECT_NEAR(next_year(parameters, state).non_bankers / 1e-12, non_banker_invasion(parameters),
                1e-9);
    SeedBankState resident = non_banking_equilibrium(parameters);
    resident.bankers = 1e-12;
    for (int t = 0; t < 30; ++t) {  // until plants and resting seeds have their lasting ratio
      resident = next_year(parameters, resident);
      const double rest = resident.resting / resident.bankers;
      resident.bankers = 1e-12;
      resident.resting = 1e-12 * rest;
    }
    EXPECT_NEAR(next_year(parameters, resident).bankers / 1e-12, banker_invasion(parameters), 1e-6);
  }
}

TEST(SeedBankLaw, OneKindInvadesIfTheOtherCannot) {
  CounterStream stream(6, 0);
  for (int i = 0; i < 1000; ++i) {
    SeedBankParameters parameters = random_parameters(stream);
    parameters.seeds_per_banker += 0.1;
    parameters.seeds_per_non_banker += 0.1;
    EXPECT_EQ(banker_invasion(parameters) > 1.0, non_banker_invasion(parameters) < 1.0);
    parameters.seeds_per_non_banker = effective_seeds_per_banker(parameters);
    EXPECT_NEAR(banker_invasion(parameters), 1.0, 1e-12);
  }
}

TEST(SeedBankLaw, MoreEffectiveSeedsExcludeInAConstantEnvironment) {
  SeedBankParameters parameters;
  const double equal = effective_seeds_per_banker(parameters);
  parameters.seeds_per_non_banker = 0.98 * equal;
  SeedBankState end = after(parameters, ten_of_each, 6000);
  EXPECT_LT(end.non_bankers, 1e-30);
  EXPECT_NEAR(end.bankers, banking_equilibrium(parameters).bankers, 1e-9);
  parameters.seeds_per_non_banker = 1.02 * equal;
  end = after(parameters, ten_of_each, 6000);
  EXPECT_LT(std::max(end.bankers, end.resting), 1e-15);
  EXPECT_NEAR(end.non_bankers, non_banking_equilibrium(parameters).non_bankers, 1e-9);
}

TEST(SeedBank, OneBadYearEndsNonBankersButNotBankers) {
  const SeedBankParameters parameters;
  const SeedBankState bad = next_year(parameters, ten_of_each, 0.0);
  EXPECT_EQ(bad.non_bankers, 0.0);
  EXPECT_EQ(bad.bankers, 0.0);
  EXPECT_NEAR(bad.resting, 0.9 * (0.7 * 10.0 + 0.4 * 80.0), 1e-12);
  const SeedBankState later = after(parameters, bad, 500);
  EXPECT_EQ(later.non_bankers, 0.0);
  EXPECT_NEAR(later.bankers, banking_equilibrium(parameters).bankers, 1e-9);
}

TEST(SeedBank, YearsAreBadAsOftenAsAskedFor) {
  const SeedBankParameters parameters;
  for (const double share : {0.0, 0.2, 0.5, 1.0}) {
    CounterStream stream(7, 0);
    constexpr std::size_t years = 40'000;
    const std::vector<double> survival = survival_of_years(parameters, share, years, stream);
    ASSERT_EQ(survival.size(), years);
    const auto bad = static_cast<double>(std::count(survival.begin(), survival.end(), 0.0));
    EXPECT_NEAR(bad / years, share, 4.0 * std::sqrt(share * (1.0 - share) / years));
    EXPECT_EQ(std::count(survival.begin(), survival.end(), 0.5),
              static_cast<std::ptrdiff_t>(years) - static_cast<std::ptrdiff_t>(bad));
  }
}

TEST(SeedBank, ARunIsItsYears) {
  const SeedBankParameters parameters;
  const std::vector<double> survival = {0.5, 0.0, 0.3};
  const std::vector<SeedBankState> states = seed_bank_run(parameters, ten_of_each, survival);
  ASSERT_EQ(states.size(), 4u);
  EXPECT_EQ(states[0], ten_of_each);
  for (std::size_t t = 0; t < 3; ++t)
    EXPECT_EQ(states[t + 1], next_year(parameters, states[t], survival[t]));
}

TEST(SeedBank, NamesTheParameterThatIsOutOfRange) {
  SeedBankParameters parameters;
  EXPECT_NO_THROW(check_parameters(parameters));
  parameters.dormancy = 1.5;
  try {
    check_parameters(parameters);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "dormancy of the seed bank is 1.5; give a share from 0 to 1");
  }
  parameters.dormancy = 0.4;
  parameters.crowding = -0.01;
  EXPECT_THROW(check_parameters(parameters), InputError);
  parameters.crowding = std::nan("");
  EXPECT_THROW(check_parameters(parameters), InputError);
}

}  // namespace
}  // namespace phytobench
