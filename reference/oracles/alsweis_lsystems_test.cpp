// SPDX-License-Identifier: MIT
#include "reference/oracles/alsweis_lsystems.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace phytobench::oracles::alsweis {
namespace {

using Outcome = std::pair<const std::string, FifthsProbability>;
using Answers = std::vector<std::pair<int, int>>;

bool likelier(const Outcome& a, const Outcome& b) {
  return a.second.numerator * b.second.denominator > b.second.numerator * a.second.denominator;
}

TEST(FifthsLaw, AddAndMultiplyInLowestTerms) {
  EXPECT_EQ(sum({2, 5}, {3, 5}), (FifthsProbability{1, 1}));
  EXPECT_EQ(sum({1, 25}, {2, 5}), (FifthsProbability{11, 25}));
  EXPECT_EQ(product({3, 5}, {3, 5}), (FifthsProbability{9, 25}));
  EXPECT_EQ(product({2, 5}, {0, 1}), (FifthsProbability{0, 1}));
}

TEST(LSystem1Law, ProbabilitiesAddUpToOne) {
  for (int steps = 0; steps <= 6; ++steps) {
    FifthsProbability all;
    for (const auto& [word, p] : outcomes_of_lsystem_1(steps)) all = sum(all, p);
    EXPECT_EQ(all, (FifthsProbability{1, 1}));
  }
}

TEST(LSystem1, HasFourOutcomesOfOneStep) {
  const std::map<std::string, FifthsProbability> expected{{"B(0)B(6)[A(3)]B(4)", {9, 25}},
                                                          {"A(2)B(6)[A(3)]B(4)", {6, 25}},
                                                          {"B(0)B(6)[A(3)]A(6)", {6, 25}},
                                                          {"A(2)B(6)[A(3)]A(6)", {4, 25}}};
  EXPECT_EQ(outcomes_of_lsystem_1(1), expected);
}

TEST(LSystem1, HasEighteenAndFortyEightOutcomesOfTwoAndThree) {
  const auto two = outcomes_of_lsystem_1(2);
  EXPECT_EQ(two.size(), 18u);
  EXPECT_EQ(two.at("B(0)B(6)[B(2)]B(4)"), (FifthsProbability{27, 125}));
  EXPECT_EQ(two.at("B(0)B(6)[A(4)]B(4)"), (FifthsProbability{18, 125}));
  const auto likeliest = std::min_element(two.begin(), two.end(), likelier);
  const auto least = std::max_element(two.begin(), two.end(), likelier);
  EXPECT_EQ(likeliest->first, "B(0)B(6)[B(2)]B(4)");
  EXPECT_EQ(least->second, (FifthsProbability{32, 3125}));
  EXPECT_EQ(least->first, "A(3)B(6)[A(4)]A(7)");
  EXPECT_EQ(outcomes_of_lsystem_1(3).size(), 48u);
}

// After the first step the three A have nothing to do with each other: an A(x) of age n is A(x + n)
// or the B(x + k - 1) that it became after k more steps.
TEST(LSystem1, IsAProductOfThreeCellsFromTheSecondStepOn) {
  for (int steps = 2; steps <= 5; ++steps) {
    const auto cell = [](int x, int age) {
      std::map<std::string, FifthsProbability> states;
      FifthsProbability still{1, 1};
      for (int k = 0; k < age; ++k) {
        states["B(" + std::to_string(x + k - 1) + ")"] = product(still, {3, 5});
        still = product(still, {2, 5});
      }
      states["A(" + std::to_string(x + age) + ")"] = still;
      return states;
    };
    std::map<std::string, FifthsProbability> expected;
    for (const auto& [a, p] : cell(1, steps))
      for (const auto& [b, q] : cell(3, steps - 1))
        for (const auto& [c, r] : cell(5, steps))
          expected[a + "B(6)[" + b + "]" + c] = product(p, product(q, r));
    EXPECT_EQ(outcomes_of_lsystem_1(steps), expected);
  }
}

TEST(LSystem2, AnswersItsQueries) {
  const Answers expected[] = {{},
                              {{0, 1}},
                              {{0, 2}, {1, 2}},
                              {{0, 3}, {2, 3}, {2, 2}},
                              {{0, 4}, {3, 4}, {3, 2}, {2, 2}},
                              {{0, 5}, {4, 5}, {4, 2}, {2, 2}, {2, 3}},
                              {{0, 6}, {5, 6}, {5, 2}, {2, 2}, {2, 4}, {3, 4}}};
  for (int n = 0; n <= 6; ++n) EXPECT_EQ(queries_of_lsystem_2(n), expected[n]);
}

TEST(LSystem2, WritesTheAnswersIntoItsWord) {
  EXPECT_EQ(word_of_lsystem_2(0), "A");
  EXPECT_EQ(word_of_lsystem_2(1), "F(1)?P(0,1)-A");
  EXPECT_EQ(word_of_lsystem_2(3), "F(3)?P(0,3)-F(2)?P(2,3)-F(1)?P(2,2)-A");
}

}  // namespace
}  // namespace phytobench::oracles::alsweis
