// SPDX-License-Identifier: MIT
#include "core/terrain/pictures/map_svg.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/contract/check.hpp"
#include "core/picture/base64.hpp"
#include "core/picture/svg_text.hpp"

namespace phytobench {

namespace {

// Pixels.
constexpr double longest_side = 640.0, shortest_side = 12.0, margin = 12.0, title_height = 26.0;
constexpr double legend_width = 170.0, bar_width = 18.0, bar_height = 180.0, line_height = 18.0;
constexpr double footer_height = 40.0;

struct MapBox {
  double left = margin;
  double top = margin + title_height;
  double width = longest_side;
  double height = longest_side;

  double right() const { return left + width; }
  double bottom() const { return top + height; }
};

MapBox box_of(const MapLegend& legend) {
  const double scale = longest_side / std::max(legend.width_m, legend.depth_m);
  MapBox box;
  box.width = std::max(shortest_side, scale * legend.width_m);
  box.height = std::max(shortest_side, scale * legend.depth_m);
  return box;
}

constexpr const char* hatched = "url(#without)";

/// Of stripes across; the image lies on it and lets it through.
std::string hatch_pattern() {
  return fmt::format(
      "<defs><pattern id=\"without\" width=\"6\" height=\"6\" patternUnits=\"userSpaceOnUse\" "
      "patternTransform=\"rotate(45)\"><rect width=\"6\" height=\"6\" fill=\"{}\"/>"
      "<rect width=\"2\" height=\"6\" fill=\"{}\"/></pattern></defs>\n",
      to_text(hatch_ground()), to_text(hatch_stripe()));
}

std::string hatched_box(const MapBox& box) {
  return hatch_pattern() +
         fmt::format(
             "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"{}\"/>\n",
             box.left, box.top, box.width, box.height, hatched);
}

std::string picture(const Image& image, const MapBox& box) {
  return fmt::format(
      "<image x=\"{0:.1f}\" y=\"{1:.1f}\" width=\"{2:.1f}\" height=\"{3:.1f}\" "
      "preserveAspectRatio=\"none\" style=\"image-rendering:pixelated\" "
      "href=\"data:image/png;base64,{4}\"/>\n<rect x=\"{0:.1f}\" y=\"{1:.1f}\" width=\"{2:.1f}\" "
      "height=\"{3:.1f}\" fill=\"none\" stroke=\"#444444\"/>\n",
      box.left, box.top, box.width, box.height, to_base64(to_png(image)));
}

std::string colour_bar(const ColourBar& bar, const std::string& unit, double left, double& top) {
  constexpr int steps = 24;
  std::string svg;
  if (!unit.empty()) {
    svg += svg_text(left, top + 12.0, "start", unit);
    top += 1.4 * line_height;
  }
  for (int i = 0; i < steps; ++i)
    svg += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.2f}\" width=\"{:.1f}\" height=\"{:.2f}\" fill=\"{}\"/>\n", left,
        top + i * bar_height / steps, bar_width, bar_height / steps + 0.3,
        to_text(bar.palette->at(1.0 - (i + 0.5) / steps)));
  svg += fmt::format(
      "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"none\" "
      "stroke=\"#444444\"/>\n",
      left, top, bar_width, bar_height);
  for (const double share : {1.0, 0.5, 0.0})
    svg +=
        svg_text(left + bar_width + 6.0, top + (1.0 - share) * bar_height + 4.0, "start",
                 fmt::format("{:.4g}", bar.scale.low + share * (bar.scale.high - bar.scale.low)));
  top += bar_height + line_height;
  return svg;
}

std::string entry_line(const std::string& fill, const std::string& text, double left, double& top) {
  const std::string svg =
      fmt::format(
          "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"12\" height=\"12\" fill=\"{}\" "
          "stroke=\"#444444\"/>\n",
          left, top, fill) +
      svg_text(left + 18.0, top + 10.0, "start", text);
  top += line_height;
  return svg;
}

std::string entry_lines(const MapLegend& legend, double left, double& top) {
  std::string svg;
  for (const ColourEntry& entry : legend.entries)
    svg += entry_line(to_text(entry.colour), entry.text, left, top);
  if (!legend.without.empty()) svg += entry_line(hatched, legend.without, left, top);
  return svg;
}

std::string north_arrow(double left, double top) {
  return fmt::format("<path d=\"M{:.1f} {:.1f}l6 22l-6 -5l-6 5z\" fill=\"#222222\"/>\n", left + 9.0,
                     top + 14.0) +
         svg_text(left + 9.0, top + 10.0, "middle", "N");
}

std::string scale_bar(const MapLegend& legend, const MapBox& box) {
  const double metres = scale_bar_length(legend.width_m);
  const double length = box.width * metres / legend.width_m, y = box.bottom() + 14.0;
  const std::string text =
      metres >= 1000.0 ? fmt::format("{:g} km", metres / 1000.0) : fmt::format("{:g} m", metres);
  return fmt::format(
             "<path d=\"M{:.1f} {:.1f}v6h{:.1f}v-6\" fill=\"none\" stroke=\"#222222\" "
             "stroke-width=\"1.5\"/>\n",
             box.left, y, length) +
         svg_text(box.left + length + 8.0, y + 7.0, "start", text);
}

}  // namespace

Colour hatch_ground() {
  return parse_colour("#ff0055");
}

Colour hatch_stripe() {
  return parse_colour("#a3003c");
}

double scale_bar_length(double width_m) {
  PHYTOBENCH_EXPECT(width_m > 0.0 && std::isfinite(width_m));
  const double most = width_m / 3.0;
  const double decade = std::pow(10.0, std::floor(std::log10(most)));
  for (const double step : {5.0, 2.0})
    if (step * decade <= most) return step * decade;
  return decade;
}

std::string map_svg(const Image& image, const MapLegend& legend) {
  PHYTOBENCH_EXPECT(legend.width_m > 0.0 && legend.depth_m > 0.0);
  const MapBox box = box_of(legend);
  const double left = box.right() + 16.0;
  double top = box.top;
  std::string body = legend.without.empty() ? "" : hatched_box(box);
  body += picture(image, box) + north_arrow(left, top);
  top += 48.0;
  if (legend.bar.palette != nullptr) body += colour_bar(legend.bar, legend.unit, left, top);
  body += entry_lines(legend, left, top);
  body += scale_bar(legend, box);
  double height = std::max(box.bottom() + footer_height, top + margin);
  if (!legend.note.empty()) {
    body += svg_text(box.left, height, "start", legend.note, " font-size=\"10\"");
    height += line_height;
  }
  const std::string title = escaped_for_svg(legend.title);
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.1f} {1:.1f}\" "
             "width=\"{0:.0f}\" height=\"{1:.0f}\" role=\"img\" aria-label=\"{2}\" "
             "fill=\"#222222\" font-size=\"12\" font-family=\"sans-serif\">\n<title>{2}</title>\n"
             "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n",
             left + legend_width, height, title) +
         svg_text(box.left, margin + 14.0, "start", legend.title,
                  " font-size=\"15\" font-weight=\"bold\"") +
         body + "</svg>\n";
}

}  // namespace phytobench
