// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "reference/errata_oracles.hpp"
#include "reference/oracles/brzoska2019_equations.hpp"
#include "reference/oracles/brzoska2019_space_colonization.hpp"

namespace phytobench {

namespace {

std::vector<oracles::brzoska2019::Point> points_of(const Arguments& a) {
  std::vector<oracles::brzoska2019::Point> points;
  for (std::size_t i = 0; i + 2 < a.size(); i += 3) points.push_back({a[i], a[i + 1], a[i + 2]});
  return points;
}

/// Two points that stay nearest to the first node whatever grows between them.
double repeated_children(double iterations, bool without_guard) {
  oracles::brzoska2019::GrowthProblem problem;
  problem.attraction_points = {{-0.4, 0.08, 0}, {0.4, 0.08, 0}};
  problem.start_nodes = {{0, 0, 0}};
  problem.start_directions = {{0, 1, 0}};
  problem.start_parents = {-1};
  problem.iterations = static_cast<int>(iterations);
  problem.D = 0.25;
  problem.d_i = 0.5;
  problem.theta_rad = 160.0 * std::numbers::pi / 180.0;
  problem.d_c = [](int) { return 0.3; };
  problem.departures.no_repeat_guard = without_guard;
  const auto parents = oracles::brzoska2019::grow(problem).parents;
  return static_cast<double>(std::count(parents.begin(), parents.end(), 0));
}

}  // namespace

OracleTable brzoska2019_oracles() {
  namespace brzoska = oracles::brzoska2019;
  return {
      // Sum of unit vectors, then tropism; the upward component is the value.
      {"brzoska2019/equation-10",
       {6,
        [](const Arguments& a) {
          return brzoska::equation_10_as_printed({a[0], a[1], a[2]}, {a[3], a[4], a[5]}).y;
        },
        [](const Arguments& a) {
          return brzoska::equation_10_corrected({a[0], a[1], a[2]}, {a[3], a[4], a[5]}).y;
        }}},
      // First and last kill distance, limits of the sigmoid, iterations, iteration.
      {"brzoska2019/equation-17",
       {6,
        [](const Arguments& a) {
          return brzoska::equation_17_as_printed(a[0], a[1], a[2], a[3], static_cast<int>(a[4]),
                                                 static_cast<int>(a[5]));
        },
        [](const Arguments& a) {
          return brzoska::equation_17_corrected(a[0], a[1], a[2], a[3], static_cast<int>(a[4]),
                                                static_cast<int>(a[5]));
        }}},
      // The function that eq. 16 should define; as printed there is none.
      {"brzoska2019/sigmoid",
       {1, [](const Arguments&) { return undefined; },
        [](const Arguments& a) { return brzoska::sig(a[0]); }}},
      // Two points seen from a node at the origin; nodes that may grow.
      {"brzoska2019/equation-9-new-nodes",
       {6,
        [](const Arguments& a) {
          return brzoska::equation_9(brzoska::equation_9_sum({0, 0, 0}, points_of(a))).x;
        },
        [](const Arguments& a) {
          return brzoska::length(brzoska::equation_9_sum({0, 0, 0}, points_of(a))) > 0 ? 1.0 : 0.0;
        }}},
      // A point at the node itself, and another; the upward component.
      {"brzoska2019/equation-9-point-at-node",
       {3,
        [](const Arguments& a) {
          const brzoska::Point other{a[0], a[1], a[2]};
          return brzoska::equation_9(brzoska::equation_9_sum({0, 0, 0}, {{0, 0, 0}, other})).y;
        },
        [](const Arguments& a) {
          return brzoska::equation_9(brzoska::equation_9_sum({0, 0, 0}, points_of(a))).y;
        }}},
      // Sum and tropism; nodes that may grow.
      {"brzoska2019/equation-10-new-nodes",
       {6,
        [](const Arguments& a) {
          return brzoska::equation_10_as_printed({a[0], a[1], a[2]}, {a[3], a[4], a[5]}).y;
        },
        [](const Arguments& a) {
          return brzoska::length({a[0] + a[3], a[1] + a[4], a[2] + a[5]}) > 0 ? 1.0 : 0.0;
        }}},
      // Iterations; children of the first node without and with the guard.
      {"brzoska2019/repeated-child",
       {1, [](const Arguments& a) { return repeated_children(a[0], true); },
        [](const Arguments& a) { return repeated_children(a[0], false); }}},
      // Cut-off ratios; volume between them.
      {"brzoska2019/base-volume",
       {2, [](const Arguments& a) { return brzoska::base_volume(a[0], a[1]); },
        [](const Arguments& a) {
          return a[0] + a[1] < 1 ? brzoska::base_volume(a[0], a[1]) : 0.0;
        }}},
      // Two angles and lambda; how much more the first turns, and how much larger its share is.
      {"brzoska2019/equation-13-turn-and-share",
       {3,
        [](const Arguments& a) {
          return brzoska::equation_13(a[0], a[2]) - brzoska::equation_13(a[1], a[2]);
        },
        [](const Arguments& a) {
          return brzoska::equation_13(a[0], a[2]) / a[0] - brzoska::equation_13(a[1], a[2]) / a[1];
        }}},
      // A point of a ring and the ring's normal; the point's x.
      {"brzoska2019/equation-3",
       {6,
        [](const Arguments& a) {
          return brzoska::equation_3_as_printed({a[0], a[1], a[2]}, {a[3], a[4], a[5]}).x;
        },
        [](const Arguments& a) {
          return brzoska::equation_3_corrected({a[0], a[1], a[2]}, {a[3], a[4], a[5]}).x;
        }}},
      // Vertices, triangles and lambda of two plants; how many file names, how many plants.
      {"brzoska2019/plants-with-one-file-name",
       {6,
        [](const Arguments& a) {
          return static_cast<double>(
              std::set<std::pair<double, double>>{{a[0], a[1]}, {a[3], a[4]}}.size());
        },
        [](const Arguments& a) {
          return static_cast<double>(
              std::set<Arguments>{{a[0], a[1], a[2]}, {a[3], a[4], a[5]}}.size());
        }}},
      // Vertices, triangles, limit; how many meshes.
      {"brzoska2019/meshes-needed",
       {3, [](const Arguments& a) { return std::ceil(std::max(a[0], a[1]) / a[2]); },
        [](const Arguments& a) { return std::ceil(a[0] / a[2]); }}},
      // Corners of a ring, printed and corrected number of vertices; vertices left over.
      {"brzoska2019/vertices-over-rings",
       {3, [](const Arguments& a) { return std::fmod(a[1], a[0] + 1); },
        [](const Arguments& a) { return std::fmod(a[2], a[0] + 1); }}},
      // Volume and density.
      {"brzoska2019/equation-22",
       {2, [](const Arguments& a) { return brzoska::equation_22_as_printed(a[0], a[1]); },
        [](const Arguments& a) { return brzoska::equation_22_corrected(a[0], a[1]); }}},
  };
}

}  // namespace phytobench
