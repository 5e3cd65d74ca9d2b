// SPDX-License-Identifier: MIT
#include "core/record/plot_files.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/record/plot_styles.hpp"

namespace phytobench {

namespace {

using nlohmann::ordered_json;

/// Shortest text that reads back as the number rounded to six digits.
std::string written(double value) {
  if (std::isnan(value)) return "";
  return fmt::format("{}", std::strtod(fmt::format("{:.5e}", value).c_str(), nullptr) + 0.0);
}

std::string quoted(const std::string& field) {
  if (field.find_first_of(",\"\r\n") == std::string::npos) return field;
  std::string text = "\"";
  for (const char c : field) text += c == '"' ? std::string("\"\"") : std::string(1, c);
  return text + "\"";
}

ordered_json axis_json(const std::string& label, bool is_log,
                       const std::optional<AxisRange>& range) {
  ordered_json axis{{"label", label}, {"log", is_log}};
  if (range) axis["range"] = {range->low, range->high};
  return axis;
}

ordered_json panel_json(const PlotPanel& panel) {
  ordered_json json{{"caption", panel.caption},
                    {"x", axis_json(panel.x_label, panel.log_x, panel.x_range)},
                    {"y", axis_json(panel.y_label, panel.log_y, panel.y_range)},
                    {"series", ordered_json::array()}};
  for (const PlotCurve& curve : panel.curves) {
    const auto style = std::find_if(plot_styles.begin(), plot_styles.end(),
                                    [&](const auto& s) { return s.second == curve.style; });
    json["series"].push_back({{"name", curve.name}, {"style", style->first}});
    if (curve.colour) json["series"].back()["colour"] = *curve.colour;
  }
  return json;
}

bool has_bars(const PlotPanel& panel) {
  return std::any_of(panel.curves.begin(), panel.curves.end(),
                     [](const PlotCurve& curve) { return !curve.low.empty(); });
}

}  // namespace

std::string plot_json(const PlotData& plot) {
  ordered_json json{{"schema", plot_schema},
                    {"title", plot.title},
                    {"description", plot.description},
                    {"panels", ordered_json::array()}};
  for (const PlotPanel& panel : plot.panels) json["panels"].push_back(panel_json(panel));
  return json.dump(2) + "\n";
}

std::string plot_csv(const PlotData& plot) {
  const bool numbered = plot.panels.size() > 1;
  const bool bars = std::any_of(plot.panels.begin(), plot.panels.end(), has_bars);
  std::string csv =
      fmt::format("{}series,x,y{}\n", numbered ? "panel," : "", bars ? ",low,high" : "");
  for (std::size_t p = 0; p < plot.panels.size(); ++p)
    for (const PlotCurve& curve : plot.panels[p].curves) {
      const std::string start = (numbered ? fmt::format("{},", p + 1) : "") + quoted(curve.name);
      for (std::size_t i = 0; i < curve.x.size(); ++i) {
        csv += fmt::format("{},{},{}", start, written(curve.x[i]), written(curve.y[i]));
        if (bars && curve.low.empty()) csv += ",,";
        if (bars && !curve.low.empty())
          csv += fmt::format(",{},{}", written(curve.low[i]), written(curve.high[i]));
        csv += "\n";
      }
    }
  return csv;
}

}  // namespace phytobench
