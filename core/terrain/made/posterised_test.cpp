// SPDX-License-Identifier: MIT
#include "core/terrain/made/posterised.hpp"

#include <algorithm>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/terrain/made/fractal_terrain.hpp"

namespace phytobench {
namespace {

using testing::Each;
using testing::ElementsAre;

HeightField row_of_heights(const std::vector<double>& heights) {
  HeightField field(static_cast<int>(heights.size()), 1, 1.0, 1.0);
  std::copy(heights.begin(), heights.end(), field.heights().begin());
  return field;
}

TEST(Posterised, GivesEachIntervalOfHeightItsId) {
  const std::vector<std::int16_t> ids{40, 80, 10};
  const NumberMap map =
      posterised(row_of_heights({100.0, 109.9, 110.0, 119.9, 120.0, 129.0, 130.0}), ids);
  EXPECT_EQ(map.columns, 7);
  EXPECT_EQ(map.rows, 1);
  EXPECT_THAT(map.numbers, ElementsAre(40, 40, 80, 80, 10, 10, 10));
}

TEST(Posterised, LeavesOutWhatHasNoData) {
  const std::vector<std::int16_t> ids{1, 2};
  EXPECT_THAT(posterised(row_of_heights({0.0, HeightField::no_data, 1.0}), ids).numbers,
              ElementsAre(1, -1, 2));
  EXPECT_THAT(posterised(row_of_heights({HeightField::no_data, HeightField::no_data}), ids).numbers,
              Each(-1));
}

TEST(Posterised, FlatMapsHaveOneSoil) {
  const std::vector<std::int16_t> ids{7, 8, 9};
  EXPECT_THAT(posterised(row_of_heights({5.0, 5.0, 5.0}), ids).numbers, Each(7));
  EXPECT_THROW(posterised(row_of_heights({5.0}), {}), ContractViolation);
}

// [Lesser2019] sec. 10.4: soils follow the height, so no vertex has a later one than a higher
// vertex.
TEST(PosterisedLaw, IdsRiseWithTheHeight) {
  const HeightField field =
      noise_terrain({.columns = 64, .rows = 48, .cell_width = 16.0, .cell_depth = 16.0}, {});
  const std::vector<std::int16_t> ids{0, 1, 2, 3, 4};
  const NumberMap map = posterised(field, ids);
  std::vector<std::pair<double, std::int16_t>> by_height;
  for (std::size_t i = 0; i < field.size(); ++i)
    by_height.emplace_back(field.heights()[i], map.numbers[i]);
  std::sort(by_height.begin(), by_height.end());
  for (std::size_t i = 1; i < by_height.size(); ++i)
    EXPECT_LE(by_height[i - 1].second, by_height[i].second) << i;
  for (const std::int16_t id : ids)
    EXPECT_GT(std::count(map.numbers.begin(), map.numbers.end(), id), 0) << id;
}

}  // namespace
}  // namespace phytobench
