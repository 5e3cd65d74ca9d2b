// SPDX-License-Identifier: MIT
#include "experiments/plot_artifacts.hpp"

#include <cmath>
#include <set>
#include <utility>

#include "core/contract/check.hpp"
#include "core/picture/simplified_line.hpp"
#include "core/record/plot_files.hpp"

namespace phytobench {

namespace {

constexpr std::size_t short_curve = 150;  // of which no point is left out
constexpr double tolerance = 1.0 / 4000.0, cells = 500.0;
constexpr std::size_t most_bytes = 60 * 1024;

CurveAxis axis_of(const PlotPanel& panel, bool of_x) {
  const AxisScale scale =
      (of_x ? panel.log_x : panel.log_y) ? AxisScale::logarithmic : AxisScale::linear;
  if (const auto& range = of_x ? panel.x_range : panel.y_range) return {*range, scale};
  std::vector<double> values;
  for (const PlotCurve& curve : panel.curves)
    for (std::size_t i = 0; i < curve.x.size(); ++i)
      if (!std::isnan(curve.y[i])) values.push_back(of_x ? curve.x[i] : curve.y[i]);
  return {range_of(values, scale), scale};
}

/// Which points of a line stay, by their places in the picture.
std::vector<bool> kept_of_line(const std::vector<Point2>& places) {
  std::vector<bool> kept(places.size(), false);
  for (std::size_t start = 0; start < places.size();) {
    std::vector<Point2> piece;
    std::size_t end = start;
    while (end < places.size() && !std::isnan(places[end].y)) piece.push_back(places[end++]);
    if (end < places.size()) kept[end] = true;  // the break
    std::size_t at = start;
    for (const Point2& place : simplified_line(piece, tolerance)) {
      while (places[at].x != place.x || places[at].y != place.y) ++at;
      kept[at++] = true;
    }
    start = end + 1;
  }
  return kept;
}

std::vector<bool> kept_of_points(const std::vector<Point2>& places) {
  std::set<std::pair<double, double>> taken;
  std::vector<bool> kept;
  for (const Point2& place : places)
    kept.push_back(taken.insert({std::floor(place.x * cells), std::floor(place.y * cells)}).second);
  return kept;
}

void thin(PlotCurve& curve, const CurveAxis& across, const CurveAxis& up) {
  if (curve.x.size() <= short_curve || !curve.low.empty()) return;
  if (curve.style == PlotStyle::steps || curve.style == PlotStyle::marked) return;
  std::vector<Point2> places;
  for (std::size_t i = 0; i < curve.x.size(); ++i)
    places.push_back({across.position(curve.x[i]),
                      std::isnan(curve.y[i]) ? curve.y[i] : up.position(curve.y[i])});
  const auto kept =
      curve.style == PlotStyle::points ? kept_of_points(places) : kept_of_line(places);
  std::vector<double> x, y;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (!kept[i]) continue;
    x.push_back(curve.x[i]);
    y.push_back(curve.y[i]);
  }
  curve.x = std::move(x);
  curve.y = std::move(y);
}

}  // namespace

void add_plot(ExperimentContext& context, const std::string& name, PlotData plot) {
  PHYTOBENCH_EXPECT(plot_problem(plot).empty());
  for (PlotPanel& panel : plot.panels) {
    const CurveAxis across = axis_of(panel, true), up = axis_of(panel, false);
    for (PlotCurve& curve : panel.curves) thin(curve, across, up);
  }
  const std::string csv = plot_csv(plot);
  PHYTOBENCH_EXPECT(csv.size() <= most_bytes);
  context.artifact(name + ".plot.json", plot_json(plot));
  context.artifact(name + ".csv", csv);
}

}  // namespace phytobench
