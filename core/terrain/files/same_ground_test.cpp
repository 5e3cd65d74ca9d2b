// SPDX-License-Identifier: MIT
#include "core/terrain/files/same_ground.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/terrain/files/test_folder.hpp"

namespace phytobench {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// Of 4 columns and 3 rows.
constexpr double west = 600'000.0, north = 5'300'000.0, cell = 25.0;

std::string ground_error(const GeoReference& map, const GeoReference& heights) {
  return input_error_of([&] {
    refuse_other_ground({"soil.tif", map}, {"hill.asc", heights}, 4, 3);
  });
}

GeoReference at(double x, double y, double side = cell, const std::string& projection = "") {
  return {x, y, side, -side, projection};
}

TEST(SameGround, IsNoFartherThanHalfACell) {
  const GeoReference heights = at(west, north);
  for (const double shift : {0.0, 12.5, -12.5}) {
    EXPECT_EQ(ground_error(at(west + shift, north), heights), "no error") << shift;
    EXPECT_EQ(ground_error(at(west, north + shift), heights), "no error") << shift;
  }
  for (const double shift : {12.6, -12.6}) {
    EXPECT_NE(ground_error(at(west + shift, north), heights), "no error") << shift;
    EXPECT_NE(ground_error(at(west, north + shift), heights), "no error") << shift;
  }
}

TEST(SameGround, NamesBothMapsThatLieElsewhere) {
  EXPECT_THAT(ground_error(at(west + 1000.0, north), at(west, north)),
              AllOf(HasSubstr("soil.tif: reaches from 601000, 5299925 to 601100, 5300000"),
                    HasSubstr("hill.asc from 600000, 5299925 to 600100, 5300000"),
                    HasSubstr("give maps of the same ground")));
}

// 4 columns that are 8 m wider put the eastern border 32 m farther out.
TEST(SameGround, HasCellsOfTheSameSize) {
  EXPECT_NE(ground_error(at(west, north, cell + 8.0), at(west, north)), "no error");
  EXPECT_EQ(ground_error(at(west, north, cell + 1e-6), at(west, north)), "no error");
}

TEST(SameGround, OfAMapThatBeginsAt0OnlyTheSizeCounts) {
  const GeoReference from_south = at(0.0, 3 * cell), from_north = at(0.0, 0.0);
  for (const GeoReference& map : {from_south, from_north}) {
    EXPECT_EQ(ground_error(map, at(west, north)), "no error");
    EXPECT_EQ(ground_error(at(west, north), map), "no error");
  }
  EXPECT_NE(ground_error(at(0.0, 0.0, 2 * cell), at(west, north)), "no error");
}

const std::string zone_32 =
    "PROJCS[\"WGS 84 / UTM zone 32N\",GEOGCS[\"WGS 84\",UNIT[\"degree\",0.0174532925199433]],"
    "PROJECTION[\"Transverse_Mercator\"],PARAMETER[\"central_meridian\",9],"
    "PARAMETER[\"scale_factor\",0.9996],UNIT[\"metre\",1]]";

std::string zone_32_with(const std::string& from, const std::string& to) {
  std::string text = zone_32;
  return text.replace(text.find(from), from.size(), to);
}

TEST(SameGround, HasTheSameProjection) {
  const auto error = [](const std::string& map, const std::string& heights) {
    return ground_error(at(west, north, cell, map), at(west, north, cell, heights));
  };
  EXPECT_EQ(error(zone_32, zone_32), "no error");
  EXPECT_EQ(error(zone_32, ""), "no error");
  EXPECT_EQ(error("", zone_32), "no error");
  // As ESRI writes the same.
  EXPECT_EQ(error(zone_32,
                  "PROJCS[\"WGS_1984_UTM_Zone_32N\",PARAMETER[\"Central_Meridian\",9.0],"
                  "PARAMETER[\"Scale_Factor\",0.9996],UNIT[\"Meter\",1.0]]"),
            "no error");
  EXPECT_THAT(error(zone_32_with("meridian\",9", "meridian\",15"), zone_32),
              AllOf(HasSubstr("soil.tif: is a map in 'WGS 84 / UTM zone 32N', and hill.asc one in"),
                    HasSubstr("give maps in the same projection")));
  EXPECT_NE(error(zone_32_with("\"metre\",1", "\"foot\",0.3048"), zone_32), "no error");
  EXPECT_THAT(error("GEOGCS[\"WGS 84\"]", zone_32), HasSubstr("in 'WGS 84', and"));
}

// Where a text breaks off it says no more.
TEST(SameGround, TakesProjectionsThatAreCutOff) {
  for (std::size_t end = 0; end < zone_32.size(); ++end)
    ground_error(at(west, north, cell, zone_32.substr(0, end)), at(west, north, cell, zone_32));
  EXPECT_EQ(ground_error(at(west, north, cell, "PROJCS[\"x\",PARAMETER[\"central_meridian\""),
                         at(west, north, cell, zone_32)),
            "no error");
}

}  // namespace
}  // namespace phytobench
