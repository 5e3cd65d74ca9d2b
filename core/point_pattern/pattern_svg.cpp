// SPDX-License-Identifier: MIT
#include "core/point_pattern/pattern_svg.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/picture/svg_text.hpp"

namespace phytobench {

namespace {

constexpr double panel_width = 300.0, gap = 20.0, margin = 4.0, caption_height = 26.0;

/// On a torus also the images of outlines that leave it, so that no border is bare.
std::vector<std::vector<Point2>> with_images(const std::vector<std::vector<Point2>>& outlines,
                                             const Window& window) {
  std::vector<std::vector<Point2>> all = outlines;
  if (window.kind() != WindowKind::torus) return all;
  const Rectangle& box = window.bounding_box();
  for (const std::vector<Point2>& outline : outlines) {
    if (std::all_of(outline.begin(), outline.end(),
                    [&](const Point2& p) { return box.contains(p); }))
      continue;
    for (int ky = -1; ky <= 1; ++ky)
      for (int kx = -1; kx <= 1; ++kx) {
        if (kx == 0 && ky == 0) continue;
        std::vector<Point2>& image = all.emplace_back(outline);
        for (Point2& p : image) p = p + Point2{kx * box.width(), ky * box.height()};
        if (std::none_of(image.begin(), image.end(),
                         [&](const Point2& p) { return box.contains(p); }))
          all.pop_back();
      }
  }
  return all;
}

class Panel {
 public:
  Panel(const Window& window, double left)
      : window_(window),
        box_(window.bounding_box()),
        left_(left),
        scale_(panel_width / box_.width()) {}

  double height() const { return scale_ * box_.height(); }

  std::string draw(const PatternPanel& panel, std::size_t number) const {
    std::string text = fmt::format(
        "<clipPath id=\"panel-{0}\"><rect x=\"{1:.1f}\" y=\"{2:.1f}\" width=\"{3:.1f}\" "
        "height=\"{4:.1f}\"/></clipPath>\n<g clip-path=\"url(#panel-{0})\">\n",
        number, left_, margin, panel_width, height());
    text += lines(with_images(panel.cells, window_), true, "stroke-width=\".6\" opacity=\".55\"");
    text += lines(panel.ways, false, "stroke-width=\".8\" opacity=\".7\"");
    text += dots(panel.points) + "</g>\n";
    text += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"none\" "
        "stroke=\"currentColor\"/>\n<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"14\" "
        "text-anchor=\"middle\" fill=\"currentColor\" font-family=\"sans-serif\">{}</text>\n",
        left_, margin, panel_width, height(), left_ + 0.5 * panel_width,
        margin + height() + 0.7 * caption_height, escaped_for_svg(panel.caption));
    return text;
  }

 private:
  std::string place(const Point2& p) const {
    return fmt::format("{:.1f} {:.1f}", left_ + scale_ * (p.x - box_.low.x),
                       margin + scale_ * (box_.high.y - p.y));
  }

  std::string lines(const std::vector<std::vector<Point2>>& all, bool closed,
                    const char* style) const {
    std::string path;
    for (const std::vector<Point2>& line : all) {
      for (std::size_t k = 0; k < line.size(); ++k) path += (k == 0 ? "M" : "L") + place(line[k]);
      if (closed && !line.empty()) path += "z";
    }
    if (path.empty()) return {};
    return fmt::format("<path fill=\"none\" stroke=\"currentColor\" {} d=\"{}\"/>\n", style, path);
  }

  /// One path of strokes without length: a third of the bytes of circles.
  std::string dots(const std::vector<Point2>& points) const {
    std::string path;
    for (const Point2& p : points) path += "M" + place(p) + "h0";
    return fmt::format(
        "<path fill=\"none\" stroke=\"#2e7d32\" stroke-width=\"5\" stroke-linecap=\"round\" "
        "d=\"{}\"/>\n",
        path);
  }

  const Window& window_;
  Rectangle box_;
  double left_, scale_;
};

}  // namespace

std::string pattern_svg(const std::vector<PatternPanel>& panels, const Window& window,
                        const std::string& title) {
  const double height = Panel(window, 0.0).height() + margin + caption_height;
  const auto count = static_cast<double>(panels.size());
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.1f} {:.1f}\" role=\"img\" "
      "aria-label=\"{}\">\n<title>{}</title>\n",
      count * panel_width + (count - 1.0) * gap + 2.0 * margin, height, escaped_for_svg(title),
      escaped_for_svg(title));
  for (std::size_t k = 0; k < panels.size(); ++k)
    text += Panel(window, margin + static_cast<double>(k) * (panel_width + gap)).draw(panels[k], k);
  return text + "</svg>\n";
}

}  // namespace phytobench
