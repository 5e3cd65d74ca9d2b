// SPDX-License-Identifier: MIT
// Numbers of [Lintermann1997]: values of the successors of a multiplier, bending, the golden angle
// on sphere caps, the leaf of the bush. Literal, and beside the misprint the corrected form. Shares
// no code with core/, so that agreement means something.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace phytobench::oracles::lintermann1997 {

// Sec. 3.2 as printed, for the i-th of n successors: v_0 is not added.
inline double v_i_as_printed(double v_0, double v_1, int n, int i) {
  return i * (v_1 - v_0) / (n - 1);
}

// As the authors print it later: i = 1 .. n. 0/0 for n = 1, where v_0 is the value of the first
// one.
inline double v_i_corrected(double v_0, double v_1, int n, int i) {
  if (n == 1) return v_0;
  return v_0 + (i - 1) * (v_1 - v_0) / (n - 1);
}

// Sec. 5.1: relative turns at m joints, from r_0 at the first to r_1 at the last.
inline double turn_at_joint(double r_0, double r_1, int m, int joint) {
  return v_i_corrected(r_0, r_1, m, joint);
}
inline double total_turn(double r_0, double r_1, int m) {  // m >= 2
  return m * (r_0 + r_1) / 2;
}

// A hydra of n places its successors around an axis.
inline double hydra_step_deg(int n) {
  return 360.0 / n;
}

inline double golden_angle_deg() {
  return 360 / (std::numbers::phi * std::numbers::phi);
}

// i = 0 .. N - 1; not reduced to one turn.
inline double azimuth_deg(int i) {
  return i * golden_angle_deg();
}

// Height over the centre of a sphere of radius 1 for the i-th of N, i = 0 .. N - 1, between two
// polar angles: bands of equal heights have equal areas, and each point is in the middle of its
// own.
inline double height_on_cap(int i, int N, double polar_from_deg, double polar_to_deg) {
  const double from = std::cos(polar_from_deg * std::numbers::pi / 180);
  const double to = std::cos(polar_to_deg * std::numbers::pi / 180);
  return from + (i + 0.5) / N * (to - from);
}

struct Place {
  double x, y, z;
};

// The pole is +z.
inline std::vector<Place> places_on_cap(int N, double radius, double polar_from_deg,
                                        double polar_to_deg) {
  std::vector<Place> places;
  for (int i = 0; i < N; ++i) {
    const double height = height_on_cap(i, N, polar_from_deg, polar_to_deg);
    const double across = std::sqrt(1 - height * height);
    const double azimuth = azimuth_deg(i) * std::numbers::pi / 180;
    places.push_back({radius * across * std::cos(azimuth), radius * across * std::sin(azimuth),
                      radius * height});
  }
  return places;
}

// On the disc: the i-th at sqrt(i) from the centre, i = 1 .. N.
inline std::vector<Place> places_on_disc(int N) {
  std::vector<Place> places;
  for (int i = 1; i <= N; ++i) {
    const double azimuth = azimuth_deg(i) * std::numbers::pi / 180;
    places.push_back({std::sqrt(i) * std::cos(azimuth), std::sqrt(i) * std::sin(azimuth), 0});
  }
  return places;
}

struct ClosestPair {
  std::size_t first = 0, second = 0;
  double distance = std::numeric_limits<double>::infinity();
};

inline ClosestPair closest_pair(const std::vector<Place>& places) {
  ClosestPair closest;
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t j = i + 1; j < places.size(); ++j) {
      const Place a = places[i], b = places[j];
      const double distance = std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
      if (distance < closest.distance) closest = {i, j, distance};
    }
  return closest;
}

// Distance of the closest two times sqrt(N), on a whole sphere of radius 1: nearly the same for all
// N.
inline double separation_constant(int N) {
  return closest_pair(places_on_cap(N, 1, 0, 180)).distance * std::sqrt(N);
}

inline double distance_of_centroid(const std::vector<Place>& places) {
  Place sum{0, 0, 0};
  for (const Place& p : places) sum = {sum.x + p.x, sum.y + p.y, sum.z + p.z};
  return std::hypot(sum.x, sum.y, sum.z) / static_cast<double>(places.size());
}

// The leaf {-f+f+f-|-f+f+f} of the bush for steps of 1 and turns of delta: three sides at -delta, 0
// and delta, and the same ones back, so that its area is that of three parallelograms.
inline double leaf_area(double delta_deg) {
  const double delta = delta_deg * std::numbers::pi / 180;
  return 2 * std::sin(delta) + std::sin(2 * delta);
}
// Along and across.
inline std::pair<double, double> leaf_extent(double delta_deg) {
  const double delta = delta_deg * std::numbers::pi / 180;
  return {1 + 2 * std::cos(delta), 2 * std::sin(delta)};
}

}  // namespace phytobench::oracles::lintermann1997
