// SPDX-License-Identifier: MIT
#include "core/terrain/pictures/map_svg.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/picture/base64.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;

MapLegend legend_of_water() {
  return {.title = "Water & soil",
          .unit = "l/m2 a day",
          .bar = {&hydrology_palette(), {0.25, 1.75}},
          .entries = {},
          .width_m = 3200.0,
          .depth_m = 1600.0};
}

TEST(MapSvg, SaysWhatItShows) {
  const Image image(4, 3, {1, 2, 3, 255});
  const std::string svg = map_svg(image, legend_of_water());
  EXPECT_THAT(svg, HasSubstr(to_base64(to_png(image))));
  EXPECT_THAT(svg, HasSubstr(">Water &amp; soil</text>"));
  EXPECT_THAT(svg, HasSubstr(">l/m2 a day</text>"));
  for (const char* number : {">0.25<", ">1<", ">1.75<", ">N<", ">1 km<"})
    EXPECT_THAT(svg, HasSubstr(number));
}

TEST(MapSvg, HasTheProportionsOfTheGround) {
  const std::string svg = map_svg(Image(2, 2), legend_of_water());
  EXPECT_THAT(svg, HasSubstr("width=\"640.0\" height=\"320.0\" preserveAspectRatio=\"none\""));
  // A quarter of the width is 800 m; the bar of 1 km is 200 pixels long.
  EXPECT_THAT(svg, HasSubstr("v6h200.0v-6"));
}

TEST(MapSvg, ListsKinds) {
  MapLegend legend = legend_of_water();
  legend.bar.palette = nullptr;
  legend.entries = {{{1.0, 0.0, 0.0}, "Dirt"}, {{0.0, 0.0, 1.0}, "Stone"}};
  const std::string svg = map_svg(Image(1, 1), legend);
  EXPECT_THAT(svg, HasSubstr("fill=\"#ff0000\""));
  EXPECT_THAT(svg, HasSubstr(">Stone</text>"));
  EXPECT_THAT(svg, testing::Not(HasSubstr("1.75")));
}

TEST(MapSvg, HasRoomForANote) {
  MapLegend legend = legend_of_water();
  const std::string plain = map_svg(Image(2, 2), legend);
  legend.note = "Moss: assumed";
  const std::string noted = map_svg(Image(2, 2), legend);
  EXPECT_THAT(plain, HasSubstr("viewBox=\"0 0 838.0 398.0\""));
  EXPECT_THAT(noted, HasSubstr("viewBox=\"0 0 838.0 416.0\""));
  EXPECT_THAT(noted,
              HasSubstr("y=\"398.0\" text-anchor=\"start\" font-size=\"10\">Moss: assumed<"));
}

TEST(MapSvg, HatchesWhatIsNotThereAndSaysWhatItMeans) {
  MapLegend legend = legend_of_water();
  EXPECT_THAT(map_svg(Image(2, 2), legend), testing::Not(HasSubstr("url(#without)")));
  legend.without = "no data";
  const std::string svg = map_svg(Image(2, 2), legend);
  const std::size_t hatches = svg.find("height=\"320.0\" fill=\"url(#without)\"");
  ASSERT_NE(hatches, std::string::npos);
  EXPECT_LT(hatches, svg.find("<image"));  // below, where the image lets it through
  EXPECT_LT(svg.find("height=\"12\" fill=\"url(#without)\""), svg.find(">no data</text>"));
}

double colour_distance(const Colour& a, const Colour& b) {
  return std::hypot(a.red - b.red, a.green - b.green, a.blue - b.blue);
}

/// Of what a map can show, to the nearer of both hatches.
double distance_to_hatches(const Colour& colour) {
  return std::min(colour_distance(colour, hatch_ground()), colour_distance(colour, hatch_stripe()));
}

TEST(MapSvg, HatchesAreUnlikeEveryColourOfAMap) {
  constexpr double unlike = 0.3;  // of 1 from black to a full red
  for (const MapPalette* palette :
       {&insolation_palette(), &soil_depth_palette(), &hydrology_palette(), &probability_palette(),
        &height_palette()})
    for (int i = 0; i <= 100; ++i) EXPECT_GT(distance_to_hatches(palette->at(i / 100.0)), unlike);
  for (std::size_t kind = 0; kind < 8; ++kind)
    EXPECT_GT(distance_to_hatches(kind_colour(kind)), unlike) << kind;
  for (int slope = 0; slope <= 75; slope += 5)
    for (int azimuth = 0; azimuth < 360; azimuth += 5) {
      const double level = std::sin(slope * std::numbers::pi / 180.0),
                   up = std::cos(slope * std::numbers::pi / 180.0),
                   angle = azimuth * std::numbers::pi / 180.0;
      const Colour colour = normal_colour(level * std::cos(angle), level * std::sin(angle), up);
      EXPECT_GT(distance_to_hatches(colour), unlike) << slope << " " << azimuth;
    }
}

TEST(MapSvg, ScaleBarsAreRound) {
  EXPECT_EQ(scale_bar_length(3200.0), 1000.0);
  EXPECT_EQ(scale_bar_length(6100.0), 2000.0);
  EXPECT_EQ(scale_bar_length(15.0), 5.0);
  EXPECT_EQ(scale_bar_length(3.3), 1.0);
}

TEST(MapSvg, AMapOfOneLineIsSeen) {
  MapLegend legend = legend_of_water();
  legend.depth_m = 1.0;
  EXPECT_THAT(map_svg(Image(5, 1), legend), HasSubstr("height=\"12.0\" preserveAspectRatio"));
}

}  // namespace
}  // namespace phytobench
