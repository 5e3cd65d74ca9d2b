// SPDX-License-Identifier: MIT
// Contexts as derive() sees them; literal_derivation.hpp looks for them in another way.
#include "core/lsystem/context_match.hpp"

#include <cctype>
#include <string>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/lsystem/derive.hpp"
#include "core/lsystem/read_lsystem.hpp"
#include "core/lsystem/word.hpp"

namespace phytobench {
namespace {

/// One step from that word.
std::string stepped(const std::string& word, const std::string& productions) {
  const LSystem system = parse_lsystem("axiom: " + word + "\n" + productions + "\n", "test.lsys");
  DeriveOptions options;
  options.steps = 1;
  return text_of(system, derive(system, options));
}

/// Whether the production, whose successor is a single '!', replaces something.
bool fits(const std::string& word, const std::string& before_arrow,
          const std::string& settings = "") {
  return stepped(word, before_arrow + " -> !\n" + settings).find('!') != std::string::npos;
}

// The example of The Algorithmic Beauty of Plants, sec. 1.8.
const std::string abop_word = "ABC[DE][SG[HI[JK]L]MNO]";
const std::string abop_pattern = "BC < S > G[H]M";

TEST(ContextMatch, FindsTheExampleOfTheBook) {
  EXPECT_EQ(stepped(abop_word, abop_pattern + " -> !"), "ABC[DE][!G[HI[JK]L]MNO]");
}

TEST(ContextMatch, FailsWhenOneSymbolOfTheExampleIsChanged) {
  for (std::size_t i = 0; i < abop_word.size(); ++i) {
    std::string changed = abop_word;
    if (changed[i] == '[' || changed[i] == ']') continue;
    changed[i] = 'Z';
    const bool matters = std::string("BCSGHM").find(abop_word[i]) != std::string::npos;
    EXPECT_EQ(fits(changed, abop_pattern), !matters) << changed;
  }
}

TEST(ContextMatch, FailsWhenOneSymbolOfThePatternIsChanged) {
  for (std::size_t i = 0; i < abop_pattern.size(); ++i) {
    std::string changed = abop_pattern;
    if (std::isalpha(static_cast<unsigned char>(changed[i])) == 0) continue;
    changed[i] = 'Z';
    EXPECT_FALSE(fits(abop_word, changed)) << changed;
  }
}

TEST(ContextMatch, SeesTheParentFromABranch) {
  EXPECT_TRUE(fits("A[B]", "A < B"));
  EXPECT_TRUE(fits("A[C][B]", "A < B"));
  EXPECT_TRUE(fits("A[[[B]]]", "A < B"));
  EXPECT_FALSE(fits("A[C B]", "A < B"));
  EXPECT_FALSE(fits("[A]B", "A < B"));
}

TEST(ContextMatch, LeavesBranchesBesideThePathOut) {
  EXPECT_TRUE(fits("A[C[D]E][F]B", "A < B"));
  EXPECT_FALSE(fits("A[C]B", "C < B"));
  EXPECT_TRUE(fits("A[C]B", "A > B"));
  EXPECT_FALSE(fits("A[B]", "A > B"));
}

TEST(ContextMatch, EndsWithTheBranch) {
  EXPECT_FALSE(fits("[A]B", "A > B"));
  EXPECT_FALSE(fits("A", "A > B"));
  EXPECT_FALSE(fits("B", "A < B"));
  EXPECT_FALSE(fits("[AB]", "AA < B"));
}

TEST(ContextMatch, TakesThePatternsNearestModuleFirst) {
  EXPECT_TRUE(fits("ABC", "AB < C"));
  EXPECT_FALSE(fits("BAC", "AB < C"));
  EXPECT_TRUE(fits("CAB", "C > AB"));
  EXPECT_FALSE(fits("CBA", "C > AB"));
}

TEST(ContextMatch, FindsABranchAmongSeveral) {
  EXPECT_TRUE(fits("A[B][C][D]", "A > [C]"));
  EXPECT_TRUE(fits("A[B][C][D]", "A > [B][D]"));
  EXPECT_FALSE(fits("A[B][C][D]", "A > [D][B]"));
  EXPECT_FALSE(fits("A[B]E[C]", "A > [C]"));
  EXPECT_TRUE(fits("A[B]E[C]", "A > E[C]"));
  EXPECT_FALSE(fits("A[B]", "A > [B][B]"));
  EXPECT_TRUE(fits("A[B][B]", "A > [B][B]"));
}

TEST(ContextMatch, FitsTheBeginningOfABranch) {
  EXPECT_TRUE(fits("A[BCD]", "A > [BC]"));
  EXPECT_FALSE(fits("A[BCD]", "A > [CD]"));
  EXPECT_FALSE(fits("A[B]C", "A > [BC]"));
  EXPECT_TRUE(fits("A[[X]B]", "A > [B]"));
  EXPECT_TRUE(fits("A[]", "A > []"));
  EXPECT_FALSE(fits("A", "A > []"));
}

TEST(ContextMatch, FindsBranchesWithinBranches) {
  EXPECT_TRUE(fits("A[B[C]D]E", "A > [B[C]D]E"));
  EXPECT_TRUE(fits("A[B[X][C]D]E", "A > [B[C]]"));
  EXPECT_TRUE(fits("A[B[X]][B[C]]E", "A > [B[C]]E"));
  EXPECT_FALSE(fits("A[B[X]C]E", "A > [B[C]]"));
}

TEST(ContextMatch, DoesNotSeeIgnoredSymbols) {
  const std::string ignore = "ignore: + -";
  EXPECT_TRUE(fits("A+-B", "A < B", ignore));
  EXPECT_TRUE(fits("A[+B]", "A < B", ignore));
  EXPECT_TRUE(fits("A-+B", "A > B", ignore));
  EXPECT_TRUE(fits("A+[X]-[+B]", "A > [B]", ignore));
  EXPECT_FALSE(fits("A+B", "A < B"));
  EXPECT_FALSE(fits("A+B", "A > B"));
}

TEST(ContextMatch, LetsIgnoredSymbolsSee) {
  EXPECT_EQ(stepped("A+B-+", "ignore: + -\nA < + > B -> C"), "ACB-+");
}

TEST(ContextMatch, TellsAritiesApart) {
  EXPECT_TRUE(fits("A(1)B", "A(x) < B"));
  EXPECT_FALSE(fits("AB", "A(x) < B"));
  EXPECT_FALSE(fits("A(1)B", "A < B"));
}

TEST(ContextMatch, HandsOverParametersOfAllContexts) {
  EXPECT_EQ(stepped("A(1,2)[X(9)]B(3)C(4)[D(5)][E(6)F(7,8)]G(10)",
                    "A(a,b) < B(c) > C(d)[E(e)F(f,g)]G(h) -> R(a,b,c,d,e,f,g,h)"),
            "A(1,2)[X(9)]R(1,2,3,4,6,7,8,10)C(4)[D(5)][E(6)F(7,8)]G(10)");
}

TEST(ContextMatch, TakesParametersOfTheFirstBranchThatFits) {
  EXPECT_EQ(stepped("A[B(1)C][B(2)D][B(3)D]", "A > [B(x)D] -> R(x)"), "R(2)[B(1)C][B(2)D][B(3)D]");
}

TEST(ContextMatch, LetsConditionsSeeContexts) {
  const std::string production = "A(x) < B(y) > C(z) : x + z > y -> R(x + z)";
  EXPECT_EQ(stepped("A(1)B(2)C(3)", production), "A(1)R(4)C(3)");
  EXPECT_EQ(stepped("A(1)B(5)C(3)", production), "A(1)B(5)C(3)");
}

TEST(ContextMatch, TriesTheNextProductionWhereContextsDoNotFit) {
  EXPECT_EQ(stepped("ABCBDB", "A < B -> X\nC < B -> Y\nB -> Z"), "AXCYDZ");
}

TEST(ContextMatch,
     SignalsTravel) {  // a signal a step, [Alsweis] sec. 3.2 in the manner of ABOP 1.8
  const LSystem system = parse_lsystem("axiom: baaaaaaa\nb < a -> b\nb -> a\n", "test.lsys");
  for (int steps = 0; steps < 8; ++steps) {
    DeriveOptions options;
    options.steps = steps;
    std::string expected(8, 'a');
    expected[static_cast<std::size_t>(steps)] = 'b';
    EXPECT_EQ(text_of(system, derive(system, options)), expected);
  }
}

/// Brackets that a text would not let through.
TEST(ContextLinks, RefuseBracketsThatDoNotMatch) {
  for (const char* broken : {"]A[", "[[A]", "[A]]"}) {
    LSystem system = parse_lsystem("axiom: A[B]\nA < B -> C\n", "test.lsys");
    system.axiom.clear();
    for (const char* c = broken; *c != '\0'; ++c)
      system.axiom.push_back({*find_symbol(system, std::string(1, *c), 0), {}});
    ContextLinks links(system);
    EXPECT_THROW(links.rebuild(axiom_word(system)), InputError) << broken;
  }
}

}  // namespace
}  // namespace phytobench
