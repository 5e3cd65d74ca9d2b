// SPDX-License-Identifier: MIT
#include "core/contract/suggestion.hpp"

#include <gtest/gtest.h>

namespace phytobench {
namespace {

using Words = std::vector<std::string>;

TEST(DidYouMean, NamesTheNearestWord) {
  const Words words{"seed", "destiny", "density"};
  EXPECT_EQ(did_you_mean("desity", words), "; did you mean 'density'?");
  EXPECT_EQ(did_you_mean("densty", words), "; did you mean 'density'?");
  EXPECT_EQ(did_you_mean("sed", words), "; did you mean 'seed'?");
  EXPECT_EQ(did_you_mean("seed", words), "; did you mean 'seed'?");
}

TEST(DidYouMean, IsSilentIfNothingIsNear) {
  EXPECT_EQ(did_you_mean("xyzzy", Words{"seed", "density"}), "");
  EXPECT_EQ(did_you_mean("seed", {}), "");
}

TEST(DidYouMean, AllowsAThirdOfTheLettersAndOneMore) {
  EXPECT_EQ(did_you_mean("abc", Words{"abcde"}), "; did you mean 'abcde'?");
  EXPECT_EQ(did_you_mean("abc", Words{"abcdef"}), "");
}

TEST(DidYouMean, CountsMissingWrongAndSurplusLettersAlike) {
  for (const char* wrong : {"iteratons", "iterotions", "iterrations"})
    EXPECT_EQ(did_you_mean(wrong, Words{"radii", "iterations"}), "; did you mean 'iterations'?");
}

TEST(DidYouMean, TakesTheFirstOfEquallyNearWords) {
  EXPECT_EQ(did_you_mean("ab", Words{"ac", "ad"}), "; did you mean 'ac'?");
  EXPECT_EQ(did_you_mean("ab", Words{"ad", "ac"}), "; did you mean 'ad'?");
}

}  // namespace
}  // namespace phytobench
