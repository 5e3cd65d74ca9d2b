// SPDX-License-Identifier: MIT
#include "reference/tree_presets.hpp"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/colonization/tree_parameters_file.hpp"
#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;

TEST(TreePresets, AreThereForEveryPublishedFigureWithKnownParameters) {
  std::set<std::string> names;
  for (const TreePreset& preset : tree_presets()) names.insert(preset.name);
  for (const char* figure : {"figure-40-left",   "figure-40-right", "figure-41-left",
                             "figure-41-middle", "figure-41-right", "figure-42-left",
                             "figure-42-right",  "figure-43-left",  "figure-43-middle",
                             "figure-43-right",  "figure-44-left",  "figure-44-middle",
                             "figure-44-right",  "figure-45-left",  "figure-45-right",
                             "figure-46-left",   "figure-47-left",  "figure-47-right",
                             "figure-51",        "figure-52",       "birch"})
    EXPECT_TRUE(names.contains(figure)) << figure;
}

TEST(TreePresets, CanBeReadAndSayWhatTheyAre) {
  std::set<std::string> names;
  for (const TreePreset& preset : tree_presets()) {
    EXPECT_NO_THROW(read_tree_parameters(preset.file)) << preset.name;
    EXPECT_GT(preset.summary.size(), 20u) << preset.name;
    EXPECT_TRUE(names.insert(preset.name).second) << preset.name;
  }
}

TEST(TreePresets, AFigureWithoutAPartIsItsLeftOne) {
  EXPECT_EQ(tree_preset_file("figure-40"), tree_preset_file("figure-40-left"));
  EXPECT_EQ(tree_preset_file("figure-51").filename(), "figure-51.toml");
}

TEST(TreePresets, AnUnknownNameGetsTheClosestOne) {
  try {
    tree_preset_file("figure-52-left-");
    ADD_FAILURE() << "an unknown preset was found";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("unknown preset 'figure-52-left-'; did you mean 'figure-"));
  }
}

// The bending order of figure 43 is what its stem and iterations give (ambiguity A4).
TEST(TreePresets, Figure43BendsFromOrder25WhicheverWayItIsSaid) {
  TreeParameters parameters = parse_tree_parameters(
      "growth.iterations = 30\nstem.length = 1.8\npendulous.begin = 0.7\n", "x.toml");
  EXPECT_EQ(parameters.plant.pendulous.first_order, 25);
  EXPECT_EQ(read_tree_parameters(tree_preset_file("figure-43")).plant.pendulous.first_order, 25);
}

}  // namespace
}  // namespace phytobench
