// SPDX-License-Identifier: MIT
#include "reference/oracles/lsystem_counts.hpp"

#include <gtest/gtest.h>

#include "reference/oracles/brzoska2019_l_systems.hpp"
#include "reference/oracles/liebemann2017_lsystems.hpp"
#include "reference/oracles/lintermann1997_bush.hpp"
#include "reference/oracles/lsystem_closed_forms.hpp"

namespace phytobench::oracles {
namespace {

using liebemann2017::D0LSystem;
using lintermann1997::BushPrint;

D0LStructure structure_of(const D0LSystem& G) {
  D0LStructure structure{G.omega, {}};
  for (const liebemann2017::Rule& rule : G.P) structure.successors[rule.a] = rule.b;
  return structure;
}

D0LStructure structure_of(const brzoska2019::LSystem& G) {
  D0LStructure structure{liebemann2017::one_by_one(G.omega), {}};
  for (const brzoska2019::Production& p : G.P)
    structure.successors[std::string(1, p.a)] = liebemann2017::one_by_one(p.chi);
  return structure;
}

Count count_of(const D0LStructure& system, int n, const std::string& letter) {
  return count_of(letter_counts(system, n), letter).in_64_bits().value();
}

Count length_of(const D0LStructure& system, int n) {
  return word_length(letter_counts(system, n)).in_64_bits().value();
}

TEST(LSystemCountsLaw, CountTheDerivedWord) {
  for (const D0LSystem& G :
       {liebemann2017::equation_2_1(), liebemann2017::equation_2_6(), liebemann2017::figure_2_5a(),
        liebemann2017::figure_2_5b(), lintermann1997::bush({})})
    for (int n = 0; n <= 4; ++n) {
      const liebemann2017::Letters word = derive_in_parallel(G, n);
      LetterCounts counted;
      for (const std::string& letter : word) counted[letter] += Natural(1);
      EXPECT_EQ(letter_counts(structure_of(G), n), counted);
      EXPECT_EQ(word_length(counted), Natural(word.size()));
    }
}

TEST(LSystemCountsLaw, StepsAndPowersOfTheMatrixAgree) {
  for (const D0LSystem& G : {liebemann2017::equation_2_1(), liebemann2017::figure_2_5a(),
                             lintermann1997::bush({8, 8, 8, 3})})
    for (const int n : {0, 1, 2, 5, 13, 40})
      EXPECT_EQ(letter_counts(structure_of(G), n), letter_counts_by_powers(structure_of(G), n));
}

TEST(LSystemCountsLaw, ALetterMayVanishOrStay) {
  const D0LStructure system{{"a", "b", "c"}, {{"a", {}}, {"b", {"a", "b"}}}};
  EXPECT_EQ(letter_counts(system, 1), (LetterCounts{{"a", 1}, {"b", 1}, {"c", 1}}));
  EXPECT_EQ(letter_counts({{"a"}, system.successors}, 1), LetterCounts{});
}

TEST(LSystemCounts, AreExactBeyond64Bits) {
  const LetterCounts counts = letter_counts(structure_of(liebemann2017::figure_2_5b()), 100);
  // 5^100, and that is more than a 64-bit count can say.
  EXPECT_EQ(drawn_segments(counts, "F").text(),
            "7888609052210118054117285652827862296732064351090230047702789306640625");
  EXPECT_EQ(drawn_segments(counts, "F").in_64_bits(), std::nullopt);
  EXPECT_EQ(drawn_segments(counts, "fG").text(), "0");
}

TEST(LSystemCounts, HaveTheClosedFormsOfLiebemann) {
  const D0LStructure island = structure_of(liebemann2017::equation_2_6());
  const D0LStructure a = structure_of(liebemann2017::figure_2_5a());
  const D0LStructure b = structure_of(liebemann2017::figure_2_5b());
  for (int n = 0; n <= 12; ++n) {
    EXPECT_EQ(length_of(structure_of(liebemann2017::equation_2_1()), n), equation_2_1_cells(n));
    EXPECT_EQ(count_of(island, n, "F"), equation_2_6_F(n));
    EXPECT_EQ(count_of(island, n, "+"), equation_2_6_plus(n));
    EXPECT_EQ(count_of(island, n, "-"), equation_2_6_minus(n));
    EXPECT_EQ(length_of(island, n), equation_2_6_letters(n));
    for (const char* sign : {"+", "-"}) {
      EXPECT_EQ(count_of(a, n, sign), figure_2_5a_plus(n));
      EXPECT_EQ(count_of(b, n, sign), figure_2_5b_plus(n));
    }
    for (const char* bracket : {"[", "]"}) {
      EXPECT_EQ(count_of(a, n, bracket), figure_2_5a_pairs(n));
      EXPECT_EQ(count_of(b, n, bracket), figure_2_5b_pairs(n));
    }
    EXPECT_EQ(count_of(a, n, "F"), figure_2_5a_F(n));
    EXPECT_EQ(count_of(b, n, "F"), figure_2_5b_F(n));
    EXPECT_EQ(length_of(a, n), figure_2_5a_letters(n));
    EXPECT_EQ(length_of(b, n), figure_2_5b_letters(n));
  }
}

TEST(LSystemCounts, HaveTheClosedFormsOfTheTreeOfEquation217) {
  // Letters without their parameters.
  const D0LStructure tree{{"/", "A"},
                          {{"A", liebemann2017::one_by_one("F[&FA]/[&FA]/[&FA]")}, {"F", {"F"}}}};
  for (int n = 0; n <= 12; ++n) {
    EXPECT_EQ(count_of(tree, n, "A"), equation_2_17_A(n));
    EXPECT_EQ(count_of(tree, n, "/"), equation_2_17_A(n));
    EXPECT_EQ(count_of(tree, n, "F"), equation_2_17_F(n));
    EXPECT_EQ(count_of(tree, n, "["), equation_2_17_pairs(n));
    EXPECT_EQ(count_of(tree, n, "&"), equation_2_17_pairs(n));
    EXPECT_EQ(length_of(tree, n), equation_2_17_modules(n));
  }
}

TEST(LSystemCounts, HaveTheClosedFormsOfBrzoska) {
  const D0LStructure koch = structure_of(brzoska2019::equation_5());
  const D0LStructure plant = structure_of(brzoska2019::equation_6_corrected());
  for (int n = 0; n <= 12; ++n) {
    EXPECT_EQ(count_of(koch, n, "F"), equation_5_F(n));
    EXPECT_EQ(length_of(koch, n), equation_5_letters(n));
    EXPECT_EQ(count_of(plant, n, "X"), equation_6_X(n));
    EXPECT_EQ(count_of(plant, n, "F"), equation_6_F(n));
    EXPECT_EQ(count_of(plant, n, "+"), equation_6_plus(n));
    EXPECT_EQ(count_of(plant, n, "-"), equation_6_plus(n));
    EXPECT_EQ(count_of(plant, n, "]"), equation_6_pairs(n));
    EXPECT_EQ(length_of(plant, n), equation_6_letters(n));
  }
}

TEST(LSystemCounts, HaveTheClosedFormsOfTheBush) {
  using namespace lintermann1997;
  for (const BushPrint& print : {BushPrint{}, BushPrint{8, 8, 8, 3}, BushPrint{5, 7, 5, 2}}) {
    const D0LStructure system = structure_of(bush(print));
    for (int n = 0; n <= 12; ++n) {
      const LetterCounts counts = letter_counts(system, n);
      const auto count = [&](const char* letter) {
        return oracles::count_of(counts, letter).in_64_bits().value();
      };
      EXPECT_EQ(count("A"), bush_A(n));
      EXPECT_EQ(count("F"), bush_F(n));
      EXPECT_EQ(count("S"), bush_S(n));
      EXPECT_EQ(count("L"), bush_L(n));
      EXPECT_EQ(count("{"), bush_polygons(n));
      EXPECT_EQ(count("["), bush_pairs(n));
      EXPECT_EQ(count("!"), bush_groups(n));
      EXPECT_EQ(count("&"), bush_groups(n));
      EXPECT_EQ(count("'"), bush_primes(n, print));
      EXPECT_EQ(count("/"), bush_slashes(n, print));
      EXPECT_EQ(count("f"), 6 * bush_polygons(n));
      EXPECT_EQ(word_length(counts), Natural(bush_letters(n, print)));
    }
  }
}

// The same productions in which one sign is missing: the checks above see it.
TEST(LSystemCounts, SeeAMissingSign) {
  D0LStructure wrong = structure_of(liebemann2017::figure_2_5a());
  wrong.successors["F"] = liebemann2017::one_by_one("FF-[F+F+F]+[+F-F-F]");
  EXPECT_NE(count_of(wrong, 4, "-"), figure_2_5a_plus(4));
  EXPECT_EQ(count_of(wrong, 4, "F"), figure_2_5a_F(4));
}

}  // namespace
}  // namespace phytobench::oracles
