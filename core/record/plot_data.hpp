// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/picture/curve_axis.hpp"

namespace phytobench {

/// How points are joined; `marked` is a line with a mark at every point, `steps` go along before
/// they go up.
enum class PlotStyle { solid, dashed, dotted, points, steps, marked };

/// Number of colours that a plot's curves can have.
inline constexpr std::size_t plot_colours = 12;

/// y against x, in the given order.
struct PlotCurve {
  std::string name;          ///< not empty, and no other curve's of the panel
  std::vector<double> x, y;  ///< as long as each other; a NaN in y breaks the line
  PlotStyle style = PlotStyle::solid;
  /// Number of the colour, below plot_colours. Unset: curves of one name share one in all panels,
  /// names take them in order.
  std::optional<std::size_t> colour = std::nullopt;
  std::vector<double> low = {}, high = {};  ///< ends of the error bars, one per point; or none
};

struct PlotPanel {
  std::vector<PlotCurve> curves;                         ///< 1 to plot_colours
  std::string caption = {}, x_label = {}, y_label = {};  ///< labels with the unit
  bool log_x = false, log_y = false;
  /// The published figure's own axes; unset: as the points need. What lies outside is cut off.
  std::optional<AxisRange> x_range = std::nullopt, y_range = std::nullopt;
};

struct PlotData {
  std::string title;              ///< what is shown
  std::string description;        ///< what a reader sees in it, in words
  std::vector<PlotPanel> panels;  ///< side by side
};

/// What breaks the rules above, or "": also a curve without a point, a value that is not finite
/// (but a break's y) and one that is not positive on a logarithmic axis.
std::string plot_problem(const PlotData& plot);

}  // namespace phytobench
