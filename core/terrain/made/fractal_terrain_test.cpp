// SPDX-License-Identifier: MIT
#include "core/terrain/made/fractal_terrain.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

using MadeTerrain = HeightField (*)(const MapGrid&, const FractalOptions&);

constexpr MapGrid oblong{.columns = 130, .rows = 97, .cell_width = 16.0, .cell_depth = 16.0};

std::vector<double> copy_of_heights(const HeightField& field) {
  return {field.heights().begin(), field.heights().end()};
}

/// Mean square of the differences of neighbours in a row.
double roughness(const HeightField& field) {
  double sum = 0.0;
  for (int row = 0; row < field.rows(); ++row)
    for (int column = 1; column < field.columns(); ++column) {
      const double step = field.at(column, row) - field.at(column - 1, row);
      sum += step * step;
    }
  return sum / (field.rows() * (field.columns() - 1));
}

class FractalTerrain : public testing::TestWithParam<MadeTerrain> {};

INSTANTIATE_TEST_SUITE_P(Both, FractalTerrain,
                         testing::Values(MadeTerrain{noise_terrain},
                                         MadeTerrain{diamond_square_terrain}),
                         [](const auto& param) {
                           return param.index == 0 ? "Noise" : "DiamondSquare";
                         });

TEST_P(FractalTerrain, HasTheSizeAndTheReliefAskedFor) {
  for (const MapGrid& grid : {oblong, MapGrid{.columns = 2, .rows = 1}, MapGrid{.rows = 77}}) {
    const HeightField field = GetParam()(grid, {.relief_m = 250.0});
    EXPECT_EQ(field.columns(), grid.columns);
    EXPECT_EQ(field.rows(), grid.rows);
    EXPECT_EQ(field.cell_width(), grid.cell_width);
    const HeightRange range = height_range(field);
    EXPECT_EQ(range.lowest, 0.0);
    EXPECT_EQ(range.highest, 250.0);
    EXPECT_EQ(range.vertices, field.size());
  }
  EXPECT_EQ(GetParam()({}, {}).at(0, 0), 0.0) << "a single vertex has no relief";
}

TEST_P(FractalTerrain, IsTheSameForAnyNumberOfThreads) {
  const HeightField one = GetParam()(oblong, {.seed = 7});
  for (const int threads : {2, 3, 8})
    EXPECT_EQ(copy_of_heights(GetParam()(oblong, {.seed = 7, .threads = threads})),
              copy_of_heights(one))
        << threads;
}

TEST_P(FractalTerrain, DiffersWithTheSeed) {
  const HeightField one = GetParam()(oblong, {.seed = 1}), other = GetParam()(oblong, {.seed = 2});
  int equal = 0;
  for (std::size_t i = 0; i < one.size(); ++i) equal += one.heights()[i] == other.heights()[i];
  EXPECT_LT(equal, 10);
}

TEST_P(FractalTerrain, PersistenceMakesItRougher) {
  const double smooth = roughness(GetParam()(oblong, {.persistence = 0.3}));
  const double rough = roughness(GetParam()(oblong, {.persistence = 0.7}));
  EXPECT_GT(rough, 4.0 * smooth);
}

TEST_P(FractalTerrain, ReliefScalesItAndNothingElse) {
  const HeightField low = GetParam()(oblong, {.relief_m = 100.0});
  const HeightField high = GetParam()(oblong, {.relief_m = 400.0});
  for (std::size_t i = 0; i < low.size(); ++i)
    ASSERT_EQ(4.0 * low.heights()[i], high.heights()[i]) << i;
}

TEST_P(FractalTerrain, OptionsThatAreNoneBreakTheContract) {
  EXPECT_THROW(GetParam()(oblong, {.relief_m = -1.0}), ContractViolation);
  EXPECT_THROW(GetParam()(oblong, {.persistence = 0.0}), ContractViolation);
  EXPECT_THROW(GetParam()(oblong, {.octaves = 15}), ContractViolation);
  EXPECT_THROW(GetParam()({.columns = 0}, {}), ContractViolation);
}

// One octave over 5 vertices is the blend of the four random corners.
TEST(NoiseTerrain, BlendsTheNumbersAtTheCorners) {
  const MapGrid grid{.columns = 5, .rows = 5};
  const HeightField field = noise_terrain(grid, {.seed = 3, .relief_m = 1.0, .octaves = 1});
  const auto corner = [](std::uint64_t x, std::uint64_t y) {
    return random_unit(3, 0, y << 32 | x);
  };
  const double corners[] = {corner(0, 0), corner(1, 0), corner(0, 1), corner(1, 1)};
  const auto [low, high] = std::minmax_element(std::begin(corners), std::end(corners));
  const auto scaled = [&](double value) { return (value - *low) / (*high - *low); };
  EXPECT_NEAR(field.at(0, 0), scaled(corners[0]), 1e-14);
  EXPECT_NEAR(field.at(4, 0), scaled(corners[1]), 1e-14);
  EXPECT_NEAR(field.at(0, 4), scaled(corners[2]), 1e-14);
  EXPECT_NEAR(field.at(4, 4), scaled(corners[3]), 1e-14);
  const double mean = (corners[0] + corners[1] + corners[2] + corners[3]) / 4.0;
  EXPECT_NEAR(field.at(2, 2), scaled(mean), 1e-14);
  // 3 t^2 - 2 t^3 at a quarter of the way.
  EXPECT_NEAR(field.at(1, 0), scaled(corners[0] + 0.15625 * (corners[1] - corners[0])), 1e-14);
}

TEST(NoiseTerrain, FinerOctavesAddDetailWithoutEnd) {
  double before = 0.0;
  for (const int octaves : {1, 2, 4, 6}) {
    const double now = roughness(noise_terrain(oblong, {.persistence = 0.7, .octaves = octaves}));
    EXPECT_GT(now, before) << octaves;
    before = now;
  }
  // 129 cells along the longer side: periods of 129, 64.5, ..., 4.03, 2.02 cells.
  EXPECT_EQ(copy_of_heights(noise_terrain(oblong, {})),
            copy_of_heights(noise_terrain(oblong, {.octaves = 7})));
}

TEST(NoiseTerrain, CountsItsOctavesInMetres) {
  // The same area, twice as many columns: every second one is the same but for the scale to the
  // relief, which here both are given by the same vertices.
  const HeightField wide = noise_terrain(
      {.columns = 33, .rows = 33, .cell_width = 2.0, .cell_depth = 2.0}, {.octaves = 1});
  const HeightField narrow = noise_terrain(
      {.columns = 65, .rows = 33, .cell_width = 1.0, .cell_depth = 2.0}, {.octaves = 1});
  for (int row = 0; row < 33; ++row)
    for (int column = 0; column < 33; ++column)
      EXPECT_EQ(narrow.at(2 * column, row), wide.at(column, row)) << column << ", " << row;
}

// The first pass over 3 x 3 vertices, by hand.
TEST(DiamondSquareTerrain, DisplacesMidpoints) {
  const FractalOptions options{.seed = 5, .relief_m = 1.0};
  const HeightField field = diamond_square_terrain({.columns = 3, .rows = 3}, options);
  const auto random = [](std::uint64_t vertex) { return 2.0 * random_unit(5, 0, vertex) - 1.0; };
  double h[9] = {random(0), 0, random(2), 0, 0, 0, random(6), 0, random(8)};
  h[4] = (h[0] + h[2] + h[6] + h[8]) / 4.0 + 0.5 * random(4);
  h[1] = (h[0] + h[2] + h[4]) / 3.0 + 0.5 * random(1);
  h[3] = (h[0] + h[4] + h[6]) / 3.0 + 0.5 * random(3);
  h[5] = (h[2] + h[4] + h[8]) / 3.0 + 0.5 * random(5);
  h[7] = (h[4] + h[6] + h[8]) / 3.0 + 0.5 * random(7);
  const auto [low, high] = std::minmax_element(std::begin(h), std::end(h));
  for (std::size_t i = 0; i < 9; ++i)
    EXPECT_NEAR(field.heights()[i], (h[i] - *low) / (*high - *low), 1e-14) << i;
}

}  // namespace
}  // namespace phytobench
