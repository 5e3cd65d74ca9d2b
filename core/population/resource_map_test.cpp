// SPDX-License-Identifier: MIT
#include "core/population/resource_map.hpp"

#include <unistd.h>

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/contract/text_file.hpp"
#include "core/picture/image.hpp"

namespace phytobench {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

const Rectangle map_ground{{100.0, -20.0}, {400.0, 180.0}};

/// Three columns, two rows: 0.1 0.2 0.3 above 0.4 0.5 0.6.
ResourceMap small_map() {
  return {3, 2, {0.1, 0.2, 0.3, 0.4, 0.5, 0.6}, map_ground};
}

TEST(ResourceMap, IsRichEverywhereUnlessGiven) {
  const ResourceMap map;
  EXPECT_TRUE(map.is_uniform());
  for (const Point2 place : {Point2{0.0, 0.0}, Point2{-1e9, 1e300}}) EXPECT_EQ(map.at(place), 1.0);
  EXPECT_FALSE(small_map().is_uniform());
}

TEST(ResourceMap, HoldsThatOfTheCellWithTheTopRowFirst) {
  const ResourceMap map = small_map();
  EXPECT_EQ(map.at({150.0, 130.0}), 0.1);
  EXPECT_EQ(map.at({250.0, 130.0}), 0.2);
  EXPECT_EQ(map.at({350.0, 130.0}), 0.3);
  EXPECT_EQ(map.at({150.0, 30.0}), 0.4);
  EXPECT_EQ(map.at({250.0, 30.0}), 0.5);
  EXPECT_EQ(map.at({350.0, 30.0}), 0.6);
}

TEST(ResourceMap, CellsMeetInTheMiddle) {
  const ResourceMap map = small_map();
  EXPECT_EQ(map.at({199.999, 79.999}), 0.4);
  EXPECT_EQ(map.at({200.001, 79.999}), 0.5);
  EXPECT_EQ(map.at({199.999, 80.001}), 0.1);
  EXPECT_EQ(map.at({200.001, 80.001}), 0.2);
}

TEST(ResourceMap, BordersAndPlacesBeyondBelongToTheNearestCell) {
  const ResourceMap map = small_map();
  EXPECT_EQ(map.at(map_ground.low), 0.4);
  EXPECT_EQ(map.at(map_ground.high), 0.3);
  EXPECT_EQ(map.at({-1e300, 1e300}), 0.1);
  EXPECT_EQ(map.at({1e300, -1e300}), 0.6);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(map.at({infinity, infinity}), 0.3);
  EXPECT_EQ(map.at({std::nan(""), std::nan("")}), 0.4);  // some cell of the map, whichever
}

TEST(ResourceMapLaw, MeanOverTheGroundIsTheMeanOfTheCells) {
  const ResourceMap map = small_map();
  double sum = 0.0;
  constexpr int across = 60, along = 40;
  for (int i = 0; i < across; ++i)
    for (int j = 0; j < along; ++j)
      sum += map.at({map_ground.low.x + (i + 0.5) / across * map_ground.width(),
                     map_ground.low.y + (j + 0.5) / along * map_ground.height()});
  EXPECT_NEAR(sum / (across * along), 0.35, 1e-12);
}

TEST(ResourceMap, WrongSizesAndValuesBreakTheContract) {
  const auto made = [](int columns, int rows, std::vector<double> values, Rectangle where) {
    ResourceMap(columns, rows, std::move(values), where);
  };
  EXPECT_NO_THROW(made(2, 1, {0.0, 1.0}, map_ground));
  EXPECT_THROW(made(2, 2, {0.0, 1.0}, map_ground), ContractViolation);
  EXPECT_THROW(made(0, 0, {}, map_ground), ContractViolation);
  EXPECT_THROW(made(-1, -2, {0.0, 1.0}, map_ground), ContractViolation);
  EXPECT_THROW(made(2, 1, {0.0, 1.1}, map_ground), ContractViolation);
  EXPECT_THROW(made(2, 1, {-0.1, 1.0}, map_ground), ContractViolation);
  EXPECT_THROW(made(2, 1, {std::nan(""), 1.0}, map_ground), ContractViolation);
  EXPECT_THROW(made(2, 1, {0.0, 1.0}, Rectangle{{0, 0}, {0, 1}}), ContractViolation);
}

/// A fresh folder per test, removed with all it holds.
class ResourceMapFile : public testing::Test {
 protected:
  void SetUp() override {
    const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) /
              (std::string("phytobench-") + test->name() + "-" + std::to_string(::getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    file_ = folder_ / "map.png";
  }
  void TearDown() override { fs::remove_all(folder_); }

  /// What is said against a picture of that size on a ground of that size.
  std::string complaint(int columns, int rows, double width, double height) const {
    write_file_atomically(file_, to_png(Image(columns, rows)));
    return complaint({{0.0, 0.0}, {width, height}});
  }
  std::string complaint(const Rectangle& where) const {
    try {
      read_resource_map(file_, where);
    } catch (const InputError& error) {
      return error.what();
    }
    return "none";
  }

  fs::path folder_, file_;
};

TEST_F(ResourceMapFile, IsTheMeanOfTheColoursWhateverTheOpacity) {
  Image image(3, 2);
  image.at(0, 0) = {0, 0, 0, 255};
  image.at(1, 0) = {255, 255, 255, 0};
  image.at(2, 0) = {51, 51, 51, 7};
  image.at(0, 1) = {255, 0, 0, 255};
  image.at(1, 1) = {1, 1, 2, 255};
  write_file_atomically(file_, to_png(image));
  const ResourceMap map = read_resource_map(file_, map_ground);
  EXPECT_EQ(map.columns(), 3);
  EXPECT_EQ(map.rows(), 2);
  EXPECT_EQ(map.values()[0], 0.0);
  EXPECT_EQ(map.values()[1], 1.0);
  EXPECT_DOUBLE_EQ(map.values()[2], 0.2);
  EXPECT_DOUBLE_EQ(map.values()[3], 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(map.values()[4], 4.0 / 765.0);
  // The picture's upper left corner is the ground's.
  EXPECT_DOUBLE_EQ(map.at({399.0, 179.0}), 0.2);
  EXPECT_DOUBLE_EQ(map.at({101.0, -19.0}), 1.0 / 3.0);
}

TEST_F(ResourceMapFile, ProportionsMustBeThoseOfTheGroundToOnePixel) {
  EXPECT_EQ(complaint(200, 200, 60.0, 60.0), "none");
  EXPECT_EQ(complaint(200, 201, 60.0, 60.0), "none");
  EXPECT_EQ(complaint(100, 67, 300.0, 200.0), "none");
  EXPECT_EQ(complaint(67, 100, 200.0, 300.0), "none");
  EXPECT_THAT(complaint(200, 202, 60.0, 60.0),
              StartsWith(file_.string() + ": 200 x 202 pixels are not in the proportion of the "
                                          "ground, 60 m x 60 m"));
  EXPECT_THAT(complaint(100, 100, 300.0, 200.0), HasSubstr("proportion"));
  EXPECT_THAT(complaint(67, 100, 300.0, 200.0), HasSubstr("proportion"));
  EXPECT_THAT(complaint(100, 65, 300.0, 200.0), HasSubstr("proportion"));
}

TEST_F(ResourceMapFile, WhatIsNoPictureIsAnInputErrorThatNamesIt) {
  EXPECT_THAT(complaint(map_ground), StartsWith(file_.string() + ": no such file"));
  for (const std::string& bytes : {std::string(), std::string("GIF89a"), std::string(100, 'x'),
                                   to_png(Image(9, 6)).substr(0, 40)}) {
    write_file_atomically(file_, bytes);
    EXPECT_THAT(complaint(map_ground), StartsWith(file_.string() + ": is no PNG picture"));
  }
}

TEST_F(ResourceMapFile, TooManyPixelsAreRefusedBeforeTheyAreUnpacked) {
  std::string bytes = to_png(Image(3, 2));
  const auto with_size = [&](unsigned char high, unsigned char low) {
    for (const std::size_t begin : {std::size_t{16}, std::size_t{20}}) {
      bytes[begin + 2] = static_cast<char>(high);
      bytes[begin + 3] = static_cast<char>(low);
    }
    write_file_atomically(file_, bytes);
  };
  with_size(0x0f, 0xa1);  // 4001 x 4001
  EXPECT_THAT(complaint(map_ground),
              StartsWith(file_.string() + ": has 4001 x 4001 pixels; a map has "
                                          "at most 16000000"));
  with_size(0x0f, 0xa0);  // 4000 x 4000 are allowed, but not there
  EXPECT_THAT(complaint(map_ground), HasSubstr("is no PNG picture"));
}

}  // namespace
}  // namespace phytobench
