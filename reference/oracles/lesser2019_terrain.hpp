// SPDX-License-Identifier: MIT
// What the literal transcriptions of [Lesser2019] work on. Shares no code with core/.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace phytobench::oracles::lesser2019 {

// A height map in metres: h[j][i] with i along x (east) and j along y (south). The thesis has
// square maps of square pixels: n_x = n_y, ps_x = ps_y. NaN: nothing is known there.
struct Heights {
  int n_x = 0, n_y = 0;
  double ps_x = 1, ps_y = 1;  // m
  std::vector<double> h;      // row by row

  double at(int i, int j) const { return h[index(i, j)]; }
  double& at(int i, int j) { return h[index(i, j)]; }
  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(n_x) +
           static_cast<std::size_t>(i);
  }
  bool has(int i, int j) const { return i >= 0 && j >= 0 && i < n_x && j < n_y; }
};

inline Heights flat(int n, double ps, double height = 0) {
  return {n, n, ps, ps,
          std::vector<double>(static_cast<std::size_t>(n) * static_cast<std::size_t>(n), height)};
}

inline double highest(const Heights& map) {
  double most = -std::numeric_limits<double>::infinity();
  for (const double height : map.h)
    if (height > most) most = height;
  return most;
}

// Towards the sun: x east, y south, z up.
struct Direction {
  double u = 0, v = 0, w = 1;
};

}  // namespace phytobench::oracles::lesser2019
