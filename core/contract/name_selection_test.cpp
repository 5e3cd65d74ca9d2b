// SPDX-License-Identifier: MIT
#include "core/contract/name_selection.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;
using Names = std::vector<std::string>;
using Places = std::vector<std::size_t>;

const Names names{"tree/mesh", "overlap/sweep", "overlap/all_pairs", "tree/leaf"};

Places selected(const Names& patterns) {
  return selected_names(names, patterns, {"thing", "phytobench list things"});
}

template <class Error>
std::string message_for(const Names& patterns) {
  try {
    selected(patterns);
  } catch (const Error& error) {
    return error.what();
  }
  return "no such error";
}

TEST(NameSelection, TakesAllWithoutPatterns) {
  EXPECT_EQ(selected({}), (Places{0, 1, 2, 3}));
}

TEST(NameSelection, TakesNamesAndGlobsInTheOrderOfTheNames) {
  EXPECT_EQ(selected({"tree/leaf", "tree/mesh"}), (Places{0, 3}));
  EXPECT_EQ(selected({"overlap/*"}), (Places{1, 2}));
  EXPECT_EQ(selected({"*ee*"}), (Places{0, 1, 3}));
  EXPECT_EQ(selected({"*ee*ea*"}), (Places{3})) << "a star matches a slash, too";
  EXPECT_EQ(selected({"tree/????"}), (Places{0, 3}));
  EXPECT_EQ(selected({"tree/*", "*/mesh"}), (Places{0, 3})) << "each only once";
}

TEST(NameSelection, SaysWhichNameWasMeant) {
  EXPECT_EQ(message_for<InputError>({"tree/*", "overlap/swep"}),
            "unknown thing 'overlap/swep'; did you mean 'overlap/sweep'? (phytobench list things)");
  EXPECT_THAT(message_for<InputError>({""}), HasSubstr("unknown thing ''"));
}

TEST(NameSelection, RefusesAGlobThatMatchesNothingBesideOneThatDoes) {
  EXPECT_EQ(message_for<NothingSelected>({"tree/*", "stand/*"}),
            "no thing matches 'stand/*'; see phytobench list things");
  EXPECT_THROW(selected_names({}, Names{"*"}, {"thing", "a list"}), NothingSelected);
  EXPECT_TRUE(selected_names({}, {}, {"thing", "a list"}).empty());
}

}  // namespace
}  // namespace phytobench
