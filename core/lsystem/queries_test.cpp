// SPDX-License-Identifier: MIT
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/lsystem/drawing.hpp"
#include "core/lsystem/test_words.hpp"

namespace phytobench {
namespace {

std::vector<double> answers(std::string_view text, TurtleSettings turtle = test_turtle(90.0)) {
  TestWords words(std::move(turtle));
  Word word = words.word(text);
  answer_queries(words.system, word);
  return {word.parameters.begin(), word.parameters.end()};
}

/// [Alsweis] sec. 3.2, L-System2 after n steps: F(n)?P-F(n-1)?P- ... F(1)?P-A.
std::string growing_word(int steps) {
  std::string word;
  for (int length = steps; length > 0; --length)
    word += "F(" + std::to_string(length) + ")?P(9,9)-";
  return word + "A";
}

TEST(Queries, GiveThePositionsOfTheGrowingSpiral) {
  using Points = std::vector<std::pair<double, double>>;
  const std::vector<Points> expected{
      {{0, 1}},
      {{0, 2}, {1, 2}},
      {{0, 3}, {2, 3}, {2, 2}},
      {{0, 4}, {3, 4}, {3, 2}, {2, 2}},
      {{0, 5}, {4, 5}, {4, 2}, {2, 2}, {2, 3}},
      {{0, 6}, {5, 6}, {5, 2}, {2, 2}, {2, 4}, {3, 4}},
  };
  for (std::size_t n = 1; n <= expected.size(); ++n) {
    const std::vector<double> all = answers(growing_word(static_cast<int>(n)));
    ASSERT_EQ(all.size(), 3 * n);
    for (std::size_t i = 0; i < n; ++i) {
      EXPECT_EQ(all[3 * i], static_cast<double>(n - i));  // the length stays
      EXPECT_EQ(all[3 * i + 1], expected[n - 1][i].first);
      EXPECT_EQ(all[3 * i + 2], expected[n - 1][i].second);
    }
  }
}

TEST(Queries, FillAsManyCoordinatesAsTheyHaveParameters) {
  EXPECT_EQ(answers("F?P(7)"), (std::vector<double>{0}));
  EXPECT_EQ(answers("F?P(7,7)"), (std::vector<double>{0, 1}));
  EXPECT_EQ(answers("F?P(7,7,7)"), (std::vector<double>{0, 1, 0}));
  EXPECT_EQ(answers("F?P(7,7,7,7)"), (std::vector<double>{0, 1, 0, 7}));
  EXPECT_EQ(answers("F?P"), (std::vector<double>{}));
}

TEST(Queries, GiveTheFrame) {
  EXPECT_EQ(answers("+?H(7,7,7)?L(7,7,7)?U(7,7,7)"),
            (std::vector<double>{-1, 0, 0, 0, -1, 0, 0, 0, 1}));
  EXPECT_EQ(answers("&?H(7,7,7)?L(7,7,7)?U(7,7,7)"),
            (std::vector<double>{0, 0, -1, -1, 0, 0, 0, 1, 0}));
}

TEST(Queries, SeeTheStateOfTheirBranch) {
  EXPECT_EQ(answers("F[+F?P(7,7)]?P(7,7)"), (std::vector<double>{-1, 1, 0, 1}));
}

TEST(Queries, ThatAreCutOffStayAsTheyAre) {
  EXPECT_EQ(answers("F[%?P(7,7)]?P(7,7)"), (std::vector<double>{7, 7, 0, 1}));
}

TEST(Queries, LeaveOtherWordsAlone) {
  EXPECT_EQ(answers("F(2)A(3)}"), (std::vector<double>{2, 3}));  // not even walked
}

}  // namespace
}  // namespace phytobench
