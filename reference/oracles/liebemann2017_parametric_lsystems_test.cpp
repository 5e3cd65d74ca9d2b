// SPDX-License-Identifier: MIT
#include "reference/oracles/liebemann2017_parametric_lsystems.hpp"

#include <map>

#include <gtest/gtest.h>

#include "reference/oracles/lsystem_closed_forms.hpp"

namespace phytobench::oracles::liebemann2017 {
namespace {

TEST(ParametricWordText, HasTheFewestDigits) {
  EXPECT_EQ(text_of(ParametricWord{{"A", {2, 0.1}}, {"C", {}}, {"?P", {-1.5}}}),
            "A(2,0.1)C?P(-1.5)");
  EXPECT_EQ(text_of(modules_of("F [ + ]")), "F[+]");
}

TEST(LiebemannParametric, DerivesTheWordsOfFigure22) {
  const char* words[] = {"A(1,1)", "A(2,2)B(1)", "A(3,4)B(2)B(2)C", "A(4,8)B(4)B(3)CB(3)CC",
                         "A(5,16)B(8)B(5)CB(4)CCB(4)CCC"};
  for (int n = 0; n < 5; ++n) EXPECT_EQ(text_of(derive(equation_2_2(), n)), words[n]);
}

TEST(LiebemannParametric, HasTheClosedFormOfItsWords) {
  for (int n = 0; n <= 12; ++n) {
    const ParametricWord word = derive(equation_2_2(), n);
    EXPECT_EQ(text_of(word), equation_2_2_word(n));
    EXPECT_EQ(word.size(), equation_2_2_modules(n));
    std::map<std::string, std::uint64_t> counts;
    for (const Module& module : word) ++counts[module.letter];
    EXPECT_EQ(counts["B"], static_cast<std::uint64_t>(n));
    EXPECT_EQ(counts["C"], equation_2_2_C(n));
  }
}

TEST(LiebemannParametricLaw, LetterAndNumberOfParametersMustFit) {
  ParametricLSystem G = equation_2_2();
  for (const std::vector<double>& parameters :
       {std::vector<double>{}, std::vector<double>{1}, std::vector<double>{1, 2, 3}}) {
    G.omega = {{"A", parameters}};
    EXPECT_EQ(derive(G, 3), G.omega);
  }
  G.omega = {{"A", {1, 2}}};
  EXPECT_NE(derive(G, 1), G.omega);
}

TEST(LiebemannParametricLaw, OneStepMoreIsOneStepOfTheWord) {
  ParametricLSystem G = equation_2_17(18.95, 137.5, 1.3);
  const ParametricWord five = derive(G, 5);
  G.omega = derive(G, 4);
  EXPECT_EQ(derive(G, 1), five);
}

TEST(LiebemannParametric, TheTreeOfFigure26HasItsCounts) {
  const ParametricLSystem G = equation_2_17(18.95, 137.5, 1.3);
  for (int n = 0; n <= 8; ++n) {
    std::map<std::string, std::uint64_t> counts;
    double length = 0;
    const ParametricWord word = derive(G, n);
    for (const Module& module : word) {
      ++counts[module.letter];
      if (module.letter == "F") length += module.parameters[0];
    }
    EXPECT_EQ(counts["A"], equation_2_17_A(n));
    EXPECT_EQ(counts["F"], equation_2_17_F(n));
    EXPECT_EQ(counts["["], equation_2_17_pairs(n));
    EXPECT_EQ(counts["]"], equation_2_17_pairs(n));
    EXPECT_EQ(counts["&"], equation_2_17_pairs(n));
    EXPECT_EQ(counts["/"], equation_2_17_A(n));
    EXPECT_EQ(word.size(), equation_2_17_modules(n));
    EXPECT_NEAR(length, equation_2_17_drawn_length(n, 1.3), 1e-9 * (1 + length));
  }
}

}  // namespace
}  // namespace phytobench::oracles::liebemann2017
