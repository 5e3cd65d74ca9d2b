// SPDX-License-Identifier: MIT
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/lsystem/derive.hpp"
#include "core/lsystem/random_lsystems.hpp"
#include "core/lsystem/read_lsystem.hpp"
#include "core/lsystem/test_lsystems.hpp"

namespace phytobench {
namespace {

constexpr std::uint64_t most = std::numeric_limits<std::uint64_t>::max();

GrowthForecast forecast_of(const std::string& text, int steps) {
  return growth_forecast(parsed(text), steps).value();
}

std::uint64_t count(const LSystem& system, const GrowthForecast& forecast, std::size_t step,
                    const char* letter) {
  return forecast.steps.at(step).symbols.at(*find_symbol(system, letter, 0));
}

TEST(GrowthForecast, BeginsWithTheAxiom) {
  const GrowthForecast forecast = forecast_of("axiom: A(1)BA(2)\nA(x) -> B\n", 0);
  ASSERT_EQ(forecast.steps.size(), 1u);
  EXPECT_EQ(forecast.steps[0].modules, 3u);
  EXPECT_EQ(forecast.steps[0].parameters, 2u);
  EXPECT_EQ(forecast.steps[0].symbols, (std::vector<std::uint64_t>{2, 1}));
}

// [Brzoska2019] eq. 6: X = 4^n, F = 9 (4^n - 2^n) / 2, 4 (4^n - 1) / 3 branches.
TEST(GrowthForecast, ClosedFormsOfABush) {
  const LSystem system = parsed("axiom: X\nX -> F[+++FX]F[---FX]F[++F-FX][F-FX]\nF -> FF\n");
  const auto forecast = growth_forecast(system, 20).value();
  for (std::size_t n = 0; n <= 20; ++n) {
    const std::uint64_t four = std::uint64_t{1} << (2 * n), two = std::uint64_t{1} << n;
    EXPECT_EQ(count(system, forecast, n, "X"), four);
    EXPECT_EQ(count(system, forecast, n, "F"), 9 * (four - two) / 2);
    EXPECT_EQ(count(system, forecast, n, "["), 4 * (four - 1) / 3);
  }
  EXPECT_EQ(forecast.steps[7].modules, 187'834u);
}

// [Liebemann2017] fig. 2.4: 4 * 8^n segments.
TEST(GrowthForecast, ClosedFormsOfAnIsland) {
  const LSystem system = parsed("axiom: F+F+F+F\nF -> F-F+F+FF-F-F+F\n");
  const auto forecast = growth_forecast(system, 4).value();
  std::uint64_t segments = 4;
  for (std::size_t n = 0; n <= 4; ++n, segments *= 8)
    EXPECT_EQ(count(system, forecast, n, "F"), segments);
  EXPECT_EQ(forecast.steps[3].modules, 3803u);
}

TEST(GrowthForecast, IsOnlyForFixedSuccessors) {
  EXPECT_FALSE(growth_forecast(parsed("axiom: A(1)\nA(x) : x < 2 -> A(x)\n"), 3));
  EXPECT_FALSE(growth_forecast(parsed("axiom: A\nA -> A : 0.5\nA -> B : 0.5\n"), 3));
  EXPECT_FALSE(growth_forecast(parsed("axiom: A\nB < A -> A\n"), 3));
  EXPECT_TRUE(growth_forecast(parsed("axiom: A(1)\nA(x) -> A(random(0, x))\n"), 3));
}

TEST(GrowthForecast, StaysAtTheGreatestNumber) {
  const GrowthForecast forecast = forecast_of("axiom: F\nF -> FF\n", 70);
  EXPECT_EQ(forecast.steps[63].modules, std::uint64_t{1} << 63);
  EXPECT_FALSE(forecast.steps[63].saturated);
  for (std::size_t step = 64; step <= 70; ++step) {
    EXPECT_EQ(forecast.steps[step].modules, most);
    EXPECT_TRUE(forecast.steps[step].saturated);
  }
}

TEST(GrowthForecast, SaturatesSumsOfModulesAndParameters) {
  const GrowthForecast sums = forecast_of("axiom: FG\nF -> FF\nG -> GG\n", 63);
  EXPECT_EQ(sums.steps[62].modules, std::uint64_t{1} << 63);
  EXPECT_EQ(sums.steps[63].modules, most);
  EXPECT_TRUE(sums.steps[63].saturated);
  const GrowthForecast parameters = forecast_of("axiom: F(1,2)\nF(x,y) -> F(x,y)F(y,x)\n", 63);
  EXPECT_EQ(parameters.steps[63].modules, std::uint64_t{1} << 63);
  EXPECT_EQ(parameters.steps[63].parameters, most);
  EXPECT_TRUE(parameters.steps[63].saturated);
}

TEST(GrowthForecast, ForgetsWhatIsErased) {
  const GrowthForecast forecast = forecast_of("axiom: AB\nA -> *\nB -> A\n", 3);
  EXPECT_EQ(forecast.steps[1].modules, 1u);
  EXPECT_EQ(forecast.steps[2].modules, 0u);
  EXPECT_EQ(forecast.steps[3].modules, 0u);
}

TEST(GrowthForecast, RefusesMoreStepsThanFitIntoMemory) {
  EXPECT_THROW(forecast_of("axiom: A\n", 2'000'000'000), InputError);
}

TEST(GrowthForecastLaw, EqualsCountingForRandomSystems) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    RandomSystemOptions options;
    options.parametric = seed % 2 == 1;
    const std::string text = RandomSystem(seed, options).text();
    const LSystem system = parsed(text);
    const GrowthForecast forecast = growth_forecast(system, 6).value();
    DeriveOptions derivation;
    derivation.steps = 6;
    int words = 0;
    derivation.each_word = [&](int step, const Word& word) {
      const GrowthForecast::Step& expected = forecast.steps[static_cast<std::size_t>(step)];
      ASSERT_EQ(word.size(), expected.modules) << text;
      ASSERT_EQ(word.parameters.size(), expected.parameters) << text;
      ASSERT_EQ(symbol_counts(system, word), expected.symbols) << text;
      ASSERT_FALSE(expected.saturated);
      ++words;
    };
    derive(system, derivation);
    EXPECT_EQ(words, 7);
  }
}

}  // namespace
}  // namespace phytobench
