// SPDX-License-Identifier: MIT
#include "reports/scaling_plots.hpp"

#include <utility>

#include "core/record/plot_files.hpp"
#include "reports/plot/line_plot.hpp"

namespace phytobench {

namespace {

constexpr std::size_t most_curves = 11;  // one more for the floor; eyes tell no more apart

/// A curve per entry that was measured at two sizes at least, the farthest and fastest first.
template <class Value>
std::vector<PlotSeries> curves(const JudgedScaling& scaling, const Value& value_at) {
  std::vector<PlotSeries> all;
  for (const ScaledEntry& entry : scaling.entries) {
    PlotSeries series{.name = entry.name, .x = {}, .y = {}, .low = {}, .high = {}};
    for (const auto& [size, at] : entry.at)
      if (const std::optional<Estimate> value = value_at(at)) {
        series.x.push_back(scaling.sizes.at(size).points);
        series.y.push_back(value->value);
        series.low.push_back(value->low);
        series.high.push_back(value->high);
      }
    if (series.x.size() > 1 && all.size() < most_curves) all.push_back(std::move(series));
  }
  return all;
}

std::optional<Estimate> evaluations_at(const ScaledEntry::AtSize& at) {
  if (!at.evaluations || !(*at.evaluations > 0.0)) return std::nullopt;
  return Estimate{*at.evaluations, *at.evaluations, *at.evaluations};
}

/// What no exact method can do without.
PlotSeries floor_curve(const JudgedScaling& scaling) {
  PlotSeries series{.name = "floor", .x = {}, .y = {}, .low = {}, .high = {}};
  for (const auto& [size, at] : scaling.sizes)
    if (const double pairs = at.association_pairs + at.removal_pairs; pairs > 0.0) {
      series.x.push_back(at.points);
      series.y.push_back(pairs);
    }
  return series;
}

std::map<std::string, LinePlot> plots_of(const JudgedScaling& scaling, bool without_varying) {
  std::map<std::string, LinePlot> plots;
  const auto add = [&](const std::string& name, LinePlot plot) {
    plot.id = scaling.study.id + "-" + name;
    plot.x_label = "attraction points";
    plot.log_x = plot.log_y = true;
    if (!plot.series.empty()) plots[plot.id] = std::move(plot);
  };
  if (!without_varying)
    add("time", {.id = {},
                 .title = "Time of one growth over the number of attraction points",
                 .description = "One curve per engine, both axes logarithmic; the values are in "
                                "the tables below.",
                 .x_label = {},
                 .y_label = "seconds per growth",
                 .series = curves(scaling, [](const auto& at) { return at.seconds; })});
  auto work = curves(scaling, evaluations_at);
  if (auto floor = floor_curve(scaling); !work.empty() && floor.x.size() > 1)
    work.push_back(std::move(floor));
  add("work", {.id = {},
               .title = "Distance evaluations of one growth over the number of attraction points",
               .description = "One curve per engine and one for the pairs that any exact method "
                              "must look at, both axes logarithmic.",
               .x_label = {},
               .y_label = "distance evaluations per growth",
               .series = std::move(work)});
  return plots;
}

}  // namespace

std::map<std::string, std::string> scaling_plots(const JudgedScaling& scaling,
                                                 bool without_varying) {
  std::map<std::string, std::string> drawn;
  for (const auto& [id, plot] : plots_of(scaling, without_varying))
    if (auto svg = draw(plot)) drawn[id] = std::move(*svg);
  return drawn;
}

std::map<std::string, std::string> scaling_plot_data(const JudgedScaling& scaling,
                                                     bool without_varying) {
  std::map<std::string, std::string> data;
  for (const auto& [id, plot] : plots_of(scaling, without_varying)) {
    PlotPanel panel;
    for (const PlotSeries& series : plot.series)
      panel.curves.push_back({.name = series.name,
                              .x = series.x,
                              .y = series.y,
                              .low = series.low,
                              .high = series.high});
    data[id] = plot_csv({.title = plot.title, .description = plot.description, .panels = {panel}});
  }
  return data;
}

}  // namespace phytobench
