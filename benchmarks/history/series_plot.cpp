// SPDX-License-Identifier: MIT
#include "benchmarks/history/series_plot.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "core/contract/check.hpp"
#include "core/statistics/order_statistics.hpp"

namespace phytobench {

namespace {

constexpr std::size_t text_rows = 11;

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text)
    result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
  return result;
}

std::string shared_name(const HistoryPoint& point) {
  if (point.value.quantity().is_counter()) return "";
  return fmt::format("{}; {} {}", point.run.machine_class(), point.run.compiler, point.run.flags);
}

/// What a picture spans upwards; never empty, so that equal values lie in its middle.
struct Range {
  double low = 0.0;
  double high = 0.0;

  /// 0 at the bottom, 1 at the top.
  double share(double value) const { return high > low ? (value - low) / (high - low) : 0.5; }
};

Range range_of(const std::vector<HistoryLine>& lines) {
  Range range{lines.front().points.front().value.number(),
              lines.front().points.front().value.number()};
  for (const HistoryLine& line : lines)
    for (const HistoryPoint& point : line.points) {
      range.low = std::min(range.low, point.value.number());
      range.high = std::max(range.high, point.value.number());
    }
  return range;
}

std::string number_text(double value, const HistoryQuantity& quantity) {
  return quantity.is_ratio() ? fmt::format("{:.6g}", value) : fmt::format("{:.0f}", value);
}

/// The picture's grid is one of whole numbers, to keep its bytes the same everywhere.
struct Grid {
  static constexpr long width = 640, height = 240, left = 100, top = 28, right = 16, bottom = 32;
  Range range;
  std::int64_t first_run = 0;
  std::int64_t last_run = 0;

  long column(const HistoryPoint& point) const {
    const auto span = static_cast<double>(std::max<std::int64_t>(last_run - first_run, 1));
    const double share =
        last_run == first_run ? 0.5 : static_cast<double>(point.run.id - first_run) / span;
    return left + std::lround(share * static_cast<double>(width - left - right));
  }
  long row(const HistoryPoint& point) const {
    const double share = range.share(point.value.number());
    return top + std::lround((1.0 - share) * static_cast<double>(height - top - bottom));
  }
};

Grid grid_of(const std::vector<HistoryLine>& lines) {
  Grid grid{.range = range_of(lines),
            .first_run = lines.front().points.front().run.id,
            .last_run = lines.front().points.front().run.id};
  for (const HistoryLine& line : lines) {
    grid.first_run = std::min(grid.first_run, line.points.front().run.id);
    grid.last_run = std::max(grid.last_run, line.points.back().run.id);
  }
  return grid;
}

std::string svg_axes(const Grid& grid, const HistoryQuantity& quantity) {
  constexpr long bottom = Grid::height - Grid::bottom, end = Grid::width - Grid::right;
  std::string svg =
      fmt::format("<path fill=\"none\" stroke=\"currentColor\" d=\"M{} {}V{}H{}\"/>\n",
                  Grid::left - 8, Grid::top, bottom + 8, end);
  const auto label = [&svg](long x, long y, const char* anchor, const std::string& text) {
    svg += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor,
                       escaped(text));
  };
  label(Grid::left - 14, Grid::top + 4, "end", number_text(grid.range.high, quantity));
  if (grid.range.low < grid.range.high)
    label(Grid::left - 14, bottom + 4, "end", number_text(grid.range.low, quantity));
  label(Grid::left, bottom + 24, "middle", fmt::format("run {}", grid.first_run));
  if (grid.first_run < grid.last_run)
    label(end, bottom + 24, "end", fmt::format("run {}", grid.last_run));
  return svg;
}

/// Lines differ in their dashes, which need no colour.
std::string svg_line(const Grid& grid, const HistoryLine& line, std::size_t index) {
  constexpr const char* dashes[] = {"", " stroke-dasharray=\"6 3\"", " stroke-dasharray=\"2 3\""};
  std::string path, circles;
  for (const HistoryPoint& point : line.points) {
    path += fmt::format("{}{} {}", path.empty() ? "M" : "L", grid.column(point), grid.row(point));
    circles +=
        fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"3\"><title>{}</title></circle>\n",
                    grid.column(point), grid.row(point),
                    escaped(fmt::format("run {}, {}{}: {}", point.run.id, point.run.commit,
                                        point.run.changed ? " changed" : "", point.value.text())));
  }
  return fmt::format(
      "<g fill=\"currentColor\"><title>{}</title>"
      "<path fill=\"none\" stroke=\"currentColor\"{} d=\"{}\"/>\n{}</g>\n",
      escaped(line.name), dashes[index % std::size(dashes)], path, circles);
}

std::string described(const std::vector<HistoryLine>& lines, const Grid& grid) {
  const HistoryQuantity& quantity = lines.front().points.front().value.quantity();
  return fmt::format("{} of runs {} to {}, between {} and {}; lines: {}", quantity.text(),
                     grid.first_run, grid.last_run, number_text(grid.range.low, quantity),
                     number_text(grid.range.high, quantity), lines.size());
}

}  // namespace

std::vector<HistoryLine> comparable_lines(const std::vector<HistoryPoint>& series) {
  std::vector<HistoryLine> lines;
  for (const HistoryPoint& point : series) {
    const std::string name = shared_name(point);
    auto line = std::find_if(lines.begin(), lines.end(),
                             [&](const HistoryLine& known) { return known.name == name; });
    if (line == lines.end()) line = lines.insert(lines.end(), HistoryLine{name, {}});
    line->points.push_back(point);
  }
  return lines;
}

std::string series_text(const HistoryLine& line, std::size_t width) {
  PHYTOBENCH_EXPECT(!line.points.empty() && width > 0);
  const Range range = range_of({line});
  const HistoryQuantity& quantity = line.points.front().value.quantity();
  const std::size_t count = line.points.size(), columns = std::min(count, width);
  std::vector<std::string> rows(text_rows, std::string(columns, ' '));
  for (std::size_t column = 0; column < columns; ++column) {
    const HistoryPoint& point = line.points[(column + 1) * count / columns - 1];
    const double share = range.share(point.value.number());
    const auto above =
        static_cast<std::size_t>(std::lround(share * static_cast<double>(text_rows - 1)));
    rows[text_rows - 1 - above][column] = '*';
  }
  std::string text;
  for (std::size_t row = 0; row < text_rows; ++row) {
    const std::string label = row == 0               ? number_text(range.high, quantity)
                              : row == text_rows - 1 ? number_text(range.low, quantity)
                                                     : "";
    const std::size_t end = rows[row].find_last_not_of(' ');
    text += fmt::format("{:>16} |{}\n", label,
                        end == std::string::npos ? "" : rows[row].substr(0, end + 1));
  }
  return text + fmt::format("{:>16} +{}\n{:>18}run {} to run {}\n", "", std::string(columns, '-'),
                            "", line.points.front().run.id, line.points.back().run.id);
}

std::string series_svg(const std::vector<HistoryLine>& lines, const std::string& title) {
  PHYTOBENCH_EXPECT(!lines.empty());
  for (const HistoryLine& line : lines) PHYTOBENCH_EXPECT(!line.points.empty());
  const Grid grid = grid_of(lines);
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" role=\"img\" "
      "font-family=\"sans-serif\" font-size=\"12\" fill=\"currentColor\"><title>{}</title>\n"
      "<desc>{}</desc>\n<text x=\"{}\" y=\"16\">{}</text>\n",
      Grid::width, Grid::height, escaped(title), escaped(described(lines, grid)), Grid::left - 8,
      escaped(title));
  svg += svg_axes(grid, lines.front().points.front().value.quantity());
  for (std::size_t i = 0; i < lines.size(); ++i) svg += svg_line(grid, lines[i], i);
  return svg + "</svg>\n";
}

std::string step_note(const std::vector<HistoryPoint>& points) {
  constexpr std::size_t last_count = 3, least_earlier = 6;
  constexpr double robust_sigma = 1.4826, sigmas = 5.0, least_change = 0.002;
  if (points.size() < last_count + least_earlier) return "";
  std::vector<double> earlier, last, deviations;
  for (std::size_t i = 0; i < points.size(); ++i)
    (i + last_count < points.size() ? earlier : last).push_back(points[i].value.number());
  const double level = median(earlier);
  for (const double value : earlier) deviations.push_back(std::abs(value - level));
  const double step = median(last) - level;
  const bool is_step = std::abs(step) > sigmas * robust_sigma * median(deviations) &&
                       std::abs(step) > least_change * std::abs(level) && level != 0.0;
  if (!is_step) return "";
  return fmt::format("note: the last {} runs stand {:+.2f} % from the {} before", last_count,
                     100.0 * step / level, earlier.size());
}

}  // namespace phytobench
