// SPDX-License-Identifier: MIT
#include "core/overlap/ground_shares.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "core/overlap/lens.hpp"
#include "core/overlap/overlap_registry.hpp"
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

/// Radii of a few sizes and of none: equal ones meet, too.
Scene random_scene(std::uint64_t seed, std::size_t count, double largest, bool on_torus) {
  Scene scene;
  CounterStream stream(seed, 0);
  for (std::size_t i = 0; i < count; ++i) {
    const double x = 10 * stream.next_unit(), y = 8 * stream.next_unit();
    const double size = 0.05 + stream.next_unit();
    scene.add(x, y, largest * (i % 3 == 0 ? std::ceil(4 * size) / 4 : size));
  }
  if (on_torus) scene.ground.torus = Rectangle{{0, 0}, {10, 8}};
  return scene;
}

template <class Check>
void for_random_scenes(const Check& check) {
  for (std::uint64_t seed = 0; seed < 24; ++seed) {
    SCOPED_TRACE(seed);
    check(random_scene(seed, 2 + 5 * seed, seed % 3 == 0 ? 0.6 : 1.7, seed % 2 == 0));
  }
}

TEST(GroundSharesLaw, AllTogetherWinWhatIsCovered) {
  for_random_scenes([](const Scene& scene) {
    const double covered = covered_by(scene, [](std::size_t) { return true; });
    for (const double exponent : exponents)
      EXPECT_NEAR(sum_of(shares_of(scene, exponent)), covered, 1e-11) << exponent;
  });
}

TEST(GroundSharesLaw, NobodyWinsLessThanItsOwnOrMoreThanItsArea) {
  for_random_scenes([](const Scene& scene) {
    const std::vector<double> covered = coverage(scene.discs(), scene.ground).covered;
    for (const double exponent : exponents) {
      const std::vector<double> won = shares_of(scene, exponent);
      for (std::size_t i = 0; i < scene.size(); ++i) {
        EXPECT_GE(won[i], scene.area(i) - covered[i] - 1e-11) << i;
        EXPECT_LE(won[i], scene.area(i)) << i;
      }
    }
  });
}

/// A_k, the ground of disc i that k discs cover: without i it is covered k - 1 times.
TEST(GroundSharesLaw, EqualSharesAreGroundOverMultiplicity) {
  for_random_scenes([](const Scene& scene) {
    const Coverage with = coverage(scene.discs(), scene.ground);
    const std::vector<double> won = shares_of(scene, 0.0);
    for (std::size_t i = 0; i < std::min<std::size_t>(scene.size(), 8); ++i) {
      Scene others = scene;
      others.radius[i] = 0.0;
      const Coverage without = coverage(others.discs(), others.ground);
      const auto at = [](const Coverage& c, std::size_t k) {
        return k < c.by_times.size() ? c.by_times[k] : 0.0;
      };
      double exactly = scene.area(i) - with.covered[i], expected = exactly;
      for (std::size_t k = 2; k < with.by_times.size(); ++k) {
        exactly += at(without, k - 1) - at(with, k - 1);
        expected += exactly / static_cast<double>(k);
      }
      EXPECT_NEAR(won[i], expected, 1e-10) << i;
    }
  });
}

TEST(GroundSharesLaw, WinnerTakesWhatNoLargerDiscCovers) {
  for_random_scenes([](const Scene& scene) {
    std::vector<std::uint64_t> order(scene.size());
    std::iota(order.rbegin(), order.rend(), 0u);  // the later of equals wins
    const SharingLaw law{.exponent = infinite, .tie_order = order};
    const std::vector<double> won = ground_shares(scene.discs(), scene.ground, law);
    for (std::size_t i = 0; i < std::min<std::size_t>(scene.size(), 8); ++i) {
      const auto is_larger = [&](std::size_t j) {
        return scene.radius[j] > scene.radius[i] || (scene.radius[j] == scene.radius[i] && j > i);
      };
      const double larger = covered_by(scene, is_larger);
      const double with_it =
          covered_by(scene, [&](std::size_t j) { return j == i || is_larger(j); });
      EXPECT_NEAR(won[i], with_it - larger, 1e-11) << i;
    }
  });
}

TEST(GroundSharesLaw, TwoDiscsShareTheirLens) {
  const double pairs[][3] = {{1, 1, 1},     {1, 2, 1.5}, {0.3, 5, 5.1}, {0.3, 5, 2},
                             {1, 1, 1.999}, {2, 1, 1},   {1, 1, 0}};
  for (const auto& [r, s, distance] : pairs) {
    Scene scene;
    scene.add(1, 2, r);
    scene.add(1 + 0.6 * distance, 2 + 0.8 * distance, s);
    const double lens = lens_area(r, s, distance);
    for (const double exponent : exponents) {
      const double ratio = r == s ? 1.0 : std::pow(s / r, 2 * exponent);
      const std::vector<double> won = shares_of(scene, exponent);
      EXPECT_NEAR(won[0], scene.area(0) - lens * (1 - 1 / (1 + ratio)), 1e-13);
      EXPECT_NEAR(won[1], scene.area(1) - lens / (1 + ratio), 1e-13);
    }
  }
}

/// Sums over pairs are never less than the loss, and equal to it where no three discs meet.
TEST(GroundSharesLaw, PairsNeverLoseLess) {
  for_random_scenes([](const Scene& scene) {
    OverlapPairs pairs;
    overlap_engine_named("layered_grid").create()->find(scene.discs(), scene.ground, {}, pairs);
    for (const double exponent : exponents) {
      const SharingLaw law{.exponent = exponent};
      std::vector<double> lost(scene.size(), 0.0);
      for (std::size_t p = 0; p < pairs.size(); ++p) {
        const auto i = static_cast<std::size_t>(pairs.first()[p]);
        const auto j = static_cast<std::size_t>(pairs.second()[p]);
        const double share = 1.0 / (1.0 + law.weight_ratio(scene.radius, j, i));
        lost[i] += (1.0 - share) * pairs.area()[p];
        lost[j] += share * pairs.area()[p];
      }
      const std::vector<double> won = shares_of(scene, exponent);
      for (std::size_t i = 0; i < scene.size(); ++i)
        EXPECT_GE(lost[i], scene.area(i) - won[i] - 1e-11) << i;
    }
  });
  Scene chain;
  for (int i = 0; i < 9; ++i) chain.add(1.5 * i, 0, 1.0);
  const std::vector<double> won = shares_of(chain, 0.0);
  for (std::size_t i = 1; i < 8; ++i) EXPECT_NEAR(won[i], pi - lens_area(1, 1, 1.5), 1e-13);
}

TEST(GroundSharesLaw, LargerExponentsFavourTheLargestAndCostTheSmallest) {
  Scene scene;
  for (int i = 0; i < 12; ++i) scene.add(std::cos(i), std::sin(2 * i), 1.0 + 0.07 * i);
  std::vector<double> before = shares_of(scene, 0.0);
  for (const double exponent : {0.3, 1.0, 2.0, 7.0, 40.0, 1e3, infinite}) {
    const std::vector<double> won = shares_of(scene, exponent);
    EXPECT_LE(won.front(), before.front() + 1e-13);
    EXPECT_GE(won.back(), before.back() - 1e-13);
    before = won;
  }
  EXPECT_NEAR(before.back(), scene.area(11), 1e-13);
}

TEST(GroundSharesLaw, DoNotDependOnOrderPlaceScaleOrThreads) {
  const Scene scene = random_scene(7, 60, 1.2, false);
  for (const double exponent : exponents) {
    const std::vector<double> first = shares_of(scene, exponent);
    Scene moved;
    for (std::size_t i = scene.size(); i-- > 0;)
      moved.add(8 * scene.x[i] + 4096, 8 * scene.y[i] - 512, 8 * scene.radius[i]);
    const std::vector<double> back = shares_of(moved, exponent);
    for (std::size_t i = 0; i < scene.size(); ++i)
      EXPECT_NEAR(back[scene.size() - 1 - i] / 64, first[i], 1e-11) << i;
  }
  Scene many;
  for (std::size_t i = 0; i < 3000; ++i)
    many.add(60 * random_unit(5, 0, i), 60 * random_unit(5, 1, i), 1.0 + random_unit(5, 2, i));
  const std::vector<double> one = shares_of(many, 1.0);
  for (const int threads : {2, 5}) EXPECT_EQ(shares_of(many, 1.0, threads), one);
}

TEST(GroundSharesLaw, DoNotDependOnWhereATorusIsCut) {
  const Scene scene = random_scene(9, 40, 1.9, true);
  Scene turned;
  turned.ground.torus = Rectangle{{-3, 100}, {7, 108}};
  for (std::size_t i = 0; i < scene.size(); ++i)
    turned.add(-3 + std::fmod(scene.x[i] + 4.25, 10), 100 + std::fmod(scene.y[i] + 7.5, 8),
               scene.radius[i]);
  for (const double exponent : exponents) {
    const std::vector<double> a = shares_of(scene, exponent), b = shares_of(turned, exponent);
    for (std::size_t i = 0; i < scene.size(); ++i) EXPECT_NEAR(a[i], b[i], 1e-11) << i;
  }
}

/// Binomial number of others at a place: mean of 1 / (1 + K) is (1 - (1 - p)^n) / (n p).
TEST(GroundSharesLaw, MeanShareOfRandomEqualDiscsIsTheBinomialOne) {
  constexpr int count = 40, runs = 200;
  const double p = pi * 0.15 * 0.15, expected = (1 - std::pow(1 - p, count)) / (count * p);
  double sum = 0.0, squares = 0.0;
  for (int run = 0; run < runs; ++run) {
    Scene scene;
    scene.ground.torus = Rectangle{{0, 0}, {1, 1}};
    CounterStream stream(12, static_cast<std::uint64_t>(run));
    for (int i = 0; i < count; ++i) {
      const double x = stream.next_unit();
      scene.add(x, stream.next_unit(), 0.15);
    }
    const double mean = sum_of(shares_of(scene, 0.0)) / (count * p);
    sum += mean;
    squares += mean * mean;
  }
  const double error = std::sqrt((squares / runs - sum * sum / runs / runs) / runs);
  EXPECT_NEAR(sum / runs, expected, 4 * error);
  EXPECT_LT(error, 0.005);  // by pairs the loss would be 1.38, beyond the plant itself
}

}  // namespace
}  // namespace phytobench
