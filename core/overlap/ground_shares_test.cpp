// SPDX-License-Identifier: MIT
#include "core/overlap/ground_shares.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/overlap/lens.hpp"
#include "core/overlap/test_discs.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

using testing_discs::covered_by;
using testing_discs::exponents;
using testing_discs::infinite;
using testing_discs::pi;
using testing_discs::Scene;
using testing_discs::shares_of;
using testing_discs::sum_of;

TEST(GroundShares, OfCoincidentDiscsAreEqualOrGoToTheLowestNumber) {
  Scene scene;
  for (int i = 0; i < 5; ++i) scene.add(1, 2, 3);
  for (const double exponent : exponents)
    EXPECT_THAT(shares_of(scene, exponent), testing::Each(testing::DoubleNear(9 * pi / 5, 1e-13)));
  const std::vector<std::uint64_t> order = {4, 3, 1, 2, 9};
  EXPECT_THAT(ground_shares(scene.discs(), {}, {.exponent = infinite, .tie_order = order}),
              testing::ElementsAre(0.0, 0.0, testing::DoubleNear(9 * pi, 1e-13), 0.0, 0.0));
  EXPECT_THAT(ground_shares(scene.discs(), {}, {.exponent = 2.0, .tie_order = order}),
              testing::Each(testing::DoubleNear(9 * pi / 5, 1e-13)));
}

TEST(GroundShares, FollowNestedTouchingAndConcurrentDiscs) {
  Scene nested;
  for (const double r : {3.0, 2.0, 1.0}) nested.add(r, 0, r);  // all touch from inside at 0
  EXPECT_THAT(shares_of(nested, 0.0),
              testing::ElementsAre(testing::DoubleNear(pi * (5 + 3. / 2 + 1. / 3), 1e-12),
                                   testing::DoubleNear(pi * (3. / 2 + 1. / 3), 1e-12),
                                   testing::DoubleNear(pi / 3, 1e-12)));
  EXPECT_THAT(shares_of(nested, 1.0),
              testing::ElementsAre(testing::DoubleNear(pi * (5 + 3 * 9. / 13 + 9. / 14), 1e-12),
                                   testing::DoubleNear(pi * (3 * 4. / 13 + 4. / 14), 1e-12),
                                   testing::DoubleNear(pi / 14, 1e-12)));
  EXPECT_THAT(shares_of(nested, infinite),
              testing::ElementsAre(testing::DoubleNear(9 * pi, 1e-13), 0.0, 0.0));
  Scene lattice;  // touching, nowhere overlapping
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 3; ++j) lattice.add(i, j, 0.5);
  EXPECT_THAT(shares_of(lattice, 1.0), testing::Each(pi / 4));
  Scene through_one_point;
  for (int i = 0; i < 6; ++i)
    through_one_point.add(std::cos(i * pi / 3), std::sin(i * pi / 3), 1.0);
  const double sixth = covered_by(through_one_point, [](std::size_t) { return true; }) / 6;
  EXPECT_THAT(shares_of(through_one_point, 3.0), testing::Each(testing::DoubleNear(sixth, 1e-13)));
}

TEST(GroundShares, OfDiscsAlmostAtOnePlaceAreAlmostEqual) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    CounterStream stream(seed, 4);
    const double apart = std::pow(10.0, -17 * stream.next_unit());
    Scene scene;
    for (std::size_t i = 0; i < 2 + seed % 7; ++i) {
      const double x = 3 + apart * stream.next_unit();
      const double r = seed % 2 == 0 ? 1.0 : 1.0 + apart * stream.next_unit();
      scene.add(x, 4 + apart * stream.next_unit(), r);
    }
    const std::vector<double> won = shares_of(scene, 0.0);
    EXPECT_NEAR(sum_of(won), covered_by(scene, [](std::size_t) { return true; }), 1e-12) << apart;
    for (const double w : won)
      EXPECT_NEAR(w, pi / static_cast<double>(scene.size()), 10 * apart + 1e-13) << apart;
  }
}

/// Weights 1 : 3^2000 : 1000^2000. Where the largest ends, the others' are 0 beside it.
TEST(GroundShares, KeepWhatIsHeldBeyondAFarStrongerDisc) {
  Scene scene;
  scene.add(0, 0, 1.0);
  scene.add(0.5, 0, 3.0);
  scene.add(0.5, 0, 3.0);
  scene.add(1000.5, 0, 1000.0);
  const std::vector<double> won = shares_of(scene, 1000.0);
  const double held = 9 * pi - lens_area(3, 1000, 1000);
  EXPECT_NEAR(won[0], 0.0, 1e-11);
  EXPECT_NEAR(won[1], 0.5 * held, 1e-11);
  EXPECT_NEAR(won[2], 0.5 * held, 1e-11);
  EXPECT_NEAR(won[3] / scene.area(3), 1.0, 1e-14);
}

TEST(GroundShares, TellHardlyDifferentDiscsApartByALargeExponent) {
  Scene scene;
  scene.add(0, 0, 1.0);
  scene.add(0, 0, 1.0 + 1e-9);
  const double more = (1.0 + 1e-9) - 1.0;
  const double expected = pi / (1 + std::exp(2e9 * std::log1p(more)));
  EXPECT_NEAR(shares_of(scene, 1e9)[0], expected, 1e-14);
  EXPECT_EQ(shares_of(scene, 1e300)[0], 0.0);
  for (const double scale : {1e-60, 1e60}) {
    Scene extreme;
    for (const double r : {0.7, 1.0}) extreme.add(0, 0, r * scale);
    EXPECT_NEAR(shares_of(extreme, 50.0)[1] / extreme.area(1), 1.0, 1e-14);
  }
}

TEST(GroundShares, OfNothingAreNothing) {
  Scene scene;
  EXPECT_TRUE(shares_of(scene, 1.0).empty());
  scene.add(0, 0, 0.0);
  EXPECT_THAT(shares_of(scene, 1.0), testing::ElementsAre(0.0));
  scene.add(0, 0, 2.0);
  EXPECT_THAT(shares_of(scene, 1.0), testing::ElementsAre(0.0, 4 * pi));
  EXPECT_THROW(shares_of(scene, -1.0), ContractViolation);
}

TEST(GroundShares, GiveUpBeyondTheMostPairs) {
  Scene scene;
  for (int i = 0; i < 20; ++i) scene.add(0, 0, 1);
  EXPECT_THROW(ground_shares(scene.discs(), {}, {}, 1, 100), InputError);
}

}  // namespace
}  // namespace phytobench
