// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace phytobench {

/// One curve: a point per x, joined in the given order.
struct PlotSeries {
  std::string name;
  std::vector<double> x, y;
  std::vector<double> low, high;  ///< ends of the error bars, one per point; empty: no error bars
};

struct LinePlot {
  std::string id;                ///< letters, digits, '-'; every id of the picture starts with it
  std::string title;             ///< not drawn: for screen readers and as tooltip
  std::string description;       ///< what a reader sees in the picture, in words; not drawn either
  std::string x_label, y_label;  ///< with the unit
  bool log_x = false, log_y = false;
  std::vector<PlotSeries> series;  ///< 1 to 12, told apart by colour, dashes and marks
};

/// The plot as an <svg> element for an HTML page, the same bytes for the same plot: scales with the
/// page, takes its text colour, is readable on a light and on a dark one. Nothing if `gnuplot` (a
/// program's name or path) is not installed. Throws EnvironmentError if it fails and
/// ContractViolation for a plot without points, for lengths that differ and for values that are not
/// finite or not positive on a logarithmic axis.
std::optional<std::string> draw(const LinePlot& plot, const std::string& gnuplot = "gnuplot");

}  // namespace phytobench
