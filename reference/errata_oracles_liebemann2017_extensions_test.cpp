// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/errata_oracles.hpp"
#include "reference/oracles/liebemann2017_space_colonization.hpp"

namespace phytobench {

namespace {

constexpr double degree = std::numbers::pi / 180.0;

/// Successors of a node that has points in so many iterations: what is set to 0 with each, max_NG
/// or the node's counter?
double successors(double iterations, double max_NG, bool counter_is_reset) {
  double counter = 0, made = 0;
  for (int i = 0; i < static_cast<int>(iterations); ++i) {
    if (counter >= max_NG) continue;
    ++made;
    (counter_is_reset ? counter : max_NG) = 0;
  }
  return made;
}

/// Distance of the upper corners of two rings about the same place: the end ring of an edge and the
/// start ring of the next one.
double gap(double radius, double end_normal_deg, double start_normal_deg) {
  const double x = std::cos(end_normal_deg * degree) - std::cos(start_normal_deg * degree);
  const double y = std::sin(end_normal_deg * degree) - std::sin(start_normal_deg * degree);
  return radius * std::hypot(x, y);
}

}  // namespace

OracleTable liebemann2017_extensions_oracles() {
  namespace literal = oracles::liebemann2017;
  return {
      // Iterations in which the node has points, max_NG; successors.
      {"liebemann2017/successors-with-max-ng",
       {2, [](const Arguments& a) { return successors(a[0], a[1], false); },
        [](const Arguments& a) { return successors(a[0], a[1], true); }}},
      // D, branch depth, max_Z; step as printed, and with the least max_Z that has two ends.
      {"liebemann2017/weighted-step",
       {3,
        [](const Arguments& a) {
          return literal::weighted_step(a[0], static_cast<int>(a[1]), static_cast<int>(a[2]));
        },
        [](const Arguments& a) {
          return literal::weighted_step(a[0], static_cast<int>(a[1]),
                                        std::max(1, static_cast<int>(a[2])));
        }}},
      // Radius, start and end normal of an edge as angles from the vertical; gap to the next edge,
      // which starts across the end normal.
      {"liebemann2017/gap-between-cylinders",
       {3, [](const Arguments& a) { return gap(a[0], a[1], a[2]); },
        [](const Arguments& a) { return gap(a[0], a[2], a[2]); }}},
  };
}

}  // namespace phytobench
