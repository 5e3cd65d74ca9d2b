// SPDX-License-Identifier: MIT
// Discs for tests of how they share ground.
#pragma once

#include <limits>
#include <numbers>
#include <numeric>
#include <vector>

#include "core/overlap/coverage.hpp"
#include "core/overlap/ground_shares.hpp"

namespace phytobench::testing_discs {

inline constexpr double pi = std::numbers::pi;
inline constexpr double infinite = std::numeric_limits<double>::infinity();
inline constexpr double exponents[] = {0.0, 0.5, 1.0, 4.0, 300.0, infinite};

struct Scene {
  std::vector<double> x, y, radius;
  Ground ground;

  void add(double px, double py, double r) {
    x.push_back(px);
    y.push_back(py);
    radius.push_back(r);
  }
  std::size_t size() const { return x.size(); }
  Discs discs() const { return {x, y, radius}; }
  double area(std::size_t i) const { return pi * radius[i] * radius[i]; }
};

inline std::vector<double> shares_of(const Scene& scene, double exponent, int threads = 1) {
  return ground_shares(scene.discs(), scene.ground, {.exponent = exponent}, threads);
}

inline double sum_of(const std::vector<double>& values, std::size_t from = 0) {
  return std::accumulate(values.begin() + static_cast<std::ptrdiff_t>(from), values.end(), 0.0);
}

/// Of the discs with this property, how much ground they cover.
template <class Has>
double covered_by(const Scene& scene, const Has& has) {
  Scene some;
  some.ground = scene.ground;
  for (std::size_t i = 0; i < scene.size(); ++i)
    if (has(i)) some.add(scene.x[i], scene.y[i], scene.radius[i]);
  return sum_of(coverage(some.discs(), some.ground).by_times, 1);
}

}  // namespace phytobench::testing_discs
