// SPDX-License-Identifier: MIT
#include "benchmarks/regression/checks/field_over_disc.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace phytobench {

namespace {

struct Node {
  double place;   ///< -1 to 1
  double weight;  ///< all together 2
};

/// The double exponential rule (Takahasi and Mori 1974): roots at the ends of a piece do it no
/// harm.
std::vector<Node> double_exponential_rule() {
  constexpr int half = 50;
  constexpr double step = 3.2 / half;  // weights beyond 3.2 are less than 1e-15
  std::vector<Node> nodes;
  for (int k = -half; k <= half; ++k) {
    const double t = k * step, u = 0.5 * std::numbers::pi * std::sinh(t);
    nodes.push_back({std::tanh(u),
                     0.5 * std::numbers::pi * step * std::cosh(t) / (std::cosh(u) * std::cosh(u))});
  }
  return nodes;
}

double field_at(const LiteralField& field, double r) {
  if (r <= field.stem) return 1.0;
  return std::pow(field.at_rim, (r - field.stem) / (field.zone - field.stem));
}

/// Length of the circle around the stem as far as it lies in the disc.
double arc_within(double r, double radius, double distance) {
  if (r <= radius - distance) return 2.0 * std::numbers::pi * r;
  if (r <= distance - radius || r >= distance + radius) return 0.0;
  const double cosine = (r * r + distance * distance - radius * radius) / (2.0 * r * distance);
  return 2.0 * r * std::acos(std::clamp(cosine, -1.0, 1.0));
}

}  // namespace

double field_over_disc(const LiteralField& field, double radius, double distance) {
  static const std::vector<Node> rule = double_exponential_rule();
  // Between these distances from the stem the integrand is smooth.
  const double far = std::min(field.zone, distance + radius);
  std::array<double, 4> cuts = {0.0, std::min(field.stem, far),
                                std::min(std::abs(distance - radius), far), far};
  std::sort(cuts.begin(), cuts.end());
  double sum = 0.0;
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    const double middle = 0.5 * (cuts[k] + cuts[k + 1]), half = 0.5 * (cuts[k + 1] - cuts[k]);
    if (half <= 0.0) continue;
    for (const Node& node : rule) {
      const double r = middle + half * node.place;
      sum += half * node.weight * field_at(field, r) * arc_within(r, radius, distance);
    }
  }
  return sum;
}

}  // namespace phytobench
