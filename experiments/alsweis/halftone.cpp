// SPDX-License-Identifier: MIT
// From painted grey to plants: does error diffusion keep the darkness, of the whole picture and of
// its parts?
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/point_pattern/halftone.hpp"
#include "experiments/experiment.hpp"

namespace phytobench::experiments::alsweis {

namespace {

/// A grey picture by its darkness from 0 (white) to 1 (black), x to the right and y down, both from
/// 0 to 1.
struct Painting {
  const char* name;
  double (*darkness)(double x, double y);
};

/// One dab of a soft brush.
double dab(double x, double y, double width) {
  return std::exp(-(x * x + y * y) / (2.0 * width * width));
}

/// What one might paint for a garden: a thicket, two bushes and a meadow that a path winds through.
double painted_garden(double x, double y) {
  const double plants = 0.12 + 0.9 * dab(x - 0.24, y - 0.28, 0.13) +
                        0.7 * dab(x - 0.78, y - 0.22, 0.08) + 0.6 * dab(x - 0.72, y - 0.74, 0.15);
  const double from_path = y - 0.55 - 0.12 * std::sin(6.0 * x);
  return std::min(1.0, plants) * (1.0 - std::exp(-from_path * from_path / 0.004));
}

constexpr std::array<Painting, 8> paintings = {{
    {"flat-5", [](double, double) { return 0.05; }},
    {"flat-25", [](double, double) { return 0.25; }},
    {"flat-50", [](double, double) { return 0.5; }},
    {"flat-90", [](double, double) { return 0.9; }},
    {"ramp-across", [](double x, double) { return x; }},
    {"ramp-down", [](double, double y) { return y; }},
    {"disc", [](double x, double y) { return std::hypot(x - 0.5, y - 0.5) < 0.35 ? 0.7 : 0.05; }},
    {"garden", painted_garden},
}};

/// A square picture, the top row first.
struct Picture {
  std::size_t size;
  std::vector<double> darkness;
};

Picture painted(const Painting& painting, std::size_t size) {
  Picture picture{size, {}};
  const auto place = [size](std::size_t i) {
    return (static_cast<double>(i) + 0.5) / static_cast<double>(size);
  };
  for (std::size_t row = 0; row < size; ++row)
    for (std::size_t column = 0; column < size; ++column)
      picture.darkness.push_back(painting.darkness(place(column), place(row)));
  return picture;
}

/// One unit of length per pixel.
std::vector<Point2> points_of(const Picture& picture) {
  const auto side = static_cast<double>(picture.size);
  return halftone_points(picture.darkness, picture.size, picture.size, {{0, 0}, {side, side}});
}

/// Most that can pass over the borders of a square of that size: no pixel's error exceeds one half,
/// 8 and 3 sixteenths of it leave at either end of a row, 9 below a column.
double largest_loss(std::size_t size) {
  return static_cast<double>(size) * (11.0 + 9.0) / 32.0;
}

/// Side of the squares that the picture is cut into, in pixels.
constexpr std::size_t block = 16;

/// Per square: points, the darkness that was painted, and the variance that the number of points
/// would have if each pixel tossed its own coin.
struct Blocks {
  std::vector<double> points, darkness, coin_variance;
};

Blocks blocks_of(const Picture& picture, std::span<const Point2> points) {
  const std::size_t across = picture.size / block;
  const std::vector<double> none(across * across, 0.0);
  Blocks blocks{none, none, none};
  for (const Point2& p : points) {
    const auto column = static_cast<std::size_t>(p.x);
    const std::size_t row = picture.size - 1 - static_cast<std::size_t>(p.y);
    blocks.points[row / block * across + column / block] += 1.0;
  }
  for (std::size_t i = 0; i < picture.darkness.size(); ++i) {
    const std::size_t place = i / picture.size / block * across + i % picture.size / block;
    const double d = picture.darkness[i];
    blocks.darkness[place] += d;
    blocks.coin_variance[place] += d * (1.0 - d);
  }
  return blocks;
}

void record_blocks(ExperimentContext& context, const std::string& name, const Blocks& blocks) {
  double largest = 0.0, squares = 0.0, coin_squares = 0.0;
  for (std::size_t i = 0; i < blocks.points.size(); ++i) {
    const double off = blocks.points[i] - blocks.darkness[i];
    largest = std::max(largest, std::abs(off));
    squares += off * off;
    coin_squares += blocks.coin_variance[i];
  }
  const auto count = static_cast<std::int64_t>(blocks.points.size());
  const auto record = [&](const char* what, double value) {
    context.record(
        {.experiment = {}, .measurement = name + what, .value = value, .sample_size = count});
  };
  // What leaves through one border may come in through another: twice the loss of a whole picture.
  record("/blocks/largest_share_of_limit", largest / (2.0 * largest_loss(block)));
  record("/blocks/scatter_beside_coins", std::sqrt(squares / coin_squares));
}

void record_picture(ExperimentContext& context, const Painting& painting, std::size_t size) {
  const std::string name = fmt::format("{}.{}", painting.name, size);
  context.progress(name);
  const Picture picture = painted(painting, size);
  const std::vector<Point2> points = points_of(picture);
  double wanted = 0.0;
  for (const double d : picture.darkness) wanted += d;
  const double excess = static_cast<double>(points.size()) - wanted;
  context.record(name + "/points", static_cast<std::int64_t>(points.size()), "points");
  context.record(name + "/painted_darkness", wanted, "points");
  context.record(name + "/relative_error", excess / wanted);
  context.record(name + "/share_of_limit", std::abs(excess) / largest_loss(size));
  record_blocks(context, name, blocks_of(picture, points));
}

/// The painted grey in `shades` steps, one path per shade, neighbours of a row in one stroke: a
/// tenth of what one square per pixel would take.
std::string shaded_rows(const Picture& picture) {
  constexpr std::size_t shades = 24;
  const auto shade_at = [&](std::size_t row, std::size_t column) {
    return static_cast<std::size_t>(
        std::lround(picture.darkness[row * picture.size + column] * (shades - 1)));
  };
  std::array<std::string, shades> strokes;
  for (std::size_t row = 0; row < picture.size; ++row)
    for (std::size_t column = 0, end = 0; column < picture.size; column = end) {
      const std::size_t shade = shade_at(row, column);
      while (end < picture.size && shade_at(row, end) == shade) ++end;
      strokes[shade] += fmt::format("M{} {}.5h{}", column, row, end - column);
    }
  std::string text;
  for (std::size_t shade = 1; shade < shades; ++shade)
    if (!strokes[shade].empty()) {
      const std::size_t grey = 255 - 255 * shade / (shades - 1);
      text += fmt::format("<path stroke=\"#{0:02x}{0:02x}{0:02x}\" d=\"{1}\"/>\n", grey,
                          strokes[shade]);
    }
  return text;
}

/// The picture and beside it the plants that stand for it.
std::string picture_and_points(const Picture& picture) {
  const std::size_t size = picture.size, gap = 4;
  std::string dots;
  for (const Point2& p : points_of(picture))
    dots += fmt::format("M{} {}h0", p.x, static_cast<double>(size) - p.y);
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-1 -1 {0} {1}\" role=\"img\" "
      "aria-label=\"A painted grey picture and the plants that error diffusion makes of it\">\n"
      "<rect x=\"-1\" y=\"-1\" width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n"
      "<g fill=\"none\" stroke-width=\"1.05\">\n{2}</g>\n"
      "<path transform=\"translate({3} 0)\" fill=\"none\" stroke=\"#1b5e20\" stroke-width=\".9\" "
      "stroke-linecap=\"round\" d=\"{4}\"/>\n"
      "<path fill=\"none\" stroke=\"#888\" stroke-width=\".3\" d=\"M0 0h{5}v{5}h-{5}z"
      "M{3} 0h{5}v{5}h-{5}z\"/>\n</svg>\n",
      2 * size + gap + 2, size + 2, shaded_rows(picture), size + gap, dots, size);
}

void run(ExperimentContext& context) {
  for (const Painting& painting : paintings)
    for (const std::size_t size : {128u, 512u}) record_picture(context, painting, size);
  context.artifact("painted-garden.svg", picture_and_points(painted(paintings.back(), 80)));
}

}  // namespace

extern const ExperimentDescriptor halftone;
constinit const ExperimentDescriptor halftone{
    .id = "alsweis/halftone",
    .question = "Does a halftoned picture have as many plants as it is dark?",
    .source = "[Alsweis] sec. 2.4.1",
    .seconds = {0.2, 0.2, 0.2},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
