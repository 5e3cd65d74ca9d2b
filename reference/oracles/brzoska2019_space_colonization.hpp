// SPDX-License-Identifier: MIT
// Space colonization as [Brzoska2019] sec. 3.4.4 describes it, in the plainest loops. Slow on
// purpose: every engine and every loop option is judged against this. Shares no code with core/.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "reference/oracles/brzoska2019_equations.hpp"

namespace phytobench::oracles::brzoska2019 {

/// Departures from the reading that reproduces the published trees; all false is that reading.
struct Departures {
  bool normalise_before_tropism = false;  ///< eq. 10 as printed
  bool sum_raw_vectors = false;           ///< the sentence before eq. 8
  bool cone_after_search = false;         ///< nearest node first, perception angle afterwards
  bool no_repeat_guard = false;           ///< the same child may be made again
  bool crown_stem_kills = false;          ///< trunk nodes inside the crown remove points too
  bool all_nodes_kill = false;  ///< every node so far removes points, not only the new ones
};

/// Removal at the start of the next iteration (option D), and the five conditions under which that
/// grows the same tree; `true` keeps a condition.
struct DeferredRemoval {
  bool enabled = false;
  bool first_pass_removes_nothing = true;       ///< condition 1
  bool uses_previous_kill_distance = true;      ///< condition 2
  bool compares_like_immediate_removal = true;  ///< condition 3: <=, where broken <
  bool ignores_perception_angle = true;         ///< condition 4
  bool stop_test_follows_removal = true;        ///< condition 5
};

struct GrowthProblem {
  std::vector<Point> attraction_points;
  std::vector<Point> start_nodes;       ///< crown root, then the trunk inside the crown
  std::vector<Point> start_directions;  ///< unit vectors
  std::vector<int> start_parents;       ///< -1 for the crown root
  int iterations = 0;
  double D = 0;
  double d_i = 0;
  double theta_rad = 0;  ///< full perception angle
  Point g{0, 0, 0};      ///< weighted tropism
  std::function<double(int)> d_c;
  Departures departures;
  DeferredRemoval deferred;
};

struct GrowthPass {
  std::vector<int> nearest;              ///< per attraction point its node, or -1
  std::vector<double> squared_distance;  ///< where there is a node
  std::size_t nodes_seen = 0;            ///< the first so many nodes of the tree stood already
};

struct GrownTree {
  std::vector<Point> nodes;
  std::vector<Point> directions;  ///< unit vectors
  std::vector<int> parents;
  std::vector<GrowthPass> passes;          ///< one per executed iteration
  std::vector<std::vector<int>> removals;  ///< the points of each removal, in the order of removals
};

GrownTree grow(const GrowthProblem& problem);

}  // namespace phytobench::oracles::brzoska2019
