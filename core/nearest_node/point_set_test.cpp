// SPDX-License-Identifier: MIT
#include "core/nearest_node/point_set.hpp"

#include <limits>
#include <set>

#include <gtest/gtest.h>

#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

std::vector<PointIndex> elements(const PointSet& points) {
  std::vector<PointIndex> found;
  points.append_to(found);
  return found;
}

PointSet set_of(std::size_t count, const std::vector<PointIndex>& members) {
  PointSet points;
  points.reset(count);
  for (const PointIndex point : members) points.insert(point);
  return points;
}

TEST(PointSet, IsEmptyAtFirst) {
  const PointSet never_reset;
  EXPECT_EQ(never_reset.size(), 0u);
  EXPECT_EQ(never_reset.bytes(), 0u);
  EXPECT_TRUE(elements(never_reset).empty());
  for (const std::size_t count : {0u, 1u, 63u, 64u, 65u, 1000u}) {
    const PointSet points = set_of(count, {});
    EXPECT_EQ(points.size(), 0u) << count;
    EXPECT_TRUE(elements(points).empty()) << count;
    for (std::size_t i = 0; i < count; ++i)
      EXPECT_FALSE(points.contains(static_cast<PointIndex>(i))) << i << " of " << count;
  }
}

TEST(PointSet, HoldsWhatWasInsertedAlone) {
  for (const PointIndex member : {0, 1, 31, 32, 62, 63, 64, 65, 127, 128, 198, 199}) {
    const PointSet points = set_of(200, {member});
    for (PointIndex i = 0; i < 200; ++i) EXPECT_EQ(points.contains(i), i == member) << member;
    EXPECT_EQ(points.size(), 1u);
    EXPECT_EQ(elements(points), std::vector<PointIndex>{member});
  }
}

TEST(PointSet, WalksAscendingWhateverTheOrderOfInsertion) {
  const PointSet points = set_of(300, {299, 64, 0, 128, 63, 65, 1, 127});
  EXPECT_EQ(elements(points), (std::vector<PointIndex>{0, 1, 63, 64, 65, 127, 128, 299}));
}

TEST(PointSet, AppendsToWhatIsThere) {
  std::vector<PointIndex> found{7, 5};
  set_of(100, {70, 2}).append_to(found);
  EXPECT_EQ(found, (std::vector<PointIndex>{7, 5, 2, 70}));
}

TEST(PointSet, InsertingAndErasingTwiceChangesNothingMore) {
  PointSet points = set_of(100, {64, 64});
  EXPECT_EQ(points.size(), 1u);
  points.erase(64);
  points.erase(64);
  EXPECT_EQ(points.size(), 0u);
  points.erase(63);
  EXPECT_EQ(points.size(), 0u) << "what was never there came in by being erased";
}

TEST(PointSet, ErasingLeavesTheOthers) {
  PointSet points = set_of(200, {62, 63, 64, 65, 190});
  points.erase(63);
  points.erase(64);
  EXPECT_EQ(elements(points), (std::vector<PointIndex>{62, 65, 190}));
}

TEST(PointSet, ClearKeepsItsPlaceForPoints) {
  PointSet points = set_of(130, {0, 64, 129});
  const std::size_t bytes = points.bytes();
  points.clear();
  EXPECT_EQ(points.size(), 0u);
  EXPECT_EQ(points.bytes(), bytes);
  points.insert(129);
  EXPECT_EQ(elements(points), std::vector<PointIndex>{129});
}

TEST(PointSet, ResetForgetsAtAnySize) {
  PointSet points = set_of(500, {0, 64, 499});
  for (const std::size_t count : {500u, 70u, 1000u}) {
    points.reset(count);
    EXPECT_EQ(points.size(), 0u) << count;
    for (std::size_t i = 0; i < count; ++i) points.insert(static_cast<PointIndex>(i));
    EXPECT_EQ(points.size(), count);
  }
}

TEST(PointSet, TakesOneBitPerPoint) {
  for (const std::size_t count : {0u, 1u, 64u, 65u, 1000000u})
    EXPECT_EQ(set_of(count, {}).bytes(), (count + 63) / 64 * 8) << count;
}

// The word of a large index must not be computed in fewer bits than an index has.
TEST(PointSet, HoldsTheLargestIndexThereIs) {
  constexpr PointIndex last = std::numeric_limits<PointIndex>::max();
  PointSet points = set_of(static_cast<std::size_t>(last) + 1, {last, 0, last - 64});
  EXPECT_TRUE(points.contains(last));
  EXPECT_FALSE(points.contains(last - 1));
  EXPECT_EQ(elements(points), (std::vector<PointIndex>{0, last - 64, last}));
}

TEST(PointSetLaw, BehavesAsASetDoes) {
  CounterStream stream(31, 0);
  constexpr std::size_t count = 333;
  PointSet points = set_of(count, {});
  std::set<PointIndex> expected;
  for (int step = 0; step < 5000; ++step) {
    const auto point = static_cast<PointIndex>(stream.next_unit() * count);
    if (stream.next_unit() < 0.5) {
      points.insert(point);
      expected.insert(point);
    } else {
      points.erase(point);
      expected.erase(point);
    }
    ASSERT_EQ(points.contains(point), expected.contains(point)) << "step " << step;
    ASSERT_EQ(points.size(), expected.size()) << "step " << step;
    if (step % 100 == 0)
      ASSERT_EQ(elements(points), std::vector<PointIndex>(expected.begin(), expected.end()));
  }
  EXPECT_GT(expected.size(), 100u);
}

}  // namespace
}  // namespace phytobench
