// SPDX-License-Identifier: MIT
// Space colonization as [Liebemann2017] sec. 3.3 describes it, with the conditions of sec. 3.5, in
// the plainest loops. Slow on purpose. Shares no code with core/, so that agreement means
// something.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace phytobench::oracles::liebemann2017 {

struct Point {  // in the plane: z = 0
  double x = 0, y = 0, z = 0;
  friend bool operator==(const Point&, const Point&) = default;
};

Point plus(Point a, Point b);
Point minus(Point a, Point b);
Point times(double s, Point a);
double norm(Point a);

// Whether "within a radius" has its boundary in it; the text does not say.
enum class Boundary { within, outside };

enum class Tropism {
  added_to_the_sum,          // eq. 3.2 as printed
  added_to_the_unit_vector,  // the sum is normalised first
};

// A new node at the place of a successor that the node has already.
enum class SameSuccessorAgain { allowed_as_printed, rejected };

// A direction of length zero, and an influence point at the node itself: 0/0 in eq. 3.2 and 3.3.
enum class ZeroOverZero { as_printed, skipped };

struct ColonizationProblem {
  static constexpr int unlimited = std::numeric_limits<int>::max();

  std::vector<Point> S;  // influence points
  Point root;
  double d_i = 0, d_k = 0, D = 0;
  Point T;  // tropism vector
  int most_iterations = 0;

  Boundary boundary = Boundary::within;
  Tropism tropism = Tropism::added_to_the_sum;
  SameSuccessorAgain same_successor_again = SameSuccessorAgain::allowed_as_printed;
  ZeroOverZero zero_over_zero = ZeroOverZero::as_printed;

  // Sec. 3.5.
  int max_grad = unlimited;
  int max_Z = unlimited;
  int max_NG = unlimited;
  bool weighted_growth = false;

  // Not in the text: an iteration after which the next would be the same in everything ends it.
  bool stop_at_standstill = false;
};

enum class Stop {
  all_points_removed,  // the three of sec. 3.3
  no_node_in_reach,
  most_iterations,
  standstill,  // nothing grew, was removed or was counted
  undefined,   // 0/0, or weighted growth without a maximal branch depth above 0
};

struct ColonizedTree {
  std::vector<Point> nodes;       // the root first, then in the order of creation
  std::vector<int> predecessors;  // -1 for the root
  std::vector<int> Z;             // eq. 3.5 at creation
  std::vector<int> born;          // iteration of the creation, from 1; 0 for the root
  std::vector<int> no_grow;       // iterations in a row without a new successor, up to max_NG
  std::vector<std::size_t> left;  // influence points that are still there
  int iterations = 0;             // in which some node had influence points, the last one too
  Stop stop = Stop::most_iterations;
  std::uint64_t distances_of_step_1 = 0;
  std::uint64_t distances_of_step_3 = 0;
};

// In each iteration nodes that have points get their successors in the order of the nodes; of nodes
// equally near to a point the first has it.
ColonizedTree colonize(const ColonizationProblem& problem);

// Eq. 3.2 with a sum that is not zero after tropism.
Point equation_3_2(Point sum, Point T, Tropism tropism);

// Weighted growth: 2 D at branch depth 0, D at max_Z. Not a number for max_Z = 0 or unlimited.
double weighted_step(double D, int Z, int max_Z);

// Nodes straight ahead until one is within d_k of a point at distance L: sec. 3.3 with one point.
int nodes_towards_one_point(double L, double d_k, double D, Boundary boundary);

}  // namespace phytobench::oracles::liebemann2017
