// SPDX-License-Identifier: MIT
#include "core/picture/curve_legend.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "core/contract/check.hpp"
#include "core/picture/svg_text.hpp"

namespace phytobench {

namespace {

constexpr double letter_width = 6.4, row_height = 18.0, sample_length = 26.0;  // pixels

// The colours' contrast is at least 4:1 to a white and to a dark page.
constexpr std::array<const char*, curve_colours> colours{
    "#247be0", "#ca5b0b", "#238e50", "#9e60ca", "#d84a46", "#168797", "#d04596", "#8c7c14"};

/// Bytes of UTF-8 that begin a letter.
double letters(const std::string& text) {
  const auto begins = [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; };
  return static_cast<double>(std::count_if(text.begin(), text.end(), begins));
}

}  // namespace

std::string curve_stroke(CurveStyle style, const std::string& colour) {
  if (style == CurveStyle::points)
    return fmt::format("stroke=\"{}\" stroke-width=\"5\" stroke-linecap=\"round\"", colour);
  const char* dashes = style == CurveStyle::dashed   ? " stroke-dasharray=\"7 4\""
                       : style == CurveStyle::dotted ? " stroke-dasharray=\"2 3\""
                                                     : "";
  return fmt::format("stroke=\"{}\" stroke-width=\"1.8\"{}", colour, dashes);
}

std::string CurveLegend::colour_of(const Curve& curve) {
  std::string colour = "currentColor";
  if (curve.colour) {
    PHYTOBENCH_EXPECT(*curve.colour < curve_colours);
    colour = colours[*curve.colour];
  } else if (!curve.name.empty()) {
    const auto known = std::find(names_.begin(), names_.end(), curve.name);
    const auto place = static_cast<std::size_t>(known - names_.begin());
    if (known == names_.end()) names_.push_back(curve.name);
    colour = colours[place % curve_colours];
  }
  if (!curve.name.empty()) add({curve.name, curve.style, colour});
  return colour;
}

void CurveLegend::add(const Entry& entry) {
  const auto same = [&](const Entry& other) {
    return other.name == entry.name && other.style == entry.style && other.colour == entry.colour;
  };
  if (std::none_of(entries_.begin(), entries_.end(), same)) entries_.push_back(entry);
}

double CurveLegend::draw(double left, double top, double right, std::string& svg) const {
  if (entries_.empty()) return top - row_height;
  double x = left, y = top;
  for (const Entry& entry : entries_) {
    const double length = sample_length + 6.0 + letter_width * letters(entry.name);
    if (x > left && x + length > right) {
      x = left;
      y += row_height;
    }
    const bool dot = entry.style == CurveStyle::points;
    svg += fmt::format("<path fill=\"none\" {} d=\"M{:.1f} {:.1f}h{}\"/>\n",
                       curve_stroke(entry.style, entry.colour), dot ? x + 0.5 * sample_length : x,
                       y - 4.0, dot ? 0.0 : sample_length);
    svg += svg_text(x + sample_length + 6.0, y, "start", entry.name);
    x += length + 18.0;
  }
  return y;
}

}  // namespace phytobench
