// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/point_pattern/window.hpp"

namespace phytobench {

/// One picture of a row of pictures.
struct PatternPanel {
  std::vector<Point2> points;
  std::vector<std::vector<Point2>> cells = {};  ///< outlines, such as voronoi_cells(); may be empty
  std::vector<std::vector<Point2>> ways = {};   ///< lines without an end, such as moves of points
  std::string caption;
};

/// Panels side by side, all of the same window, as an SVG that follows the page's text colour.
/// `title` is read aloud and shown as a tooltip. Points keep three digits of their panel's width.
std::string pattern_svg(const std::vector<PatternPanel>& panels, const Window& window,
                        const std::string& title);

}  // namespace phytobench
