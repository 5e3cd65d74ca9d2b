// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "core/contract/check.hpp"
#include "core/population/stand_look.hpp"
#include "core/population/stand_picture.hpp"
#include "core/population/stand_statistics.hpp"

namespace phytobench {

namespace {

/// Ink on white paper. Coordinates in pixels, y downwards.
class Canvas {
 public:
  Canvas(int width, int height)
      : width_(width),
        height_(height),
        ink_(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 1.0f) {}

  void blend(int column, int row, const Colour& colour, double opacity) {
    float* pixel = &ink_[3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
                              static_cast<std::size_t>(column))];
    const auto mix = [opacity](float& old, double fresh) {
      old += static_cast<float>(opacity * (fresh - static_cast<double>(old)));
    };
    mix(pixel[0], colour.red);
    mix(pixel[1], colour.green);
    mix(pixel[2], colour.blue);
  }

  /// What lies between two circles around (x, y); inner = 0 is a disc. The rim is as soft as a
  /// pixel is wide, and discs below a pixel are fainter instead of smaller.
  void ring(double x, double y, double inner, double outer, const Colour& colour, double opacity) {
    if (outer < 0.5) {
      opacity *= 4.0 * outer * outer;
      outer = 0.5;
    }
    const auto first = [](double at) { return static_cast<int>(std::max(0.0, std::floor(at))); };
    const auto last = [](double at, int size) {
      return static_cast<int>(std::clamp(std::ceil(at), 0.0, static_cast<double>(size)));
    };
    const double reach = outer + 0.5;
    const int end_row = last(y + reach, height_), end_column = last(x + reach, width_);
    for (int row = first(y - reach); row < end_row; ++row) {
      const double dy = row + 0.5 - y;
      // Half the width of what lies so far inside that nothing is drawn there.
      const double hole = std::sqrt(std::max(0.0, (inner - 1.0) * std::abs(inner - 1.0) - dy * dy));
      for (int column = first(x - reach); column < end_column; ++column) {
        const double dx = column + 0.5 - x;
        if (std::abs(dx) < hole) {
          const double last_inside = std::floor(x + hole - 0.5);
          column = std::max(column, static_cast<int>(std::min<double>(last_inside, end_column)));
          continue;
        }
        const double distance = std::sqrt(dx * dx + dy * dy);
        double cover = std::clamp(outer + 0.5 - distance, 0.0, 1.0);
        if (inner > 0.0) cover -= std::clamp(inner + 0.5 - distance, 0.0, 1.0);
        if (cover > 0.0) blend(column, row, colour, cover * opacity);
      }
    }
  }

  Image image() const {
    Image result(width_, height_);
    const float* ink = ink_.data();
    for (int row = 0; row < height_; ++row)
      for (int column = 0; column < width_; ++column, ink += 3)
        result.at(column, row) = to_pixel({static_cast<double>(ink[0]), static_cast<double>(ink[1]),
                                           static_cast<double>(ink[2])});
    return result;
  }

  int width() const { return width_; }
  int height() const { return height_; }

 private:
  int width_, height_;
  std::vector<float> ink_;  ///< red, green, blue of each pixel
};

class StandPainter {
 public:
  StandPainter(const StandView& view, int side)
      : view_(view),
        parameters_(view.parameters),
        scale_(side / std::max(parameters_.ground.width(), parameters_.ground.height())),
        canvas_(pixels(parameters_.ground.width()), pixels(parameters_.ground.height())),
        order_(order_of_ids(view.stand)) {}

  Image painted() {
    fills_roots_ = show_as_areas(view_.root_radius);
    fills_crowns_ = show_as_areas(view_.crown_radius);
    if (const ResourceMap* map = background_of(parameters_)) paint_map(*map);
    for (const std::size_t i : order_) paint_root_zone(i);
    for (const std::size_t i : order_) paint_crown(i);
    for (const std::size_t i : order_) paint_stem(i);
    for (const std::size_t i : order_)
      if (view_.stand.ill_since[i] != healthy) paint_illness(i);
    return canvas_.image();
  }

 private:
  int pixels(double metres) const {
    return std::max(1, static_cast<int>(std::lround(scale_ * metres)));
  }

  /// Where a place lies in very many zones, areas would only add up to one flat colour, slowly.
  bool show_as_areas(std::span<const double> radii) const {
    constexpr double most_layers = 100.0;
    const double ground = parameters_.ground.area();
    double sum = 0.0;
    for (const double radius : radii) sum += std::min(ground, std::numbers::pi * radius * radius);
    return sum <= most_layers * ground;
  }

  void paint_map(const ResourceMap& map) {
    constexpr double darkest = 0.35;  // plants must stand out from it
    const Rectangle& ground = parameters_.ground;
    for (int row = 0; row < canvas_.height(); ++row)
      for (int column = 0; column < canvas_.width(); ++column) {
        const Point2 place{ground.low.x + (column + 0.5) / scale_,
                           ground.high.y - (row + 0.5) / scale_};
        canvas_.blend(column, row, {0.0, 0.0, 0.0}, darkest * (1.0 - map.at(place)));
      }
  }

  void paint(std::size_t i, double inner, double outer, const Colour& colour, double opacity) {
    const Rectangle& ground = parameters_.ground;
    for_each_appearance(parameters_, view_.stand.place(i), outer / scale_, [&](const Point2& at) {
      canvas_.ring(scale_ * (at.x - ground.low.x), scale_ * (ground.high.y - at.y), inner, outer,
                   colour, opacity);
    });
  }

  Colour own_colour(std::size_t i) const {
    const std::size_t species = view_.stand.species[i];
    return plant_colour(species, age_class(parameters_.species[species], view_.stand.age[i]));
  }

  void paint_root_zone(std::size_t i) {
    constexpr double smallest_circle = 3.0;  // pixels
    const double radius = scale_ * view_.root_radius[i];
    const Colour colour = is_oppressed(view_.loss[i]) ? oppressed_colour() : own_colour(i);
    if (radius < smallest_circle) return paint(i, 0.0, radius, colour, 0.25);
    if (fills_roots_) paint(i, 0.0, radius, colour, 0.07);
    paint(i, radius - line, radius, colour, 0.8);
  }

  void paint_crown(std::size_t i) {
    if (view_.crown_radius.empty()) return;
    const double radius = scale_ * view_.crown_radius[i];
    paint(i, fills_crowns_ ? 0.0 : radius - line, radius, own_colour(i), 0.18);
  }

  /// Between plants, if they stood in a square lattice; pixels.
  double spacing() const {
    return std::sqrt(static_cast<double>(canvas_.width()) * canvas_.height() /
                     static_cast<double>(order_.size()));
  }

  void paint_stem(std::size_t i) {
    // Visible dots, unless there are so many that they would cover the ground.
    const double radius =
        std::max(scale_ * view_.stand.stem_radius[i], std::min(1.5, 0.2 * spacing()));
    paint(i, 0.0, radius, own_colour(i), 1.0);
  }

  /// A circle of dots around the stem.
  void paint_illness(std::size_t i) {
    constexpr double dot = 0.9, distance = 3.2;  // pixels
    const double radius = illness_ring(scale_ * view_.stand.stem_radius[i], spacing());
    const auto dots = std::max(4L, std::lround(2.0 * std::numbers::pi * radius / distance));
    const Rectangle& ground = parameters_.ground;
    for_each_appearance(
        parameters_, view_.stand.place(i), (radius + dot) / scale_, [&](const Point2& at) {
          for (long k = 0; k < dots; ++k) {
            const double angle =
                2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(dots);
            canvas_.ring(scale_ * (at.x - ground.low.x) + radius * std::cos(angle),
                         scale_ * (ground.high.y - at.y) + radius * std::sin(angle), 0.0, dot,
                         {0.0, 0.0, 0.0}, 1.0);
          }
        });
  }

  const StandView& view_;
  const PopulationParameters& parameters_;
  static constexpr double line = 1.2;  ///< width of circles, pixels
  double scale_;                       ///< pixels per metre
  bool fills_roots_ = true, fills_crowns_ = true;
  Canvas canvas_;
  std::vector<std::size_t> order_;
};

}  // namespace

std::string stand_png(const StandView& view, int side) {
  PHYTOBENCH_EXPECT(side > 0 && view.loss.size() == view.stand.size() &&
                    view.root_radius.size() == view.stand.size() &&
                    (view.crown_radius.empty() || view.crown_radius.size() == view.stand.size()));
  return to_png(StandPainter(view, side).painted());
}

}  // namespace phytobench
