// SPDX-License-Identifier: MIT
// Rules of two zones on pairs whose losses follow from the printed formulas.
#include <numbers>

#include <gtest/gtest.h>

#include "core/competition/test_stands.hpp"
#include "core/competition/zone_laws.hpp"
#include "core/overlap/lens.hpp"

namespace phytobench {
namespace {

using testing_stands::losses;
using testing_stands::TestStand;

/// A tall plant of species 1 and a small one of species 0 with zones that partly overlap.
struct Pair {
  double root = 1.0, crown = 0.8, tall_root = 2.0, tall_crown = 3.0, distance = 2.6;

  TestStand stand(double weakening_of_tall = 0.0) const {
    TestStand stand;
    stand.add(0, 0, root, crown, 0);
    stand.add(distance, 0, tall_root, tall_crown, 1, weakening_of_tall);
    return stand;
  }
  double below() const { return lens_area(root, tall_root, distance) / disc_area(root); }
  double above() const { return lens_area(crown, tall_crown, distance) / disc_area(crown); }
};

CompetitionParameters parameters_of(double p) {
  return {.above_share = p, .species = {CompetitionTraits(), CompetitionTraits()}};
}

TEST(AboveBelow, IsTheWeightedSumOfBothTerms) {
  const Pair pair;  // (2.6 - 0.8) / 3 reaches ring 3
  for (const double p : {0.0, 0.3, 1.0}) {
    const std::vector<double> loss = losses("above_below", parameters_of(p), pair.stand());
    EXPECT_NEAR(loss[0], p * pair.above() + (1 - p) * 0.5 * pair.below(), 1e-15);
    EXPECT_NEAR(loss[1], (1 - p) * 0.5 * lens_area(1, 2, 2.6) / disc_area(2.0), 1e-15);
  }
}

TEST(AboveBelow, OuterRingsWeighLess) {
  const auto loss_at = [](double distance) {
    Pair pair;
    pair.distance = distance;
    return losses("above_below", parameters_of(1.0), pair.stand())[0] / pair.above();
  };
  EXPECT_NEAR(loss_at(3.7), 0.6, 1e-14);
  EXPECT_NEAR(loss_at(3.0), 0.75, 1e-14);
  EXPECT_NEAR(loss_at(2.5), 1.0, 1e-14);
  EXPECT_NEAR(loss_at(1.0), 1.0, 1e-14);
}

TEST(InfluenceSigns, NineStatesOfATallNeighbour) {
  const Pair pair;
  CompetitionParameters parameters = parameters_of(0.4);
  for (const Influence above : {Influence::harms, Influence::none, Influence::helps})
    for (const Influence below : {Influence::harms, Influence::none, Influence::helps}) {
      parameters.influence_above.assign(4, Influence::harms);
      parameters.influence_below.assign(4, Influence::harms);
      parameters.influence_above[1] = above;  // of species 1 on species 0
      parameters.influence_below[1] = below;
      const double expected = static_cast<double>(above) * 0.4 * pair.above() +
                              static_cast<double>(below) * 0.6 * 0.5 * pair.below();
      const std::vector<double> loss = losses("influence_signs", parameters, pair.stand());
      EXPECT_NEAR(loss[0], expected, 1e-15);
      EXPECT_NEAR(loss[1], 0.6 * 0.5 * lens_area(1, 2, 2.6) / disc_area(2.0), 1e-15);
    }
}

TEST(Light, OpacityOfTheLargerCrownMovesTheShare) {
  Pair pair;
  pair.distance = 1.5;  // (1.5 - 0.8) / 3 reaches ring 2
  for (const double opacity : {0.0, 0.5, 1.0}) {
    CompetitionParameters parameters = parameters_of(1.0);
    parameters.light_constant = 1.4;
    parameters.species[0].crown_opacity = 0.123;  // the smaller one's does not matter
    parameters.species[1].crown_opacity = opacity;
    const std::vector<double> loss = losses("light", parameters, pair.stand());
    const double weight = 1.4 / 2;
    EXPECT_NEAR(loss[0], weight * pair.above() * (1 + opacity) / 2, 1e-14);
    EXPECT_NEAR(loss[1] * disc_area(3.0) + loss[0] * disc_area(0.8),
                weight * lens_area(0.8, 3.0, 1.5), 1e-14);
  }
}

TEST(Light, OfEqualCrownsTheWinnersOpacityCounts) {
  CompetitionParameters parameters = parameters_of(1.0);
  parameters.ties = TieRule::lower_id_wins;
  parameters.species[0].crown_opacity = 0.0;
  parameters.species[1].crown_opacity = 1.0;
  TestStand stand;
  stand.add(0, 0, 1, 1, 0);
  stand.add(1, 0, 1, 1, 1);
  const std::vector<double> loss = losses("light", parameters, stand);
  EXPECT_EQ(loss[0], loss[1]);  // the open crown of the lower id wins: nothing, that is
  const std::vector<double> other = losses("light", parameters, stand.permuted({1, 0}));
  EXPECT_EQ(other[0], loss[1]);
  EXPECT_EQ(other[1], loss[0]);
}

TEST(Roots, DeepNeighboursTakeTwiceAsMuch) {
  const Pair pair;
  CompetitionParameters parameters = parameters_of(0.0);
  parameters.species[0].root_rank = 1.0;
  parameters.species[1].root_rank = 0.0;
  const std::vector<double> loss = losses("roots", parameters, pair.stand());
  EXPECT_NEAR(loss[0], 0.5 * pair.below(), 1e-15);
  EXPECT_NEAR(loss[1], lens_area(1, 2, 2.6) / disc_area(2.0), 1e-15);
}

TEST(Disease, AnIllNeighbourTakesLess) {
  const Pair pair;
  for (const double weakening : {0.0, 0.25, 1.0}) {
    const std::vector<double> loss = losses("disease", parameters_of(0.0), pair.stand(weakening));
    EXPECT_NEAR(loss[0], (1 - weakening) * 0.5 * pair.below(), 1e-15);
    EXPECT_NEAR(loss[1], 0.5 * lens_area(1, 2, 2.6) / disc_area(2.0), 1e-15);
  }
}

TEST(Nurse, RootsHelpAgainstTheStressOfOpenGround) {
  const Pair pair;
  CompetitionParameters parameters = parameters_of(0.25);
  parameters.species[0].open_ground_stress = 0.6;
  const std::vector<double> loss = losses("nurse", parameters, pair.stand());
  EXPECT_NEAR(loss[0], 0.6 + 0.25 * pair.above() - 0.75 * 0.5 * pair.below(), 1e-15);
  TestStand alone;
  alone.add(0, 0, 1, 1, 0);
  EXPECT_EQ(losses("nurse", parameters, alone)[0], 0.6);
}

TEST(Combined, IsEachRuleWhereTheOthersAreSilent) {
  const TestStand stand = testing_stands::crowded_stand(80, true);
  CompetitionParameters parameters = testing_stands::two_species();
  parameters.influence_above.clear();
  parameters.influence_below.clear();
  for (CompetitionTraits& traits : parameters.species)
    traits = {.crown_opacity = 0.6, .root_rank = 0.0, .open_ground_stress = 0.0};
  TestStand without_ill = stand;
  without_ill.weakening.assign(stand.size(), 0.0);
  EXPECT_EQ(losses("combined", parameters, without_ill), losses("light", parameters, without_ill));
}

TEST(GrowthFactor, FallsToNothingAtOneHalf) {
  EXPECT_EQ(growth_factor(0.0), 1.0);
  EXPECT_EQ(growth_factor(0.25), 0.5);
  EXPECT_EQ(growth_factor(0.5), 0.0);
  EXPECT_EQ(growth_factor(0.7), 0.0);
  EXPECT_EQ(growth_factor(-1.0), 3.0);
}

}  // namespace
}  // namespace phytobench
