// SPDX-License-Identifier: MIT
#include "reports/artifact_plots.hpp"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "core/contract/errors.hpp"
#include "core/contract/text_file.hpp"
#include "core/record/plot_files.hpp"
#include "core/record/plot_points.hpp"
#include "reports/document_anchors.hpp"
#include "reports/plot/line_plot.hpp"

namespace phytobench {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view plot_ending = ".plot.json";

// Of a plot alone, and of one of several; letters of 14 have room in both.
constexpr int lone_width = 640, lone_height = 420, panel_width = 480, panel_height = 400;

/// Colours of curves that name none: one for each name, in order.
class Colours {
 public:
  std::size_t of(const PlotCurve& curve) {
    if (curve.colour) return *curve.colour;
    return colours_.emplace(curve.name, colours_.size() % plot_colours).first->second;
  }

 private:
  std::map<std::string, std::size_t> colours_;
};

LinePlot line_plot(const PlotPanel& panel, Colours& colours) {
  LinePlot plot{.id = {},
                .title = {},
                .description = {},
                .x_label = panel.x_label,
                .y_label = panel.y_label,
                .log_x = panel.log_x,
                .log_y = panel.log_y,
                .series = {},
                .caption = panel.caption,
                .x_range = panel.x_range,
                .y_range = panel.y_range,
                .key = panel.curves.size() > 1 ? PlotKey::below : PlotKey::none};
  for (const PlotCurve& curve : panel.curves)
    plot.series.push_back({.name = curve.name,
                           .x = curve.x,
                           .y = curve.y,
                           .low = curve.low,
                           .high = curve.high,
                           .style = curve.style,
                           .colour = colours.of(curve)});
  return plot;
}

ArtifactPlot read_plot(const fs::path& folder, const std::set<std::string>& artifacts,
                       const std::string& name, const std::string& gnuplot) {
  const std::string stem = name.substr(0, name.size() - plot_ending.size());
  ArtifactPlot result{.svg = {}, .caption = {}, .data_name = stem + ".csv"};
  const fs::path json_file = folder / name;
  result.data_file = folder / result.data_name;
  if (!artifacts.contains(result.data_name))
    throw InputError(fmt::format("{}: the points of {} are missing; run the experiment again",
                                 result.data_file.string(), json_file.filename().string()));
  result.data = read_text_file(result.data_file);
  const PlotData plot = parse_plot(read_text_file(json_file), json_file.string(), result.data,
                                   result.data_file.string());
  result.caption = {plot.title, plot.description};
  result.svg = draw_plot(plot, slug(stem), gnuplot).value_or("");
  return result;
}

}  // namespace

std::optional<std::string> draw_plot(const PlotData& plot, const std::string& id,
                                     const std::string& gnuplot) {
  const bool is_lone = plot.panels.size() == 1;
  PlotRow row{.id = id, .title = plot.title, .description = plot.description, .plots = {}};
  Colours colours;
  for (const PlotPanel& panel : plot.panels) {
    row.plots.push_back(line_plot(panel, colours));
    row.plots.back().width = is_lone ? lone_width : panel_width;
    row.plots.back().height = is_lone ? lone_height : panel_height;
  }
  return draw(row, gnuplot);
}

std::map<std::string, ArtifactPlot> artifact_plots(const fs::path& run_folder,
                                                   const std::set<std::string>& artifacts,
                                                   const std::string& gnuplot) {
  std::map<std::string, ArtifactPlot> plots;
  for (const std::string& name : artifacts)
    if (name.ends_with(plot_ending))
      plots[name.substr(0, name.size() - plot_ending.size()) + ".svg"] =
          read_plot(run_folder / "artifacts", artifacts, name, gnuplot);
  return plots;
}

DataTable data_table(const std::string& csv, std::size_t most_rows) {
  DataTable table;
  std::vector<std::vector<std::string>> rows;
  for (std::string_view rest = csv; !rest.empty();) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    rows.push_back(csv_fields(rest.substr(0, end)));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  if (rows.empty()) return table;
  table.header = rows[0];
  if (rows.size() - 1 <= most_rows) table.rows.assign(rows.begin() + 1, rows.end());
  return table;
}

}  // namespace phytobench
