// SPDX-License-Identifier: MIT
#include "core/tree/curve_reduction.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/random/counter_stream.hpp"
#include "core/tree/branches.hpp"
#include "core/tree/habit.hpp"
#include "core/tree/test_angles.hpp"

namespace phytobench {
namespace {

using enum ReductionOrder;

/// Unit edges that turn by the same angle at each node.
Skeleton arc(int edges, double turn_deg) {
  Skeleton tree{Vector3{}};
  for (int i = 0; i < edges; ++i) {
    const double heading = i * turn_deg * degree;
    tree.append(i, tree.position(i) + Vector3{std::sin(heading), std::cos(heading), 0});
  }
  return tree;
}

Skeleton random_upward_tree(std::uint64_t seed) {
  CounterStream stream(seed, 0);
  Skeleton tree{Vector3{}};
  for (std::int32_t i = 1; i < 300; ++i) {
    const auto any = static_cast<std::int32_t>(stream.next_unit() * i);
    const std::int32_t parent = stream.next_unit() < 0.8 ? i - 1 : any;
    const Vector3 step{0.3 * stream.next_unit(), 1.0, 0.3 * stream.next_unit()};
    tree.append(parent, tree.position(parent) + step);
  }
  return tree;
}

CurveReduction below(double degrees, ReductionOrder order) {
  return {.cosine_above = std::cos(degrees * degree), .order = order};
}

std::size_t kept(const Skeleton& tree, double degrees, ReductionOrder order) {
  return reduce_curves(tree, below(degrees, order)).skeleton.node_count();
}

TEST(CurveReduction, OfAnArcDependsOnTheOrder) {
  struct Case {
    double turn, threshold;
    std::size_t root_to_tip, simultaneous;
  };
  for (const auto& [turn, threshold, sequential, at_once] :
       {Case{5, 11, 10, 2}, Case{5, 21, 6, 2}, Case{10, 31, 7, 2}, Case{2, 11, 5, 2},
        Case{5, 6, 19, 2}, Case{5, 4, 37, 37}}) {
    EXPECT_EQ(kept(arc(36, turn), threshold, root_to_tip), sequential) << turn << " " << threshold;
    EXPECT_EQ(kept(arc(36, turn), threshold, simultaneous), at_once) << turn << " " << threshold;
  }
}

// The chord of k edges makes the angle (k + 1) t / 2 with the next edge.
TEST(CurveReductionLaw, FromRootToTipMergesAsManyEdgesAsTheChordAllows) {
  for (const double turn : {1.0, 3.0, 7.0, 11.0})
    for (double threshold = 0.311; threshold < 80.0; threshold += 1.373) {
      const double merged = std::max(1.0, std::ceil(2.0 * threshold / turn - 1.0));
      const auto expected = static_cast<std::size_t>(std::ceil(36.0 / merged)) + 1;
      ASSERT_EQ(kept(arc(36, turn), threshold, root_to_tip), expected) << turn << ", " << threshold;
    }
}

TEST(CurveReduction, MakesOneEdgeOfAStraightBranch) {
  Skeleton tree{Vector3{}};
  for (std::int32_t i = 0; i < 9; ++i) tree.append(i, {0.1 * (i + 1), 0.3 * (i + 1), 0});
  for (const ReductionOrder order : {simultaneous, root_to_tip}) {
    const ReducedSkeleton reduced = reduce_curves(tree, below(1.0, order));
    EXPECT_EQ(reduced.node_before, (std::vector<std::int32_t>{0, 9}));
    EXPECT_EQ(reduced.skeleton.positions()[1], tree.positions()[9]);
  }
}

// Rounding gives straight edges cosines above 1.
TEST(CurveReduction, ThatAsksForMoreThanStraightRemovesNothing) {
  for (const Skeleton& tree : {arc(36, 0.0), random_upward_tree(1)})
    for (const ReductionOrder order : {simultaneous, root_to_tip}) {
      const ReducedSkeleton reduced = reduce_curves(tree, {.cosine_above = 1.0, .order = order});
      EXPECT_EQ(tree_hash(reduced.skeleton), tree_hash(tree));
    }
}

TEST(CurveReduction, KeepsNodesAtAnEdgeWithoutLength) {
  Skeleton tree{Vector3{}};
  tree.append(0, {0, 1, 0});
  tree.append(1, {0, 1, 0});
  tree.append(2, {0, 2, 0});
  for (const ReductionOrder order : {simultaneous, root_to_tip})
    EXPECT_EQ(kept(tree, 180.0, order), 4u);
}

TEST(CurveReductionLaw, LeavesRootTipsAndForksAndHowTheyHangTogether) {
  for (std::uint64_t seed = 0; seed < 20; ++seed)
    for (const ReductionOrder order : {simultaneous, root_to_tip}) {
      const Skeleton tree = random_upward_tree(seed);
      const ReducedSkeleton reduced = reduce_curves(tree, below(12.0, order));
      ASSERT_LT(reduced.skeleton.node_count(), tree.node_count());
      EXPECT_EQ(tip_count(reduced.skeleton), tip_count(tree));
      EXPECT_EQ(branching_count(reduced.skeleton), branching_count(tree));
      const ChildLists children(tree), fewer(reduced.skeleton);
      for (std::int32_t i = 0; i < static_cast<std::int32_t>(tree.node_count()); ++i) {
        const std::int32_t now = reduced.node_after[static_cast<std::size_t>(i)];
        if (now == ReducedSkeleton::removed) {
          ASSERT_EQ(children.of(i).size(), 1u);
          continue;
        }
        ASSERT_EQ(reduced.node_before[static_cast<std::size_t>(now)], i);
        ASSERT_EQ(reduced.skeleton.position(now), tree.position(i));
        ASSERT_EQ(fewer.of(now).size(), children.of(i).size());
        // The nearest ancestor that is left is the new parent.
        std::int32_t ancestor =
            i == 0 ? Skeleton::no_parent : tree.parents()[static_cast<std::size_t>(i)];
        while (ancestor >= 0 && reduced.node_after[static_cast<std::size_t>(ancestor)] < 0)
          ancestor = tree.parents()[static_cast<std::size_t>(ancestor)];
        const std::int32_t parent = reduced.skeleton.parents()[static_cast<std::size_t>(now)];
        ASSERT_EQ(parent < 0 ? parent : reduced.node_before[static_cast<std::size_t>(parent)],
                  ancestor);
      }
    }
}

TEST(CurveReductionLaw, AtOnceRemovesWhatAnyLargerThresholdRemoves) {
  const Skeleton tree = random_upward_tree(7);
  std::size_t last = tree.node_count();
  for (const double degrees : {0.0, 5.0, 10.0, 20.0, 90.0, 180.0}) {
    const std::size_t now = kept(tree, degrees, simultaneous);
    EXPECT_LE(now, last);
    last = now;
  }
  EXPECT_EQ(last, tip_count(tree) + branching_count(tree) +
                      (ChildLists(tree).of(0).size() == 1 ? 1u : 0u));
}

TEST(CurveReduction, RefusesWhatIsNoCosine) {
  EXPECT_THROW(reduce_curves(arc(3, 1.0), {.cosine_above = 1.5}), ContractViolation);
  EXPECT_THROW(reduce_curves(arc(3, 1.0), {.cosine_above = std::nan("")}), ContractViolation);
}

}  // namespace
}  // namespace phytobench
