// SPDX-License-Identifier: MIT
// (2.6) and (2.7) of [Alsweis], literally. Shares no code with core/, so that agreement means
// something.
#pragma once

#include <cmath>
#include <numbers>
#include <span>
#include <vector>

namespace phytobench::oracles::alsweis {

struct PlaneVector {
  double x = 0.0;
  double y = 0.0;
};

// (2.7): q_1, q_2, ... of the uniform numbers v_1, v_2, ... Uniform in what is not said; it takes
// (0, 1], because one v_i = 0 would make all later q infinite.
inline std::vector<double> equation_2_7(std::span<const double> v) {
  std::vector<double> q;
  for (const double v_i : v) q.push_back(q.empty() ? -std::log(v_i) : q.back() - std::log(v_i));
  return q;
}

// The unit vector e_i whose direction is the share `turn` of a full turn.
inline PlaneVector unit_vector(double turn) {
  return {std::cos(2.0 * std::numbers::pi * turn), std::sin(2.0 * std::numbers::pi * turn)};
}

// (2.6): the point P_i.
inline PlaneVector equation_2_6(double q_i, double lambda, const PlaneVector& e_i) {
  const double factor = std::sqrt(q_i / (std::numbers::pi * lambda));
  return {factor * e_i.x, factor * e_i.y};
}

}  // namespace phytobench::oracles::alsweis
