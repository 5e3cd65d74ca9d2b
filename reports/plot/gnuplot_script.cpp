// SPDX-License-Identifier: MIT
#include "reports/plot/gnuplot_script.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "reports/plot/plot_text.hpp"

namespace phytobench {

namespace {

// The colours' contrast is at least 4:1 to both pages, #fdfdfb and #141814; dashes start over.
constexpr std::array<const char*, plot_colours> colours{"#247be0", "#ca5b0b", "#238e50", "#9e60ca",
                                                        "#d84a46", "#168797", "#d04596", "#8c7c14",
                                                        "#6f6fe0", "#9d7254", "#56891d", "#6e7d8d"};
constexpr std::array marks{7, 5, 9, 13, 6, 4, 8, 12, 11, 15, 2, 10};
constexpr std::array dashes{"solid", "(10,4)", "(3,3)", "(12,3,3,3)"};

// Of more points, marks would hide each other and swell the picture.
constexpr std::size_t most_marks = 150;

constexpr char head[] =
    "set terminal svg size {},{} noenhanced font 'sans-serif,14'\nset encoding utf8\n"
    "{}\nset border 3 lw 0.75\n"
    "set tics nomirror scale 0.7\nset grid lt 1 lw 0.75 lc rgb '#b0808080'\nset format '%g'\n"
    "set pointsize 0.8\nset clip two\nset xlabel {}{}\nset ylabel {}\nset title {}\n";

const char* key_command(PlotKey key) {
  if (key == PlotKey::none) return "set key off";
  return key == PlotKey::right
             ? "set key outside right top Left reverse samplen 4 spacing 1.2"
             : "set key bmargin center horizontal Left reverse samplen 3 spacing 1.2";
}

/// Octal escapes only, for gnuplot ends or expands quoted text in more ways than its manual says.
std::string quoted(const std::string& text) {
  std::string codes;
  for (const char c : printable(text)) codes += fmt::format("\\{:03o}", c & 0xff);
  return "\"" + codes + "\"";
}

/// digit * 10^power: 0.01, 50, 1,000, but 1e-6.
std::string tick_label(int digit, int power) {
  if (power < -3 || power > 7) return fmt::format("{}e{}", digit, power);
  std::string label = fmt::format("{:.{}f}", digit * std::pow(10, power), std::max(0, -power));
  for (int place = power - 2; place > 0; place -= 3)
    label.insert(static_cast<std::size_t>(place), ",");
  return label;
}

using Range = std::optional<AxisRange>;

/// Around the values, at least a factor of 6.25 from end to end, so that two named ticks lie
/// between.
AxisRange padded(const std::vector<double>& values) {
  const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
  const double pad = std::max(1.4, 2.5 / std::sqrt(*highest / *lowest));
  return {*lowest / pad, *highest * pad};
}

/// Ticks at every digit, named at decades; at 2 and 5 as well where there are few decades.
std::string logarithmic_axis(char axis, const AxisRange& range) {
  const auto [low, high] = range;
  std::string script =
      fmt::format("set logscale {0}\nset {0}range [{1}:{2}]\nset {0}tics ()\n", axis, low, high);
  for (int power = static_cast<int>(std::floor(std::log10(low))); power <= std::log10(high);
       ++power)
    for (int digit = 1; digit <= 9; ++digit) {
      const bool named = digit == 1 || (high < 100.0 * low && (digit == 2 || digit == 5));
      script += fmt::format("set {}tics add ('{}' {}e{} {})\n", axis,
                            named ? tick_label(digit, power) : "", digit, power, named ? 0 : 1);
    }
  return script;
}

std::string axis_commands(char axis, bool is_log, const Range& range,
                          const std::vector<double>& values) {
  if (is_log) return logarithmic_axis(axis, range ? *range : padded(values));
  return range ? fmt::format("set {}range [{}:{}]\n", axis, range->low, range->high) : "";
}

/// How a series is drawn, as gnuplot says it: marks and dashes go with the colour.
std::string style_of(const PlotSeries& series, std::size_t colour) {
  const auto line = [&](const char* with, const char* dash) {
    return fmt::format("with {} lw 2 lc rgb '{}' dt {}", with, colours[colour], dash);
  };
  switch (series.style) {
    case PlotStyle::solid:
      return line("lines", "solid");
    case PlotStyle::dashed:
      return line("lines", "(10,5)");
    case PlotStyle::dotted:
      return line("lines", "(2,4)");
    case PlotStyle::steps:
      return line("steps", "solid");
    case PlotStyle::points:
      return series.x.size() > most_marks
                 ? fmt::format("with dots lc rgb '{}'", colours[colour])
                 : fmt::format("with points lc rgb '{}' pt {}", colours[colour], marks[colour]);
    case PlotStyle::marked:
      break;
  }
  return fmt::format("{} pt {}", line("lp", dashes[colour % dashes.size()]), marks[colour]);
}

std::string data_block(std::size_t number, const PlotSeries& series) {
  const auto& [name, x, y, low, high, style, colour] = series;
  std::string block = fmt::format("$data{} << end\n", number);
  for (std::size_t j = 0; j < x.size(); ++j) {
    if (std::isnan(y[j]))
      block += "\n";
    else if (low.empty())
      block += fmt::format("{} {}\n", x[j], y[j]);
    else
      block += fmt::format("{} {} {} {}\n", x[j], y[j], low[j], high[j]);
  }
  return block + "end\n";
}

}  // namespace

std::string gnuplot_script(const LinePlot& plot) {
  std::string script =
      fmt::format(head, plot.width, plot.height, key_command(plot.key), quoted(plot.x_label),
                  plot.key == PlotKey::below ? " offset 0,0.3" : "", quoted(plot.y_label),
                  quoted(plot.caption));
  std::vector<double> all_x, all_y;
  std::string curves = "plot", bars;
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    const PlotSeries& series = plot.series[i];
    const std::size_t colour = series.colour.value_or(i);
    script += data_block(i, series);
    all_x.insert(all_x.end(), series.x.begin(), series.x.end());
    for (const auto* values : {&series.y, &series.low, &series.high})
      std::copy_if(values->begin(), values->end(), std::back_inserter(all_y),
                   [](double value) { return !std::isnan(value); });
    curves += fmt::format(" $data{} using 1:2 {} title {},", i, style_of(series, colour),
                          quoted(series.name));
    if (!series.low.empty())
      bars += fmt::format(
          " $data{} u 1:3:(0):($4-$3) with vectors heads size screen 0.004,90 lc rgb '{}' "
          "notitle,",
          i, colours[colour]);
  }
  (bars.empty() ? curves : bars).back() = '\n';
  script += axis_commands('x', plot.log_x, plot.x_range, all_x);
  script += axis_commands('y', plot.log_y, plot.y_range, all_y);
  return script + curves + bars;
}

}  // namespace phytobench
