// SPDX-License-Identifier: MIT
#include "core/nearest_node/engine_registry.hpp"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;

/// The message of the InputError that asking for an engine ends with.
std::string naming_error(std::string_view name) {
  try {
    engine_named(name);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(EngineRegistry, HoldsTheEnginesOfTheThesis) {
  std::set<std::string_view> names;
  for (const EngineDescriptor* engine : all_engines()) names.insert(engine->name);
  for (const char* name : {"euclidean_scan", "squared_scan", "sorted_axes", "voxel_grid"})
    EXPECT_TRUE(names.contains(name)) << name;
}

TEST(EngineRegistry, NamesAreUniqueAndFileNames) {
  std::set<std::string_view> names;
  for (const EngineDescriptor* engine : all_engines()) {
    EXPECT_TRUE(names.insert(engine->name).second) << engine->name << " stands there twice";
    EXPECT_FALSE(engine->name.empty());
    EXPECT_EQ(engine->name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_"),
              std::string_view::npos)
        << engine->name;
  }
  EXPECT_GE(names.size(), 4u);
}

TEST(EngineRegistry, EveryEngineSaysWhatItIsAndWhereItComesFrom) {
  for (const EngineDescriptor* engine : all_engines()) {
    EXPECT_FALSE(engine->summary.empty()) << engine->name;
    EXPECT_TRUE(engine->summary.ends_with('.')) << engine->name << ": one sentence";
    EXPECT_FALSE(engine->source.empty()) << engine->name;
    EXPECT_EQ(engine->built(), engine->missing_package.empty()) << engine->name;
  }
}

TEST(EngineRegistry, BuiltEnginesAreFoundAndMade) {
  for (const EngineDescriptor* engine : all_engines()) {
    if (engine->built()) {
      EXPECT_EQ(&engine_named(engine->name), engine);
      EXPECT_TRUE(engine->create() != nullptr) << engine->name;
    } else {
      EXPECT_THAT(naming_error(engine->name), HasSubstr(std::string(engine->missing_package)));
    }
  }
}

TEST(EngineRegistry, UnknownNameIsAnInputErrorThatListsTheEngines) {
  for (const char* name : {"", "kd_treee", "Voxel_Grid"}) {
    const std::string message = naming_error(name);
    EXPECT_THAT(message, HasSubstr("'" + std::string(name) + "'"));
    for (const EngineDescriptor* engine : all_engines())
      EXPECT_THAT(message, HasSubstr(std::string(engine->name)));
  }
}

TEST(KnownEngineNames, AreSeparatedByCommasInTheOrderOfTheList) {
  std::string expected;
  for (const EngineDescriptor* engine : all_engines())
    expected += (expected.empty() ? "" : ", ") + std::string(engine->name);
  EXPECT_EQ(known_engine_names(), expected);
}

}  // namespace
}  // namespace phytobench
