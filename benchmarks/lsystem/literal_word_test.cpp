// SPDX-License-Identifier: MIT
#include "benchmarks/lsystem/literal_word.hpp"

#include <gtest/gtest.h>

#include "core/lsystem/derive.hpp"
#include "core/lsystem/read_lsystem.hpp"

namespace phytobench {
namespace {

LSystem plant() {
  return parse_lsystem("axiom: XY\nX -> F-[[X]+X]+F[+FX]-X\nF -> FF\nY -> *\n", "plant");
}

Word derived(const LSystem& system, int steps) {
  DeriveOptions options;
  options.steps = steps;
  return derive(system, options);
}

TEST(LiteralWord, AcceptsWhatIsDerived) {
  for (int steps = 0; steps <= 6; ++steps)
    EXPECT_EQ(objection_to_letters(plant(), steps, derived(plant(), steps)), "") << steps;
}

TEST(LiteralWord, SeesAnotherLetterAndAnotherOrder) {
  const LSystem system = plant();
  Word word = derived(system, 4);
  word.symbols[100] = word.symbols[100] == 0 ? 1 : 0;
  EXPECT_NE(objection_to_letters(system, 4, word), "");
  word = derived(system, 4);
  std::size_t at = word.size() / 2;
  while (word.symbols[at] == word.symbols[at + 1]) ++at;
  std::swap(word.symbols[at], word.symbols[at + 1]);
  EXPECT_NE(objection_to_letters(system, 4, word), "");
}

TEST(LiteralWord, SeesAWordThatIsShorterOrLonger) {
  const LSystem system = parse_lsystem("axiom: A\nA -> AB\n", "row");
  EXPECT_EQ(objection_to_letters(system, 3, derived(system, 2)), "the word ends after 3 modules");
  EXPECT_EQ(objection_to_letters(system, 2, derived(system, 3)), "4 modules instead of 3");
}

}  // namespace
}  // namespace phytobench
