// SPDX-License-Identifier: MIT
#include "reference/oracles/lesser2019_march.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace phytobench::oracles::lesser2019 {

PrintedMarch::PrintedMarch(const Heights& heights, MarchForm form)
    : map_(heights), form_(form), heightmap_max_height_(highest(heights)) {}

PrintedMarch::Step PrintedMarch::printed_step(double X, double Y, const Direction& sun) const {
  const double rem_x = std::fmod(X, map_.ps_x), rem_y = std::fmod(Y, map_.ps_y);
  if (rem_x >= rem_y && sun.u != 0) return {std::abs((map_.ps_x - rem_x) / sun.u)};
  if (sun.v != 0) return {std::abs((map_.ps_y - rem_y) / sun.v)};
  if (form_.unguarded) return {0, true};
  return {std::abs((map_.ps_x - rem_x) / sun.u)};
}

double PrintedMarch::true_step(double X, double Y, const Direction& sun) const {
  const auto along = [](double at, double ps, double step) {
    if (step == 0) return std::numeric_limits<double>::infinity();
    const double rem = std::fmod(at, ps);
    // A ray that goes back from a line has a whole pixel before it.
    const double way = step > 0 ? ps - rem : (rem > 0 ? rem : ps);
    return way / std::abs(step);
  };
  return std::min(along(X, map_.ps_x, sun.u), along(Y, map_.ps_y, sun.v));
}

PrintedMarch::Step PrintedMarch::step(double X, double Y, const Direction& sun) const {
  if (form_.larger_remainder) return printed_step(X, Y, sun);
  return {true_step(X, Y, sun)};
}

int PrintedMarch::pixel(double real, double ps) const {
  return static_cast<int>(form_.truncates ? std::trunc(real / ps) : std::floor(real / ps));
}

MarchResult PrintedMarch::from(int x, int y, const Direction& sun) const {
  return over(x, y, map_.at(x, y), sun, heightmap_max_height_);
}

MarchResult PrintedMarch::over(int x, int y, double z, const Direction& sun,
                               double heightmap_max) const {
  const double B_x = map_.n_x * map_.ps_x, B_y = map_.n_y * map_.ps_y;
  const double in = form_.start == Start::centre ? 0.5 : 0.0;
  const double x_start = in == 0 ? x * map_.ps_x : (x + in) * map_.ps_x;
  const double y_start = in == 0 ? y * map_.ps_y : (y + in) * map_.ps_y;
  double X = x_start, Y = y_start, Z = z, t = 0;
  MarchResult result;
  while (0 <= X && X < B_x && 0 <= Y && Y < B_y && Z < heightmap_max) {
    ++result.iterations;
    if (sun.u == 0 && sun.v == 0) break;  // the zenith
    Step t_step = step(X, Y, sun);
    if (t_step.divides_by_zero) return result.outcome = Outcome::crashed, result;
    if (t + t_step.t == t) {
      if (form_.unguarded) return result.outcome = Outcome::stuck, result;
      t_step.t += std::min(map_.ps_x, map_.ps_y) / std::max(std::abs(sun.u), std::abs(sun.v));
    }
    t += t_step.t;
    X = x_start + t * sun.u;
    Y = y_start + t * sun.v;
    Z = z + t * sun.w;
    const int i = pixel(X, map_.ps_x), j = pixel(Y, map_.ps_y);
    if (i < 0 || j < 0 || i > map_.n_x - 1 || j > map_.n_y - 1) break;
    result.visited.push_back({i, j, X, Y});
    if (map_.at(i, j) > Z) return result.outcome = Outcome::dark, result;
  }
  return result;
}

std::vector<Visited> crossed_from_corner(const Heights& map, int x, int y, const Direction& sun) {
  // Between two lines that follow each other the ray is inside one cell.
  std::vector<double> lines{0};
  const auto meet = [&](int lines_there, double ps, double step) {
    if (step == 0) return;
    for (int k = 1; k <= lines_there; ++k) lines.push_back(k * ps / std::abs(step));
  };
  meet(map.n_x, map.ps_x, sun.u);
  meet(map.n_y, map.ps_y, sun.v);
  std::sort(lines.begin(), lines.end());
  std::vector<Visited> cells;
  for (std::size_t k = 0; k + 1 < lines.size(); ++k) {
    if (lines[k + 1] - lines[k] < 1e-9 * lines[k + 1]) continue;  // a corner, not a cell
    const double t = (lines[k] + lines[k + 1]) / 2;
    const double X = x * map.ps_x + t * sun.u, Y = y * map.ps_y + t * sun.v;
    const int i = static_cast<int>(std::floor(X / map.ps_x));
    const int j = static_cast<int>(std::floor(Y / map.ps_y));
    if (!map.has(i, j)) break;
    if (i != x || j != y) cells.push_back({i, j, X, Y});
  }
  return cells;
}

Untested untested_cells(const Heights& map, int x, int y, const Direction& sun,
                        const MarchForm& form) {
  const Direction level{sun.u, sun.v, 0};
  std::set<std::pair<int, int>> seen;
  for (const Visited& cell :
       PrintedMarch(map, form).over(x, y, highest(map), level, highest(map) + 1).visited)
    seen.insert({cell.i, cell.j});
  Untested count;
  for (const Visited& cell : crossed_from_corner(map, x, y, sun)) {
    ++count.crossed;
    count.untested += !seen.contains({cell.i, cell.j});
  }
  return count;
}

}  // namespace phytobench::oracles::lesser2019
