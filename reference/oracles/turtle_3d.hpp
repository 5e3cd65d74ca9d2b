// SPDX-License-Identifier: MIT
// The turtle of [Liebemann2017] sec. 2.3.3 in space, with the matrices as printed, those of The
// Algorithmic Beauty of Plants, and the signs of other programs. Shares no code with core/.
#pragma once

#include <array>
#include <cmath>
#include <compare>
#include <numbers>
#include <string>

#include "reference/oracles/turtle_drawing.hpp"

namespace phytobench::oracles {

struct SpacePoint {
  double x = 0, y = 0, z = 0;
  friend auto operator<=>(const SpacePoint&, const SpacePoint&) = default;
};

// Rows. The columns of a turtle's matrix are H, L and U.
using Matrix3 = std::array<std::array<double, 3>, 3>;

inline Matrix3 product(const Matrix3& A, const Matrix3& B) {
  Matrix3 C{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) C[i][j] += A[i][k] * B[k][j];
  return C;
}

inline SpacePoint column(const Matrix3& R, std::size_t j) {
  return {R[0][j], R[1][j], R[2][j]};
}

// Greatest entry of R^T R - I, as a magnitude: 0 for a rotation.
inline double distance_from_orthonormal(const Matrix3& R) {
  double greatest = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      double entry = i == j ? -1 : 0;
      for (std::size_t k = 0; k < 3; ++k) entry += R[k][i] * R[k][j];
      greatest = std::fmax(greatest, std::fabs(entry));
    }
  return greatest;
}

// Eq. 2.7 to 2.9; d in radians.
inline Matrix3 equation_2_7(double d) {
  return {{{1, 0, 0}, {0, std::cos(d), std::sin(d)}, {0, -std::sin(d), std::cos(d)}}};
}
inline Matrix3 equation_2_8(double d) {
  return {{{std::cos(d), 0, std::sin(d)}, {0, 1, 0}, {-std::sin(d), 0, std::cos(d)}}};
}
inline Matrix3 equation_2_9(double d) {
  return {{{std::cos(d), -std::sin(d), 0}, {std::sin(d), std::cos(d), 0}, {0, 0, 1}}};
}

// The Algorithmic Beauty of Plants, p. 19: R_H, R_L and R_U.
inline Matrix3 abop_R_H(double d) {
  return {{{1, 0, 0}, {0, std::cos(d), -std::sin(d)}, {0, std::sin(d), std::cos(d)}}};
}
inline Matrix3 abop_R_L(double d) {
  return {{{std::cos(d), 0, -std::sin(d)}, {0, 1, 0}, {std::sin(d), 0, std::cos(d)}}};
}
inline Matrix3 abop_R_U(double d) {
  return {{{std::cos(d), std::sin(d), 0}, {-std::sin(d), std::cos(d), 0}, {0, 0, 1}}};
}

enum class TurtleMatrices {
  printed,  // [Liebemann2017]
  abop,
  cpfg,              // as printed, rolls the other way
  lpfg_uncorrected,  // as printed, pitches and rolls the other way
};

inline constexpr Matrix3 start_local{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};     // H = +x, U = +z
inline constexpr Matrix3 start_upwards{{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}};  // H = +y, U = +z

// (p, R).
struct SpaceTurtle {
  SpacePoint position;
  Matrix3 R = start_local;
  TurtleMatrices matrices = TurtleMatrices::printed;

  // Eq. 2.10; the H in it is the heading in the turtle's own system, (1, 0, 0).
  void move(double l) {
    const SpacePoint H = column(R, 0);
    position = {position.x + H.x * l, position.y + H.y * l, position.z + H.z * l};
  }

  // Eq. 2.11 to 2.16, and | as half a turn about U.
  void turn(const std::string& letter, double d_deg) {
    const double d = d_deg * std::numbers::pi / 180;
    if (letter == "+") R = product(R, R_U(d));
    if (letter == "-") R = product(R, R_U(-d));
    if (letter == "&") R = product(R, R_L(d));
    if (letter == "^") R = product(R, R_L(-d));
    if (letter == "\\") R = product(R, R_H(d));
    if (letter == "/") R = product(R, R_H(-d));
    if (letter == "|") R = product(R, R_U(std::numbers::pi));
  }

  Matrix3 R_H(double d) const {
    if (matrices == TurtleMatrices::abop) return abop_R_H(d);
    return equation_2_7(matrices == TurtleMatrices::printed ? d : -d);
  }
  Matrix3 R_L(double d) const {
    if (matrices == TurtleMatrices::abop) return abop_R_L(d);
    return equation_2_8(matrices == TurtleMatrices::lpfg_uncorrected ? -d : d);
  }
  Matrix3 R_U(double d) const {
    return matrices == TurtleMatrices::abop ? abop_R_U(d) : equation_2_9(d);
  }
};

using SpaceDrawing = TurtleDrawing<SpaceTurtle>;

// From the origin.
inline SpaceDrawing turtle_3d(const ParametricWord& word, const TurtleDefaults& defaults,
                              const Matrix3& start = start_local,
                              TurtleMatrices matrices = TurtleMatrices::printed) {
  return drawing_of(word, SpaceTurtle{{}, start, matrices}, defaults);
}

}  // namespace phytobench::oracles
