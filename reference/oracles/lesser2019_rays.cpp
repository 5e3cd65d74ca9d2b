// SPDX-License-Identifier: MIT
#include "reference/oracles/lesser2019_rays.hpp"

#include <cmath>

namespace phytobench::oracles::lesser2019 {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

void compare(double terrain, double ray_height, Ray& ray) {
  if (std::isnan(terrain)) return;
  ++ray.compared;
  ray.margin = std::min(ray.margin, ray_height - terrain);
  if (terrain > ray_height) ray.lit = false;
}

// The height where the ray meets the column line i, at the row y between two vertices.
double on_column_line(const Heights& map, int i, double y) {
  const int j = static_cast<int>(std::floor(y));
  const double f = y - j;
  return f == 0 ? map.at(i, j) : (1 - f) * map.at(i, j) + f * map.at(i, j + 1);
}

double on_row_line(const Heights& map, double x, int j) {
  const int i = static_cast<int>(std::floor(x));
  const double f = x - i;
  return f == 0 ? map.at(i, j) : (1 - f) * map.at(i, j) + f * map.at(i + 1, j);
}

Ray surface_ray(const Heights& map, int x, int y, const Direction& sun) {
  Ray ray;
  const double own = map.at(x, y);
  if (sun.u != 0)
    for (int c = 1;; ++c) {
      const double t = c * map.ps_x / std::abs(sun.u);
      const int i = sun.u > 0 ? x + c : x - c;
      const double row = y + t * sun.v / map.ps_y;
      if (i < 0 || i >= map.n_x || row < 0 || row > map.n_y - 1) break;
      compare(on_column_line(map, i, row), own + t * sun.w, ray);
    }
  if (sun.v != 0)
    for (int c = 1;; ++c) {
      const double t = c * map.ps_y / std::abs(sun.v);
      const int j = sun.v > 0 ? y + c : y - c;
      const double column = x + t * sun.u / map.ps_x;
      if (j < 0 || j >= map.n_y || column < 0 || column > map.n_x - 1) break;
      compare(on_row_line(map, column, j), own + t * sun.w, ray);
    }
  return ray;
}

Ray column_ray(const Heights& map, int x, int y, const Direction& sun, Reading reading) {
  Ray ray;
  const double level = sun.u * sun.u + sun.v * sun.v;
  for (const EnteredCell& cell : entered_cells(map, x, y, sun)) {
    const double foot = ((cell.i - x) * map.ps_x * sun.u + (cell.j - y) * map.ps_y * sun.v) / level;
    const double t = reading == Reading::entry ? cell.t : foot;
    compare(map.at(cell.i, cell.j), map.at(x, y) + t * sun.w, ray);
  }
  return ray;
}

}  // namespace

std::vector<EnteredCell> entered_cells(const Heights& map, int x, int y, const Direction& sun) {
  std::vector<EnteredCell> cells;
  const double d_x = sun.u != 0 ? map.ps_x / std::abs(sun.u) : never;
  const double d_y = sun.v != 0 ? map.ps_y / std::abs(sun.v) : never;
  int i = x, j = y, lines_x = 0, lines_y = 0;
  while (true) {
    // Lines lie half a pixel from the centre, then whole ones; never added up.
    const double t_x = sun.u != 0 ? (lines_x + 0.5) * d_x : never;
    const double t_y = sun.v != 0 ? (lines_y + 0.5) * d_y : never;
    const double t = std::min(t_x, t_y);
    const bool corner = std::abs(t_x - t_y) < 1e-9 * t;
    if (corner || t_x < t_y) i += sun.u > 0 ? 1 : -1, ++lines_x;
    if (corner || t_y < t_x) j += sun.v > 0 ? 1 : -1, ++lines_y;
    if (!map.has(i, j)) return cells;
    cells.push_back({i, j, t});
  }
}

Ray ray(const Heights& map, int x, int y, const Direction& sun, Reading reading) {
  return reading == Reading::surface ? surface_ray(map, x, y, sun)
                                     : column_ray(map, x, y, sun, reading);
}

}  // namespace phytobench::oracles::lesser2019
