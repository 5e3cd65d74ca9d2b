// SPDX-License-Identifier: MIT
#include "cli/history_series.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "benchmarks/history/history_file.hpp"
#include "benchmarks/history/run_changes.hpp"
#include "benchmarks/history/series_plot.hpp"
#include "cli/option_values.hpp"
#include "cli/output_files.hpp"
#include "cli/terminal.hpp"
#include "core/contract/errors.hpp"
#include "core/contract/suggestion.hpp"
#include "core/contract/text_file.hpp"

namespace phytobench::cli {

namespace {

using nlohmann::ordered_json;

struct Series {
  HistoryQuantity quantity;
  std::vector<HistoryLine> lines;
};

/// All that was asked for; never empty.
std::vector<Series> chosen_series(const HistoryOptions& options) {
  const HistoryFile file(options.file, HistoryAccess::read);
  const std::string& benchmark = options.names.front();
  std::vector<std::string> quantities = file.quantities(benchmark);
  if (quantities.empty())
    throw InputError(fmt::format("{} has no benchmark '{}'{}", options.file, benchmark,
                                 did_you_mean(benchmark, file.benchmarks())));
  if (!options.quantity.empty()) {
    const std::string wanted = HistoryQuantity::named(options.quantity).text();
    if (std::find(quantities.begin(), quantities.end(), wanted) == quantities.end())
      throw InputError(fmt::format("'{}' has no {}{}; it has {}", benchmark, wanted,
                                   did_you_mean(wanted, quantities), fmt::join(quantities, ", ")));
    quantities = {wanted};
  }
  std::vector<Series> result;
  for (const std::string& text : quantities) {
    const HistoryQuantity quantity = HistoryQuantity::named(text);
    result.push_back({quantity, comparable_lines(file.series(benchmark, quantity))});
  }
  return result;
}

/// Of a point against the one before in its line; nothing for the first.
std::string change_text(const HistoryPoint* before, const HistoryPoint& point) {
  if (before == nullptr) return "";
  const HistoryChange change{before->value, point.value};
  if (change.is_equal()) return "same";
  if (!std::isfinite(change.relative())) return "was 0";
  return fmt::format("{:+.2f} %", 100.0 * change.relative());
}

std::string line_text(const HistoryLine& line) {
  std::string text = line.name.empty() ? "" : line.name + "\n";
  text += fmt::format("{:>5}  {:<20}  {:<21}  {:>20}  {:>10}\n", "run", "date", "commit", "value",
                      "change");
  const HistoryPoint* before = nullptr;
  for (const HistoryPoint& point : line.points) {
    const bool has_other_inputs =
        before != nullptr && before->value.inputs() != point.value.inputs();
    text +=
        fmt::format("{:>5}  {:<20}  {:<21}  {:>20}  {:>10}{}\n", point.run.id, point.run.utc,
                    point.run.commit + (point.run.changed ? " changed" : ""), point.value.text(),
                    change_text(before, point), has_other_inputs ? "  other inputs" : "");
    before = &point;
  }
  const std::string note = step_note(line.points);
  return note.empty() ? text : text + note + "\n";
}

ordered_json point_json(const HistoryPoint* before, const HistoryPoint& point) {
  ordered_json json{{"run", point.run.id},
                    {"date_utc", point.run.utc},
                    {"commit", point.run.commit},
                    {"source_changed", point.run.changed},
                    {"inputs", point.value.inputs()}};
  if (point.value.quantity().is_ratio())
    json["value"] = point.value.number();
  else
    json["value"] = point.value.count();
  json["change"] = nullptr;  // of the first, and of what was 0
  if (before == nullptr) return json;
  const HistoryChange change{before->value, point.value};
  if (std::isfinite(change.relative())) json["change"] = change.relative();
  return json;
}

ordered_json series_json(const Series& series) {
  ordered_json json{{"quantity", series.quantity.text()}, {"lines", ordered_json::array()}};
  for (const HistoryLine& line : series.lines) {
    ordered_json points = ordered_json::array();
    for (std::size_t i = 0; i < line.points.size(); ++i)
      points.push_back(point_json(i == 0 ? nullptr : &line.points[i - 1], line.points[i]));
    json["lines"].push_back(
        {{"name", line.name}, {"note", step_note(line.points)}, {"points", points}});
  }
  return json;
}

void print_json(const HistoryOptions& options, const std::vector<Series>& all) {
  ordered_json document{
      {"schema", "phytobench/history-1"}, {"kind", "series"}, {"benchmark", options.names.front()}};
  document["entries"] = ordered_json::array();
  for (const Series& series : all) document["entries"].push_back(series_json(series));
  print(json_text(document) + "\n");
}

std::string title_of(const HistoryOptions& options, const Series& series) {
  return fmt::format("{}, {}", options.names.front(), series.quantity.text());
}

void write_svg(const HistoryOptions& options, const std::vector<Series>& all) {
  if (all.size() != 1) {
    std::vector<std::string> quantities;
    for (const Series& series : all) quantities.push_back(series.quantity.text());
    throw InputError(fmt::format("--out takes one quantity; give --quantity with one of {}",
                                 fmt::join(quantities, ", ")));
  }
  if (!options.out.ends_with(".svg"))
    throw InputError("--out '" + options.out + "': a plot is written as .svg");
  refuse_unwritable_files({options.out});
  write_file_atomically(options.out, series_svg(all.front().lines, title_of(options, all.front())));
}

}  // namespace

int show_history(const HistoryOptions& options) {
  const std::vector<Series> all = chosen_series(options);
  if (options.json) {
    print_json(options, all);
    return 0;
  }
  std::string text;
  for (const Series& series : all) {
    text += fmt::format("{}{}\n", text.empty() ? "" : "\n", title_of(options, series));
    for (const HistoryLine& line : series.lines) text += line_text(line);
  }
  print(text);
  return 0;
}

int plot_history(const HistoryOptions& options) {
  const std::vector<Series> all = chosen_series(options);
  if (!options.out.empty()) write_svg(options, all);
  if (options.json) {
    print_json(options, all);
    return 0;
  }
  std::string text;
  for (const Series& series : all) {
    text += fmt::format("{}{}\n", text.empty() ? "" : "\n", title_of(options, series));
    for (const HistoryLine& line : series.lines)
      text += (line.name.empty() ? "" : line.name + "\n") + series_text(line);
  }
  print(text);
  return 0;
}

}  // namespace phytobench::cli
