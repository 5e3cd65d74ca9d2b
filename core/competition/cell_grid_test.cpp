// SPDX-License-Identifier: MIT
#include "core/competition/cell_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/competition/neighbour_field.hpp"
#include "core/contract/errors.hpp"
#include "core/overlap/ground_shares.hpp"
#include "core/overlap/test_discs.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

using testing_discs::infinite;
using testing_discs::pi;
using testing_discs::Scene;

Scene random_scene(std::uint64_t seed, std::size_t count, bool on_torus) {
  Scene scene;
  CounterStream stream(seed, 0);
  for (std::size_t i = 0; i < count; ++i) {
    const double x = 10 * stream.next_unit(), y = 8 * stream.next_unit();
    scene.add(x, y, i % 3 == 0 ? 1.5 : 0.2 + 2 * stream.next_unit());
  }
  if (on_torus) scene.ground.torus = Rectangle{{0, 0}, {10, 8}};
  return scene;
}

/// Every cell asks every disc.
CellShares literally(const Scene& scene, double side, double exponent) {
  CellShares shares{std::vector<double>(scene.size(), 0.0),
                    std::vector<std::int64_t>(scene.size(), 0)};
  const bool torus = scene.ground.torus.has_value();
  const int low = torus ? 0 : -10, right = torus ? 10 : 20, top = torus ? 8 : 18;
  const auto cells = [side](int length) { return std::lround(length / side); };
  for (long row = cells(low); row < cells(top); ++row)
    for (long column = cells(low); column < cells(right); ++column) {
      std::vector<std::size_t> covering;
      for (std::size_t i = 0; i < scene.size(); ++i) {
        double dx = std::abs((static_cast<double>(column) + 0.5) * side - scene.x[i]);
        double dy = std::abs((static_cast<double>(row) + 0.5) * side - scene.y[i]);
        if (torus) {
          dx = std::min(dx, 10 - dx);
          dy = std::min(dy, 8 - dy);
        }
        if (dx * dx + dy * dy <= scene.radius[i] * scene.radius[i]) covering.push_back(i);
      }
      for (const std::size_t i : covering) {
        double weights = 0.0;
        for (const std::size_t j : covering)
          weights += scene.radius[i] == scene.radius[j]
                         ? 1.0
                         : std::pow(scene.radius[j] / scene.radius[i], 2 * exponent);
        shares.won[i] += side * side / weights;
        ++shares.cells[i];
      }
    }
  return shares;
}

TEST(CellSharesLaw, AreWhatEveryCellSays) {
  for (const bool on_torus : {false, true})
    for (const double side : {0.25, 0.5, 1.0})
      for (const double exponent : {0.0, 1.0, 3.0, infinite}) {
        const Scene scene = random_scene(3, 14, on_torus);
        const CellShares found =
            cell_shares(scene.discs(), scene.ground, side, {.exponent = exponent});
        const CellShares expected = literally(scene, side, exponent);
        EXPECT_EQ(found.cells, expected.cells);
        for (std::size_t i = 0; i < scene.size(); ++i)
          EXPECT_NEAR(found.won[i], expected.won[i], 1e-12) << i;
      }
}

TEST(CellSharesLaw, EveryCoveredCellIsWonOnce) {
  const Scene scene = random_scene(4, 30, true);
  const CellShares all = cell_shares(scene.discs(), scene.ground, 0.1, {});
  for (const double exponent : {0.7, 50.0, 1e6, infinite}) {
    const CellShares shares = cell_shares(scene.discs(), scene.ground, 0.1, {.exponent = exponent});
    EXPECT_NEAR(std::accumulate(shares.won.begin(), shares.won.end(), 0.0),
                std::accumulate(all.won.begin(), all.won.end(), 0.0), 1e-11);
    EXPECT_EQ(shares.cells, all.cells);
    for (std::size_t i = 0; i < scene.size(); ++i)
      EXPECT_LE(shares.won[i], 0.01 * static_cast<double>(shares.cells[i]) + 1e-12);
  }
}

/// Root mean square error over grids that lie anywhere: divided by 8 when cells are a quarter.
TEST(CellSharesLaw, ErrorFallsWithThePowerThreeHalves) {
  const Scene scene = random_scene(5, 12, false);
  const SharingLaw law{.exponent = 1.0};
  const std::vector<double> exact = ground_shares(scene.discs(), {}, law);
  const auto error = [&](double side) {
    double squares = 0.0;
    CounterStream stream(6, 0);
    for (int k = 0; k < 60; ++k) {
      Scene moved = scene;
      const double dx = stream.next_unit(), dy = stream.next_unit();
      for (double& x : moved.x) x += dx;
      for (double& y : moved.y) y += dy;
      const CellShares shares = cell_shares(moved.discs(), {}, side, law);
      for (std::size_t i = 0; i < scene.size(); ++i)
        squares += std::pow(shares.won[i] - exact[i], 2);
    }
    return std::sqrt(squares);
  };
  const double order = std::log(error(0.2) / error(0.0125)) / std::log(16.0);
  EXPECT_NEAR(order, 1.5, 0.08);
}

TEST(CellSharesLaw, AreaOfADiscScattersAsDocumented) {
  for (const double r : {3.0, 10.0, 31.0}) {
    CounterStream stream(8, 0);
    double squares = 0.0, largest = 0.0;
    constexpr int places = 1500;
    for (int k = 0; k < places; ++k) {
      Scene scene;
      const double x = stream.next_unit();
      scene.add(x, stream.next_unit(), r);
      const double error = cell_shares(scene.discs(), {}, 1.0, {}).won[0] - pi * r * r;
      squares += error * error;
      largest = std::max(largest, std::abs(error));
    }
    // Single radii lie above or below the mean over radii by up to a fifth.
    EXPECT_NEAR(std::sqrt(squares / places / r), 0.68, 0.2 * 0.68) << r;
    EXPECT_LE(largest, pi * (std::numbers::sqrt2 * r + 0.5));
  }
}

TEST(CellShares, OfAPlantSmallerThanACellAreNoneOrTooLarge) {
  Scene scene;
  scene.add(0.1, 0.1, 0.3);    // no center within
  scene.add(3.45, 0.55, 0.3);  // one center within
  const CellShares shares = cell_shares(scene.discs(), {}, 1.0, {});
  EXPECT_THAT(shares.cells, testing::ElementsAre(0, 1));
  EXPECT_THAT(shares.won, testing::ElementsAre(0.0, 1.0));  // of an area of 0.28
}

TEST(CellShares, GiveEqualDiscsToTheLowestNumber) {
  Scene scene;
  for (int i = 0; i < 3; ++i) scene.add(5, 5, 2);
  const std::vector<std::uint64_t> order = {7, 2, 3};
  const CellShares shares =
      cell_shares(scene.discs(), {}, 0.5, {.exponent = infinite, .tie_order = order});
  EXPECT_EQ(shares.won[0], 0.0);
  EXPECT_EQ(shares.won[1], 0.25 * static_cast<double>(shares.cells[1]));
  EXPECT_EQ(shares.won[2], 0.0);
}

TEST(CellShares, RefuseSidesThatCannotBe) {
  const Scene plane = random_scene(1, 3, false), torus = random_scene(1, 3, true);
  for (const double side : {0.0, -1.0, infinite, std::nan(""), 1e-9})
    EXPECT_THROW(cell_shares(plane.discs(), {}, side, {}), InputError) << side;
  for (const double side : {0.3, 3.0, 11.0, 1e-9})
    EXPECT_THROW(cell_shares(torus.discs(), torus.ground, side, {}), InputError) << side;
  EXPECT_THROW(cell_shares(plane.discs(), {}, 1.0, {.exponent = -1.0}), ContractViolation);
  EXPECT_TRUE(cell_shares({}, {}, 1.0, {}).won.empty());
}

/// The mean over a zone is an integral that the closed boundary form has to 1e-9.
TEST(CellFieldLaw, TendsToTheIntegralOfTheNeighboursFields) {
  for (const bool on_torus : {false, true}) {
    Scene scene;
    if (on_torus) scene.ground.torus = Rectangle{{0, 0}, {10, 8}};
    scene.add(0.3, 4, 1.5);
    scene.add(1.9, 4.2, 1.0);
    scene.add(9.6, 4.4, 0.8);
    const std::vector<double> stem = {0.2, 0.1, 0.3};
    const CellField field = cell_field(scene.discs(), stem, 0.1, scene.ground, 0.01);
    for (std::size_t i = 0; i < 3; ++i) {
      double sum = 0.0;
      for (std::size_t j = 0; j < 3; ++j) {
        double dx = std::abs(scene.x[i] - scene.x[j]);
        if (on_torus) dx = std::min(dx, 10 - dx);
        const NeighbourField other(stem[j], scene.radius[j], 0.1);
        if (i != j)
          sum += other.over_disc(scene.radius[i], std::hypot(dx, scene.y[i] - scene.y[j]));
      }
      EXPECT_NEAR(field.mean[i], sum / (pi * scene.radius[i] * scene.radius[i]), 5e-4) << i;
    }
    EXPECT_EQ(field.mean[2] > 0.0, on_torus);
  }
}

TEST(CellField, IsNoNumberForAPlantWithoutACell) {
  Scene scene;
  scene.add(0.0, 0.0, 0.3);
  scene.add(0.4, 0.4, 1.0);
  const std::vector<double> stem = {0.1, 0.1};
  const CellField field = cell_field(scene.discs(), stem, 0.1, {}, 1.0);
  EXPECT_TRUE(std::isnan(field.mean[0]));
  EXPECT_EQ(field.cells[0], 0);
  EXPECT_EQ(field.mean[1], 0.0);
}

}  // namespace
}  // namespace phytobench
