// SPDX-License-Identifier: MIT
#include <cmath>

#include "reference/errata_oracles.hpp"
#include "reference/oracles/liebemann2017_ring_example.hpp"

namespace phytobench {

OracleTable liebemann2017_growth_oracles() {
  namespace literal = oracles::liebemann2017;
  return {
      // Half distance of two points, height of the root, most iterations; nodes of the tree with
      // successors repeated as printed, and once each.
      {"liebemann2017/nodes-between-two-points",
       {3,
        [](const Arguments& a) {
          return static_cast<double>(
              literal::colonize(literal::two_point_trap(a[0], a[1], static_cast<int>(a[2])))
                  .nodes.size());
        },
        [](const Arguments& a) {
          return static_cast<double>(
              literal::colonize(literal::without_repetition(
                                    literal::two_point_trap(a[0], a[1], static_cast<int>(a[2]))))
                  .nodes.size());
        }}},
      // x and y of two points, height of the root; whether the points are equally far from it, and
      // whether a node repeats its successor for ever.
      {"liebemann2017/caught-between-two-points",
       {5,
        [](const Arguments& a) {
          const double one = std::hypot(a[0], a[1] - a[4]), other = std::hypot(a[2], a[3] - a[4]);
          return one == other ? 1.0 : 0.0;
        },
        [](const Arguments& a) {
          auto problem = literal::two_point_trap(0, a[4], 200);
          problem.S = {{a[0], a[1], 0}, {a[2], a[3], 0}};
          return literal::colonize(problem).stop == literal::Stop::most_iterations ? 1.0 : 0.0;
        }}},
      // x of two points at height 0, seen from the origin, without tropism; length of the step by
      // eq. 3.2, and with no step where the sum is zero.
      {"liebemann2017/step-between-two-points",
       {2,
        [](const Arguments& a) {
          const double sum = a[0] / std::abs(a[0]) + a[1] / std::abs(a[1]);
          return 15.0 * std::abs(sum / std::abs(sum));
        },
        [](const Arguments& a) {
          const double sum = a[0] / std::abs(a[0]) + a[1] / std::abs(a[1]);
          return sum == 0.0 ? 0.0 : 15.0 * std::abs(sum / std::abs(sum));
        }}},
      // Radius of the region, height of the root; nodes of a circle line with 2000 even points, and
      // of as many in a disc (sunflower), after one iteration.
      {"liebemann2017/first-nodes-in-ring",
       {2,
        [](const Arguments& a) {
          auto problem = literal::without_repetition(literal::ring_example(0, a[0], 1, 1));
          problem.root = {0, a[1], 0};
          for (int i = 0; i < 2000; ++i) {
            const double angle = 0.0031415926535897931 * i;
            problem.S.push_back({a[0] * std::cos(angle), a[0] * std::sin(angle), 0});
          }
          return static_cast<double>(literal::colonize(problem).nodes.size());
        },
        [](const Arguments& a) {
          auto problem = literal::without_repetition(literal::ring_example(0, a[0], 1, 1));
          problem.root = {0, a[1], 0};
          for (int i = 0; i < 2000; ++i) {
            const double radius = a[0] * std::sqrt((i + 0.5) / 2000.0), angle = 2.399963 * i;
            problem.S.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
          }
          return static_cast<double>(literal::colonize(problem).nodes.size());
        }}},
  };
}

}  // namespace phytobench
