// SPDX-License-Identifier: MIT
#include "reference/certified_values.hpp"

#include <set>
#include <string>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"

namespace phytobench::certified {
namespace {

TEST(CertifiedDigits, AreRoundedInTheLastPlaceThatIsWritten) {
  const Exact third = Exact(1) / 3, tiny = Exact("1.25e-18") / 3;
  EXPECT_TRUE(is_rounded_to("0.3333", third));
  EXPECT_FALSE(is_rounded_to("0.3334", third));
  EXPECT_FALSE(is_rounded_to("0.3332", third));
  EXPECT_TRUE(is_rounded_to("0.33333333333333333333333333333333333333333333333333", third));
  EXPECT_FALSE(is_rounded_to("0.33333333333333333333333333333333333333333333333334", third));
  EXPECT_TRUE(is_rounded_to("4.1667e-19", tiny));
  EXPECT_FALSE(is_rounded_to("4.1666e-19", tiny));
  EXPECT_FALSE(is_rounded_to("4.1667e-18", tiny));
  EXPECT_TRUE(is_rounded_to("12", Exact("12.4")));
  EXPECT_FALSE(is_rounded_to("12", Exact("12.6")));
}

TEST(CertifiedDigits, OfNothingMustBeNothing) {
  EXPECT_TRUE(is_rounded_to("0", Exact(0)));
  EXPECT_FALSE(is_rounded_to("0", Exact("1e-90")));
  EXPECT_FALSE(is_rounded_to("0.10", Exact(0)));
}

TEST(CertifiedDigits, AreCountedFromTheFirstThatIsNotZero) {
  EXPECT_EQ(significant_digits("0"), 0u);
  EXPECT_EQ(significant_digits("0.00"), 0u);
  EXPECT_EQ(significant_digits("0.0250"), 3u);
  EXPECT_EQ(significant_digits("12.50"), 4u);
  EXPECT_EQ(significant_digits("-1.5e-22"), 2u);
}

TEST(CertifiedFiles, HaveThirtyDigitsAndInputsThatDoublesHoldExactly) {
  std::set<std::string> names;
  for (const char* family : {"lens_areas", "hopkins", "growth"})
    for (const Value& value : values_of(family)) {
      SCOPED_TRACE(std::string(family) + ": " + value.name());
      EXPECT_TRUE(names.insert(std::string(family) + "/" + value.name()).second) << "named twice";
      if (value.digits() != "0") {
        EXPECT_EQ(significant_digits(value.digits()), 30u);
      }
      EXPECT_GE(value.promised_digits(), 10.0);
      EXPECT_FALSE(value.inputs().empty());
      for (const std::string& input : value.inputs())
        EXPECT_EQ(Exact(value.number(input)), value.exact(input)) << input;
    }
  EXPECT_THROW(values_of("nothing"), InputError);
}

}  // namespace
}  // namespace phytobench::certified
