// SPDX-License-Identifier: MIT
#include "core/lsystem/unused_productions.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/lsystem/read_lsystem.hpp"

namespace phytobench {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

std::vector<std::string> unused(const std::string& text) {
  return unused_productions(parse_lsystem(text, "test"));
}

TEST(UnusedProductions, HaveALetterThatNeverOccurs) {
  EXPECT_THAT(
      unused("axiom: A\nA -> AF\np7: B -> FF\n"),
      ElementsAre("test:3:5: p7 is never used: 'B' comes neither in the axiom nor from it; correct "
                  "its letter or number of parameters, or remove the production"));
}

TEST(UnusedProductions, HaveANumberOfParametersThatNeverOccurs) {
  EXPECT_THAT(unused("axiom: A(1)\nA(x) -> A(x + 1)\nA(x, y) -> A(x)\nA -> A(1)\n"),
              ElementsAre(StartsWith("test:3:1: p2 is never used: 'A' with 2 parameters comes "
                                     "neither in the axiom nor from it ('A' with 1 parameter "
                                     "does); correct"),
                          StartsWith("test:4:1: p3 is never used: 'A' comes")));
}

TEST(UnusedProductions, ComeOnlyFromEachOther) {
  EXPECT_THAT(unused("axiom: A\nA -> AF\nB -> C\nC -> B\n"),
              ElementsAre(HasSubstr("'B' comes"), HasSubstr("'C' comes")));
}

TEST(UnusedProductions, HaveAContextThatNeverOccurs) {
  EXPECT_THAT(unused("axiom: AB[B]\nC < A -> F\nA > B[C] -> F\nA < B -> B\nF -> C(1)\n"),
              ElementsAre(StartsWith("test:2:5: p1 is never used: 'C' comes"),
                          StartsWith("test:3:1: p2 is never used: 'C' comes"),
                          StartsWith("test:5:1: p4 is never used: 'F' comes")));
}

TEST(UnusedProductions, HaveABranchAsContextWhereNothingBranches) {
  EXPECT_THAT(unused("axiom: AB\nA > [B] -> F\n"), ElementsAre(HasSubstr("never used: '[' comes")));
}

TEST(UnusedProductions, StandBehindOneThatFitsWhereverTheyWould) {
  EXPECT_THAT(
      unused("axiom: ABC\nA < B -> B\nA < B > C -> F\n"),
      ElementsAre("test:3:5: p2 is never used: p1 in line 2 has no condition and fits wherever it "
                  "would; move this one above it"));
  EXPECT_THAT(unused("axiom: ABCA\nB > C -> B\nB > C A : 1 < 2 -> F\n"),
              ElementsAre(HasSubstr("p1 in line 2")));
  EXPECT_THAT(unused("axiom: CAB\nA < B -> B\nC A < B -> F\n"), ElementsAre(HasSubstr("p1 in")));
}

TEST(UnusedProductions, AreNotThoseThatMayFit) {
  for (const char* text :
       {"axiom: ABC\nA < B > C -> F\nA < B -> B\n",          // the special one first
        "axiom: ABC\nB -> F\nA < B -> B\n",                  // contexts come first anyway
        "axiom: ABC\nA < B : 2 < 1 -> B\nA < B > C -> F\n",  // nothing is said of conditions
        "axiom: ABC\nA < B -> B\nB > C -> F\n",              // B C without an A
        "axiom: BAC\nA C < B -> B\nC A < B -> F\n",
        "axiom: A(1)\nA(x) : x < 5 -> A(x + 1)\nA(x) : x < 3 -> F\n",
        "axiom: A\nA -> AF : 0.5\nA -> B : 0.5\nB -> F\n",
        "axiom: AB\nA < B -> B : 0.5\nA < B -> F : 0.5\n",
        "axiom: A\nA -> [+B(1)]?P(0, 0)\nB(x) -> B(x)\n?P(x, y) : x > 1 -> F\n"})
    EXPECT_THAT(unused(text), IsEmpty()) << text;
}

}  // namespace
}  // namespace phytobench
