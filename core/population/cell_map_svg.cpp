// SPDX-License-Identifier: MIT
#include "core/population/cell_map_svg.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/contract/check.hpp"
#include "core/picture/svg_text.hpp"

namespace phytobench {

namespace {

constexpr int shades = 8;
constexpr double map_width = 220.0, gap = 16.0, panel_margin = 4.0, caption_height = 22.0;
constexpr double key_width = 26.0, key_height = 12.0;
constexpr const char* cell_colour = "#2e9e48";  // seen on white and on dark pages in every shade

/// 0 is bare.
int shade_of(double count, double full) {
  const double shade = std::round(count / full * shades);
  return shade > 0.0 ? static_cast<int>(std::min<double>(shade, shades)) : 0;
}

double opacity_of(int shade) {
  return static_cast<double>(shade) / shades;
}

/// Cells of one shade as strokes as wide as a cell, in units of cells.
std::string runs_of(const CellMapPanel& panel, int shade, double full) {
  std::string path;
  for (std::size_t y = 0; y < panel.grid.height; ++y)
    for (std::size_t x = 0; x < panel.grid.width;) {
      const auto has_shade = [&](std::size_t at) {
        return shade_of(panel.counts[y * panel.grid.width + at], full) == shade;
      };
      std::size_t end = x;
      while (end < panel.grid.width && has_shade(end)) ++end;
      if (end > x) path += fmt::format("M{} {}.5h{}", x, y, end - x);
      x = std::max(end, x + 1);
    }
  return path;
}

std::string drawn(const CellMapPanel& panel, double left, double full) {
  const double scale = map_width / static_cast<double>(panel.grid.width);
  const double height = scale * static_cast<double>(panel.grid.height);
  std::string svg = fmt::format("<g transform=\"translate({:.1f} {:.1f}) scale({:.4f})\">\n", left,
                                panel_margin, scale);
  for (int shade = 1; shade <= shades; ++shade) {
    const std::string path = runs_of(panel, shade, full);
    if (!path.empty())
      svg += fmt::format("<path stroke=\"{}\" stroke-opacity=\"{:.3g}\" d=\"{}\"/>\n", cell_colour,
                         opacity_of(shade), path);
  }
  svg += fmt::format(
      "</g>\n<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"none\" "
      "stroke=\"currentColor\"/>\n",
      left, panel_margin, map_width, height);
  return svg +
         svg_text(left + 0.5 * map_width, panel_margin + height + 16.0, "middle", panel.caption);
}

/// Shades with the counts at their ends.
std::string key(double top, double full) {
  std::string svg = svg_text(panel_margin, top + key_height - 1.0, "start", "0");
  for (int shade = 1; shade <= shades; ++shade)
    svg += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{}\" height=\"{}\" fill=\"{}\" "
        "fill-opacity=\"{:.3g}\"/>\n",
        panel_margin + 14.0 + key_width * (shade - 1), top, key_width, key_height, cell_colour,
        opacity_of(shade));
  return svg + svg_text(panel_margin + 20.0 + key_width * shades, top + key_height - 1.0, "start",
                        fmt::format("{:.3g} plants and more per cell", full));
}

}  // namespace

std::string cell_map_svg(const std::vector<CellMapPanel>& panels, double full,
                         const std::string& title) {
  PHYTOBENCH_EXPECT(!panels.empty() && full > 0.0);
  const CellGrid& grid = panels[0].grid;
  PHYTOBENCH_EXPECT(grid.width > 0 && grid.height > 0);
  std::string body;
  double left = panel_margin;
  for (const CellMapPanel& panel : panels) {
    PHYTOBENCH_EXPECT(panel.grid.width == grid.width && panel.grid.height == grid.height);
    PHYTOBENCH_EXPECT(panel.counts.size() == grid.size());
    body += drawn(panel, left, full);
    left += map_width + gap;
  }
  const double top = panel_margin + caption_height + 8.0 +
                     map_width * static_cast<double>(grid.height) / static_cast<double>(grid.width);
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.1f} {1:.1f}\" "
             "role=\"img\" aria-label=\"{2}\" fill=\"currentColor\" font-size=\"12\" "
             "font-family=\"sans-serif\">\n<title>{2}</title>\n",
             std::max(left - gap + panel_margin, 420.0), top + key_height + panel_margin,
             escaped_for_svg(title)) +
         body + key(top, full) + "</svg>\n";
}

}  // namespace phytobench
