// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/record/plot_data.hpp"

namespace phytobench {

/// One curve: a point per x, joined in the given order; a NaN in y breaks the line.
struct PlotSeries {
  std::string name;
  std::vector<double> x, y;
  std::vector<double> low, high;  ///< ends of the error bars, one per point; empty: no error bars
  PlotStyle style = PlotStyle::marked;
  /// Of plot_colours; unset: the series' place. Marked lines of other colours have other dashes.
  std::optional<std::size_t> colour = std::nullopt;
};

enum class PlotKey { right, below, none };  ///< where names of series stand

struct LinePlot {
  std::string id;                ///< letters, digits, '-'; every id of the picture starts with it
  std::string title;             ///< not drawn: for screen readers and as tooltip
  std::string description;       ///< what a reader sees in the picture, in words; not drawn either
  std::string x_label, y_label;  ///< with the unit
  bool log_x = false, log_y = false;
  std::vector<PlotSeries> series;  ///< 1 to 12, told apart by colour, dashes and marks
  std::string caption = {};        ///< drawn above
  std::optional<AxisRange> x_range = std::nullopt, y_range = std::nullopt;  ///< unset: all points
  PlotKey key = PlotKey::right;
  int width = 960, height = 540;  ///< of the picture, in its own units; letters take 14
};

/// Plots in one picture, `columns` of them in a row, each as large as it says; their titles and
/// descriptions are not used. An id of each follows from the picture's.
struct PlotRow {
  std::string id;  ///< as of a LinePlot
  std::string title, description;
  std::vector<LinePlot> plots;  ///< 1 at least, of one size
  int columns = 2;
};

/// The plot as an <svg> element for an HTML page, the same bytes for the same plot: scales with the
/// page, takes its text colour, is readable on a light and on a dark one. Nothing if `gnuplot` (a
/// program's name or path) is not installed. Throws EnvironmentError if it fails and
/// ContractViolation for a plot without points, for lengths that differ and for values that are not
/// finite (a break's y apart) or not positive on a logarithmic axis.
std::optional<std::string> draw(const LinePlot& plot, const std::string& gnuplot = "gnuplot");
std::optional<std::string> draw(const PlotRow& row, const std::string& gnuplot = "gnuplot");

}  // namespace phytobench
