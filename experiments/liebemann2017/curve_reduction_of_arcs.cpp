// SPDX-License-Identifier: MIT
// Curve reduction of sec. 3.5, eq. 3.6, on branches of which one can tell what must be left: does
// the order matter?
#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "experiments/experiment.hpp"
#include "experiments/liebemann2017/reduction_orders.hpp"

namespace phytobench::experiments::liebemann2017 {

namespace {

namespace literal = oracles::liebemann2017;
constexpr double degree = std::numbers::pi / 180.0;

/// Unit edges that turn by the same angle at each node.
Skeleton arc(int edges, double turn_deg) {
  Skeleton branch{Vector3{}};
  for (int v = 0; v < edges; ++v) {
    const double heading = v * turn_deg * degree;
    branch.append(v, branch.position(v) + Vector3{std::sin(heading), std::cos(heading), 0});
  }
  return branch;
}

double distance_to_segment(const Vector3& p, const Vector3& a, const Vector3& b) {
  const Vector3 way = b - a;
  const double t = std::clamp(dot(p - a, way) / dot(way, way), 0.0, 1.0);
  return norm(p - (a + t * way));
}

/// How far a node of a branch is from the reduced branch, at most.
double greatest_distance(const Skeleton& branch, const Skeleton& fewer) {
  double greatest = 0.0;
  for (const Vector3& p : branch.positions()) {
    double nearest = norm(p - fewer.position(0));
    for (std::size_t v = 1; v < fewer.node_count(); ++v)
      nearest = std::min(nearest, distance_to_segment(p, fewer.position(fewer.parents()[v]),
                                                      fewer.positions()[v]));
    greatest = std::max(greatest, nearest);
  }
  return greatest;
}

/// 36 edges, so that 5 degrees a node make half a circle. Twice the threshold is no multiple of the
/// turn: there rounding would decide.
void measure_arcs(ExperimentContext& context) {
  struct Case {
    double turn, threshold;
  };
  std::int64_t other_than_formula = 0;
  for (const auto& [turn, threshold] :
       {Case{5, 11}, Case{5, 21}, Case{10, 31}, Case{2, 10.5}, Case{5, 6}, Case{5, 4}})
    for (const auto& [order, name] : orders) {
      const std::int64_t left = nodes_left(arc(36, turn), std::cos(threshold * degree), order);
      context.record(fmt::format("arc/t-{}/T-{}/{}", turn, threshold, name), left);
      other_than_formula +=
          left != literal::nodes_kept_of_an_arc(36, turn, threshold, literal_order(order));
    }
  context.record("arc/other_than_formula", other_than_formula);
  for (const auto& [order, name] : orders)
    context.record(
        fmt::format("half-circle/{}/greatest_distance", name),
        greatest_distance(arc(36, 5), reduced(arc(36, 5), std::cos(11 * degree), order).skeleton),
        "length");
}

/// A straight branch, one with a right angle, and the greatest cosine there is.
void measure_short_branches(ExperimentContext& context) {
  Skeleton straight{Vector3{}}, corner{Vector3{}};
  for (std::int32_t v = 0; v < 9; ++v) straight.append(v, {3.0 * (v + 1), 4.0 * (v + 1), 0});
  for (std::int32_t v = 0; v < 9; ++v)
    corner.append(v, {v < 4 ? 0.0 : v - 3.0, v < 4 ? v + 1.0 : 4.0, 0});
  for (const auto& [order, name] : orders) {
    context.record(fmt::format("straight/{}/nodes", name), nodes_left(straight, 0.99, order));
    context.record(fmt::format("straight/{}/nodes_at_cosine_1", name),
                   nodes_left(straight, 1.0, order));
    context.record(fmt::format("right-angle/{}/nodes", name), nodes_left(corner, 0.99, order));
  }
}

void run(ExperimentContext& context) {
  measure_arcs(context);
  measure_short_branches(context);
}

}  // namespace

extern const ExperimentDescriptor curve_reduction_of_arcs;
constinit const ExperimentDescriptor curve_reduction_of_arcs{
    .id = "liebemann2017/curve-reduction-of-arcs",
    .question = "Does it matter in which order curve reduction goes through a branch?",
    .source = "[Liebemann2017] sec. 3.5, eq. 3.6",
    .seconds = {0.01, 0.01, 0.01},
    .run = run,
};

}  // namespace phytobench::experiments::liebemann2017
