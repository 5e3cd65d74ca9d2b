// SPDX-License-Identifier: MIT
#include "core/record/plot_data.hpp"

#include <cmath>
#include <set>

#include <fmt/format.h>

namespace phytobench {

namespace {

bool can_show(double value, bool is_log) {
  return std::isfinite(value) && (value > 0.0 || !is_log);
}

std::string curve_problem(const PlotCurve& curve, const PlotPanel& panel) {
  const auto& [name, x, y, style, colour, low, high] = curve;
  if (colour.value_or(0) >= plot_colours) return "has a colour that there is not";
  if (x.size() != y.size()) return "has not as many y as x";
  if (low.size() != high.size() || (!low.empty() && low.size() != x.size()))
    return "has error bars at some of its points only";
  std::size_t shown = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!can_show(x[i], panel.log_x)) return fmt::format("has x = {}", x[i]);
    if (std::isnan(y[i])) continue;
    if (!can_show(y[i], panel.log_y)) return fmt::format("has y = {}", y[i]);
    if (!low.empty() && !(can_show(low[i], panel.log_y) && can_show(high[i], panel.log_y)))
      return fmt::format("has an error bar from {} to {}", low[i], high[i]);
    ++shown;
  }
  return shown > 0 ? "" : "has no point";
}

bool is_range(const std::optional<AxisRange>& range, bool is_log) {
  return !range || (can_show(range->low, is_log) && can_show(range->high, is_log) &&
                    range->low < range->high);
}

std::string panel_problem(const PlotPanel& panel) {
  if (panel.curves.empty() || panel.curves.size() > plot_colours)
    return fmt::format("a panel has {} series", panel.curves.size());
  if (!is_range(panel.x_range, panel.log_x) || !is_range(panel.y_range, panel.log_y))
    return "a panel has an impossible range";
  std::set<std::string> names;
  for (const PlotCurve& curve : panel.curves) {
    if (curve.name.empty()) return "a series has no name";
    if (!names.insert(curve.name).second)
      return fmt::format("two series are named '{}'", curve.name);
    if (const std::string problem = curve_problem(curve, panel); !problem.empty())
      return fmt::format("the series '{}' {}", curve.name, problem);
  }
  return "";
}

}  // namespace

std::string plot_problem(const PlotData& plot) {
  if (plot.title.empty() || plot.description.empty()) return "title or description is empty";
  if (plot.panels.empty()) return "there is no panel";
  for (const PlotPanel& panel : plot.panels)
    if (std::string problem = panel_problem(panel); !problem.empty()) return problem;
  return "";
}

}  // namespace phytobench
