// SPDX-License-Identifier: MIT
#include "core/lsystem/svg_path_text.hpp"

#include <fmt/format.h>

namespace phytobench {

namespace {

/// Whether b lies between a and c on a straight line.
bool is_between(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
  const long ux = b.x - a.x, uy = b.y - a.y, vx = c.x - b.x, vy = c.y - b.y;
  return ux * vy == uy * vx && ux * vx + uy * vy > 0;
}

}  // namespace

std::vector<GridPoint> grid_line(const std::vector<GridPoint>& points) {
  std::vector<GridPoint> line;
  for (const GridPoint& point : points) {
    if (!line.empty() && point == line.back()) continue;
    if (line.size() >= 2 && is_between(line[line.size() - 2], line.back(), point)) line.pop_back();
    line.push_back(point);
  }
  return line;
}

void SvgPathText::add_line(const std::vector<GridPoint>& line) {
  move_to(line.front());
  if (line.size() == 1) {
    text_ += "h0";
    return;
  }
  const bool is_closed = line.size() > 3 && line.front() == line.back();
  steps(line, line.size() - (is_closed ? 1 : 0));
  if (is_closed) text_ += 'z';
}

void SvgPathText::add_outline(const std::vector<GridPoint>& outline) {
  move_to(outline.front());
  steps(outline, outline.size() - (outline.front() == outline.back() ? 1 : 0));
  text_ += 'z';
}

void SvgPathText::move_to(const GridPoint& point) {
  text_ += fmt::format("M{}{}{}", point.x, point.y < 0 ? "" : " ", point.y);
}

void SvgPathText::steps(const std::vector<GridPoint>& line, std::size_t end) {
  bool follows_l = false;
  for (std::size_t i = 1; i < end; ++i) {
    const long right = line[i].x - line[i - 1].x, down = line[i].y - line[i - 1].y;
    if (down == 0)
      text_ += fmt::format("h{}", right);
    else if (right == 0)
      text_ += fmt::format("v{}", down);
    else
      text_ += fmt::format("{}{}{}{}",
                           !follows_l  ? "l"
                           : right < 0 ? ""
                                       : " ",
                           right, down < 0 ? "" : " ", down);
    follows_l = down != 0 && right != 0;
  }
}

}  // namespace phytobench
