// SPDX-License-Identifier: MIT
#include "core/population/stand_picture.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/contract/check.hpp"
#include "core/picture/svg_text.hpp"
#include "core/population/stand_look.hpp"
#include "core/population/stand_statistics.hpp"

namespace phytobench {

namespace {

constexpr const char* haze = "#808080";
constexpr const char* lightest = "#ffffff";  // richest ground
constexpr const char* poorest = "#cccccc";   // haze at its darkest on it
constexpr double darkest = 0.4;              // opacity of haze: plants must stand out from it
constexpr const char* ill_style =
    "fill=\"none\" stroke=\"currentColor\" stroke-width=\"1.2\" stroke-dasharray=\"2.4 1.6\"";
constexpr double map_side = 640.0, narrowest = 360.0, picture_margin = 8.0,
                 row_height = 20.0;  // pixels

/// 1, 2 or 5 times a power of ten, the largest that is no longer than this.
double round_length(double longest) {
  const double power = std::pow(10.0, std::floor(std::log10(longest)));
  for (const double step : {5.0, 2.0})
    if (step * power <= longest) return step * power;
  return power;
}

class StandSvg {
 public:
  explicit StandSvg(const StandView& view)
      : view_(view),
        parameters_(view.parameters),
        scale_(map_side / std::max(ground().width(), ground().height())),
        order_(order_of_ids(view.stand)) {}

  std::string drawn(const std::string& title) {
    constexpr double top = picture_margin + row_height;
    const double width = std::max(narrowest, scale_ * ground().width()) + 2.0 * picture_margin;
    std::string body = svg_text(picture_margin, picture_margin + 0.6 * row_height, "start", title);
    body += fmt::format("<svg x=\"{}\" y=\"{}\" width=\"{:.2f}\" height=\"{:.2f}\">\n",
                        picture_margin, top, scale_ * ground().width(), scale_ * ground().height());
    body += background() + zones() + crowns() + stems() + illness() + "</svg>\n";
    body += fmt::format(
        "<rect x=\"{}\" y=\"{}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"none\" "
        "stroke=\"currentColor\" stroke-opacity=\".5\"/>\n",
        picture_margin, top, scale_ * ground().width(), scale_ * ground().height());
    double bottom = top + scale_ * ground().height() + row_height;
    body += length_bar(bottom);
    body += legend(width, bottom);
    return fmt::format(
               "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.2f} {:.2f}\" "
               "role=\"img\" font-family=\"sans-serif\" font-size=\"13\" fill=\"currentColor\">\n"
               "<title>{}</title>\n",
               width, bottom + picture_margin, escaped_for_svg(title)) +
           body + "</svg>\n";
  }

 private:
  const Rectangle& ground() const { return parameters_.ground; }

  /// Circles of the plants that belong to a group; nothing if there are none.
  template <class Belongs, class Radius>
  std::string group(const std::string& style, const Belongs& belongs, const Radius& radius) const {
    std::string circles;
    for (const std::size_t i : order_) {
      if (!belongs(i)) continue;
      const double r = radius(i);
      for_each_appearance(parameters_, view_.stand.place(i), r, [&](const Point2& at) {
        circles += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.2f}\"/>",
                               scale_ * (at.x - ground().low.x), scale_ * (ground().high.y - at.y),
                               std::max(0.6, scale_ * r));
      });
    }
    return circles.empty() ? circles : fmt::format("<g {}>{}</g>\n", style, circles);
  }

  /// A group for each species and age; `belongs` may leave out some plants.
  template <class Belongs, class Radius>
  std::string groups(const char* paint, const std::string& style, const Belongs& belongs,
                     const Radius& radius) const {
    std::string text;
    for (std::size_t species = 0; species < parameters_.species.size(); ++species)
      for (std::size_t age = 0; age < age_classes; ++age)
        text += group(
            fmt::format("{}=\"{}\" {}", paint, to_text(plant_colour(species, age)), style),
            [&](std::size_t i) {
              return view_.stand.species[i] == species &&
                     age_class(parameters_.species[species], view_.stand.age[i]) == age &&
                     belongs(i);
            },
            radius);
    return text;
  }

  std::string zones() const {
    const auto radius = [&](std::size_t i) { return view_.root_radius[i]; };
    const auto oppressed = [&](std::size_t i) { return is_oppressed(view_.loss[i]); };
    const std::string style = "stroke-width=\".9\" fill=\"none\"";
    return groups(
               "stroke", style, [&](std::size_t i) { return !oppressed(i); }, radius) +
           group(fmt::format("stroke=\"{}\" {}", to_text(oppressed_colour()), style), oppressed,
                 radius);
  }

  std::string crowns() const {
    if (view_.crown_radius.empty()) return {};
    return groups(
        "fill", "fill-opacity=\".18\"", [](std::size_t) { return true; },
        [&](std::size_t i) { return view_.crown_radius[i]; });
  }

  std::string stems() const {
    return groups(
        "fill", "", [](std::size_t) { return true; },
        [&](std::size_t i) { return view_.stand.stem_radius[i]; });
  }

  bool is_ill(std::size_t i) const { return view_.stand.ill_since[i] != healthy; }

  std::string illness() const {
    const double spacing =
        scale_ * std::sqrt(ground().area() /
                           static_cast<double>(std::max<std::size_t>(1, view_.stand.size())));
    return group(
        ill_style, [&](std::size_t i) { return is_ill(i); },
        [&](std::size_t i) {
          return illness_ring(scale_ * view_.stand.stem_radius[i], spacing) / scale_;
        });
  }

  /// Haze where the ground is poor, in cells; neighbours of one grey in a row are one rectangle.
  std::string background() const {
    const ResourceMap* map = background_of(parameters_);
    if (map == nullptr) return {};
    constexpr int cells = 48, greys = 8;
    const double width = ground().width() / cells, height = ground().height() / cells;
    const auto grey_at = [&](int column, int row) {
      const Point2 center{ground().low.x + (column + 0.5) * width,
                          ground().high.y - (row + 0.5) * height};
      return static_cast<int>(std::lround(greys * (1.0 - map->at(center))));
    };
    // On a page of any colour poor ground is the darker one: it lies on white.
    std::string text = fmt::format(
        "<rect width=\"{:.2f}\" height=\"{:.2f}\" fill=\"{}\"/><g fill=\"{}\" "
        "shape-rendering=\"crispEdges\">",
        scale_ * ground().width(), scale_ * ground().height(), lightest, haze);
    for (int row = 0; row < cells; ++row)
      for (int column = 0, next = 0; column < cells; column = next) {
        const int grey = grey_at(column, row);
        for (next = column + 1; next < cells && grey_at(next, row) == grey;) ++next;
        if (grey > 0)
          text += fmt::format(
              "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" "
              "fill-opacity=\"{:.3f}\"/>",
              scale_ * column * width, scale_ * row * height, scale_ * (next - column) * width,
              scale_ * height, darkest * grey / greys);
      }
    return text + "</g>\n";
  }

  std::string length_bar(double y) const {
    const double length = round_length(0.3 * ground().width());
    return fmt::format(
               "<path d=\"M{} {:.2f}v6h{:.2f}v-6\" fill=\"none\" stroke=\"currentColor\"/>\n",
               picture_margin, y - 10.0, scale_ * length) +
           svg_text(picture_margin + scale_ * length + 6.0, y, "start",
                    fmt::format("{:g} m", length));
  }

  /// Below `y`, which moves on to the last row.
  std::string legend(double width, double& y) const {
    constexpr double letter = 7.8;
    std::string text;
    double x = picture_margin;
    y += row_height;
    const auto entry = [&](const std::string& mark, const std::string& words) {
      const double length = 18.0 + letter * static_cast<double>(words.size());
      if (x > picture_margin && x + length > width) {
        x = picture_margin;
        y += row_height;
      }
      text +=
          fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"5\" {}/>", x + 6.0, y - 4.5, mark);
      text += svg_text(x + 18.0, y, "start", words);
      x += length + 12.0;
    };
    std::vector<std::size_t> plants(parameters_.species.size(), 0);
    for (const SpeciesIndex species : view_.stand.species) ++plants[species];
    for (std::size_t k = 0; k < plants.size(); ++k)
      entry(fmt::format("fill=\"{}\"", to_text(plant_colour(k, 0))),
            fmt::format("{}: {}", parameters_.species[k].name, plants[k]));
    const auto oppressed = std::count_if(view_.loss.begin(), view_.loss.end(), is_oppressed);
    entry(fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\"",
                      to_text(oppressed_colour())),
          fmt::format("loses more than half: {}", oppressed));
    std::size_t ill = 0;
    for (std::size_t i = 0; i < view_.stand.size(); ++i) ill += is_ill(i);
    if (ill > 0) entry(ill_style, fmt::format("ill: {}", ill));
    if (background_of(parameters_) != nullptr)
      entry(fmt::format("fill=\"{}\"", poorest), "darker ground: poorer");
    return text;
  }

  const StandView& view_;
  const PopulationParameters& parameters_;
  double scale_;  ///< pixels per metre
  std::vector<std::size_t> order_;
};

}  // namespace

std::string stand_svg(const StandView& view, const std::string& title) {
  PHYTOBENCH_EXPECT(view.stand.size() <= most_plants_in_svg &&
                    view.loss.size() == view.stand.size() &&
                    view.root_radius.size() == view.stand.size() &&
                    (view.crown_radius.empty() || view.crown_radius.size() == view.stand.size()));
  return StandSvg(view).drawn(title);
}

}  // namespace phytobench
