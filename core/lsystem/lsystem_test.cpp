// SPDX-License-Identifier: MIT
#include "core/lsystem/lsystem.hpp"

#include <gtest/gtest.h>

#include "core/lsystem/read_lsystem.hpp"

namespace phytobench {
namespace {

LSystemKind kind(const char* text) {
  return kind_of(parse_lsystem(text, "test"));
}

TEST(LSystemKind, FindsWhatProductionsAskFor) {
  EXPECT_TRUE(kind("axiom: F\nF -> F[+F]").is_d0l());
  EXPECT_TRUE(kind("axiom: F(1)\nF(x) -> F(x)").parametric);
  EXPECT_TRUE(kind("axiom: F(1)\nF(x) : x > 1 -> F(x)").conditional);
  EXPECT_TRUE(kind("axiom: A\nB < A -> C").contextual);
  EXPECT_TRUE(kind("axiom: A\nA > B -> C").contextual);
  EXPECT_TRUE(kind("axiom: A\nA -> F?P(x, y)A").queries);
  EXPECT_TRUE(kind("axiom: A\nA -> B : 0.5\nA -> C : 0.5").stochastic_choice);
}

TEST(LSystemKind, NamesNothingThatIsNotThere) {
  const LSystemKind plain = kind("axiom: F\nF -> F[+F]");
  EXPECT_FALSE(plain.parametric || plain.stochastic || plain.stochastic_choice ||
               plain.conditional || plain.contextual || plain.queries);
}

TEST(LSystemKind, TellsChoicesFromRandomParameters) {
  const LSystemKind parameters = kind("axiom: F(1)\nF(x) -> F(random())");
  EXPECT_TRUE(parameters.stochastic);
  EXPECT_FALSE(parameters.stochastic_choice);
  EXPECT_TRUE(parameters.has_fixed_successors());
  const LSystemKind choice = kind("axiom: A\nA -> B : 0.5\nA -> C : 0.5");
  EXPECT_TRUE(choice.stochastic);
  EXPECT_FALSE(choice.has_fixed_successors());
  EXPECT_TRUE(kind("axiom: A\nA(x) : random() < 0.5 -> B").stochastic);
}

TEST(LSystemKind, TakesAProbabilityOfOneForNoChoice) {
  EXPECT_TRUE(kind("axiom: A\nA -> B : 1").is_d0l());
}

TEST(FindSymbol, NeedsLetterAndNumberOfParameters) {
  const LSystem system = parse_lsystem("axiom: A(1)A B(1, 2)", "test");
  ASSERT_EQ(system.symbols.size(), 3u);
  EXPECT_EQ(find_symbol(system, "A", 1), SymbolIndex{0});
  EXPECT_EQ(find_symbol(system, "A", 0), SymbolIndex{1});
  EXPECT_EQ(find_symbol(system, "B", 2), SymbolIndex{2});
  EXPECT_FALSE(find_symbol(system, "B", 1));
  EXPECT_FALSE(find_symbol(system, "C", 0));
}

}  // namespace
}  // namespace phytobench
