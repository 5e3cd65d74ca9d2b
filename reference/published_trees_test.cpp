// SPDX-License-Identifier: MIT
// Trees of published figures, to the last bit: no new option may change what grows without it.
#include <gtest/gtest.h>

#include "core/colonization/growth.hpp"
#include "core/colonization/tree_parameters_file.hpp"
#include "core/nearest_node/engine_registry.hpp"
#include "reference/tree_presets.hpp"

namespace phytobench {
namespace {

Seedling seedling_of(const char* preset) {
  return make_seedling(read_tree_parameters(tree_preset_file(preset)));
}

std::string grown_hash(const Seedling& seedling) {
  const auto engine = engine_named("node_driven").create();
  return tree_hash(grow_crown(seedling, *engine).skeleton);
}

TEST(PublishedTrees, GrowAsTheyDidBeforeThereWereLimits) {
  EXPECT_EQ(grown_hash(seedling_of("figure-40-left")), "500fa216eb9f6dc4");
  EXPECT_EQ(grown_hash(seedling_of("figure-43-middle")), "558137ba7fd2807e");
  EXPECT_EQ(grown_hash(seedling_of("figure-46-left")), "324af5e10a8d975b");
}

TEST(PublishedTrees, GrowAlikeUnderLimitsThatTheyNeverReach) {
  Seedling seedling = seedling_of("figure-40-left");
  seedling.growth.limits = {
      .most_children = 1000, .most_branch_depth = 1000, .rest_iterations = 1000};
  EXPECT_EQ(grown_hash(seedling), "500fa216eb9f6dc4");
}

}  // namespace
}  // namespace phytobench
