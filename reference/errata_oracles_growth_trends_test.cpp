// SPDX-License-Identifier: MIT
#include <numbers>

#include "reference/errata_oracles.hpp"
#include "reference/oracles/brzoska2019_space_colonization.hpp"

namespace phytobench {

namespace {

namespace brzoska = oracles::brzoska2019;

/// On which side of the line from a to b a point lies, in the plane z = 0.
double side(const brzoska::Point& a, const brzoska::Point& b, const brzoska::Point& p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

bool cross(const brzoska::Point& a, const brzoska::Point& b, const brzoska::Point& c,
           const brzoska::Point& d) {
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

/// Two nodes beside each other, with a point above each; pairs of new branches that cross after one
/// iteration. Half the distance of the nodes, distance of the points from the middle, their height,
/// D, d_c.
double crossing_branches(const Arguments& a) {
  brzoska::GrowthProblem problem;
  problem.attraction_points = {{-a[1], a[2], 0}, {a[1], a[2], 0}};
  problem.start_nodes = {{-a[0], 0, 0}, {a[0], 0, 0}};
  problem.start_directions = {{0, 1, 0}, {0, 1, 0}};
  problem.start_parents = {-1, 0};
  problem.iterations = 1;
  problem.D = a[3];
  problem.d_i = 2 * a[3];
  problem.theta_rad = 160 * std::numbers::pi / 180;
  problem.d_c = [d_c = a[4]](int) { return d_c; };
  const brzoska::GrownTree tree = brzoska::grow(problem);
  double pairs = 0;
  for (std::size_t i = 2; i < tree.nodes.size(); ++i)
    for (std::size_t j = i + 1; j < tree.nodes.size(); ++j)
      pairs += cross(tree.nodes[static_cast<std::size_t>(tree.parents[i])], tree.nodes[i],
                     tree.nodes[static_cast<std::size_t>(tree.parents[j])], tree.nodes[j]);
  return pairs;
}

}  // namespace

OracleTable brzoska2019_growth_trend_oracles() {
  return {
      // Half the distance of two nodes, place of a point above each, D, d_c; pairs that cross.
      {"brzoska2019/branches-that-cross",
       {5, [](const Arguments&) { return 0.0; },  // what "avoided" means
        [](const Arguments& a) { return crossing_branches(a); }}},
  };
}

}  // namespace phytobench
