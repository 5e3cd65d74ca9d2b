// SPDX-License-Identifier: MIT
#include "reference/oracles/liebemann2017_space_colonization.hpp"

#include <cmath>

namespace phytobench::oracles::liebemann2017 {

Point plus(Point a, Point b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
Point minus(Point a, Point b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Point times(double s, Point a) {
  return {s * a.x, s * a.y, s * a.z};
}
double norm(Point a) {
  return std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z);
}

namespace {

Point over(Point a, double s) {
  return {a.x / s, a.y / s, a.z / s};
}

bool within(double distance, double radius, Boundary boundary) {
  return boundary == Boundary::within ? distance <= radius : distance < radius;
}

struct Colonization {
  const ColonizationProblem& problem;
  ColonizedTree tree;
  std::vector<bool> removed;
  std::vector<int> successors;                 // per node, how many
  std::vector<std::vector<std::size_t>> S_of;  // S(v)
  bool changed = false;                        // in this iteration

  explicit Colonization(const ColonizationProblem& p) : problem(p), removed(p.S.size(), false) {
    add(p.root, -1, 0);
  }

  void add(Point position, int predecessor, int Z) {
    tree.nodes.push_back(position);
    tree.predecessors.push_back(predecessor);
    tree.Z.push_back(Z);
    successors.push_back(0);
    tree.born.push_back(tree.iterations);
    tree.no_grow.push_back(0);
  }

  // Step 1. Whether any S(v) has a point.
  bool find_influences() {
    S_of.assign(tree.nodes.size(), {});
    bool any = false;
    for (std::size_t s = 0; s < problem.S.size(); ++s) {
      if (removed[s]) continue;
      int nearest = -1;
      double shortest = 0;
      for (std::size_t v = 0; v < tree.nodes.size(); ++v) {
        if (tree.no_grow[v] >= problem.max_NG) continue;
        ++tree.distances_of_step_1;
        const double distance = norm(minus(problem.S[s], tree.nodes[v]));
        if (nearest >= 0 && distance >= shortest) continue;
        nearest = static_cast<int>(v);
        shortest = distance;
      }
      if (nearest < 0 || !within(shortest, problem.d_i, problem.boundary)) continue;
      S_of[static_cast<std::size_t>(nearest)].push_back(s);
      any = true;
    }
    return any;
  }

  // Eq. 3.3.
  Point sum_of_directions(std::size_t v) const {
    Point n;
    for (const std::size_t s : S_of[v]) {
      const Point way = minus(problem.S[s], tree.nodes[v]);
      if (norm(way) == 0 && problem.zero_over_zero == ZeroOverZero::skipped) continue;
      n = plus(n, over(way, norm(way)));
    }
    return n;
  }

  bool has_successor_at(std::size_t v, Point position) const {
    for (std::size_t w = 0; w < tree.nodes.size(); ++w)
      if (tree.predecessors[w] == static_cast<int>(v) && tree.nodes[w] == position) return true;
    return false;
  }

  // Step 2 for one node. False: the arithmetic is undefined.
  bool grow(std::size_t v) {
    if (successors[v] >= problem.max_grad) return true;
    const int Z = successors[v] == 0 ? tree.Z[v] : 1 + tree.Z[v];
    if (Z > problem.max_Z) return true;
    const double D =
        problem.weighted_growth ? weighted_step(problem.D, tree.Z[v], problem.max_Z) : problem.D;
    if (!std::isfinite(D)) return false;
    const Point n = equation_3_2(sum_of_directions(v), problem.T, problem.tropism);
    if (!std::isfinite(norm(n))) return problem.zero_over_zero == ZeroOverZero::skipped;
    const Point position = plus(tree.nodes[v], times(D, n));  // eq. 3.1
    if (problem.same_successor_again == SameSuccessorAgain::rejected &&
        has_successor_at(v, position))
      return true;
    ++successors[v];
    add(position, static_cast<int>(v), Z);
    return true;
  }

  // Step 2. False: the arithmetic is undefined.
  bool grow_all() {
    for (std::size_t v = 0; v < S_of.size(); ++v) {
      const std::size_t before = tree.nodes.size();
      if (!S_of[v].empty() && !grow(v)) return false;
      const bool grew = tree.nodes.size() > before;
      const bool counts = !grew && tree.no_grow[v] < problem.max_NG;
      tree.no_grow[v] = grew ? 0 : tree.no_grow[v] + (counts ? 1 : 0);
      changed = changed || grew || (counts && problem.max_NG != ColonizationProblem::unlimited);
    }
    return true;
  }

  // Step 3.
  void remove_points() {
    for (std::size_t s = 0; s < problem.S.size(); ++s)
      for (std::size_t v = 0; v < tree.nodes.size() && !removed[s]; ++v) {
        ++tree.distances_of_step_3;
        if (!within(norm(minus(problem.S[s], tree.nodes[v])), problem.d_k, problem.boundary))
          continue;
        removed[s] = true;
        changed = true;
      }
  }

  bool all_removed() const {
    for (const bool gone : removed)
      if (!gone) return false;
    return true;
  }

  Stop run() {
    for (;;) {
      if (all_removed()) return Stop::all_points_removed;
      if (tree.iterations >= problem.most_iterations) return Stop::most_iterations;
      if (!find_influences()) return Stop::no_node_in_reach;
      ++tree.iterations;
      changed = false;
      if (!grow_all()) return Stop::undefined;
      remove_points();
      if (problem.stop_at_standstill && !changed) return Stop::standstill;
    }
  }
};

}  // namespace

Point equation_3_2(Point sum, Point T, Tropism tropism) {
  const Point n = tropism == Tropism::added_to_the_sum ? sum : over(sum, norm(sum));
  return over(plus(n, T), norm(plus(n, T)));
}

double weighted_step(double D, int Z, int max_Z) {
  if (max_Z <= 0 || max_Z == ColonizationProblem::unlimited)
    return std::numeric_limits<double>::quiet_NaN();
  return D * (2 - static_cast<double>(Z) / max_Z);
}

int nodes_towards_one_point(double L, double d_k, double D, Boundary boundary) {
  int nodes = 0;
  while (!within(L - nodes * D, d_k, boundary)) ++nodes;
  return nodes;
}

ColonizedTree colonize(const ColonizationProblem& problem) {
  Colonization colonization(problem);
  const Stop stop = colonization.run();
  ColonizedTree tree = colonization.tree;
  tree.stop = stop;
  for (std::size_t s = 0; s < problem.S.size(); ++s)
    if (!colonization.removed[s]) tree.left.push_back(s);
  return tree;
}

}  // namespace phytobench::oracles::liebemann2017
