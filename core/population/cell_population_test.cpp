// SPDX-License-Identifier: MIT
#include "core/population/cell_population.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/population/test_cells.hpp"

namespace phytobench {
namespace {

using namespace test_cells;

using std::numbers::pi;

TEST(CellPopulationLaw, UniformFieldsFollowTheMap) {
  for (const CellStep step : steps)
    for (const CellBorder border : {CellBorder::torus, CellBorder::reflecting}) {
      CellPopulation cells({7, 5}, {0.2, step, border}, map_of(2.2));
      fill(cells, [](auto, auto) { return 0.3; });
      const std::vector<double> expected = orbit(map_of(2.2), 0.3, 1000);
      for (std::size_t t = 1; t <= 1000; ++t) {
        cells.step();
        for (const double count : cells.counts()) ASSERT_EQ(count, expected[t]);
      }
    }
}

TEST(CellPopulationLaw, CellsWithoutMigrationFollowTheirOwnMaps) {
  std::vector<LogisticMap> habitats;
  for (std::size_t i = 0; i < 12; ++i)
    habitats.push_back(map_of(0.2 * static_cast<double>(i), 1.0 + static_cast<double>(i)));
  for (const CellStep step : steps) {
    CellPopulation cells({4, 3}, {0.0, step, CellBorder::absorbing}, habitats);
    fill(cells, [](auto, auto) { return 0.4; });
    run(cells, 50);
    for (std::size_t i = 0; i < 12; ++i)
      EXPECT_EQ(cells.counts()[i], orbit(habitats[i], 0.4, 50)[50]);
  }
}

TEST(CellPopulationLaw, MigrationConservesTheTotalOverTenThousandYears) {
  for (const CellStep step : {CellStep::unclipped, CellStep::conserving})
    for (const CellBorder border : {CellBorder::torus, CellBorder::reflecting})
      for (const double migration : {0.01, 0.13, 0.25}) {
        CellPopulation cells({13, 9}, {migration, step, border}, no_growth);
        fill(cells, random_field(0.0, 10.0, 1));
        const double before = cells.total();
        run(cells, 10'000);
        EXPECT_NEAR(cells.total() / before, 1.0, 1e-13) << name_of(border) << " " << migration;
      }
}

TEST(CellPopulationLaw, AnAbsorbingBorderLosesWhatItsCellsSendOut) {
  CellPopulation cells({6, 4}, {0.2, CellStep::conserving, CellBorder::absorbing}, no_growth);
  fill(cells, random_field(0.0, 10.0, 2));
  for (int t = 0; t < 100; ++t) {
    double along_border = 0.0;  // corners have two sides there
    for (std::size_t x = 0; x < 6; ++x) along_border += cells.count_at(x, 0) + cells.count_at(x, 3);
    for (std::size_t y = 0; y < 4; ++y) along_border += cells.count_at(0, y) + cells.count_at(5, y);
    const double expected = cells.total() - 0.2 * along_border;
    cells.step();
    ASSERT_NEAR(cells.total(), expected, 1e-12);
  }
}

// Patterns that (2.12) only multiplies, one kind for each border.

TEST(CellPopulationLaw, ModesGrowByTheirFactors) {
  constexpr std::size_t width = 12, height = 10;
  constexpr double migration = 0.17;
  const auto wave = [](CellBorder border, std::size_t k, std::size_t n, std::size_t x) {
    const auto number = static_cast<double>(k), size = static_cast<double>(n);
    const auto place = static_cast<double>(x);
    if (border == CellBorder::torus) return std::cos(2.0 * pi * number * place / size);
    if (border == CellBorder::reflecting) return std::cos(pi * number * (place + 0.5) / size);
    return std::sin(pi * (number + 1.0) * (place + 1.0) / (size + 1.0));
  };
  const auto eigenvalue = [](CellBorder border, std::size_t k, std::size_t n) {
    const auto number = static_cast<double>(k), size = static_cast<double>(n);
    const double turn = border == CellBorder::torus        ? 2.0 * pi * number / size
                        : border == CellBorder::reflecting ? pi * number / size
                                                           : pi * (number + 1.0) / (size + 1.0);
    return 2.0 * std::cos(turn) - 2.0;
  };
  for (const CellBorder border : borders)
    for (std::size_t k = 0; k < 6; ++k)
      for (std::size_t l = 0; l < 5; ++l) {
        CellPopulation cells({width, height}, {migration, CellStep::unclipped, border}, no_growth);
        const Field mode = [&](std::size_t x, std::size_t y) {
          return wave(border, k, width, x) * wave(border, l, height, y);
        };
        fill(cells, mode);
        run(cells, 3);
        const double mu = eigenvalue(border, k, width) + eigenvalue(border, l, height);
        const double factor = std::pow(1.0 + migration * mu, 3.0);
        for (std::size_t y = 0; y < height; ++y)
          for (std::size_t x = 0; x < width; ++x)
            ASSERT_NEAR(cells.count_at(x, y), factor * mode(x, y), 1e-14) << name_of(border);
      }
}

// Around the equilibrium growth and migration add up in (2.13); in two parts they multiply.

// From a count of (1 + alpha - 4 gamma) / |beta| on the board turns into its negative.

// Mirrored and turned landscapes give mirrored and turned bits; on a torus so do shifted ones.

TEST(CellPopulationLaw, SymmetriesOfTheGridAreThoseOfTheCounts) {
  constexpr std::size_t side = 7;
  using Place = std::pair<std::size_t, std::size_t>;
  const std::vector<std::function<Place(std::size_t, std::size_t)>> mirrors = {
      [](auto x, auto y) {
        return Place{side - 1 - x, y};
      },
      [](auto x, auto y) {
        return Place{x, side - 1 - y};
      },
      [](auto x, auto y) {
        return Place{y, x};
      },
      [](auto x, auto y) {
        return Place{side - 1 - y, x};
      }};
  const auto shift = [](auto x, auto y) { return Place{(x + 2) % side, (y + 5) % side}; };
  for (const CellStep step : steps)
    for (const CellBorder border : borders) {
      const auto after = [&](const Field& start) {
        CellPopulation cells({side, side}, {0.12, step, border}, map_of(1.4));
        fill(cells, start);
        run(cells, 50);
        return cells;
      };
      const Field start = random_field(0.0, 0.7, 9);
      const CellPopulation plain = after(start);
      auto moves = mirrors;
      if (border == CellBorder::torus) moves.emplace_back(shift);
      for (const auto& move : moves) {
        const CellPopulation moved = after([&](std::size_t x, std::size_t y) {
          const auto [a, b] = move(x, y);
          return start(a, b);
        });
        for (std::size_t y = 0; y < side; ++y)
          for (std::size_t x = 0; x < side; ++x) {
            const auto [a, b] = move(x, y);
            ASSERT_EQ(moved.count_at(x, y), plain.count_at(a, b)) << name_of(border);
          }
      }
    }
}

TEST(CellPopulation, BitsDoNotDependOnThreads) {
  const CellGrid grids[] = {{300, 200}, {40'000, 2}, {1, 40'000}};
  for (const CellGrid& grid : grids)
    for (const CellStep step : steps) {
      std::vector<LogisticMap> habitats;
      for (std::size_t i = 0; i < grid.size(); ++i)
        habitats.push_back(map_of(0.5 + random_unit(3, 0, i)));
      std::vector<CellPopulation> runs(3, {grid, {0.2, step, CellBorder::torus}, habitats});
      int threads = 1;
      for (CellPopulation& cells : runs) {
        fill(cells, random_field(0.0, 0.5, 11));
        for (int t = 0; t < 5; ++t) cells.step(threads);
        threads += 2;
        EXPECT_TRUE(
            std::equal(cells.counts().begin(), cells.counts().end(), runs[0].counts().begin()));
      }
    }
}

// Rows are shared out in bands: no row may be left out or done twice.
TEST(CellPopulationLaw, ShiftedLandscapesOfManyRowsGiveShiftedBits) {
  constexpr CellGrid grid{300, 200};
  CellPopulation plain(grid, {0.2, CellStep::positive_part, CellBorder::torus}, map_of(1.4));
  CellPopulation shifted = plain;
  const Field start = random_field(0.0, 0.7, 12);
  fill(plain, start);
  fill(shifted, [&](auto x, auto y) { return start((x + 11) % 300, (y + 37) % 200); });
  run(plain, 5);
  run(shifted, 5);
  for (std::size_t y = 0; y < grid.height; ++y)
    for (std::size_t x = 0; x < grid.width; ++x)
      ASSERT_EQ(shifted.count_at(x, y), plain.count_at((x + 11) % 300, (y + 37) % 200));
}

// A torus of one or two cells meets itself.

TEST(CellPopulation, NarrowGridsCountEveryNeighbourOnce) {
  CellPopulation pair({2, 1}, {0.1, CellStep::unclipped, CellBorder::torus}, no_growth);
  pair.counts()[0] = 1.0;
  pair.step();  // left and right are the same cell, above and below the cell itself
  EXPECT_NEAR(pair.counts()[0], 0.8, 1e-15);
  EXPECT_NEAR(pair.counts()[1], 0.2, 1e-15);
  CellPopulation alone({1, 1}, {0.1, CellStep::unclipped, CellBorder::absorbing}, no_growth);
  alone.counts()[0] = 1.0;
  alone.step();
  EXPECT_NEAR(alone.counts()[0], 0.6, 1e-15);
  CellPopulation column({1, 3}, {0.1, CellStep::unclipped, CellBorder::reflecting}, no_growth);
  column.counts()[0] = 1.0;
  column.step();
  EXPECT_NEAR(column.counts()[0], 0.9, 1e-15);
  EXPECT_NEAR(column.counts()[1], 0.1, 1e-15);
}

TEST(CellPopulation, RefusesWhatIsNoLandscape) {
  EXPECT_THROW(CellPopulation({0, 5}, {}, no_growth), ContractViolation);
  EXPECT_THROW(CellPopulation({5, 5}, {.migration = 1.1}, no_growth), ContractViolation);
  EXPECT_THROW(CellPopulation({5, 5}, {.migration = -0.1}, no_growth), ContractViolation);
  EXPECT_THROW(CellPopulation({5, 5}, {}, std::vector<LogisticMap>(24)), ContractViolation);
}

}  // namespace
}  // namespace phytobench
