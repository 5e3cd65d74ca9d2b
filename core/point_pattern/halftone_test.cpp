// SPDX-License-Identifier: MIT
#include "core/point_pattern/halftone.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

constexpr HalftoneScan both_scans[] = {HalftoneScan::plain, HalftoneScan::serpentine};

/// One unit of length per pixel.
Rectangle pixel_box(std::size_t width, std::size_t height) {
  return {{0, 0}, {static_cast<double>(width), static_cast<double>(height)}};
}

std::vector<Point2> halftone(const std::vector<double>& darkness, std::size_t width,
                             HalftoneScan scan = HalftoneScan::plain) {
  const std::size_t height = darkness.size() / width;
  return halftone_points(darkness, width, height, pixel_box(width, height), scan);
}

std::vector<double> random_picture(std::size_t pixels, std::uint64_t seed) {
  CounterStream stream(seed, 0);
  std::vector<double> darkness(pixels);
  for (double& value : darkness) value = stream.next_unit();
  return darkness;
}

double total(const std::vector<double>& darkness) {
  return std::accumulate(darkness.begin(), darkness.end(), 0.0);
}

TEST(Halftone, OfBlackIsEveryPixelAndOfWhiteNone) {
  for (const HalftoneScan scan : both_scans) {
    EXPECT_EQ(halftone(std::vector<double>(35, 1.0), 7, scan).size(), 35u);
    EXPECT_TRUE(halftone(std::vector<double>(35, 0.0), 7, scan).empty());
  }
}

TEST(Halftone, PutsPointsIntoPixelCentresTheTopRowFirst) {
  const std::vector<double> darkness{0, 0, 1,   // top
                                     1, 0, 0};  // bottom
  const Rectangle plot{{10, 20}, {16, 24}};
  const std::vector<Point2> expected{{15, 23}, {11, 21}};
  EXPECT_EQ(halftone_points(darkness, 3, 2, plot), expected);
}

// Worked by hand. Top row: 0.5 is black and leaves -0.5; 0.5 - 7/32 = 0.28125 is white. Bottom row:
// 0.5 - 5/32 + 3/16 * 0.28125 = 0.396 is white, 0.5 - 1/32 + 5/16 * 0.28125 + 7/16 * 0.396 = 0.730
// is black.
TEST(Halftone, OfFourGreyPixelsIsTheDiagonal) {
  EXPECT_EQ(halftone({0.5, 0.5, 0.5, 0.5}, 2), (std::vector<Point2>{{0.5, 1.5}, {1.5, 0.5}}));
}

// One weight at a time: a dark but white pixel (0.48) lifts exactly one neighbour over 0.5.
TEST(Halftone, SpreadsSevenThreeFiveAndOneSixteenths) {
  const double error = 0.48;
  const auto blackens = [&](std::size_t neighbour, double start) {
    std::vector<double> darkness(9, 0.0);
    darkness[1] = error;
    darkness[neighbour] = start;
    return halftone(darkness, 3).size() == 1;
  };
  // To the right 7/16 come directly; below, the rest of the first row adds its own shares.
  const double right = error * 7.0 / 16.0;
  EXPECT_TRUE(blackens(2, 0.5 - right + 1e-9));
  EXPECT_FALSE(blackens(2, 0.5 - right - 1e-9));
  const double below_left = error * 3.0 / 16.0;
  EXPECT_TRUE(blackens(3, 0.5 - below_left + 1e-9));
  EXPECT_FALSE(blackens(3, 0.5 - below_left - 1e-9));
  const double below = error * 5.0 / 16.0 + right * 3.0 / 16.0 + below_left * 7.0 / 16.0;
  EXPECT_TRUE(blackens(4, 0.5 - below + 1e-9));
  EXPECT_FALSE(blackens(4, 0.5 - below - 1e-9));
  const double below_right = error * 1.0 / 16.0 + right * 5.0 / 16.0 + below * 7.0 / 16.0;
  EXPECT_TRUE(blackens(5, 0.5 - below_right + 1e-9));
  EXPECT_FALSE(blackens(5, 0.5 - below_right - 1e-9));
}

TEST(HalftoneLaw, KeepsTheDarknessUpToTheBorder) {
  // No error exceeds 1/2; 8 and 3 sixteenths fall off each row's ends, 9 off each lowest pixel.
  for (const auto& [width, height] : {std::pair{1u, 1u}, {1u, 40u}, {40u, 1u}, {23u, 31u}})
    for (std::uint64_t seed = 0; seed < 50; ++seed)
      for (const HalftoneScan scan : both_scans) {
        const auto darkness = random_picture(std::size_t{width} * height, seed);
        const auto points = static_cast<double>(halftone(darkness, width, scan).size());
        EXPECT_LE(std::abs(points - total(darkness)), (11.0 * height + 9.0 * width) / 32.0);
      }
}

// The acceptance of the ledger: within 1 % of mean darkness * pixels.
TEST(HalftoneLaw, KeepsTheMeanOfASmoothPictureToOnePercent) {
  constexpr std::size_t size = 200;
  for (const double power : {1.0, 2.0, 0.5})
    for (const HalftoneScan scan : both_scans) {
      std::vector<double> darkness;
      for (std::size_t i = 0; i < size * size; ++i)
        darkness.push_back(std::pow(static_cast<double>(i % size) / size, power));
      const auto points = static_cast<double>(halftone(darkness, size, scan).size());
      EXPECT_NEAR(points / total(darkness), 1.0, 0.01) << power;
    }
}

TEST(HalftoneLaw, KeepsTheDarknessOfEveryPart) {
  constexpr std::size_t size = 160, part = 40;
  std::vector<double> darkness;
  for (std::size_t i = 0; i < size * size; ++i)
    darkness.push_back(0.1 + 0.8 * static_cast<double>(i % size) / size);
  for (const HalftoneScan scan : both_scans) {
    std::vector<double> black(size / part, 0.0), grey(size / part, 0.0);
    for (const Point2& p : halftone(darkness, size, scan))
      black[static_cast<std::size_t>(p.x) / part] += 1.0;
    for (std::size_t i = 0; i < darkness.size(); ++i) grey[i % size / part] += darkness[i];
    // What crosses a part's border: at most 11/32 of a point per row on either side.
    for (std::size_t i = 0; i < black.size(); ++i)
      EXPECT_NEAR(black[i], grey[i], 2.0 * (11.0 * size + 9.0 * part) / 32.0);
    EXPECT_LT(black[0] * 2.0, black[3]);
  }
}

TEST(HalftoneLaw, SerpentineMirrorsEverySecondRow) {
  constexpr std::size_t width = 50;
  const auto row = random_picture(width, 7);
  std::vector<double> below_white(width, 0.0), mirrored_below_white(width, 0.0);
  below_white.insert(below_white.end(), row.begin(), row.end());
  mirrored_below_white.insert(mirrored_below_white.end(), row.rbegin(), row.rend());
  auto backwards = halftone(below_white, width, HalftoneScan::serpentine);
  const auto forwards = halftone(mirrored_below_white, width);
  for (Point2& p : backwards) p.x = static_cast<double>(width) - p.x;
  EXPECT_EQ(backwards, forwards);
  EXPECT_NE(halftone(below_white, width, HalftoneScan::serpentine), halftone(below_white, width));
}

TEST(Halftone, RefusesPicturesThatAreNone) {
  const Rectangle box = pixel_box(2, 2);
  EXPECT_THROW(halftone_points(std::vector<double>(3), 2, 2, box), ContractViolation);
  EXPECT_THROW(halftone_points({}, 0, 2, box), ContractViolation);
  EXPECT_THROW(halftone_points({}, 2, 0, box), ContractViolation);
  for (const double wrong : {-0.01, 1.01, std::nan("")})
    EXPECT_THROW(halftone_points(std::vector<double>(4, wrong), 2, 2, box), ContractViolation);
  EXPECT_THROW(halftone_points(std::vector<double>(4), 2, 2, {{0, 0}, {0, 1}}), ContractViolation);
}

}  // namespace
}  // namespace phytobench
