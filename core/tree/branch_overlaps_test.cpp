// SPDX-License-Identifier: MIT
#include "core/tree/branch_overlaps.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/geometry/segment_distance.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

/// Two branches on a common foot that cross above it, `apart` from each other.
Skeleton crossing_branches(double apart) {
  Skeleton tree({0, 0, 0});
  tree.append(0, {-1, 1, 0});     // 1
  tree.append(0, {1, 1, 0});      // 2
  tree.append(1, {1, 3, apart});  // 3, from the left to the right
  tree.append(2, {-1, 3, 0});     // 4, from the right to the left
  return tree;
}

Skeleton random_tree(std::uint64_t seed, int nodes) {
  CounterStream stream(seed, 0);
  Skeleton tree({0, 0, 0});
  for (int i = 1; i < nodes; ++i) {
    const auto parent = static_cast<std::int32_t>(stream.next_unit() * i);
    const double x = stream.next_between(-1, 1), y = stream.next_between(-1, 1);
    tree.append(parent, tree.position(parent) + Vector3{x, y, stream.next_between(-1, 1)});
  }
  return tree;
}

/// Way between two nodes, by marking all nodes below the first.
int way(const Skeleton& tree, std::int32_t a, std::int32_t b) {
  std::vector<int> steps(tree.node_count(), -1);
  int count = 0;
  for (std::int32_t n = a; n >= 0; n = tree.parents()[static_cast<std::size_t>(n)])
    steps[static_cast<std::size_t>(n)] = count++;
  count = 0;
  for (std::int32_t n = b;; n = tree.parents()[static_cast<std::size_t>(n)], ++count)
    if (steps[static_cast<std::size_t>(n)] >= 0) return count + steps[static_cast<std::size_t>(n)];
}

/// Of all four pairs of ends the nearest along the branches.
int least_way(const Skeleton& tree, std::int32_t a, std::int32_t b) {
  const std::int32_t c = tree.parents()[static_cast<std::size_t>(a)];
  const std::int32_t d = tree.parents()[static_cast<std::size_t>(b)];
  return std::min(std::min(way(tree, a, b), way(tree, a, d)),
                  std::min(way(tree, c, b), way(tree, c, d)));
}

TEST(BranchOverlaps, FindBranchesThatCross) {
  const std::vector<double> thin(5, 0.01);
  const auto overlaps = branch_overlaps(crossing_branches(0.0), thin);
  ASSERT_EQ(overlaps.size(), 1u);
  EXPECT_EQ(overlaps[0].lower_index, 3);
  EXPECT_EQ(overlaps[0].higher_index, 4);
  EXPECT_EQ(overlaps[0].edges_between, 2) << "down one branch and up the other";
  EXPECT_NEAR(overlaps[0].distance, 0.0, 1e-12);
}

TEST(BranchOverlaps, NeedRadiiThatReachAcross) {
  const Skeleton tree = crossing_branches(0.4);
  EXPECT_TRUE(branch_overlaps(tree, std::vector<double>(5, 0.05)).empty());
  EXPECT_EQ(branch_overlaps(tree, std::vector<double>(5, 0.11)).size(), 1u);
}

TEST(BranchOverlaps, AreNeverThoseOfNeighbours) {
  Skeleton straight({0, 0, 0});
  for (int y = 1; y < 10; ++y) straight.append(y - 1, {0, static_cast<double>(y), 0});
  EXPECT_TRUE(branch_overlaps(straight, std::vector<double>(10, 0.4)).empty());
  const auto thick = branch_overlaps(straight, std::vector<double>(10, 0.6));
  ASSERT_EQ(thick.size(), 7u) << "each edge with the next but one";
  for (const BranchOverlap& overlap : thick) EXPECT_EQ(overlap.edges_between, 1);
  EXPECT_TRUE(branch_overlaps(Skeleton({0, 0, 0}), std::vector<double>{1.0}).empty());
}

TEST(BranchOverlapsLaw, AreThoseOfAllPairs) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const Skeleton tree = random_tree(seed, 150);
    const std::vector<double> radii(tree.node_count(), 0.05);
    const auto line = [&](std::int32_t n) {
      return Segment{tree.position(tree.parents()[static_cast<std::size_t>(n)]), tree.position(n)};
    };
    std::size_t found = 0;
    const auto overlaps = branch_overlaps(tree, radii);
    for (std::int32_t a = 1; a < 150; ++a)
      for (std::int32_t b = a + 1; b < 150; ++b) {
        const double distance = std::sqrt(squared_distance(line(a), line(b)));
        const int between = least_way(tree, a, b);
        if (distance >= 0.1 || between == 0) continue;
        ASSERT_LT(found, overlaps.size());
        EXPECT_EQ(overlaps[found].lower_index, a);
        EXPECT_EQ(overlaps[found].higher_index, b);
        EXPECT_EQ(overlaps[found].edges_between, between);
        EXPECT_NEAR(overlaps[found].distance, distance, 1e-12);
        ++found;
      }
    EXPECT_EQ(found, overlaps.size());
    EXPECT_GT(found, 0u);
  }
}

TEST(BranchOverlaps, RadiiOfAnotherTreeAreRefused) {
  EXPECT_THROW(branch_overlaps(crossing_branches(0), std::vector<double>{1.0}), ContractViolation);
}

}  // namespace
}  // namespace phytobench
