// SPDX-License-Identifier: MIT
#include "core/terrain/pictures/map_image.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

namespace phytobench {
namespace {

double lightness(const Colour& colour) {
  return 0.3 * colour.red + 0.6 * colour.green + 0.1 * colour.blue;
}

TEST(MapPalettes, GetLighterOrDarkerAllTheWay) {
  for (int i = 0; i < 20; ++i) {
    const double low = i / 20.0, high = (i + 1) / 20.0;
    for (const MapPalette* palette :
         {&insolation_palette(), &probability_palette(), &height_palette()})
      EXPECT_LT(lightness(palette->at(low)), lightness(palette->at(high))) << i;
    for (const MapPalette* palette : {&soil_depth_palette(), &hydrology_palette()})
      EXPECT_GT(lightness(palette->at(low)), lightness(palette->at(high))) << i;
  }
}

/// [Lesser2019] sec. 10.3.
TEST(MapPalettes, HaveTheColoursOfTheThesis) {
  EXPECT_EQ(insolation_palette().at(1.0), (Colour{1.0, 1.0, 1.0}));
  const Colour yellow = insolation_palette().at(0.5), brown = insolation_palette().at(0.0);
  EXPECT_GT(yellow.red, 0.9);
  EXPECT_GT(yellow.green, 0.7);
  EXPECT_LT(yellow.blue, 0.1);
  EXPECT_TRUE(brown.red > brown.green && brown.green > brown.blue && brown.red < 0.3);
  const Colour half = probability_palette().at(0.5);
  EXPECT_TRUE(half.red == half.green && half.green == half.blue);
  EXPECT_NEAR(half.red, 0.5, 0.01);
  EXPECT_EQ(probability_palette().at(-3.0), (Colour{0.0, 0.0, 0.0}));
  EXPECT_EQ(hydrology_palette().at(0.0), (Colour{1.0, 1.0, 1.0}));
  EXPECT_GT(hydrology_palette().at(2.0).blue, hydrology_palette().at(2.0).red);
}

TEST(MapPalettes, NormalsToTheSouthAreGreenAndUpIsLilac) {
  const double half = std::sqrt(0.5);
  const Colour south = normal_colour(0.0, half, half), up = normal_colour(0.0, 0.0, 1.0);
  EXPECT_GT(south.green, south.red);
  EXPECT_EQ(up, (Colour{0.5, 0.5, 1.0}));
  const Colour north = normal_colour(0.0, -half, half);
  EXPECT_LT(north.green, north.red);
}

TEST(MapImage, ShowsEveryCellAndNothingWithoutData) {
  const TerrainMap map{3, 2, {0.0, 0.5, 1.0, HeightField::no_data, 1.0, 0.0}};
  const Image image = map_image(map, {0.0, 1.0}, probability_palette());
  ASSERT_EQ(image.width(), 3);
  ASSERT_EQ(image.height(), 2);
  EXPECT_EQ(image.at(0, 0), (Pixel{0, 0, 0, 255}));
  EXPECT_EQ(image.at(2, 0), (Pixel{255, 255, 255, 255}));
  EXPECT_EQ(image.at(0, 1)[3], 0);
  EXPECT_EQ(scale_of(map.values).high, 1.0);
}

TEST(MapImage, ThinsOutLargeMaps) {
  EXPECT_EQ(thinning(100, 100, 100), 1);
  EXPECT_EQ(thinning(101, 3, 100), 2);
  EXPECT_EQ(thinning(3, 1000, 100), 10);
  TerrainMap map{5, 3, std::vector<double>(15, 0.0)};
  map.values[2] = 1.0;  // column 2, row 0
  const Image image = map_image(map, {0.0, 1.0}, probability_palette(), 2);
  EXPECT_EQ(image.width(), 3);
  EXPECT_EQ(image.height(), 2);
  EXPECT_EQ(image.at(1, 0)[0], 255);
}

TEST(MapImage, FlatAndEmptyMapsHaveAColour) {
  EXPECT_EQ(scale_of(std::array{2.0, 2.0}).share(2.0), 0.0);
  const std::array none{HeightField::no_data};
  EXPECT_EQ(scale_of(none).low, 0.0);
}

TEST(MapImage, ShowsNormalsAndKinds) {
  HeightField field(2, 1, 1.0, 1.0);
  field.at(1, 0) = HeightField::no_data;
  const std::array<SurfaceGradient, 2> surfaces{};
  const Image normals = normal_image(field, surfaces);
  EXPECT_EQ(normals.at(0, 0), (Pixel{128, 128, 255, 255}));
  EXPECT_EQ(normals.at(1, 0)[3], 0);
  const std::array<std::int16_t, 3> kinds{0, 1, -1};
  const Image soils = kind_image(3, 1, kinds);
  EXPECT_NE(soils.at(0, 0), soils.at(1, 0));
  EXPECT_EQ(soils.at(2, 0)[3], 0);
}

}  // namespace
}  // namespace phytobench
