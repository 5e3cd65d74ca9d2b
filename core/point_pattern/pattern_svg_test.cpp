// SPDX-License-Identifier: MIT
#include "core/point_pattern/pattern_svg.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace phytobench {
namespace {

using testing::HasSubstr;

TEST(PatternSvg, DrawsEveryPanelWithItsCaption) {
  const Window window = Window::rectangle({{0, 0}, {2, 1}});
  const std::string svg = pattern_svg({{.points = {{0, 0}, {2, 1}}, .caption = "a & b"},
                                       {.points = {{1, 0.5}},
                                        .cells = {{{0, 0}, {2, 0}, {2, 1}, {0, 1}}},
                                        .ways = {{{0, 0}, {1, 0.5}}},
                                        .caption = "cells"}},
                                      window, "points < cells");
  EXPECT_TRUE(svg.starts_with("<svg xmlns"));
  EXPECT_THAT(svg, HasSubstr("a &amp; b"));
  EXPECT_THAT(svg, HasSubstr("points &lt; cells"));
  EXPECT_THAT(svg, HasSubstr("M4.0 154.0h0M304.0 4.0h0"));  // up is up
  EXPECT_THAT(svg, HasSubstr("M324.0 154.0L624.0 154.0L624.0 4.0L324.0 4.0z"));
  EXPECT_THAT(svg, HasSubstr("currentColor"));
  EXPECT_EQ(svg.find("nan"), std::string::npos);
}

}  // namespace
}  // namespace phytobench
