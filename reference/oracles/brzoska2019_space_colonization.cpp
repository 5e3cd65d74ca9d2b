// SPDX-License-Identifier: MIT
#include "reference/oracles/brzoska2019_space_colonization.hpp"

#include <map>

namespace phytobench::oracles::brzoska2019 {

namespace {

struct Growth {
  const GrowthProblem& problem;
  GrownTree tree;
  std::vector<bool> flagged;   // per point: removed (the thesis' boolean array)
  std::vector<int> new_nodes;  // of the iteration before

  explicit Growth(const GrowthProblem& p) : problem(p), flagged(p.attraction_points.size(), false) {
    tree.nodes = p.start_nodes;
    tree.directions = p.start_directions;
    tree.parents = p.start_parents;
  }

  // Fig. 26: the angle between the node's direction and the way to the point is at most theta/2.
  // As cosines: cos(angle) >= cos(theta/2), multiplied by the distance.
  bool perceives(std::size_t v, Point p, double distance) const {
    if (problem.theta_rad / 2 >= std::numbers::pi) return true;
    return scalar_product(tree.directions[v], minus(p, tree.nodes[v])) >=
           std::cos(problem.theta_rad / 2) * distance;
  }

  void associate() {
    GrowthPass pass;
    pass.nodes_seen = tree.nodes.size();
    pass.nearest.assign(flagged.size(), -1);
    pass.squared_distance.assign(flagged.size(), 0);
    const bool cone_first = !problem.departures.cone_after_search;
    for (std::size_t s = 0; s < flagged.size(); ++s) {
      if (flagged[s]) continue;
      const Point p = problem.attraction_points[s];
      int nearest = -1;
      double shortest = 0;
      for (std::size_t v = 0; v < tree.nodes.size(); ++v) {
        const double squared = equation_24(p, tree.nodes[v]);
        if (squared > problem.d_i * problem.d_i) continue;
        if (nearest >= 0 && squared >= shortest) continue;
        if (cone_first && !perceives(v, p, std::sqrt(squared))) continue;
        nearest = static_cast<int>(v);
        shortest = squared;
      }
      pass.nearest[s] = nearest;
      pass.squared_distance[s] = shortest;
    }
    tree.passes.push_back(pass);
  }

  // S(v) for every node that has points, in the order of the first point.
  std::vector<std::pair<std::size_t, std::vector<Point>>> sets() const {
    std::vector<std::pair<std::size_t, std::vector<Point>>> S;
    std::map<int, std::size_t> place;
    const GrowthPass& pass = tree.passes.back();
    for (std::size_t s = 0; s < flagged.size(); ++s) {
      const int v = pass.nearest[s];
      if (v < 0) continue;
      const Point p = problem.attraction_points[s];
      if (problem.departures.cone_after_search &&
          !perceives(static_cast<std::size_t>(v), p, std::sqrt(pass.squared_distance[s])))
        continue;
      if (!place.contains(v)) {
        place[v] = S.size();
        S.push_back({static_cast<std::size_t>(v), {}});
      }
      // A point exactly at the node is 0/0 in eq. 9; it is taken to pull nowhere.
      if (pass.squared_distance[s] == 0) continue;
      S[place[v]].second.push_back(p);
    }
    return S;
  }

  // Back to the edge of the perception cone where tropism has pulled the direction out of it.
  Point turned_back(Point n, Point own) const {
    const double half = problem.theta_rad / 2;
    if (half >= std::numbers::pi) return n;
    const double along = scalar_product(n, own);
    if (along >= std::cos(half)) return n;
    const Point across = minus(n, times(along, own));
    Point sideways = over(across, length(across));
    if (!(length(across) > 1e-8)) {  // straight backwards: any plane will do, this one is agreed
      const Point other = std::abs(own.x) < 0.9 ? Point{1, 0, 0} : Point{0, 0, 1};
      const Point normal = vector_product(own, other);
      sideways = over(normal, length(normal));
    }
    return plus(times(std::cos(half), own), times(std::sin(half), sideways));
  }

  bool stands_there(std::size_t v, Point position) const {
    for (std::size_t i = 0; i < tree.nodes.size(); ++i)
      if (tree.parents[i] == static_cast<int>(v) && tree.nodes[i].x == position.x &&
          tree.nodes[i].y == position.y && tree.nodes[i].z == position.z)
        return true;
    return false;
  }

  void grow_nodes() {
    new_nodes.clear();
    for (const auto& [v, S] : sets()) {
      const Point sum = problem.departures.sum_raw_vectors
                            ? sentence_before_equation_8_sum(tree.nodes[v], S)
                            : equation_9_sum(tree.nodes[v], S);
      if (problem.departures.normalise_before_tropism && length(sum) == 0) continue;  // 0/0
      const Point n = problem.departures.normalise_before_tropism
                          ? equation_10_as_printed(sum, problem.g)
                          : equation_10_corrected(sum, problem.g);
      if (!(length(n) > 0)) continue;  // nothing is left to follow: 0/0
      const Point towards = turned_back(n, tree.directions[v]);
      const Point position = equation_8(tree.nodes[v], problem.D, towards);
      if (!problem.departures.no_repeat_guard && stands_there(v, position)) continue;
      new_nodes.push_back(static_cast<int>(tree.nodes.size()));
      tree.nodes.push_back(position);
      tree.parents.push_back(static_cast<int>(v));
      tree.directions.push_back(towards);
    }
  }

  // The nodes that remove points after iteration i.
  std::vector<int> killers_of(int i) const {
    std::vector<int> killers;
    if (problem.departures.all_nodes_kill) {
      for (std::size_t v = 0; v < tree.nodes.size(); ++v) killers.push_back(static_cast<int>(v));
      return killers;
    }
    if (i == 0) {
      killers.push_back(0);
      if (problem.departures.crown_stem_kills)
        for (std::size_t v = 1; v < problem.start_nodes.size(); ++v)
          killers.push_back(static_cast<int>(v));
    }
    killers.insert(killers.end(), new_nodes.begin(), new_nodes.end());
    return killers;
  }

  void remove_points(const std::vector<int>& killers, double d_c, bool strictly,
                     bool in_cone_only) {
    std::vector<int> removed;
    for (std::size_t s = 0; s < flagged.size(); ++s) {
      if (flagged[s]) continue;
      const Point p = problem.attraction_points[s];
      for (int v : killers) {
        const double squared = equation_24(p, tree.nodes[static_cast<std::size_t>(v)]);
        const bool near = strictly ? squared < d_c * d_c : squared <= d_c * d_c;
        if (near &&
            (!in_cone_only || perceives(static_cast<std::size_t>(v), p, std::sqrt(squared))))
          flagged[s] = true;
      }
      if (flagged[s]) removed.push_back(static_cast<int>(s));
    }
    tree.removals.push_back(removed);
  }

  bool none_left() const {
    for (bool gone : flagged)
      if (!gone) return false;
    return true;
  }

  void remove_deferred(int i) {
    const DeferredRemoval& deferred = problem.deferred;
    const bool strictly = !deferred.compares_like_immediate_removal;
    const bool in_cone_only = !deferred.ignores_perception_angle;
    if (i == 0) {
      if (!deferred.first_pass_removes_nothing)
        remove_points(killers_of(0), problem.d_c(0), strictly, in_cone_only);
      return;
    }
    const double d_c = problem.d_c(deferred.uses_previous_kill_distance ? i - 1 : i);
    remove_points(killers_of(i - 1), d_c, strictly, in_cone_only);
  }

  void run() {
    const bool deferred = problem.deferred.enabled;
    for (int i = 0; i < problem.iterations; ++i) {
      if (deferred) {
        if (i > 0 && !problem.deferred.stop_test_follows_removal && none_left()) return;
        remove_deferred(i);
        if (i > 0 && problem.deferred.stop_test_follows_removal && none_left()) return;
      }
      associate();
      grow_nodes();
      if (new_nodes.empty()) return;
      if (!deferred) {
        remove_points(killers_of(i), problem.d_c(i), false, false);
        if (none_left()) return;
      }
    }
  }
};

}  // namespace

GrownTree grow(const GrowthProblem& problem) {
  Growth growth(problem);
  growth.run();
  return growth.tree;
}

}  // namespace phytobench::oracles::brzoska2019
