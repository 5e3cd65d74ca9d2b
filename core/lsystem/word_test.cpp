// SPDX-License-Identifier: MIT
#include "core/lsystem/word.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/lsystem/read_lsystem.hpp"
#include "core/lsystem/symbol_histogram.hpp"

namespace phytobench {
namespace {

std::string axiom_text(const std::string& text) {
  const LSystem system = parse_lsystem(text, "test");
  return text_of(system, axiom_word(system));
}

std::string axiom_hash(const std::string& text) {
  const LSystem system = parse_lsystem(text, "test");
  return word_hash(system, axiom_word(system));
}

TEST(Word, IsWrittenAsItIsRead) {
  for (const std::string word : {"F", "F+F[-F]F", "A(2,2)B(1)", "A(0.1)?P(0,0)F", "A(1e+300,-2)",
                                 "A(0.30000000000000004)", "!(0.5)'(3)F(1,2)"})
    EXPECT_EQ(axiom_text("axiom: " + word), word);
}

TEST(Word, WritesTheShortestDigits) {
  EXPECT_EQ(axiom_text("axiom: A(2.0, 1/4, 1/3)"), "A(2,0.25,0.3333333333333333)");
}

TEST(Word, PartsLettersThatWouldBeJoined) {
  EXPECT_EQ(axiom_text("alphabet: ar al\naxiom: al ar[al]al(1)ar"), "al ar[al]al(1)ar");
  // 'a' and 'r' one after the other are not 'ar'.
  EXPECT_EQ(axiom_text("alphabet: ar\naxiom: a r ar r a"), "a r ar ra");
  EXPECT_EQ(axiom_text("axiom: a r"), "ar");
}

TEST(Word, IsReadBackToItself) {
  const std::string text = "alphabet: ar al\naxiom: a r ar[al(1/3)r a]r ar";
  const std::string word = axiom_text(text);
  EXPECT_EQ(axiom_text("alphabet: ar al\naxiom: " + word), word);
}

TEST(Word, CountsItsBytes) {
  const LSystem system = parse_lsystem("axiom: A(1,2)B(3)C", "test");
  const Word word = axiom_word(system);
  EXPECT_EQ(word.size(), 3u);
  EXPECT_EQ(word.bytes(), 3u + 3u * sizeof(double));
}

TEST(Word, CountsSymbolsByLetterAndArity) {
  const LSystem system = parse_lsystem("axiom: AA(1)BA(2)A(1,2)A", "test");
  const auto counts = symbol_counts(system, axiom_word(system));
  const auto count = [&](const char* letter, std::size_t arity) {
    return counts.at(*find_symbol(system, letter, arity));
  };
  EXPECT_EQ(counts.size(), system.symbols.size());
  EXPECT_EQ(count("A", 0), 2u);
  EXPECT_EQ(count("A", 1), 2u);
  EXPECT_EQ(count("A", 2), 1u);
  EXPECT_EQ(count("B", 0), 1u);
}

TEST(SymbolHistogram, CountsPiecesOfEveryLength) {
  std::vector<SymbolIndex> symbols;
  for (std::size_t length = 0; length < 20; ++length) {
    const SymbolHistogram counts = histogram_of(symbols);
    for (std::size_t s = 0; s < most_symbols; ++s) {
      const auto expected =
          static_cast<std::uint64_t>(std::count(symbols.begin(), symbols.end(), s));
      EXPECT_EQ(counts[s], expected) << "symbol " << s << " of " << length;
    }
    symbols.push_back(static_cast<SymbolIndex>(length * length % 5 == 0 ? 255 : length % 3));
  }
}

TEST(Word, CopiesShareNothing) {
  const LSystem system = parse_lsystem("axiom: A(1)B", "test");
  Word word = axiom_word(system);
  const Word copy = copy_of(word);
  word.parameters[0] = 7;
  word.symbols[1] = word.symbols[0];
  EXPECT_EQ(text_of(system, copy), "A(1)B");
}

TEST(WordHash, IsOfSixteenDigits) {
  EXPECT_EQ(axiom_hash("axiom: F").size(), 16u);
  EXPECT_EQ(axiom_hash("axiom: F").find_first_not_of("0123456789abcdef"), std::string::npos);
}

TEST(WordHash, DoesNotDependOnTheNumberingOfSymbols) {
  EXPECT_EQ(axiom_hash("axiom: AB(1)\nB(x) -> C"), axiom_hash("axiom: AB(1)\nA -> D\nC -> B(1)"));
  LSystem turned = parse_lsystem("axiom: AB", "test");
  const std::string before = word_hash(turned, axiom_word(turned));
  std::swap(turned.symbols[0], turned.symbols[1]);
  std::swap(turned.axiom[0].symbol, turned.axiom[1].symbol);
  EXPECT_EQ(word_hash(turned, axiom_word(turned)), before);
}

TEST(WordHash, SeesEveryDifference) {
  const std::string hash = axiom_hash("axiom: A(1)B(2)C");
  for (const char* other : {"axiom: A(1)B(2)", "axiom: B(1)A(2)C", "axiom: A(1)CB(2)",
                            "axiom: A(2)B(1)C", "axiom: A(1,2)BC", "axiom: AB(1,2)C",
                            "axiom: A(1.0000000000000002)B(2)C", "axiom: A(-1)B(2)C"})
    EXPECT_NE(axiom_hash(other), hash) << other;
}

}  // namespace
}  // namespace phytobench
