// SPDX-License-Identifier: MIT
#include "reference/graph_presets.hpp"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/component_graph/component_graph_file.hpp"
#include "core/contract/errors.hpp"
#include "reference/tree_presets.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;

TEST(GraphPresets, AreThereForEveryExampleOfTheArticle) {
  std::set<std::string> names;
  for (const GraphPreset& preset : graph_presets()) names.insert(preset.name);
  for (const char* plant : {"bush", "dandelion", "weeping-willow"})
    EXPECT_TRUE(names.contains(plant)) << plant;
}

/// `list presets` shows both.
TEST(GraphPresets, CanBeReadSayWhatTheyAreAndShareNoNameWithATree) {
  std::set<std::string> names;
  for (const TreePreset& preset : tree_presets()) names.insert(preset.name);
  for (const GraphPreset& preset : graph_presets()) {
    EXPECT_NO_THROW(read_component_graph(preset.file)) << preset.name;
    EXPECT_GT(preset.summary.size(), 20u) << preset.name;
    EXPECT_TRUE(names.insert(preset.name).second) << preset.name;
  }
}

TEST(GraphPresets, AnUnknownNameGetsTheClosestOne) {
  EXPECT_EQ(graph_preset_file("bush").filename(), "bush.toml");
  try {
    graph_preset_file("bushes");
    ADD_FAILURE() << "an unknown preset was found";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("unknown preset 'bushes'; did you mean 'bush'?"));
    EXPECT_THAT(error.what(), testing::EndsWith("see phytobench list graphs"));
  }
}

}  // namespace
}  // namespace phytobench
