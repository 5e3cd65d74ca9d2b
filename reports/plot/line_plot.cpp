// SPDX-License-Identifier: MIT
#include "reports/plot/line_plot.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "core/contract/check.hpp"
#include "reports/plot/gnuplot_script.hpp"
#include "reports/plot/plot_text.hpp"
#include "reports/plot/run_gnuplot.hpp"
#include "reports/plot/smaller_svg.hpp"

namespace phytobench {

namespace {

bool is_id(const std::string& id) {
  return !id.empty() && std::all_of(id.begin(), id.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-';
  });
}

void expect_drawable(const PlotSeries& series, bool log_x, bool log_y) {
  const auto& [name, x, y, low, high, style, colour] = series;
  PHYTOBENCH_EXPECT(!x.empty() && y.size() == x.size() && low.size() == high.size());
  PHYTOBENCH_EXPECT(low.empty() || low.size() == x.size());
  PHYTOBENCH_EXPECT(colour.value_or(0) < plot_colours);
  PHYTOBENCH_EXPECT(
      !std::all_of(y.begin(), y.end(), [](double value) { return std::isnan(value); }));
  for (const auto* values : {&x, &y, &low, &high})
    for (const double value : *values)
      PHYTOBENCH_EXPECT((values == &y && std::isnan(value)) ||
                        (std::isfinite(value) && (value > 0.0 || !(values == &x ? log_x : log_y))));
}

void expect_drawable(const LinePlot& plot) {
  PHYTOBENCH_EXPECT(is_id(plot.id) && plot.width > 0 && plot.height > 0);
  PHYTOBENCH_EXPECT(!plot.series.empty() && plot.series.size() <= plot_colours);
  for (const PlotSeries& series : plot.series) expect_drawable(series, plot.log_x, plot.log_y);
}

/// Names of what gnuplot draws, in its order.
std::vector<std::string> drawn_names(const LinePlot& plot) {
  std::vector<std::string> names;
  for (const PlotSeries& series : plot.series) names.push_back(series.name);
  for (const PlotSeries& series : plot.series)
    if (!series.low.empty()) names.push_back(series.name);
  return names;
}

/// What gnuplot has drawn, its ids our own, without the root. Only tags change: what stands between
/// may be a text of the user.
std::string inside(const LinePlot& plot, const std::string& drawn) {
  const std::string svg = smaller_svg(drawn);
  const std::vector<std::string> names = drawn_names(plot);
  std::string result;
  std::size_t titles = 0;
  const std::size_t end = svg.rfind("</svg>");
  for (std::size_t tag = svg.find("<g id="), text = 0, next = 0; tag < end; tag = next) {
    text = svg.find('>', tag) + 1;
    next = std::min(svg.find('<', text), svg.size());
    std::string markup = replaced(svg.substr(tag, text - tag), "black", "currentColor");
    for (const char* reference : {" id='", " id=\"", "href='#", "url(#"})
      markup = replaced(markup, reference, fmt::format("{}{}-", reference, plot.id));
    result += markup;
    result += markup == "<title>" && titles < names.size() ? escaped_for_xml(names[titles++])
                                                           : svg.substr(text, next - text);
  }
  return result;
}

/// Single quotes around the ids: what gives others to an SVG, by its double quotes, leaves them.
std::string rooted(const std::string& id, const std::string& title, const std::string& description,
                   int width, int height, const std::string& content) {
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" "
             "xmlns:xlink=\"http://www.w3.org/1999/xlink\" viewBox=\"0 0 {0} {1}\" role=\"img\" "
             "aria-labelledby=\"{2}-title {2}-description\" aria-label=\"{3}\">\n"
             "<title id='{2}-title'>{3}</title>\n<desc id='{2}-description'>{4}</desc>\n",
             width, height, id, escaped_for_xml(title), escaped_for_xml(description)) +
         content + "</svg>\n";
}

}  // namespace

std::optional<std::string> draw(const LinePlot& plot, const std::string& gnuplot) {
  expect_drawable(plot);
  const std::optional<std::string> svg = run_gnuplot(gnuplot, gnuplot_script(plot));
  if (!svg) return std::nullopt;
  return rooted(plot.id, plot.title, plot.description, plot.width, plot.height, inside(plot, *svg));
}

std::optional<std::string> draw(const PlotRow& row, const std::string& gnuplot) {
  PHYTOBENCH_EXPECT(is_id(row.id) && !row.plots.empty() && row.columns > 0);
  const int width = row.plots[0].width, height = row.plots[0].height;
  const int count = static_cast<int>(row.plots.size()), columns = std::min(row.columns, count);
  std::string content;
  for (int i = 0; i < count; ++i) {
    LinePlot plot = row.plots[static_cast<std::size_t>(i)];
    PHYTOBENCH_EXPECT(plot.width == width && plot.height == height);
    plot.id = fmt::format("{}-{}", row.id, i + 1);
    expect_drawable(plot);
    const std::optional<std::string> svg = run_gnuplot(gnuplot, gnuplot_script(plot));
    if (!svg) return std::nullopt;
    content += fmt::format(
        "<svg x=\"{0}\" y=\"{1}\" width=\"{2}\" height=\"{3}\" viewBox=\"0 0 {2} "
        "{3}\">\n{4}</svg>\n",
        i % columns * width, i / columns * height, width, height, inside(plot, *svg));
  }
  return rooted(row.id, row.title, row.description, columns * width,
                (count + columns - 1) / columns * height, content);
}

}  // namespace phytobench
