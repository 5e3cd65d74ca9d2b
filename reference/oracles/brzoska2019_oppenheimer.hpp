// SPDX-License-Identifier: MIT
// The recursive tree of [Brzoska2019] listing 1: its segments and leaves, and what the recursion
// comes to. Shares no code with core/, so that agreement means something.
#pragma once

#include <cmath>
#include <cstdint>

namespace phytobench::oracles::brzoska2019 {

struct RecursiveTree {
  std::int64_t segments = 0;
  std::int64_t leaves = 0;
  double total_size = 0;  // of all segments
};

struct RecursiveTreeProblem {
  double size = 1;          // of the first segment
  double stem_ratio = 1;    // "Transform Stem": the next size
  double branch_ratio = 1;  // "Transform Branch"
  int branches = 1;         // n of "repeat n times"
  double least_size = 0;    // below it a segment is "too small"
};

// Listing 1. Ratios below 1, or it never ends.
inline void draw_tree(const RecursiveTreeProblem& problem, double size, RecursiveTree& tree) {
  ++tree.segments;
  tree.total_size += size;
  if (size < problem.least_size) {
    ++tree.leaves;
    return;
  }
  draw_tree(problem, size * problem.stem_ratio, tree);
  for (int i = 0; i < problem.branches; ++i) draw_tree(problem, size * problem.branch_ratio, tree);
}

inline RecursiveTree listing_1(const RecursiveTreeProblem& problem) {
  RecursiveTree tree;
  draw_tree(problem, problem.size, tree);
  return tree;
}

// The same where "too small" is a number of levels k: 1 + (n + 1) + ... + (n + 1)^k segments.
inline std::int64_t leaves_of_equal_depth(int n, int k) {
  std::int64_t leaves = 1;
  for (int j = 0; j < k; ++j) leaves *= n + 1;
  return leaves;
}
inline std::int64_t segments_of_equal_depth(int n, int k) {
  std::int64_t segments = 0;
  for (int j = 0; j <= k; ++j) segments += leaves_of_equal_depth(n, j);
  return segments;
}

// Ways with a stem and b branch steps: (a + b over a) n^b of them, all of the size s r_s^a r_b^b.
// The ones that are not too small are forks, as sizes only shrink; each has n + 1 segments above
// it.
inline RecursiveTree closed_form_of_listing_1(const RecursiveTreeProblem& problem) {
  const auto large = [&](double size) { return size >= problem.least_size; };
  double forks = 0, size_above_forks = 0;
  for (int b = 0; large(problem.size * std::pow(problem.branch_ratio, b)); ++b) {
    double ways = std::pow(problem.branches, b);  // for a = 0
    for (int a = 0;; ++a) {
      const double size =
          problem.size * std::pow(problem.stem_ratio, a) * std::pow(problem.branch_ratio, b);
      if (!large(size)) break;
      forks += ways;
      size_above_forks +=
          ways * size * (problem.stem_ratio + problem.branches * problem.branch_ratio);
      ways = ways * (a + b + 1) / (a + 1);
    }
  }
  RecursiveTree tree;
  tree.segments = 1 + std::llround(forks) * (problem.branches + 1);
  tree.leaves = tree.segments - std::llround(forks);
  tree.total_size = problem.size + size_above_forks;
  return tree;
}

// For any tree of listing 1.
inline std::int64_t leaves_of_segments(std::int64_t segments, int n) {
  return (segments * n + 1) / (n + 1);
}

}  // namespace phytobench::oracles::brzoska2019
