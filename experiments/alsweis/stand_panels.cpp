// SPDX-License-Identifier: MIT
#include "experiments/alsweis/stand_panels.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <tuple>

#include <fmt/format.h>

#include "core/contract/check.hpp"
#include "core/picture/curve_legend.hpp"
#include "core/picture/svg_text.hpp"

namespace phytobench::experiments::alsweis {

namespace {

constexpr double gap = 14.0, margin = 4.0, caption_height = 24.0, legend_height = 22.0;
constexpr double units_per_pixel = 2.0;  // whole numbers of half pixels: short, and fine enough
constexpr int least_disc = 4;            // diameter in units: still seen

struct Mark {
  int x, y, radius;  ///< in units

  friend auto operator<=>(const Mark&, const Mark&) = default;
};

/// From metres on the ground to units from the upper left corner of a panel.
class Scale {
 public:
  explicit Scale(const StandMap& map)
      : map_(map), units_per_metre_(units_per_pixel * map.panel_width / map.ground.width()) {}

  int width() const { return whole(map_.ground.width()); }
  int height() const { return whole(map_.ground.height()); }

  /// What of a layer is seen, with images on a torus, sorted: the order of plants is nothing to the
  /// picture.
  std::vector<Mark> marks_of(const StandLayer& layer) const {
    std::vector<Mark> marks;
    const Rectangle& ground = map_.ground;
    const int images = map_.is_torus ? 1 : 0;
    for (std::size_t i = 0; i < layer.places.size(); ++i)
      for (int ky = -images; ky <= images; ++ky)
        for (int kx = -images; kx <= images; ++kx) {
          const Point2 p = layer.places[i] + Point2{kx * ground.width(), ky * ground.height()};
          const double r = layer.radii[i];
          if (p.x + r < ground.low.x || p.x - r > ground.high.x || p.y + r < ground.low.y ||
              p.y - r > ground.high.y)
            continue;
          marks.push_back({whole(p.x - ground.low.x), whole(ground.high.y - p.y), whole(r)});
        }
    std::sort(marks.begin(), marks.end());
    return marks;
  }

 private:
  int whole(double metres) const {
    return static_cast<int>(std::lround(units_per_metre_ * metres));
  }

  const StandMap& map_;
  double units_per_metre_;
};

/// Strokes without length, from each to the next: a fifth of the bytes of circles. In strips, so
/// that the next is near.
std::string dots(std::vector<Mark> marks) {
  constexpr int strip = 24;
  const auto key = [](const Mark& m) { return std::tuple(m.y / strip, m.x, m.y); };
  std::sort(marks.begin(), marks.end(),
            [&](const Mark& a, const Mark& b) { return key(a) < key(b); });
  marks.erase(std::unique(marks.begin(), marks.end()), marks.end());
  std::string path;
  int x = 0, y = 0;
  for (const Mark& mark : marks) {
    path += fmt::format("m{}{}{}h0", mark.x - x, mark.y < y ? "" : " ", mark.y - y);
    std::tie(x, y) = std::tuple(mark.x, mark.y);
  }
  return path;
}

/// One path for each width.
std::string discs_svg(const std::vector<Mark>& marks, const std::string& colour) {
  std::map<int, std::vector<Mark>> by_width;
  for (const Mark& mark : marks) by_width[std::max(2 * mark.radius, least_disc)].push_back(mark);
  std::string svg;
  for (const auto& [width, alike] : by_width)
    svg += fmt::format(
        "<path fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" stroke-linecap=\"round\" "
        "d=\"{}\"/>\n",
        colour, width, dots(alike));
  return svg;
}

std::string rings_svg(const std::vector<Mark>& marks, const std::string& colour,
                      const char* dashes) {
  std::string svg =
      fmt::format("<g fill=\"none\" stroke=\"{}\" stroke-width=\"1.6\"{}>\n", colour, dashes);
  for (const Mark& mark : marks)
    svg += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"/>\n", mark.x, mark.y, mark.radius);
  return svg + "</g>\n";
}

std::string crosses_svg(const std::vector<Mark>& marks, const std::string& colour) {
  std::string path;
  for (const Mark& mark : marks) {
    const int r = mark.radius;
    path += fmt::format("M{} {}l{} {}m0 {}l{} {}", mark.x - r, mark.y - r, 2 * r, 2 * r, -2 * r,
                        -2 * r, 2 * r);
  }
  return fmt::format("<path fill=\"none\" stroke=\"{}\" stroke-width=\"4\" d=\"{}\"/>\n", colour,
                     path);
}

CurveStyle style_of(StandMark mark) {
  switch (mark) {
    case StandMark::disc:
      return CurveStyle::points;
    case StandMark::dashed_ring:
      return CurveStyle::dashed;
    case StandMark::ring:
    case StandMark::cross:
      break;
  }
  return CurveStyle::solid;
}

std::string marks_svg(StandMark mark, const std::vector<Mark>& marks, const std::string& colour) {
  if (marks.empty()) return {};
  switch (mark) {
    case StandMark::disc:
      return discs_svg(marks, colour);
    case StandMark::cross:
      return crosses_svg(marks, colour);
    case StandMark::dashed_ring:
      return rings_svg(marks, colour, " stroke-dasharray=\"9 6\"");
    case StandMark::ring:
      break;
  }
  return rings_svg(marks, colour, "");
}

std::string panel_svg(const Scale& scale, const StandPanel& panel, Point2 corner,
                      CurveLegend& legend) {
  const double width = scale.width() / units_per_pixel, height = scale.height() / units_per_pixel;
  // A picture within cuts off what lies beyond it, without an id that another one may have, too.
  std::string svg = fmt::format(
      "<svg x=\"{:.1f}\" y=\"{:.1f}\" width=\"{}\" height=\"{}\" viewBox=\"0 0 {} {}\">\n",
      corner.x, corner.y, width, height, scale.width(), scale.height());
  for (const StandLayer& layer : panel.layers) {
    PHYTOBENCH_EXPECT(layer.places.size() == layer.radii.size());
    const std::string colour = legend.colour_of({.name = layer.name,
                                                 .x = {},
                                                 .y = {},
                                                 .style = style_of(layer.mark),
                                                 .colour = layer.colour});
    svg += marks_svg(layer.mark, scale.marks_of(layer), colour);
  }
  svg += fmt::format(
      "</svg>\n<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{}\" height=\"{}\" fill=\"none\" "
      "stroke=\"currentColor\"/>\n",
      corner.x, corner.y, width, height);
  return svg + svg_text(corner.x + 0.5 * width, corner.y + height + 16.0, "middle", panel.caption);
}

/// Every plant of one species: where, and how large `radius` of its index says.
template <class Radius>
StandLayer layer_of(const Population& population, SpeciesIndex species, StandMark mark,
                    const Radius& radius) {
  const Stand& stand = population.stand();
  StandLayer layer{.name = population.parameters().species.at(species).name,
                   .places = {},
                   .radii = {},
                   .mark = mark};
  for (std::size_t i = 0; i < stand.size(); ++i) {
    if (stand.species[i] != species) continue;
    layer.places.push_back(stand.place(i));
    layer.radii.push_back(radius(i));
  }
  return layer;
}

StandLayer zones(const Population& population, SpeciesIndex species,
                 const std::vector<double>& radii, const char* kind) {
  StandLayer layer =
      layer_of(population, species, StandMark::ring, [&](std::size_t i) { return radii[i]; });
  layer.name += kind;
  return layer;
}

}  // namespace

std::string stand_panels_svg(const StandMap& map, const std::vector<StandPanel>& panels,
                             const std::string& title) {
  PHYTOBENCH_EXPECT(!panels.empty() && map.columns > 0 && map.ground.width() > 0.0);
  const Scale scale(map);
  const double across = map.panel_width + gap;
  const double down = scale.height() / units_per_pixel + caption_height;
  const std::size_t columns = std::min(map.columns, panels.size());
  const std::size_t rows = (panels.size() + columns - 1) / columns;
  CurveLegend legend;
  std::string body;
  for (std::size_t k = 0; k < panels.size(); ++k)
    body += panel_svg(scale, panels[k],
                      {margin + across * static_cast<double>(k % columns),
                       margin + down * static_cast<double>(k / columns)},
                      legend);
  const double right = 2.0 * margin + across * static_cast<double>(columns) - gap;
  const double bottom = legend.draw(
      margin, margin + down * static_cast<double>(rows) + legend_height - 8.0, right, body);
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.1f} {1:.1f}\" "
             "role=\"img\" aria-label=\"{2}\" fill=\"currentColor\" font-size=\"12\" "
             "font-family=\"sans-serif\">\n<title>{2}</title>\n",
             right, bottom + 10.0, escaped_for_svg(title)) +
         body + "</svg>\n";
}

StandLayer stems_of(const Population& population, SpeciesIndex species, double magnification) {
  return layer_of(population, species, StandMark::disc,
                  [&](std::size_t i) { return magnification * population.stand().stem_radius[i]; });
}

StandLayer root_zones_of(const Population& population, SpeciesIndex species) {
  return zones(population, species, population.root_radii(), ", root zone");
}

StandLayer crown_zones_of(const Population& population, SpeciesIndex species) {
  return zones(population, species, population.crown_radii(), ", crown zone");
}

}  // namespace phytobench::experiments::alsweis
