// SPDX-License-Identifier: MIT
#include "core/point_pattern/halftone.hpp"

#include <cmath>
#include <utility>

#include "core/contract/check.hpp"
#include "core/point_pattern/point_limit.hpp"

namespace phytobench {

namespace {

/// Error carried into a row, with one place more on either side for what falls off the picture.
using ErrorRow = std::vector<double>;

/// The black pixels of one row in the order of the scan, passed to `blacken(column)`. `here` holds
/// the errors carried into the row and is used up; `below` receives those for the next.
template <typename Blacken>
void diffuse_row(std::span<const double> darkness, bool to_the_right, ErrorRow& here,
                 ErrorRow& below, const Blacken& blacken) {
  const std::size_t width = darkness.size();
  for (std::size_t step = 0; step < width; ++step) {
    const std::size_t column = to_the_right ? step : width - 1 - step;
    const std::size_t place = column + 1;
    const std::size_t ahead = to_the_right ? place + 1 : place - 1;
    const std::size_t behind = to_the_right ? place - 1 : place + 1;
    const double wanted = darkness[column] + here[place];
    const bool black = wanted >= 0.5;
    if (black) blacken(column);
    const double error = wanted - (black ? 1.0 : 0.0);
    here[ahead] += error * (7.0 / 16.0);
    below[behind] += error * (3.0 / 16.0);
    below[place] += error * (5.0 / 16.0);
    below[ahead] += error * (1.0 / 16.0);
  }
}

void expect_picture(std::span<const double> darkness, std::size_t width, std::size_t height,
                    const Rectangle& rectangle) {
  PHYTOBENCH_EXPECT(width > 0 && height > 0 && darkness.size() % width == 0 &&
                    darkness.size() / width == height);
  PHYTOBENCH_EXPECT(rectangle.width() > 0.0 && rectangle.height() > 0.0 &&
                    std::isfinite(rectangle.area()));
  double total = 0.0;
  for (const double value : darkness) {
    PHYTOBENCH_EXPECT(value >= 0.0 && value <= 1.0);
    total += value;
  }
  refuse_too_many_points(total, "give a brighter or smaller picture");
}

}  // namespace

std::vector<Point2> halftone_points(std::span<const double> darkness, std::size_t width,
                                    std::size_t height, const Rectangle& rectangle,
                                    HalftoneScan scan) {
  expect_picture(darkness, width, height, rectangle);
  const double pixel_width = rectangle.width() / static_cast<double>(width);
  const double pixel_height = rectangle.height() / static_cast<double>(height);
  std::vector<Point2> points;
  ErrorRow here(width + 2, 0.0), below(width + 2, 0.0);
  for (std::size_t row = 0; row < height; ++row) {
    // Rows count from the top of the picture, y from the bottom of the rectangle.
    const double y = rectangle.high.y - pixel_height * (static_cast<double>(row) + 0.5);
    const bool to_the_right = scan == HalftoneScan::plain || row % 2 == 0;
    diffuse_row(darkness.subspan(row * width, width), to_the_right, here, below,
                [&](std::size_t column) {
                  const double x = pixel_width * (static_cast<double>(column) + 0.5);
                  points.push_back({rectangle.low.x + x, y});
                });
    std::swap(here, below);
    below.assign(width + 2, 0.0);
  }
  return points;
}

}  // namespace phytobench
