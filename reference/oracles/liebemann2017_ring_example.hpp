// SPDX-License-Identifier: MIT
// The example of [Liebemann2017] fig. 3.2 and the trap of sec. 5.3 as problems for the literal
// loop, and how to see that a node was caught. Shares no code with core/.
#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <random>
#include <tuple>
#include <vector>

#include "reference/oracles/liebemann2017_space_colonization.hpp"

namespace phytobench::oracles::liebemann2017 {

// Evenly in a disc around the origin; the same for a seed everywhere.
inline std::vector<Point> points_in_disc(int N, double r, unsigned seed) {
  std::mt19937_64 bits(seed);
  const auto uniform = [&] { return static_cast<double>(bits() >> 11) * 0x1p-53; };
  std::vector<Point> points;
  while (points.size() < static_cast<std::size_t>(N)) {
    const double x = r * (2 * uniform() - 1), y = r * (2 * uniform() - 1);
    if (x * x + y * y <= r * r) points.push_back({x, y, 0});
  }
  return points;
}

// Fig. 3.2 has N = 2000 and r = 500. Its "ring" is read as a disc, and the root, of which nothing
// is said, stands at the lowest place of its edge.
inline ColonizationProblem ring_example(int N, double r, unsigned seed, int most_iterations) {
  ColonizationProblem problem;
  problem.S = points_in_disc(N, r, seed);
  problem.root = {0, -r, 0};
  problem.d_i = 100;
  problem.d_k = 20;
  problem.D = 15;
  problem.most_iterations = most_iterations;
  return problem;
}

// Two points at the same distance from the line on which the tree grows towards them.
inline ColonizationProblem two_point_trap(double half_distance, double root_y,
                                          int most_iterations) {
  ColonizationProblem problem = ring_example(0, 1, 1, most_iterations);
  problem.S = {{half_distance, 0, 0}, {-half_distance, 0, 0}};
  problem.root = {0, root_y, 0};
  return problem;
}

inline ColonizationProblem without_repetition(ColonizationProblem problem) {
  problem.same_successor_again = SameSuccessorAgain::rejected;
  problem.zero_over_zero = ZeroOverZero::skipped;
  problem.stop_at_standstill = true;
  return problem;
}

inline std::size_t distinct_places(const ColonizedTree& tree) {
  std::map<std::tuple<double, double, double>, int> times;
  for (const Point& p : tree.nodes) ++times[{p.x, p.y, p.z}];
  return times.size();
}

// The greatest number of successors of one node at one place.
inline int most_identical_successors(const ColonizedTree& tree) {
  std::map<std::tuple<int, double, double, double>, int> times;
  int most = 0;
  for (std::size_t v = 0; v < tree.nodes.size(); ++v) {
    const Point p = tree.nodes[v];
    most = std::max(most, ++times[{tree.predecessors[v], p.x, p.y, p.z}]);
  }
  return most;
}

}  // namespace phytobench::oracles::liebemann2017
