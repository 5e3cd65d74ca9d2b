// SPDX-License-Identifier: MIT
// What the comment on bounds in cell_population.hpp says.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/population/cell_population.hpp"
#include "core/population/test_cells.hpp"

namespace phytobench {
namespace {

using namespace test_cells;

TEST(CellPopulationBoundsLaw, SmallCheckerboardsGrowByTheFactorOfTheStep) {
  constexpr double alpha = 0.3, gamma = 0.19;
  for (const double size : {1e-4, 1e-5}) {
    for (const CellStep step : steps) {
      CellPopulation cells({4, 6}, {gamma, step, CellBorder::torus}, map_of(alpha));
      const double equilibrium = map_of(alpha).equilibrium();
      fill(cells, checkerboard(equilibrium + size, equilibrium - size));
      cells.step();
      const double factor = step == CellStep::conserving ? (1.0 - alpha) * (1.0 - 8.0 * gamma)
                                                         : 1.0 - alpha - 8.0 * gamma;
      EXPECT_NEAR((cells.count_at(0, 0) - cells.count_at(1, 0)) / (2.0 * size), factor, 2.0 * size);
    }
  }
}

TEST(CellPopulationBoundsLaw, UniformStateIsStableUpToTheBound) {
  EXPECT_EQ(stable_migration(0.3), 0.2125);
  const auto spread_after = [](double migration, CellStep step) {
    CellPopulation cells({8, 8}, {migration, step, CellBorder::torus}, map_of());
    const double equilibrium = map_of().equilibrium();
    fill(cells, random_field(equilibrium - 0.01, equilibrium + 0.01, 3));
    run(cells, 2000);
    return largest_of(cells) - least_of(cells);
  };
  for (const CellStep step : {CellStep::unclipped, CellStep::positive_part}) {
    EXPECT_LT(spread_after(0.21, step), 1e-9);
    EXPECT_GT(spread_after(0.215, step), 1e-3);
  }
  for (const double migration : {0.1, 0.2125, 0.25, 0.9})
    EXPECT_LT(spread_after(migration, CellStep::conserving), 1e-9) << migration;
}

TEST(CellPopulationBoundsLaw, MigrationUpToAQuarterKeepsWithinLeastAndLargest) {
  for (const CellBorder border : {CellBorder::torus, CellBorder::reflecting})
    for (const double migration : {0.05, 0.25}) {
      CellPopulation cells({9, 11}, {migration, CellStep::unclipped, border}, no_growth);
      fill(cells, random_field(1.0, 2.0, 4));
      double least = least_of(cells), largest = largest_of(cells);
      for (int t = 0; t < 200; ++t) {
        cells.step();
        ASSERT_GE(least_of(cells), least - 1e-15);
        ASSERT_LE(largest_of(cells), largest + 1e-15);
        least = least_of(cells);
        largest = largest_of(cells);
      }
    }
}

TEST(CellPopulationBounds, MigrationBeyondAQuarterEmptiesMoreThanACellHolds) {
  CellPopulation cells({5, 5}, {0.3, CellStep::unclipped, CellBorder::torus}, no_growth);
  cells.counts()[12] = 1.0;
  cells.step();
  EXPECT_NEAR(cells.count_at(2, 2), -0.2, 1e-15);
  EXPECT_NEAR(cells.count_at(1, 2), 0.3, 1e-15);
  EXPECT_NEAR(cells.total(), 1.0, 1e-15);
}

TEST(CellPopulationBounds, PositivePartCreatesPlantsAndTheConservingStepDoesNot) {
  for (const CellStep step : {CellStep::positive_part, CellStep::conserving}) {
    CellPopulation cells({5, 5}, {0.3, step, CellBorder::torus}, no_growth);
    cells.counts()[12] = 1.0;
    cells.step();
    const bool conserves = step == CellStep::conserving;
    EXPECT_EQ(cells.count_at(2, 2), 0.0);
    EXPECT_NEAR(cells.count_at(2, 1), conserves ? 0.25 : 0.3, 1e-15);
    EXPECT_NEAR(cells.total(), conserves ? 1.0 : 1.2, 1e-15);
  }
}

TEST(CellPopulationBoundsLaw, ClippedCheckerboardsGrowByFourGammaAYear) {
  for (const double migration : {0.26, 0.3, 0.5, 0.9}) {
    CellPopulation cells({6, 4}, {migration, CellStep::positive_part, CellBorder::torus}, map_of());
    fill(cells, checkerboard(0.0, 0.3));
    for (int t = 1; t <= 100; ++t) {
      cells.step();
      const double expected = 0.3 * std::pow(4.0 * migration, t);
      ASSERT_NEAR(largest_of(cells) / expected, 1.0, 1e-12);
      ASSERT_EQ(least_of(cells), 0.0);
    }
  }
}

TEST(CellPopulationBoundsLaw, ClippedCountsFallBelowTheBound) {
  for (const double migration : {0.05, 0.2, 0.24}) {
    const double bound = count_bound(map_of(), migration);
    CellPopulation cells({10, 10}, {migration, CellStep::positive_part, CellBorder::torus},
                         map_of());
    fill(cells, checkerboard(0.0, 50.0));
    run(cells, 1000);
    EXPECT_LE(largest_of(cells), bound * (1.0 + 1e-12));
    for (int t = 0; t < 200; ++t) {
      fill(cells, random_field(0.0, bound, static_cast<std::uint64_t>(10 + t)));
      cells.step();
      ASSERT_LE(largest_of(cells), bound * (1.0 + 1e-12));
    }
  }
  EXPECT_THROW(count_bound(map_of(), 0.25), ContractViolation);
  EXPECT_THROW(count_bound(no_growth, 0.1), ContractViolation);
}

TEST(CellPopulationBoundsLaw, NothingIsClippedUpToTheUnclippedMigration) {
  for (const double fertility : {0.3, 1.0, 2.5}) {
    const double migration = unclipped_migration(fertility);
    const double bound = count_bound(map_of(fertility), migration);
    CellPopulation cells({20, 20}, {migration, CellStep::unclipped, CellBorder::torus},
                         map_of(fertility));
    fill(cells, random_field(0.0, bound, 5));
    cells.counts()[0] = bound;
    for (int t = 0; t < 500; ++t) {
      cells.step();
      ASSERT_GE(least_of(cells), -1e-15) << fertility;
    }
    // The bound is sharp: a full cell among empty ones empties just so.
    fill(cells, [](auto, auto) { return 0.0; });
    cells.counts()[0] = bound;
    cells.step();
    EXPECT_NEAR(cells.counts()[0], 0.0, 1e-15);
  }
}

TEST(CellPopulationBoundsLaw, ConservingStepsNeverGiveNegativeCountsInAnyHabitat) {
  std::vector<LogisticMap> habitats;
  for (std::size_t i = 0; i < 400; ++i)
    habitats.push_back(map_of(3.0 * random_unit(8, 0, i), std::pow(100.0, random_unit(8, 1, i))));
  double most = 0.0;
  for (const LogisticMap& habitat : habitats) most = std::max(most, habitat.largest_next());
  for (const CellBorder border : borders)
    for (const double migration : {0.1, 0.25, 0.7}) {
      CellPopulation cells({20, 20}, {migration, CellStep::conserving, border}, habitats);
      fill(cells, random_field(0.0, 100.0, 6));
      for (int t = 0; t < 300; ++t) {
        cells.step();
        ASSERT_GE(least_of(cells), 0.0);
        ASSERT_LE(largest_of(cells), most * (1.0 + 1e-15));
      }
    }
}

}  // namespace
}  // namespace phytobench
