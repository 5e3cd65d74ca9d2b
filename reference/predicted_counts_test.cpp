// SPDX-License-Identifier: MIT
#include "reference/predicted_counts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/lsystem/derive.hpp"
#include "core/lsystem/read_lsystem.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;

constexpr const char* plant = "axiom: X\nX -> F[+X]F(2)[-X]\nF -> FF\nF(l) -> F(l * 2)!\n";

std::vector<std::uint64_t> made_counts(const LSystem& system, int steps) {
  DeriveOptions options;
  options.steps = steps;
  return symbol_counts(system, derive(system, options));
}

std::uint64_t sum_of(const std::vector<std::uint64_t>& counts) {
  std::uint64_t sum = 0;
  for (const std::uint64_t count : counts) sum += count;
  return sum;
}

TEST(PredictedSymbols, AreThoseOfTheWord) {
  const LSystem system = parse_lsystem(plant, "plant");
  for (int steps = 0; steps <= 9; ++steps) {
    const auto predicted = predicted_symbols(system, steps);
    ASSERT_TRUE(predicted);
    const std::vector<std::uint64_t> made = made_counts(system, steps);
    EXPECT_EQ(symbol_count_disagreement(system, made, *predicted), "");
    EXPECT_EQ(predicted->modules.number, sum_of(made));
    const auto drawn = made[*find_symbol(system, "F", 0)] + made[*find_symbol(system, "F", 1)];
    ASSERT_TRUE(predicted->segments);
    EXPECT_EQ(predicted->segments->number, drawn);
    EXPECT_EQ(segment_count_disagreement(drawn, *predicted), "");
  }
}

TEST(PredictedSymbols, FindAPlantedFault) {
  const LSystem system = parse_lsystem(plant, "plant");
  const auto predicted = predicted_symbols(system, 5);
  ASSERT_TRUE(predicted);
  const std::vector<std::uint64_t> right = made_counts(system, 5);
  for (std::size_t i = 0; i < right.size(); ++i)
    for (const int change : {-1, 1}) {
      std::vector<std::uint64_t> wrong = right;
      wrong[i] += static_cast<std::uint64_t>(change);
      EXPECT_THAT(symbol_count_disagreement(system, wrong, *predicted),
                  HasSubstr("'" + name_of(system.symbols[i]) + "' where its matrix counts " +
                            std::to_string(right[i])));
    }
  // Another word of the same length.
  std::vector<std::uint64_t> swapped = right;
  std::swap(swapped[*find_symbol(system, "F", 0)], swapped[*find_symbol(system, "X", 0)]);
  EXPECT_NE(symbol_count_disagreement(system, swapped, *predicted), "");
  // A word of one step less.
  EXPECT_NE(symbol_count_disagreement(system, made_counts(system, 4), *predicted), "");
  EXPECT_THAT(segment_count_disagreement(*predicted->segments->number + 1, *predicted),
              HasSubstr("segments are drawn where the matrix of the system counts"));
}

TEST(PredictedSymbols, HaveAllDigits) {
  const LSystem doubling = parse_lsystem("axiom: F\nF -> FF\n", "doubling");
  const auto at = [&](int steps) { return predicted_symbols(doubling, steps)->modules; };
  EXPECT_EQ(at(63).number, std::uint64_t{1} << 63);
  EXPECT_EQ(at(64).number, std::nullopt);
  EXPECT_EQ(at(64).digits, "18446744073709551616");
  EXPECT_EQ(at(200).digits, "1606938044258990275541962092341162602522202993782792835301376");
  // A count that fits into no 64 bits is no count that was made.
  EXPECT_NE(symbol_count_disagreement(doubling, std::vector<std::uint64_t>{~std::uint64_t{0}},
                                      *predicted_symbols(doubling, 64)),
            "");
}

TEST(PredictedSymbols, AreNotGivenWhereTheSymbolDoesNotDecide) {
  for (const char* text : {"axiom: A(1)\nA(x) : x < 3 -> A(x + 1)F\n", "axiom: AB\nA < B -> F\n",
                           "axiom: F\nF -> FF : 0.5\nF -> F : 0.5\n"}) {
    const LSystem system = parse_lsystem(text, "chosen");
    EXPECT_FALSE(predicted_symbols(system, 2)) << text;
  }
  // Numbers drawn by lot change no symbol.
  EXPECT_TRUE(predicted_symbols(parse_lsystem("axiom: F\nF -> +(random(1, 9))F\n", "turns"), 2));
}

TEST(PredictedSymbols, AreNotCountedForHours) {
  const LSystem doubling = parse_lsystem("axiom: F\nF -> FF\n", "doubling");
  EXPECT_TRUE(predicted_symbols(doubling, 5000));
  EXPECT_FALSE(predicted_symbols(doubling, 1'000'000));
  EXPECT_TRUE(predicted_symbols(parse_lsystem("axiom: F\n", "still"), 1'000'000));
  // Many steps alone are no reason: these numbers stay short.
  const auto chain = predicted_symbols(parse_lsystem("axiom: A\nA -> F[+A]\n", "chain"), 200'000);
  ASSERT_TRUE(chain);
  EXPECT_EQ(chain->modules.number, 800'001u);
}

TEST(PredictedSymbols, LeaveSegmentsOpenWhereBranchesAreCut) {
  const auto predicted = predicted_symbols(parse_lsystem("axiom: F\nF -> F[F%F]\n", "cut"), 2);
  ASSERT_TRUE(predicted);
  EXPECT_FALSE(predicted->segments);
  EXPECT_EQ(segment_count_disagreement(5, *predicted), "");
}

TEST(PredictedSymbols, NameSymbolsWithTheirParameters) {
  EXPECT_EQ(name_of(Symbol{"F", 0}), "F");
  EXPECT_EQ(name_of(Symbol{"A", 1}), "A(.)");
  EXPECT_EQ(name_of(Symbol{"bud", 3}), "bud(.,.,.)");
}

}  // namespace
}  // namespace phytobench
