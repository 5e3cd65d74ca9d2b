// SPDX-License-Identifier: MIT
#include "core/terrain/quantities.hpp"

#include <type_traits>

#include <gtest/gtest.h>

#include "core/terrain/site_model.hpp"

namespace phytobench {
namespace {

// [Lesser2019] listing 9.16 multiplies where it should divide: here that has another unit, and
// cannot be taken off a supply of water.
static_assert(std::is_same_v<decltype(DailyEnergy() / HeatOfEvaporation()), DailyWater>);
static_assert(!std::is_same_v<decltype(DailyEnergy() * HeatOfEvaporation()), DailyWater>);
static_assert(!std::is_convertible_v<decltype(DailyEnergy() * HeatOfEvaporation()), DailyWater>);
static_assert(!std::is_convertible_v<double, DailyWater>);
static_assert(std::is_same_v<decltype(EnergyPerArea() / one_day), DailyEnergy>);

TEST(Quantities, CountLikeNumbers) {
  const DailyEnergy energy(819.0);
  EXPECT_NEAR((energy / heat_of_evaporation).value(), 1.3706784, 1e-12);
  EXPECT_EQ(energy / DailyEnergy(2000.0), 0.4095);
  EXPECT_EQ((energy + energy - energy * 0.5).value(), 1228.5);
  EXPECT_EQ(in_centimetres(centimetres(80.0)), 80.0);
  EXPECT_LT(DailyWater(1.0), DailyWater(2.0));
}

}  // namespace
}  // namespace phytobench
