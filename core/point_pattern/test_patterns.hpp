// SPDX-License-Identifier: MIT
// Small patterns for the tests of this folder.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "core/point_pattern/window.hpp"
#include "core/random/counter_stream.hpp"
#include "core/statistics/running_moments.hpp"

namespace phytobench::test_patterns {

using Points = std::vector<Point2>;

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double standard_errors = 4.5;  // seeds are fixed: no test fails by chance later on
inline constexpr double least_p = 1e-4;         // of a chi-square test: about four standard errors

inline constexpr Rectangle unit_square{{0.0, 0.0}, {1.0, 1.0}};
inline const Window unit_torus = Window::torus(unit_square);
inline const Window unit_plot = Window::rectangle(unit_square);

/// Area 3; the largest circle inside has radius 2 - sqrt(2).
inline Window l_shape() {
  return Window::polygon({{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}, {1.0, 1.0}, {1.0, 2.0}, {0.0, 2.0}});
}

inline Points random_points(const Window& window, std::size_t count, std::uint64_t stream_index,
                            std::uint64_t seed = 71) {
  CounterStream stream(seed, stream_index);
  Points points;
  for (std::size_t i = 0; i < count; ++i) points.push_back(window.random_point(stream));
  return points;
}

/// Points around few centres, kept inside by trying again.
inline Points clustered_points(const Window& window, std::size_t count, double radius,
                               std::uint64_t stream_index) {
  CounterStream stream(72, stream_index);
  Points centres, points;
  for (int i = 0; i < 5; ++i) centres.push_back(window.random_point(stream));
  while (points.size() < count) {
    const Point2 centre = centres[points.size() % centres.size()];
    const Point2 p{centre.x + stream.next_between(-radius, radius),
                   centre.y + stream.next_between(-radius, radius)};
    if (window.contains(p)) points.push_back(p);
  }
  return points;
}

/// Unit spacing, the lower left point half a step inside.
inline Points square_lattice(int columns, int rows) {
  Points points;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) points.push_back({column + 0.5, row + 0.5});
  return points;
}

inline Rectangle lattice_box(int columns, int rows) {
  return {{0.0, 0.0}, {static_cast<double>(columns), static_cast<double>(rows)}};
}

struct NamedPattern {
  std::string name;
  Window window;
  Points points;
};

/// Every kind of window and of trouble that a neighbour search must survive.
inline std::vector<NamedPattern> assorted_patterns() {
  const Window square = Window::rectangle(unit_square), torus = Window::torus(unit_square);
  const Window flat = Window::torus({{-3.0, 5.0}, {7.0, 5.5}});
  std::vector<NamedPattern> all;
  for (const Window& window : {square, torus, l_shape(), flat}) {
    const std::string kind =
        std::string(name_of(window.kind())) + (window.area() == 5.0 ? " flat" : "");
    for (const std::size_t count : {0U, 1U, 2U, 3U, 10U, 300U})
      all.push_back(
          {kind + " random " + std::to_string(count), window, random_points(window, count, count)});
    all.push_back({kind + " clustered", window, clustered_points(window, 250, 0.01, 3)});
    Points copies = random_points(window, 40, 9);
    for (std::size_t i = 0; i < 40; ++i) copies.push_back(copies[i / 3]);
    all.push_back({kind + " duplicated", window, copies});
    all.push_back({kind + " all equal", window, Points(60, copies[0])});
    const Rectangle& box = window.bounding_box();
    Points lump;
    for (const Point2& p : random_points(window, 200, 11))
      lump.push_back(box.low + 1e-6 * (p - box.low));
    lump.push_back(window.corners()[2]);
    all.push_back({kind + " lump", window, lump});
    Points row, column, diagonal;
    for (int i = 0; i < 80; ++i) {
      const double t = i * i / 6400.0;
      row.push_back({box.low.x + t * box.width(), box.low.y});
      column.push_back({box.low.x, box.low.y + t * box.height()});
      diagonal.push_back({box.low.x + 0.5 * t * box.width(), box.low.y + 0.5 * t * box.height()});
    }
    all.push_back({kind + " in a row", window, row});
    all.push_back({kind + " in a column", window, column});
    all.push_back({kind + " on a diagonal", window, diagonal});
    all.push_back({kind + " corners", window, window.corners()});
  }
  all.push_back({"lattice torus", Window::torus(lattice_box(12, 9)), square_lattice(12, 9)});
  all.push_back({"lattice plot", Window::rectangle(lattice_box(12, 9)), square_lattice(12, 9)});
  return all;
}

/// Mean and standard error of independent values.
struct Sample : RunningMoments {
  double error() const { return standard_error(); }
  /// How many standard errors the mean lies above a value.
  double errors_above(double value) const { return (mean() - value) / error(); }
};

/// Beyond this many standard errors chance is no longer an excuse: 6 in 100 000.
inline constexpr double chance = 4.0;

}  // namespace phytobench::test_patterns
