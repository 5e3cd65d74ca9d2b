// SPDX-License-Identifier: MIT
#include "reference/oracles/lesser2019_relief.hpp"

#include <algorithm>
#include <cmath>

namespace phytobench::oracles::lesser2019 {

namespace {

constexpr double degrees_per_radian = 180.0 / 3.14159265358979323846;

struct Triple {
  double x = 0, y = 0, z = 0;
};

struct Step {
  int i, j;
};
using Face = std::array<Step, 2>;  // the two neighbours that a face has with the vertex

// Written out face by face. N is a row up (j - 1), E a column on (i + 1).
constexpr Step N{0, -1}, E{1, 0}, S{0, 1}, W{-1, 0};
constexpr Step NE{1, -1}, SE{1, 1}, SW{-1, 1}, NW{-1, -1};
constexpr std::array<Face, 6> faces_with_sw_ne = {
    {{E, NE}, {NE, N}, {N, W}, {W, SW}, {SW, S}, {S, E}}};
constexpr std::array<Face, 6> faces_with_nw_se = {
    {{E, N}, {N, NW}, {NW, W}, {W, S}, {S, SE}, {SE, E}}};

Triple cross_product(const Triple& a, const Triple& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

double length(const Triple& a) {
  return std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z);
}

Normal normalised(const Triple& a) {
  const double l = length(a);
  return {a.x / l, a.y / l, a.z / l};
}

}  // namespace

Normal normal_of_six_faces(const Heights& map, int i, int j, Diagonal diagonal, FaceWeight weight) {
  const auto& faces =
      diagonal == Diagonal::south_west_north_east ? faces_with_sw_ne : faces_with_nw_se;
  const auto edge = [&](const Step& to) -> Triple {
    return {to.i * map.ps_x, to.j * map.ps_y, map.at(i + to.i, j + to.j) - map.at(i, j)};
  };
  Triple sum;
  for (const Face& face : faces) {
    if (!map.has(i + face[0].i, j + face[0].j) || !map.has(i + face[1].i, j + face[1].j)) continue;
    // Neighbours follow each other against the clock as seen from above, in a frame whose y runs
    // south: the second edge first, so that the product points up.
    const Triple n = cross_product(edge(face[1]), edge(face[0]));
    if (std::isnan(n.x + n.y)) continue;
    const double over = weight == FaceWeight::unit ? length(n) : 1.0;
    sum = {sum.x + n.x / over, sum.y + n.y / over, sum.z + n.z / over};
  }
  return normalised(sum);
}

SobelSums equation_8_3(const Heights& map, int i, int j) {
  const int S_x[3][3] = {{-1, 0, 1}, {-2, 0, 2}, {-1, 0, 1}};
  const int S_y[3][3] = {{1, 2, 1}, {0, 0, 0}, {-1, -2, -1}};
  SobelSums sums;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) {
      const double height = map.at(i + column - 1, j + row - 1);
      sums.S_x += S_x[row][column] * height;
      sums.S_y += S_y[row][column] * height;
    }
  return sums;
}

Normal sobel_as_printed(const Heights& map, int i, int j) {
  const SobelSums sums = equation_8_3(map, i, j);
  return normalised({-sums.S_x, -sums.S_y, 1});
}

Normal sobel_corrected(const Heights& map, int i, int j) {
  const SobelSums sums = equation_8_3(map, i, j);
  // S_y is the upper row less the lower one: what rises to the south counts negative.
  return normalised({-sums.S_x / (8 * map.ps_x), sums.S_y / (8 * map.ps_y), 1});
}

double steepest_edge(const Heights& map, int i, int j) {
  double steepest = 0;
  for (const Step& to : {E, N, W, S}) {
    if (!map.has(i + to.i, j + to.j)) continue;
    const double rise = std::abs(map.at(i + to.i, j + to.j) - map.at(i, j));
    steepest = std::max(steepest, rise / (to.i != 0 ? map.ps_x : map.ps_y));
  }
  return std::atan(steepest) * degrees_per_radian;
}

double angle_to_vertical(const Normal& n) {
  return std::acos(std::clamp(n.z, -1.0, 1.0)) * degrees_per_radian;
}

double dot_with_vertical(const Normal& n) {
  return n.x * 0 + n.y * 0 + n.z * 1;
}

double listing_9_15(double angle, double max_soil_depth) {
  return (1 - angle / 90) * max_soil_depth;
}

}  // namespace phytobench::oracles::lesser2019
