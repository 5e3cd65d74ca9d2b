// SPDX-License-Identifier: MIT
#include "reference/oracles/liebemann2017_lsystems.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace phytobench::oracles::liebemann2017 {
namespace {

const D0LSystem swap{one_by_one("ABAB"), {{"A", {"B"}}, {"B", {"A"}}}};
const D0LSystem algae{{"b"}, {{"b", {"a"}}, {"a", {"a", "b"}}}};

TEST(LiebemannLettersLaw, WordsComeBackFromTheirText) {
  EXPECT_EQ(joined(one_by_one("F - F")), "F-F");
  EXPECT_EQ(joined(between_blanks(" al  br "), " "), "al br");
  EXPECT_EQ(between_blanks("al br").size(), 2u);
  EXPECT_TRUE(between_blanks(" ").empty());
}

TEST(LiebemannD0LLaw, APartOfAWordIsDerivedAsOnItsOwn) {
  for (const D0LSystem& G : {equation_2_1(), equation_2_6(), figure_2_5a(), figure_2_5b()}) {
    const Letters whole = derive_in_parallel(G, 3);
    const Letters half = derive_in_parallel(G, 2);
    for (std::size_t cut = 0; cut <= half.size(); cut += 3) {
      const auto middle = half.begin() + static_cast<std::ptrdiff_t>(cut);
      const std::string left = joined(derive_in_parallel({{half.begin(), middle}, G.P}, 1));
      const std::string right = joined(derive_in_parallel({{middle, half.end()}, G.P}, 1));
      EXPECT_EQ(left + right, joined(whole));
    }
  }
}

TEST(LiebemannD0LLaw, ALetterWithoutProductionStays) {
  EXPECT_EQ(joined(derive_in_parallel({one_by_one("abC"), {{"a", {"a", "a"}}}}, 2)), "aaaabC");
  EXPECT_EQ(joined(derive_in_parallel({one_by_one("ab"), {{"a", {}}}}, 1)), "b");
}

TEST(LiebemannD0L, GrowsAnabaenaAsPrinted) {
  const char* words[] = {"ar",
                         "al br",
                         "bl ar ar",
                         "al al br al br",
                         "bl ar bl ar ar bl ar ar",
                         "al al br al al br al br al al br al br"};
  for (int n = 0; n < 6; ++n)
    EXPECT_EQ(joined(derive_in_parallel(equation_2_1(), n), " "), words[n]);
}

TEST(LiebemannD0L, AnabaenaHasFibonacciLengths) {
  const std::size_t lengths[] = {1, 2, 3, 5, 8, 13, 21, 34, 55, 89, 144, 233, 377};
  for (int n = 0; n <= 12; ++n) {
    const Letters word = derive_in_parallel(equation_2_1(), n);
    EXPECT_EQ(word.size(), lengths[n]);
    const auto big = std::count_if(word.begin(), word.end(),
                                   [](const std::string& cell) { return cell[0] == 'a'; });
    if (n > 0) EXPECT_EQ(static_cast<std::size_t>(big), lengths[n - 1]);
  }
}

TEST(LiebemannInPlace, RuleAfterRuleIsNoDerivation) {
  EXPECT_EQ(joined(derive_in_parallel(swap, 1)), "BABA");
  EXPECT_EQ(joined(derive_rule_after_rule(swap, 1)), "AAAA");
  EXPECT_EQ(joined(derive_in_parallel(algae, 1)), "a");
  EXPECT_EQ(joined(derive_rule_after_rule(algae, 1)), "ab");  // b -> a -> ab in one derivation
}

TEST(LiebemannInPlace, TheOrderOfTheRulesMattersThenOnly) {
  const D0LSystem turned{algae.omega, {algae.P[1], algae.P[0]}};
  for (int n = 0; n < 6; ++n)
    EXPECT_EQ(derive_in_parallel(turned, n), derive_in_parallel(algae, n));
  EXPECT_EQ(joined(derive_rule_after_rule(turned, 2)), "aa");
  EXPECT_EQ(joined(derive_rule_after_rule(algae, 2)), "abab");
}

TEST(LiebemannInPlace, OneRuleHidesTheDefect) {
  // The systems of figures 2.4 and 2.5 have one production each: every way gives the same.
  for (const D0LSystem& G : {equation_2_6(), figure_2_5a(), figure_2_5b()})
    EXPECT_EQ(derive_rule_after_rule(G, 3), derive_in_parallel(G, 3));
  EXPECT_NE(derive_rule_after_rule(equation_2_1(), 3), derive_in_parallel(equation_2_1(), 3));
}

TEST(LiebemannInPlace, LeftToRightIsADerivationIfItStepsOverWhatItWrote) {
  for (const D0LSystem& G : {swap, algae, equation_2_1(), equation_2_6(), figure_2_5a()})
    for (int n = 0; n < 4; ++n)
      EXPECT_EQ(derive_left_to_right(G, n, GoOn::behind_the_successor, 100000),
                derive_in_parallel(G, n));
}

TEST(LiebemannInPlace, LeftToRightWithoutSteppingOverIsNone) {
  // a -> ab, and then this b -> a.
  const D0LSystem from_a{{"a"}, algae.P};
  EXPECT_EQ(joined(*derive_left_to_right(from_a, 1, GoOn::at_the_next_letter, 100)), "aa");
  EXPECT_EQ(joined(derive_in_parallel(from_a, 1)), "ab");
  // F -> FF never comes to an end.
  EXPECT_EQ(derive_left_to_right({{"F"}, {{"F", {"F", "F"}}}}, 1, GoOn::at_the_next_letter, 1000),
            std::nullopt);
}

}  // namespace
}  // namespace phytobench::oracles::liebemann2017
