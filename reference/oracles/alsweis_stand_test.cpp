// SPDX-License-Identifier: MIT
#include "reference/oracles/alsweis_stand.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/random/counter_stream.hpp"

namespace phytobench::oracles::alsweis::competition {
namespace {

std::vector<LiteralPlant> scattered(std::size_t count, double side, std::size_t species = 1) {
  CounterStream stream(11, count);
  std::vector<LiteralPlant> plants;
  for (std::size_t i = 0; i < count; ++i)
    plants.push_back({stream.next_between(0, side), stream.next_between(0, side),
                      stream.next_between(0.03, 0.07), i % species});
  return plants;
}

std::vector<LiteralPlant> pair(double distance, double R, double S, std::size_t own = 0,
                               std::size_t other = 0) {
  return {{0, 0, R, own}, {distance, 0, S, other}};
}

void run(LiteralStand& stand, int steps) {
  for (int t = 0; t < steps; ++t) stand.step();
}

double radius_after(const LiteralModel& model, const std::vector<LiteralPlant>& plants, int steps,
                    std::size_t plant = 0) {
  LiteralStand stand(model, plants);
  run(stand, steps);
  return stand.plants()[plant].R;
}

TEST(LiteralStandLaw, PlantsOutOfReachGrowAsIfAlone) {
  LiteralStand stand({.p = 0.5}, {{0, 0, 0.05}, {1000, 0, 0.05}});
  run(stand, 60);
  double R = 0.05;
  for (int t = 0; t < 60; ++t) R += 0.05 * R / 0.5 * (1 - R / 0.5);
  for (const LiteralPlant& plant : stand.plants()) EXPECT_NEAR(plant.R, R, 1e-15);
  EXPECT_EQ(stand.plants()[0].age, 60);
  EXPECT_EQ(stand.plants()[0].sizes.size(), 61u);
}

TEST(LiteralStandLaw, EqualPlantsStayEqualAndTheSmallerFallsBehind) {
  for (const Zones zones : {Zones::one, Zones::two}) {
    LiteralStand equal({.zones = zones, .p = 0.7}, pair(8, 0.05, 0.05));
    LiteralStand unequal({.zones = zones, .p = 0.7}, pair(8, 0.05, 0.06));
    run(equal, 40);
    run(unequal, 40);
    EXPECT_EQ(equal.plants()[0].R, equal.plants()[1].R);
    EXPECT_LT(unequal.plants()[0].R / 0.05, unequal.plants()[1].R / 0.06);
  }
}

TEST(LiteralStandLaw, TheLargestGrowsAsIfAloneWhereItWinsAll) {
  std::vector<LiteralPlant> plants = scattered(60, 60);
  plants[17].R = 0.08;
  const LiteralModel model{.period_x = 60, .period_y = 60, .p = 1.0};
  EXPECT_EQ(radius_after(model, plants, 40, 17), radius_after(model, {plants[17]}, 40));
}

TEST(LiteralStandLaw, OrderAndPlaceOfTheOriginDoNotMatter) {
  const LiteralModel model{.period_x = 60, .period_y = 60, .zones = Zones::two, .p = 0.4};
  std::vector<LiteralPlant> plants = scattered(60, 60);
  std::vector<double> sizes, moved;
  for (std::size_t i = 0; i < plants.size(); ++i)
    sizes.push_back(radius_after(model, plants, 1, i));
  for (LiteralPlant& plant : plants) {
    plant.x = std::fmod(plant.x + 23, 60);
    plant.y = std::fmod(plant.y + 41, 60);
  }
  std::reverse(plants.begin(), plants.end());
  for (std::size_t i = 0; i < plants.size(); ++i)
    moved.push_back(radius_after(model, plants, 1, i));
  std::reverse(moved.begin(), moved.end());
  for (std::size_t i = 0; i < sizes.size(); ++i) EXPECT_NEAR(sizes[i], moved[i], 1e-12);
}

TEST(LiteralStandLaw, NeighboursReachAcrossTheBorderOfATorusOnly) {
  const std::vector<LiteralPlant> plants{{0.5, 30, 0.05}, {59.5, 30, 0.05}};
  EXPECT_EQ(LiteralStand({}, plants).losses()[0], 0.0);
  const LiteralModel torus{.period_x = 60, .period_y = 60};
  EXPECT_NEAR(LiteralStand(torus, plants).losses()[0],
              LiteralStand({}, pair(1, 0.05, 0.05)).losses()[0], 1e-12);
}

TEST(LiteralStandLaw, WithoutANeighbourNobodyLosesMore) {
  for (const Zones zones : {Zones::one, Zones::two}) {
    LiteralStand stand({.zones = zones, .p = 0.3}, scattered(80, 40));
    const std::vector<double> before = stand.losses();
    stand.remove(5);
    const std::vector<double> after = stand.losses();
    int freed = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
      EXPECT_LE(after[i], before[i]);
      freed += after[i] < before[i];
    }
    EXPECT_GT(freed, 1);
    EXPECT_EQ(after[5], 0.0);
  }
}

TEST(LiteralStandLaw, HelpersSpeedGrowthBeyondThatOfALonePlant) {
  const LiteralModel nurse{.zones = Zones::two, .p = 0.0, .s2 = {-1}};
  LiteralStand covered(nurse, {{0, 0, 0.05}, {0, 0, 0.2}, {0, 0, 0.2}});
  EXPECT_NEAR(covered.losses()[0], -1.0, 1e-12);  // half by each of two
  EXPECT_GT(radius_after(nurse, pair(1, 0.05, 0.2), 20), radius_after(nurse, {{0, 0, 0.05}}, 20));
}

TEST(LiteralStandLaw, StressOfOpenGroundIsMadeUpForByHelpers) {
  const LiteralModel model{
      .species = {{.stress = 0.6}}, .zones = Zones::two, .p = 0.0, .has_stress = true, .s2 = {-1}};
  EXPECT_EQ(radius_after(model, {{0, 0, 0.05}}, 20), 0.05);
  EXPECT_GT(radius_after(model, pair(0, 0.05, 0.2), 20), 0.05);
}

// Printed forms: each does something the corrected one does not.

TEST(PrintedStandOracle, TheLargerPlantPaysForWhatItWins) {
  const LiteralModel printed{.p = 1.0, .as_printed = {.gain_as_loss = true}}, corrected{.p = 1.0};
  const auto plants = pair(4, 0.05, 0.07);
  const auto p = LiteralStand(printed, plants).losses(),
             c = LiteralStand(corrected, plants).losses();
  EXPECT_EQ(p[0], 0.0);
  EXPECT_GT(p[1], 0.0);
  EXPECT_GT(c[0], 0.0);
  EXPECT_EQ(c[1], 0.0);
}

TEST(PrintedStandOracle, UngatedLightTakesTheOverlapTwice) {
  LiteralModel model{.zones = Zones::two, .p = 1.0, .has_light = true};
  const auto plants = pair(4, 0.05, 0.07);
  const auto corrected = LiteralStand(model, plants).losses();
  model.as_printed.light_without_size = true;
  const auto printed = LiteralStand(model, plants).losses();
  EXPECT_EQ(printed[0], corrected[0]);
  EXPECT_EQ(corrected[1], 0.0);
  EXPECT_NEAR(printed[1] * 0.07, printed[0] * 0.05, 1e-15);  // areas go with R
}

TEST(PrintedStandOracle, RootsOfThePairLetNobodyWin) {
  LiteralModel model{
      .species = {{.rank = 0.0}, {.rank = 1.0}}, .zones = Zones::two, .p = 0.0, .has_roots = true};
  EXPECT_NEAR(radius_after(model, pair(8, 0.05, 0.05, 0, 1), 80, 0), 0.21895, 1e-5);
  EXPECT_NEAR(radius_after(model, pair(8, 0.05, 0.05, 0, 1), 80, 1), 0.48999, 1e-5);
  model.as_printed.roots_of_pair = true;
  EXPECT_EQ(radius_after(model, pair(8, 0.05, 0.05, 0, 1), 80, 0),
            radius_after(model, pair(8, 0.05, 0.05, 0, 1), 80, 1));
}

TEST(PrintedStandOracle, AnIllPlantIsAStrongerRivalAndNeverLetsGo) {
  LiteralModel model{.zones = Zones::two, .p = 0.0, .has_illness = true};
  const auto beside = [&](bool is_ill, int steps) {
    LiteralStand stand(model, pair(8, 0.05, 0.05));
    if (is_ill) stand.fall_ill(1);
    run(stand, steps);
    return stand.plants()[0].R;
  };
  const double alone = radius_after(model, {{0, 0, 0.05}}, 40), healthy = beside(false, 40);
  EXPECT_NEAR(alone, 0.42826, 1e-5);
  EXPECT_NEAR(healthy, 0.34552, 1e-5);
  EXPECT_NEAR(beside(true, 40), 0.40607, 1e-5);
  model.as_printed.illness_from_2s = true;
  EXPECT_NEAR(beside(true, 40), 0.26450, 1e-5);
}

// Death.

LiteralModel deadly(Death death, double threshold) {
  return {.death = death, .n = 5, .threshold = threshold};
}

TEST(LiteralDeathLaw, SlowGrowthKillsTheCoveredAndSizeTheSmall) {
  const std::vector<LiteralPlant> alone{{0, 0, 0.05}}, covered{{0, 0, 0.05}, {0, 0, 0.4}};
  const auto dead_after = [](const LiteralModel& model, const std::vector<LiteralPlant>& plants) {
    LiteralStand stand(model, plants);
    int steps = 0;
    while (!stand.plants()[0].is_dead && steps < 20) {
      stand.step();
      ++steps;
    }
    return steps;
  };
  LiteralModel growth = deadly(Death::mean_growth, 0.0002), size = deadly(Death::mean_size, 0.1);
  growth.p = size.p = 1.0;
  EXPECT_EQ(dead_after(growth, alone), 20);  // lives
  EXPECT_EQ(dead_after(growth, covered), 5);
  EXPECT_EQ(dead_after(size, alone), 5);  // although nothing hinders it
}

TEST(LiteralDeathLaw, PlantsThatAreGrownUpDoNotStarve) {
  const std::vector<LiteralPlant> old{{0, 0, 0.499}}, small{{0, 0, 0.05}, {0, 0, 0.4}};
  LiteralModel model = deadly(Death::mean_relative_growth, 0.01);
  model.p = 1.0;
  LiteralStand stand(model, old), other(model, small);
  run(stand, 20);
  run(other, 5);
  EXPECT_FALSE(stand.plants()[0].is_dead);
  EXPECT_TRUE(other.plants()[0].is_dead);
}

TEST(PrintedStandOracle, OneTermMoreOverNDoublesTheMeanOfOne) {
  // A mean over n + 1 equal sizes is (n + 1) / n of them: 0.08 > 0.075 > 0.04.
  LiteralModel model{
      .species = {{.MGR = 0.0}}, .death = Death::mean_size, .n = 1, .threshold = 0.075};
  LiteralStand corrected(model, {{0, 0, 0.04}});
  model.as_printed.one_term_more = true;
  LiteralStand printed(model, {{0, 0, 0.04}});
  run(corrected, 1);
  run(printed, 1);
  EXPECT_TRUE(corrected.plants()[0].is_dead);
  EXPECT_FALSE(printed.plants()[0].is_dead);
}

TEST(LiteralDeathLaw, AgeAndIllnessEndAtTheirStep) {
  LiteralStand old({.species = {{.oldest = 7}}}, {{0, 0, 0.05}});
  run(old, 6);
  EXPECT_FALSE(old.plants()[0].is_dead);
  old.step();
  EXPECT_TRUE(old.plants()[0].is_dead);
  LiteralStand ill({.has_illness = true, .illness_steps = 4, .illness_kills = true},
                   {{0, 0, 0.05}});
  run(ill, 3);
  ill.fall_ill(0);
  run(ill, 3);
  EXPECT_FALSE(ill.plants()[0].is_dead);
  ill.step();
  EXPECT_TRUE(ill.plants()[0].is_dead);
}

}  // namespace
}  // namespace phytobench::oracles::alsweis::competition
