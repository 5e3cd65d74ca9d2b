// SPDX-License-Identifier: MIT
#include "reference/oracles/brzoska2019_l_systems.hpp"

#include <algorithm>
#include <cstddef>

#include <gtest/gtest.h>

namespace phytobench::oracles::brzoska2019 {
namespace {

std::ptrdiff_t count(const std::string& word, char letter) {
  return std::count(word.begin(), word.end(), letter);
}

TEST(LiteralLSystems, ReplaceAllLettersAtOnce) {
  EXPECT_EQ(derive(equation_4(), 0), "b");
  EXPECT_EQ(derive(equation_4(), 5), "abaababa");
  EXPECT_EQ(derive(equation_4(), 7).size(), 21u);  // Fibonacci
}

TEST(LiteralLSystems, KeepALetterWithoutProduction) {
  EXPECT_EQ(derive({"ab", "ab", {{'a', "aa"}}}, 2), "aaaab");
}

TEST(LiteralLSystems, DoNotSeeNeighbours) {
  const LSystem any = equation_7();
  for (const char x : any.V)
    for (const char y : any.V) {
      const std::string pair{x, y};
      EXPECT_EQ(derive({any.V, pair, any.P}, 1), derive({any.V, pair.substr(0, 1), any.P}, 1) +
                                                     derive({any.V, pair.substr(1), any.P}, 1));
    }
}

TEST(LiteralLSystems, HaveTheClosedFormsOfTheirCounts) {
  int four = 1, two = 1;  // powers
  for (int n = 0; n <= 6; ++n, four *= 4, two *= 2) {
    EXPECT_EQ(count(derive(equation_5(), n), 'F'), four);
    const std::string word = derive(equation_6_corrected(), n);
    EXPECT_EQ(count(word, 'X'), four);
    EXPECT_EQ(count(word, 'F'), 9 * (four - two) / 2);
    EXPECT_EQ(count(word, '['), 4 * (four - 1) / 3);
    EXPECT_EQ(count(word, '['), count(word, ']'));
  }
}

TEST(LiteralLSystems, OnlyOneUsesALetterThatItsAlphabetLacks) {
  EXPECT_EQ(letters_outside_alphabet(equation_4()), 0);
  EXPECT_EQ(letters_outside_alphabet(equation_5()), 0);
  EXPECT_EQ(letters_outside_alphabet(equation_6_as_printed()), 6);  // axiom, p2, four times in p2
  EXPECT_EQ(letters_outside_alphabet(equation_6_corrected()), 0);
  EXPECT_EQ(letters_outside_alphabet(equation_7()), 0);
  EXPECT_EQ(equation_7().V.size(), 18u);
}

}  // namespace
}  // namespace phytobench::oracles::brzoska2019
