// SPDX-License-Identifier: MIT
#include <algorithm>
#include <initializer_list>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/contract/errors.hpp"
#include "core/record/plot_files.hpp"
#include "core/record/plot_points.hpp"
#include "core/record/plot_styles.hpp"

namespace phytobench {

namespace {

using nlohmann::ordered_json;

/// Part of a JSON file and where it is: "figure-4.5.plot.json: panels[0].x".
struct Part {
  const ordered_json& json;
  std::string where;

  [[noreturn]] void refuse(const std::string& what) const {
    throw InputError(fmt::format("{} {}; {}", where, what, plot_remedy));
  }

  void expect_keys(std::initializer_list<std::string_view> known) const {
    if (!json.is_object()) refuse("is no object");
    for (const auto& [key, value] : json.items())
      if (std::find(known.begin(), known.end(), key) == known.end())
        refuse(fmt::format("has a key '{}' that {} does not know", key, plot_schema));
  }

  Part at(const std::string& key) const {
    if (!json.contains(key)) refuse(fmt::format("lacks the key '{}'", key));
    return {json.at(key), where + (where.ends_with(':') ? " " : ".") + key};
  }

  std::string text(const std::string& key) const {
    const Part part = at(key);
    if (!part.json.is_string()) part.refuse("is no text");
    return part.json;
  }

  std::vector<Part> parts(const std::string& key) const {
    const Part list = at(key);
    if (!list.json.is_array() || list.json.empty()) list.refuse("is no list, or an empty one");
    std::vector<Part> parts;
    for (std::size_t i = 0; i < list.json.size(); ++i)
      parts.push_back({list.json[i], fmt::format("{}[{}]", list.where, i)});
    return parts;
  }
};

void read_axis(const Part& axis, std::string& label, bool& is_log,
               std::optional<AxisRange>& range) {
  axis.expect_keys({"label", "log", "range"});
  label = axis.text("label");
  const Part log = axis.at("log");
  if (!log.json.is_boolean()) log.refuse("is neither true nor false");
  is_log = log.json;
  if (!axis.json.contains("range")) return;
  const Part ends = axis.at("range");
  if (!ends.json.is_array() || ends.json.size() != 2 || !ends.json[0].is_number() ||
      !ends.json[1].is_number())
    ends.refuse("is no pair of numbers");
  range = AxisRange{ends.json[0], ends.json[1]};
  if (!(range->low < range->high) || (is_log && !(range->low > 0.0)))
    ends.refuse("is no range of this axis");
}

PlotCurve read_curve(const Part& series) {
  series.expect_keys({"name", "style", "colour"});
  PlotCurve curve{.name = series.text("name"), .x = {}, .y = {}};
  const std::string word = series.text("style");
  const auto style = std::find_if(plot_styles.begin(), plot_styles.end(),
                                  [&](const auto& s) { return s.first == word; });
  if (style == plot_styles.end()) series.at("style").refuse("is no style of lines");
  curve.style = style->second;
  if (!series.json.contains("colour")) return curve;
  const Part colour = series.at("colour");
  if (!colour.json.is_number_unsigned() || colour.json.get<std::size_t>() >= plot_colours)
    colour.refuse(fmt::format("is no whole number below {}", plot_colours));
  curve.colour = colour.json.get<std::size_t>();
  return curve;
}

PlotPanel read_panel(const Part& part) {
  part.expect_keys({"caption", "x", "y", "series"});
  PlotPanel panel{.curves = {}, .caption = part.text("caption")};
  read_axis(part.at("x"), panel.x_label, panel.log_x, panel.x_range);
  read_axis(part.at("y"), panel.y_label, panel.log_y, panel.y_range);
  for (const Part& series : part.parts("series")) panel.curves.push_back(read_curve(series));
  if (panel.curves.size() > plot_colours)
    part.at("series").refuse(fmt::format("holds more than {} curves", plot_colours));
  return panel;
}

PlotData read_description(const ordered_json& json, const std::string& name) {
  const Part root{json, name + ":"};
  if (!json.is_object() || json.value("schema", ordered_json()) != plot_schema)
    root.refuse(fmt::format("the key 'schema' is not {}", plot_schema));
  root.expect_keys({"schema", "title", "description", "panels"});
  PlotData plot{.title = root.text("title"), .description = root.text("description"), .panels = {}};
  for (const Part& panel : root.parts("panels")) plot.panels.push_back(read_panel(panel));
  return plot;
}

ordered_json parsed_json(const std::string& text, const std::string& name) {
  try {
    return ordered_json::parse(text);
  } catch (const ordered_json::parse_error& error) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
    throw InputError(fmt::format("{}:{}: is no JSON; {}", name,
                                 1 + std::count(text.begin(), end, '\n'), plot_remedy));
  }
}

}  // namespace

PlotData parse_plot(const std::string& json, const std::string& json_name, const std::string& csv,
                    const std::string& csv_name) {
  PlotData plot = read_description(parsed_json(json, json_name), json_name);
  read_plot_points(plot, csv, csv_name);
  if (const std::string problem = plot_problem(plot); !problem.empty())
    throw InputError(fmt::format("{}, {}: {}; {}", json_name, csv_name, problem, plot_remedy));
  return plot;
}

}  // namespace phytobench
