// SPDX-License-Identifier: MIT
#include "core/colonization/resting_nodes.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

std::vector<NodeIndex> sorted(std::span<const NodeIndex> nodes) {
  std::vector<NodeIndex> all(nodes.begin(), nodes.end());
  std::sort(all.begin(), all.end());
  return all;
}

using Nodes = std::vector<NodeIndex>;

TEST(RestingNodes, AStartNodeRestsAfterItsFirstIterationWithoutChild) {
  RestingNodes rest(1, 2);
  EXPECT_EQ(sorted(rest.after_iteration(Nodes{1}, 1)), Nodes{0});
  EXPECT_EQ(sorted(rest.after_iteration(Nodes{}, 0)), (Nodes{1, 2}));
  EXPECT_EQ(rest.count(), 3u);
}

TEST(RestingNodes, AChildStartsTheCountAfresh) {
  RestingNodes rest(3, 1);
  EXPECT_TRUE(rest.after_iteration(Nodes{}, 0).empty());
  EXPECT_TRUE(rest.after_iteration(Nodes{}, 0).empty());
  EXPECT_TRUE(rest.after_iteration(Nodes{0}, 1).empty());
  EXPECT_TRUE(rest.after_iteration(Nodes{}, 0).empty());
  EXPECT_TRUE(rest.after_iteration(Nodes{}, 0).empty());
  EXPECT_EQ(sorted(rest.after_iteration(Nodes{}, 0)), (Nodes{0, 1}));
}

/// One counter per node, literally.
TEST(RestingNodesLaw, DoesAsOneCounterPerNodeDoes) {
  for (const std::int32_t limit : {1, 2, 3, 7}) {
    CounterStream stream(static_cast<std::uint64_t>(limit), 0);
    std::vector<std::int32_t> counters(20, 0);
    RestingNodes rest(limit, counters.size());
    std::size_t resting = 0;
    for (int iteration = 0; iteration < 40; ++iteration) {
      Nodes parents;
      const std::size_t known = counters.size();
      for (std::size_t i = 0; i < known; ++i)
        if (counters[i] < limit && known < 200 && stream.next_unit() < 0.5)
          parents.push_back(static_cast<NodeIndex>(i));
      Nodes expected;
      for (std::size_t i = 0; i < known; ++i) {
        const auto node = static_cast<NodeIndex>(i);
        const bool grew = std::find(parents.begin(), parents.end(), node) != parents.end();
        if (counters[i] >= limit) continue;
        counters[i] = grew ? 0 : counters[i] + 1;
        if (counters[i] == limit) expected.push_back(node);
      }
      counters.resize(known + parents.size(), 0);
      ASSERT_EQ(sorted(rest.after_iteration(parents, parents.size())), expected)
          << "limit " << limit << ", iteration " << iteration;
      resting += expected.size();
      ASSERT_EQ(rest.count(), resting);
    }
    EXPECT_GT(resting, 10u);
  }
}

TEST(RestingNodes, RefusesToRestAtOnce) {
  EXPECT_THROW(RestingNodes(0, 1), ContractViolation);
}

}  // namespace
}  // namespace phytobench
