// SPDX-License-Identifier: MIT
#include "core/terrain/shadow/lit_maps.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/random/counter_stream.hpp"
#include "core/terrain/shadow/line_sweep.hpp"

namespace phytobench {
namespace {

using testing::ElementsAre;

LitMaps random_maps(int columns, int rows, std::size_t positions, std::uint64_t seed) {
  LitMaps maps(columns, rows, positions);
  CounterStream stream(seed, 0);
  for (std::size_t p = 0; p < positions; ++p)
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column)
        if (stream.next_unit() < 0.4) maps.set_lit(p, column, row);
  return maps;
}

TEST(LitMaps, HasABitForEveryVertexAndPosition) {
  for (const int columns : {1, 63, 64, 65, 130}) {
    LitMaps maps(columns, 3, 2);
    EXPECT_EQ(maps.words_per_row(), static_cast<std::size_t>(columns + 63) / 64);
    EXPECT_EQ(maps.lit(), 0u);
    maps.set_lit(1, columns - 1, 2);
    maps.set_lit(1, columns - 1, 2);
    EXPECT_EQ(maps.lit(), 1u);
    EXPECT_EQ(maps.lit(0), 0u);
    EXPECT_EQ(maps.lit(1), 1u);
    EXPECT_TRUE(maps.is_lit(1, columns - 1, 2));
    EXPECT_FALSE(maps.is_lit(0, columns - 1, 2));
    EXPECT_EQ(maps.row(1, 2)[(columns - 1) / 64], std::uint64_t{1} << ((columns - 1) % 64));
  }
}

TEST(LitMaps, LightsAllAndNoBitBeyond) {
  for (const int columns : {1, 64, 65, 127, 128}) {
    LitMaps maps(columns, 5, 3);
    maps.light_all(1);
    EXPECT_EQ(maps.lit(1), 5u * static_cast<unsigned>(columns));
    EXPECT_EQ(maps.lit(), maps.lit(1));
  }
}

TEST(LitMaps, ResetDarkensAndTakesAnotherShape) {
  LitMaps maps = random_maps(70, 9, 2, 1);
  maps.reset(5, 4, 3);
  EXPECT_EQ(maps, LitMaps(5, 4, 3));
  EXPECT_EQ(maps.lit(), 0u);
  EXPECT_GE(maps.bytes(), 3u * 4u * 8u);
  EXPECT_THROW(maps.reset(0, 4, 3), ContractViolation);
}

TEST(LitMaps, DifferingBitsAreCounted) {
  const LitMaps a = random_maps(130, 7, 3, 2);
  LitMaps b = a;
  EXPECT_EQ(differing_bits(a, b), 0u);
  b.row(0, 6)[2] ^= 2u;
  b.row(2, 0)[0] ^= 5u;
  EXPECT_EQ(differing_bits(a, b), 3u);
  EXPECT_EQ(differing_bits(b, a, 0), 1u);
  EXPECT_EQ(differing_bits(a, b, 1), 0u);
  EXPECT_EQ(differing_bits(a, b, 2), 2u);
  EXPECT_THROW(differing_bits(a, LitMaps(130, 7, 2)), ContractViolation);
  EXPECT_THROW(differing_bits(a, LitMaps(7, 130, 3)), ContractViolation);
  EXPECT_THROW(differing_bits(a, b, 3), ContractViolation);
}

TEST(LitMaps, CountsPositionsOfEachVertex) {
  LitMaps maps(3, 2, 3);
  maps.set_lit(0, 1, 0);
  maps.set_lit(1, 1, 0);
  maps.set_lit(2, 1, 0);
  maps.set_lit(1, 2, 1);
  EXPECT_THAT(lit_positions(maps), ElementsAre(0, 3, 0, 0, 0, 1));
}

TEST(LitMaps, ExchangesRowsAndColumnsBitByBit) {
  for (const int columns : {1, 5, 64, 100, 129})
    for (const int rows : {1, 63, 64, 65, 140}) {
      const LitMaps from = random_maps(columns, rows, 2, 3);
      LitMaps to(rows, columns, 3);
      transpose_bits(from, 1, to, 2);
      EXPECT_EQ(to.lit(), from.lit(1)) << "and no bit beyond the last column";
      for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
          ASSERT_EQ(to.is_lit(2, row, column), from.is_lit(1, column, row));
    }
  LitMaps wrong(5, 6, 1);
  EXPECT_THROW(transpose_bits(LitMaps(5, 6, 1), 0, wrong, 0), ContractViolation);
}

}  // namespace
}  // namespace phytobench
