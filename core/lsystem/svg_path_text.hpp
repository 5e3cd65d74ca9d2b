// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace phytobench {

/// A point on the grid of whole numbers that a small SVG draws on; y points down.
struct GridPoint {
  long x = 0;
  long y = 0;

  friend bool operator==(const GridPoint&, const GridPoint&) = default;
};

/// What remains of a line on the grid: no point twice in a row, none in the midst of a straight
/// piece.
std::vector<GridPoint> grid_line(const std::vector<GridPoint>& points);

/// The attribute d of an SVG path, in few bytes: whole numbers, relative, h and v where they do.
class SvgPathText {
 public:
  /// `line` is not empty; one point alone becomes a dot, if line ends are round. A line that ends
  /// where it began is closed.
  void add_line(const std::vector<GridPoint>& line);
  /// A filled outline of at least three points, closed by itself.
  void add_outline(const std::vector<GridPoint>& outline);

  const std::string& text() const { return text_; }
  bool empty() const { return text_.empty(); }

 private:
  void move_to(const GridPoint& point);
  void steps(const std::vector<GridPoint>& line, std::size_t end);

  std::string text_;
};

}  // namespace phytobench
