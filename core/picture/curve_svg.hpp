// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/picture/curve_axis.hpp"

namespace phytobench {

enum class CurveStyle { solid, dashed, dotted, points };

/// y against x, joined in the given order.
struct Curve {
  std::string name;  ///< in the legend, and what tells colours apart; empty: not in the legend
  std::vector<double> x, y;  ///< as long as each other; a NaN in y breaks the line
  CurveStyle style = CurveStyle::solid;
  /// Number of the colour, of curve_colours. Unset: curves of one name share one, names take them
  /// in order; a curve without a name has the text's colour.
  std::optional<std::size_t> colour = std::nullopt;
};

inline constexpr std::size_t curve_colours = 8;

/// One plot of a row of plots.
struct CurvePanel {
  std::vector<Curve> curves;
  std::string caption = {}, x_label = {}, y_label = {};  ///< labels with the unit
  AxisScale x_scale = AxisScale::linear, y_scale = AxisScale::linear;
  /// Unset: x from end to end of the curves, y a little more. What lies outside is cut off.
  std::optional<AxisRange> x_range = std::nullopt, y_range = std::nullopt;
};

/// Plots side by side with one legend below, as an SVG that follows the page's text colour; the
/// same bytes for the same panels. `title` is read aloud and shown as a tooltip. Lines keep half a
/// pixel, so that a curve of any length takes a few kilobytes unless it jumps up and down. Throws
/// ContractViolation for a panel without a point to draw, for lengths that differ, for an x that is
/// not finite, a y that is infinite, and for values <= 0 on a logarithmic axis.
std::string curve_svg(const std::vector<CurvePanel>& panels, const std::string& title);

}  // namespace phytobench
