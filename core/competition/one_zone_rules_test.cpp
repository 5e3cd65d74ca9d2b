// SPDX-License-Identifier: MIT
// Rules of one zone, and zones that two plants share.
#include <cmath>

#include <gtest/gtest.h>

#include "core/competition/test_stands.hpp"
#include "core/competition/zone_laws.hpp"
#include "core/overlap/lens.hpp"
#include "core/overlap/test_discs.hpp"

namespace phytobench {
namespace {

using testing_discs::infinite;
using testing_stands::crowded_stand;
using testing_stands::losses;
using testing_stands::TestStand;
using testing_stands::with_exponent;

TestStand pair_of(double r, double s, double distance) {
  TestStand stand;
  stand.add(0, 0, r, r);
  stand.add(distance, 0, s, s);
  return stand;
}

TEST(OneZoneRulesLaw, LossesOfAPairAddUpToTheOverlap) {
  for (const char* rule : {"symmetric", "asymmetric", "mixture", "asymmetry_exponent"})
    for (const double distance : {0.1, 0.9, 1.6, 2.4, 2.6}) {
      const std::vector<double> loss =
          losses(rule, with_exponent(1.3), pair_of(1.0, 1.5, distance));
      const double lost = loss[0] * disc_area(1.0) + loss[1] * disc_area(1.5);
      EXPECT_NEAR(lost, lens_area(1.0, 1.5, distance), 1e-13) << rule << " " << distance;
    }
}

TEST(OneZoneRulesLaw, SymmetricIsHalfTheOverlapOverTheOwnZone) {
  const std::vector<double> loss = losses("symmetric", {}, pair_of(1.0, 1.0, 1.0));
  EXPECT_NEAR(loss[0], 0.5 * (2 * std::numbers::pi / 3 - std::sqrt(3.0) / 2) / std::numbers::pi,
              1e-15);
}

TEST(OneZoneRulesLaw, TheLargestPlantDoesNotFeelAsymmetricCompetition) {
  TestStand stand = crowded_stand(200, true);
  stand.add(5, 5, 3.5, 3.5);
  EXPECT_EQ(losses("asymmetric", {}, stand).back(), 0.0);
  EXPECT_GT(losses("symmetric", {}, stand).back(), 0.0);
}

TEST(OneZoneRulesLaw, MixtureJoinsBothRulesInAStraightLine) {
  const TestStand stand = crowded_stand(100, false);
  const std::vector<double> symmetric = losses("symmetric", {}, stand),
                            asymmetric = losses("asymmetric", {}, stand);
  for (const double p : {0.0, 0.25, 0.5, 1.0}) {
    const std::vector<double> mixed = losses("mixture", {.above_share = p}, stand);
    for (std::size_t i = 0; i < mixed.size(); ++i)
      EXPECT_NEAR(mixed[i], p * asymmetric[i] + (1 - p) * symmetric[i], 1e-12);
  }
}

TEST(OneZoneRulesLaw, TheExponentContainsBothRules) {
  const TestStand stand = crowded_stand(100, true);
  const auto expect_same = [&](double exponent, const char* rule) {
    const std::vector<double> by_exponent =
                                  losses("asymmetry_exponent", with_exponent(exponent), stand),
                              by_rule = losses(rule, {}, stand);
    for (std::size_t i = 0; i < by_rule.size(); ++i)
      EXPECT_NEAR(by_exponent[i], by_rule[i], 1e-12) << rule << " " << i;
  };
  expect_same(0.0, "symmetric");
  expect_same(infinite, "asymmetric");
}

TEST(OneZoneRulesLaw, TheSmallerLosesMoreTheHigherTheExponent) {
  double before = 0.0;
  for (const double exponent : {0.0, 0.5, 1.0, 2.0, 8.0, 1000.0, infinite}) {
    const std::vector<double> loss =
        losses("asymmetry_exponent", with_exponent(exponent), pair_of(1.0, 1.2, 1.0));
    EXPECT_GE(loss[0], before) << exponent;
    before = loss[0];
  }
  EXPECT_NEAR(before, lens_area(1.0, 1.2, 1.0) / disc_area(1.0), 1e-15);
}

TEST(OneZoneRulesLaw, TiesAreSharedOrDecidedOncePerPair) {
  CompetitionParameters parameters;
  const TestStand twins = pair_of(1.0, 1.0, 0.5);
  const double overlap = lens_area(1.0, 1.0, 0.5) / disc_area(1.0);
  EXPECT_EQ(losses("asymmetric", parameters, twins),
            (std::vector<double>{0.5 * overlap, 0.5 * overlap}));
  parameters.ties = TieRule::lower_id_wins;
  EXPECT_EQ(losses("asymmetric", parameters, twins), (std::vector<double>{0.0, overlap}));
  EXPECT_EQ(losses("asymmetric", parameters, twins.permuted({1, 0})),
            (std::vector<double>{overlap, 0.0}));
}

TEST(OneZoneRulesLaw, RemovingAPlantHelpsItsNeighboursAtOnce) {
  const TestStand stand = crowded_stand(60, true);
  for (const char* rule : {"symmetric", "asymmetric", "mixture", "field_of_neighbourhood"}) {
    const std::vector<double> loss = losses(rule, {}, stand);
    for (std::size_t gone = 0; gone < stand.size(); gone += 7) {
      std::vector<std::size_t> rest;
      for (std::size_t i = 0; i < stand.size(); ++i)
        if (i != gone) rest.push_back(i);
      const std::vector<double> without = losses(rule, {}, stand.permuted(rest));
      for (std::size_t k = 0; k < rest.size(); ++k)
        EXPECT_LE(without[k], loss[rest[k]] + 1e-12) << rule;
    }
  }
}

TEST(PairDistance, IsThatOfTheImageWithThisOverlap) {
  TestStand stand;
  stand.ground.torus = Rectangle{{0, 0}, {10, 10}};
  stand.add(1, 5, 3.5, 1);
  stand.add(6.5, 5, 4.5, 1);  // 5.5 one way, 4.5 round the torus: both ways they overlap
  const Discs zone = stand.plants().below;
  const double near = lens_area(3.5, 4.5, 4.5), far = lens_area(3.5, 4.5, 5.5);
  EXPECT_EQ(distance_of_pair(zone, stand.ground, 0, 1, near), 4.5);
  EXPECT_EQ(distance_of_pair(zone, stand.ground, 0, 1, far), 5.5);
  EXPECT_EQ(distance_of_pair(zone, {}, 0, 1, far), 5.5);
}

TEST(ZoneIndex, CountsRingsOfEqualWidthFromTheStemOutwards) {
  EXPECT_EQ(zone_index(5.5, 1.0, 5.0), 5);
  EXPECT_EQ(zone_index(4.5, 1.0, 5.0), 4);
  EXPECT_EQ(zone_index(3.5, 1.0, 5.0), 3);
  EXPECT_EQ(zone_index(3.0, 1.0, 5.0), 2);
  EXPECT_EQ(zone_index(2.0, 1.0, 5.0), 1);
  EXPECT_EQ(zone_index(0.5, 1.0, 5.0), 1);
  EXPECT_EQ(zone_index(5.999, 1.0, 5.0), 5);
}

}  // namespace
}  // namespace phytobench
