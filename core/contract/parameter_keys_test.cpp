// SPDX-License-Identifier: MIT
#include "core/contract/parameter_keys.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace phytobench {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(NumberRange, HoldsItsBordersUnlessTheyAreLeftOut) {
  const NumberRange closed{.low = -1.0, .high = 2.0};
  EXPECT_TRUE(is_allowed(-1.0, closed));
  EXPECT_TRUE(is_allowed(2.0, closed));
  EXPECT_FALSE(is_allowed(std::nextafter(2.0, 3.0), closed));
  EXPECT_FALSE(is_allowed(std::nextafter(-1.0, -2.0), closed));
  const NumberRange open{
      .low = -1.0, .high = 2.0, .low_is_allowed = false, .high_is_allowed = false};
  EXPECT_FALSE(is_allowed(-1.0, open));
  EXPECT_FALSE(is_allowed(2.0, open));
  EXPECT_TRUE(is_allowed(std::nextafter(2.0, 0.0), open));
}

TEST(NumberRange, NeverHoldsWhatIsNoNumber) {
  for (const NumberRange& range :
       {NumberRange{}, NumberRange{.infinity_is_allowed = true}, NumberRange{.low = -infinity}})
    EXPECT_FALSE(is_allowed(std::nan(""), range));
}

TEST(NumberRange, HoldsInfinityOnlyIfThatIsSaid) {
  EXPECT_FALSE(is_allowed(infinity, {}));
  EXPECT_TRUE(is_allowed(infinity, {.high = 5.0, .whole = true, .infinity_is_allowed = true}));
  EXPECT_FALSE(is_allowed(-infinity, {.low = -infinity, .infinity_is_allowed = true}));
  EXPECT_FALSE(is_allowed(6.0, {.high = 5.0, .infinity_is_allowed = true}));
}

TEST(NumberRange, OfWholeNumbersHoldsNoFractions) {
  EXPECT_TRUE(is_allowed(3.0, {.whole = true}));
  EXPECT_FALSE(is_allowed(3.5, {.whole = true}));
}

TEST(NumberRange, IsSaidInWords) {
  EXPECT_EQ(allowed({}), ">= 0");
  EXPECT_EQ(allowed({.low = 1.0, .high = 20.0, .whole = true}), ">= 1 and <= 20, whole");
  EXPECT_EQ(allowed({.high = 1.0, .low_is_allowed = false, .high_is_allowed = false}),
            "> 0 and < 1");
  EXPECT_EQ(allowed({.infinity_is_allowed = true}), ">= 0, or inf");
  EXPECT_EQ(out_of_range("a.b", 2.5, {.high = 1.0}),
            "a.b = 2.5 is not allowed; give a number >= 0 and <= 1");
}

TEST(ParameterKey, UnknownGetsTheClosestAndIsOneLine) {
  const std::string known[] = {"seed", "steps"};
  EXPECT_EQ(unknown_key("sed", known, "phytobench grow --example"),
            "unknown key 'sed'; did you mean 'seed'? (phytobench grow --example lists all keys)");
  EXPECT_EQ(unknown_key("a\nb", known, "x"), "unknown key 'a?b' (x lists all keys)");
}

TEST(ParameterKey, TextOfAUserIsCutAndHasNoControlCharacters) {
  EXPECT_EQ(in_one_line("oak \xc3\xbc"), "oak \xc3\xbc");
  EXPECT_EQ(in_one_line("a\tb\x1b[1m\n"), "a?b?[1m?");
  EXPECT_EQ(in_one_line(std::string(80, 'x')), std::string(80, 'x'));
  EXPECT_EQ(in_one_line(std::string(81, 'x')), std::string(80, 'x') + "...");
}

TEST(ParameterKey, NameIsSectionAndShortName) {
  EXPECT_EQ(section_of("seed"), "");
  EXPECT_EQ(section_of("a.b"), "a");
  EXPECT_EQ(section_of("a.b.c"), "a.b");
  EXPECT_EQ(short_name_of("seed"), "seed");
  EXPECT_EQ(short_name_of("a.b.c"), "c");
}

TEST(ParameterKey, ExampleTellsAllThatIsKnown) {
  KeyText key{.name = "a.seed",
              .unit = "m",
              .meaning = "start of all",
              .source = "phytobench",
              .allowed = "a number >= 0",
              .value = "3"};
  EXPECT_EQ(example_lines(key),
            "# Start of all. Unit: m. Allowed: a number >= 0. Source: phytobench.\nseed = 3\n");
  key.is_commented_out = true;
  EXPECT_TRUE(example_lines(key).ends_with("\n# seed = 3\n"));
}

}  // namespace
}  // namespace phytobench
