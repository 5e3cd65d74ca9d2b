// SPDX-License-Identifier: MIT
#include "core/picture/curve_svg.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/contract/check.hpp"
#include "core/picture/curve_legend.hpp"
#include "core/picture/simplified_line.hpp"
#include "core/picture/svg_text.hpp"

namespace phytobench {

namespace {

// Pixels. Around the plot: its captions, numbers and names.
constexpr double plot_width = 290.0, plot_height = 220.0;
constexpr double left_margin = 62.0, right_margin = 14.0, top_margin = 26.0, bottom_margin = 40.0;
constexpr double panel_width = left_margin + plot_width + right_margin;
constexpr double panel_height = top_margin + plot_height + bottom_margin;
constexpr double legend_row = 18.0;
constexpr double tolerance = 0.1;  // of lines

AxisRange range_of_panel(const CurvePanel& panel, bool of_x) {
  const AxisScale scale = of_x ? panel.x_scale : panel.y_scale;
  std::vector<double> values;
  for (const Curve& curve : panel.curves) {
    PHYTOBENCH_EXPECT(curve.x.size() == curve.y.size());
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
      if (std::isnan(curve.y[i])) continue;
      const double value = of_x ? curve.x[i] : curve.y[i];
      PHYTOBENCH_EXPECT(std::isfinite(value) && (value > 0.0 || scale == AxisScale::linear));
      values.push_back(value);
    }
  }
  PHYTOBENCH_EXPECT(!values.empty());
  if (const auto& range = of_x ? panel.x_range : panel.y_range) return *range;
  const AxisRange range = range_of(values, scale);
  return of_x ? range : rounded_outwards(range, scale);
}

/// One decimal, and never -0.0.
std::string written(const Point2& p) {
  const auto rounded = [](double pixels) { return std::abs(pixels) < 0.05 ? 0.0 : pixels; };
  return fmt::format("{:.1f} {:.1f}", rounded(p.x), rounded(p.y));
}

/// A lone point becomes a stroke without length, that is, a dot.
std::string joined(const std::vector<Point2>& line) {
  std::string path;
  for (const Point2& p : line) path += (path.empty() ? "M" : "L") + written(p);
  return line.size() == 1 ? path + "h0" : path;
}

std::string dots(const std::vector<Point2>& points) {
  std::string path;
  for (const Point2& p : points) path += "M" + written(p) + "h0";
  return path;
}

class PanelDrawing {
 public:
  PanelDrawing(const CurvePanel& panel, double left)
      : panel_(panel),
        x_(range_of_panel(panel, true), panel.x_scale),
        y_(range_of_panel(panel, false), panel.y_scale),
        left_(left + left_margin) {}

  std::string draw(CurveLegend& legend) const {
    std::string svg = frame() + numbers();
    // A picture in the picture cuts off what lies outside, and needs no name as a clip path does.
    svg += fmt::format(
        "<svg x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" overflow=\"{}\">\n",
        left_, top_margin, plot_width, plot_height, all_inside() ? "visible" : "hidden");
    for (const Curve& curve : panel_.curves)
      svg += fmt::format("<path fill=\"none\" {} d=\"{}\"/>\n",
                         curve_stroke(curve.style, legend.colour_of(curve)), path_of(curve));
    return svg + "</svg>\n";
  }

 private:
  double right_of(double x) const { return plot_width * x_.position(x); }
  double down_to(double y) const { return plot_height * (1.0 - y_.position(y)); }

  bool all_inside() const {
    const auto within = [](double p) { return p >= -1e-9 && p <= 1.0 + 1e-9; };
    for (const Curve& curve : panel_.curves)
      for (std::size_t i = 0; i < curve.x.size(); ++i)
        if (!std::isnan(curve.y[i]) &&
            !(within(x_.position(curve.x[i])) && within(y_.position(curve.y[i]))))
          return false;
    return true;
  }

  std::string frame() const {
    const double middle = left_ + 0.5 * plot_width, centre = top_margin + 0.5 * plot_height;
    const double name = left_ - left_margin + 14.0;
    return svg_text(middle, top_margin - 9.0, "middle", panel_.caption) +
           fmt::format(
               "<path fill=\"none\" stroke=\"currentColor\" d=\"M{:.1f} {:.1f}v{:.1f}h{:.1f}"
               "\"/>\n",
               left_, top_margin, plot_height, plot_width) +
           svg_text(middle, top_margin + plot_height + 34.0, "middle", panel_.x_label) +
           svg_text(name, centre, "middle", panel_.y_label,
                    fmt::format(" transform=\"rotate(-90 {:.1f} {:.1f})\"", name, centre));
  }

  std::string numbers() const {
    std::string grid, texts;
    const double bottom = top_margin + plot_height;
    for (const AxisTick& tick : x_.ticks()) {
      const double x = left_ + right_of(tick.value);
      grid += fmt::format("M{:.1f} {:.1f}v{}", x, bottom, tick.label.empty() ? 3 : 5);
      if (!tick.label.empty()) texts += svg_text(x, bottom + 17.0, "middle", tick.label);
    }
    for (const AxisTick& tick : y_.ticks()) {
      const double y = top_margin + down_to(tick.value);
      grid += fmt::format("M{:.1f} {:.1f}h{}", left_, y, tick.label.empty() ? -3 : -5);
      if (!tick.label.empty()) texts += svg_text(left_ - 8.0, y + 4.0, "end", tick.label);
    }
    return fmt::format("<path fill=\"none\" stroke=\"currentColor\" d=\"{}\"/>\n", grid) + texts;
  }

  Point2 place(double x, double y) const {
    const auto drawable = [](double pixels) { return std::clamp(pixels, -1e7, 1e7); };
    return {drawable(right_of(x)), drawable(down_to(y))};
  }

  std::string path_of(const Curve& curve) const {
    std::string path;
    std::vector<Point2> line;
    const auto end_line = [&] {
      if (curve.style != CurveStyle::points) line = simplified_line(line, tolerance);
      path += curve.style == CurveStyle::points ? dots(line) : joined(line);
      line.clear();
    };
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
      if (std::isnan(curve.y[i]))
        end_line();
      else
        line.push_back(place(curve.x[i], curve.y[i]));
    }
    end_line();
    return path;
  }

  const CurvePanel& panel_;
  CurveAxis x_, y_;
  double left_;
};

}  // namespace

std::string curve_svg(const std::vector<CurvePanel>& panels, const std::string& title) {
  PHYTOBENCH_EXPECT(!panels.empty());
  const double width = panel_width * static_cast<double>(panels.size());
  CurveLegend legend;
  std::string body;
  for (std::size_t k = 0; k < panels.size(); ++k)
    body += PanelDrawing(panels[k], panel_width * static_cast<double>(k)).draw(legend);
  const double end = legend.draw(left_margin, panel_height + legend_row, width, body);
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.1f} {1:.1f}\" "
             "role=\"img\" aria-label=\"{2}\" fill=\"currentColor\" font-size=\"12\" "
             "font-family=\"sans-serif\">\n<title>{2}</title>\n",
             width, end + 8.0, escaped_for_svg(title)) +
         body + "</svg>\n";
}

}  // namespace phytobench
