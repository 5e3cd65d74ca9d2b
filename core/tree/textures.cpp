// SPDX-License-Identifier: MIT
#include "core/tree/textures.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/random/counter_stream.hpp"

namespace phytobench {

namespace {

constexpr std::uint64_t bark_stream = 111, leaf_stream = 112;

Colour shaded(const Colour& colour, double factor) {
  return {factor * colour.red, factor * colour.green, factor * colour.blue};
}

struct Ellipse {
  double x, y, half_length, half_width, angle;

  bool contains(double px, double py) const {
    const double dx = px - x, dy = py - y;
    const double along = (std::cos(angle) * dx + std::sin(angle) * dy) / half_length;
    const double across = (std::cos(angle) * dy - std::sin(angle) * dx) / half_width;
    return along * along + across * across <= 1.0;
  }
};

void draw(Image& image, const Ellipse& ellipse, const Pixel& pixel) {
  const double reach = std::max(ellipse.half_length, ellipse.half_width);
  const auto clipped = [](double value, int most) {
    return std::clamp(static_cast<int>(std::floor(value)), 0, most);
  };
  for (int row = clipped(ellipse.y - reach, image.height() - 1);
       row <= clipped(ellipse.y + reach, image.height() - 1); ++row)
    for (int column = clipped(ellipse.x - reach, image.width() - 1);
         column <= clipped(ellipse.x + reach, image.width() - 1); ++column)
      if (ellipse.contains(column + 0.5, row + 0.5)) image.at(column, row) = pixel;
}

}  // namespace

Image bark_texture(const Colour& colour) {
  constexpr int width = 64, height = 128;
  CounterStream stream(0, bark_stream);
  std::vector<double> streak(width);
  for (double& shade : streak) shade = stream.next_between(0.82, 1.0);
  Image image(width, height);
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) {
      const double grain = stream.next_between(0.92, 1.0);
      image.at(column, row) =
          to_pixel(shaded(colour, streak[static_cast<std::size_t>(column)] * grain));
    }
  return image;
}

Image leaf_particle_texture(const Colour& colour, std::uint64_t seed) {
  constexpr int edge = 256, particles = 150;
  CounterStream stream(seed, leaf_stream);
  // Where nothing is drawn the colour still counts: viewers blend it in at the borders.
  Pixel nothing = to_pixel(colour, 0.0);
  Image image(edge, edge, nothing);
  for (int i = 0; i < particles; ++i) {
    // Within a disc, so that the square's corners do not show.
    const double distance = 0.46 * edge * std::sqrt(stream.next_unit());
    const double direction = 2.0 * std::numbers::pi * stream.next_unit();
    const double half_length = edge * stream.next_between(0.030, 0.050);
    const Ellipse ellipse{0.5 * edge + distance * std::cos(direction),
                          0.5 * edge + distance * std::sin(direction), half_length,
                          half_length * stream.next_between(0.40, 0.60),
                          std::numbers::pi * stream.next_unit()};
    draw(image, ellipse, to_pixel(shaded(colour, stream.next_between(0.65, 1.15))));
  }
  return image;
}

}  // namespace phytobench
