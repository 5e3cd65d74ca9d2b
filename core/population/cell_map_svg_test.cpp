// SPDX-License-Identifier: MIT
#include "core/population/cell_map_svg.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(CellMapSvg, CellsOfOneShadeAreOneStroke) {
  const CellMapPanel panel{{4, 2}, {8.0, 8.0, 0.0, 8.0, 0.0, 4.0, 4.0, 4.0}, "a & b"};
  const std::string svg = cell_map_svg({panel}, 8.0, "cells");
  EXPECT_TRUE(contains(svg, "stroke-opacity=\"1\" d=\"M0 0.5h2M3 0.5h1\""));
  EXPECT_TRUE(contains(svg, "stroke-opacity=\"0.5\" d=\"M1 1.5h3\""));
  EXPECT_TRUE(contains(svg, "a &amp; b"));
  EXPECT_TRUE(contains(svg, "<title>cells</title>"));
}

TEST(CellMapSvg, NothingNegativeAndNoNumberAreBareAndWhatIsBeyondIsFull) {
  const CellMapPanel bare{{4, 1}, {0.0, -9.0, nan, 0.04}, "bare"};
  EXPECT_FALSE(contains(cell_map_svg({bare}, 1.0, "t"), "stroke-opacity"));
  const CellMapPanel beyond{{2, 1}, {1e300, std::numeric_limits<double>::infinity()}, "beyond"};
  EXPECT_TRUE(contains(cell_map_svg({beyond}, 1.0, "t"), "stroke-opacity=\"1\" d=\"M0 0.5h2\""));
}

TEST(CellMapSvg, FollowsThePage) {
  const CellMapPanel panel{{1, 1}, {1.0}, ""};
  const std::string svg = cell_map_svg({panel, panel}, 1.0, "t");
  EXPECT_TRUE(contains(svg, "currentColor"));
  EXPECT_FALSE(contains(svg, "black"));
  EXPECT_FALSE(contains(svg, "white"));
}

TEST(CellMapSvg, RefusesWhatDoesNotFit) {
  EXPECT_THROW(cell_map_svg({}, 1.0, "t"), ContractViolation);
  EXPECT_THROW(cell_map_svg({{{2, 2}, {1.0}, ""}}, 1.0, "t"), ContractViolation);
  EXPECT_THROW(cell_map_svg({{{1, 1}, {1.0}, ""}}, 0.0, "t"), ContractViolation);
  EXPECT_THROW(cell_map_svg({{{1, 1}, {1.0}, ""}, {{2, 1}, {1.0, 1.0}, ""}}, 1.0, "t"),
               ContractViolation);
}

}  // namespace
}  // namespace phytobench
