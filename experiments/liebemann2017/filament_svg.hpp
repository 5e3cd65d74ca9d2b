// SPDX-License-Identifier: MIT
// Filaments of cells as a picture.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace phytobench::experiments::liebemann2017 {

/// A cell with an arrow head on the side of its polarity.
inline std::string cell_svg(const std::string& cell, double x, double y, double width) {
  const double tip = cell[1] == 'l' ? x + 4 : x + width - 4;
  const double back = cell[1] == 'l' ? tip + 6 : tip - 6;
  return fmt::format(
      "<rect x=\"{:.1f}\" y=\"{}\" width=\"{:.1f}\" height=\"24\" rx=\"8\" fill=\"{}\" "
      "stroke=\"#2f5d50\"/><path d=\"M{:.1f} {}L{:.1f} {}L{:.1f} {}\" fill=\"none\" "
      "stroke=\"#2f5d50\"/>",
      x + 1, y, width - 2, cell[0] == 'a' ? "#a9cfa4" : "#e6f0dd", back, y + 6, tip, y + 12, back,
      y + 18);
}

/// A row for each filament of cells "al", "ar", "bl", "br"; big cells are dark and twice as long.
inline std::string filament_svg(const std::vector<std::vector<std::string>>& filaments,
                                const std::string& title) {
  std::string svg;
  double widest = 0.0, y = 4.0;
  for (const std::vector<std::string>& filament : filaments) {
    double x = 0.0;
    for (const std::string& cell : filament) {
      const double width = cell[0] == 'a' ? 48.0 : 24.0;
      svg += cell_svg(cell, x, y, width);
      x += width;
    }
    widest = std::max(widest, x);
    y += 36.0;
  }
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\">"
      "<title>{}</title>{}</svg>\n",
      widest, y, title, svg);
}

}  // namespace phytobench::experiments::liebemann2017
