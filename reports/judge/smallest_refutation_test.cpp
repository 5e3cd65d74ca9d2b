// SPDX-License-Identifier: MIT
#include "reports/judge/smallest_refutation.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "reports/judge/claim_fixture.hpp"

namespace phytobench {
namespace {

using testing::ElementsAre;

ClaimCheck between(double low, double high, ClaimCheck check) {
  check.low = low;
  check.high = high;
  return check;
}

std::optional<Refutation> refutation_of(const ClaimCheck& check, const Measurements& measurements) {
  return smallest_refutation(claim_of({check}), measurements);
}

TEST(SmallestRefutation, OfABoundIsHowFarItIsAway) {
  const auto found =
      refutation_of(between(8.0, 11.0, check_of(CheckSubject::value, {{"m"}})), {{"m", 10.0}});
  ASSERT_TRUE(found);
  EXPECT_THAT(found->measurements, ElementsAre("m"));
  EXPECT_GT(std::get<double>(found->after), 11.0);
  EXPECT_GE(found->relative_change, 0.1);
  EXPECT_LT(found->relative_change, 0.101);
}

TEST(SmallestRefutation, OfAnExactNumberIsItsLastPlace) {
  ClaimCheck check = check_of(CheckSubject::value, {{"m"}});
  check.equals = 5.0;
  const auto real = refutation_of(check, {{"m", 5.0}});
  ASSERT_TRUE(real);
  EXPECT_LE(real->relative_change, 0x1p-52);
  const auto whole = refutation_of(check, {{"m", std::int64_t{5}}});
  ASSERT_TRUE(whole);
  EXPECT_EQ(whole->relative_change, 0.2);
}

TEST(SmallestRefutation, OfZeroIsTheChangeItself) {
  ClaimCheck check = check_of(CheckSubject::value, {{"m"}});
  check.high = 0.5;
  const auto found = refutation_of(check, {{"m", 0.0}});
  ASSERT_TRUE(found);
  EXPECT_GE(found->relative_change, 0.5);
  EXPECT_LT(found->relative_change, 0.505);
}

TEST(SmallestRefutation, ReachesBoundsFarAboveWhatIsNearlyNothing) {
  ClaimCheck check = check_of(CheckSubject::value, {{"m"}});
  check.high = 1e-10;
  EXPECT_TRUE(refutation_of(check, {{"m", 1e-60}}));
}

TEST(SmallestRefutation, FindsTheMeasurementThatLiesNearestToItsBound) {
  ClaimCheck check = check_of(CheckSubject::value, {{"far"}, {"near"}, {"farther"}});
  check.low = 1.0;
  const auto found = refutation_of(check, {{"far", 4.0}, {"near", 2.0}, {"farther", 8.0}});
  ASSERT_TRUE(found);
  EXPECT_THAT(found->measurements, ElementsAre("near"));
  EXPECT_LT(std::get<double>(found->after), 1.0);
}

TEST(SmallestRefutation, IsAbsentWhereNothingCanFail) {
  const Measurements five = {{"m", 5.0}};
  EXPECT_FALSE(refutation_of(between(-1e300, 1e300, check_of(CheckSubject::value, {{"m"}})), five));
  ClaimCheck low = check_of(CheckSubject::value, {{"m"}});
  low.low = -1e300;
  EXPECT_FALSE(refutation_of(low, five));
  EXPECT_FALSE(refutation_of(low, {{"m", 0.0}}));
  EXPECT_FALSE(refutation_of(low, {{"m", std::int64_t{5}}}));
}

TEST(SmallestRefutation, OfAClaimHidesNoCheckThatCannotFail) {
  ClaimCheck empty = check_of(CheckSubject::value, {{"m"}});
  empty.low = -1e300;
  const Claim claim = claim_of({between(4.0, 6.0, check_of(CheckSubject::value, {{"m"}})), empty});
  const Measurements five = {{"m", 5.0}};
  EXPECT_TRUE(smallest_refutation(claim, five));
  EXPECT_FALSE(smallest_refutation(claim_of({claim.checks[1]}), five));
}

TEST(SmallestRefutation, OfSameAndDifferentIsOneStepOrOneText) {
  const ClaimCheck same = check_of(CheckSubject::same, {{"a", "b"}});
  const auto numbers = refutation_of(same, {{"a", 3.0}, {"b", 3.0}});
  ASSERT_TRUE(numbers);
  EXPECT_LE(numbers->relative_change, 0x1p-51);
  const auto texts = refutation_of(same, {{"a", std::string("x")}, {"b", std::string("x")}});
  ASSERT_TRUE(texts);
  EXPECT_EQ(texts->relative_change, 0.0);
  const ClaimCheck different = check_of(CheckSubject::different, {{"a", "b"}});
  const auto equal = refutation_of(different, {{"a", 3.0}, {"b", 4.0}});
  ASSERT_TRUE(equal);
  EXPECT_EQ(equal->relative_change, 0.25);
  EXPECT_TRUE(refutation_of(different, {{"a", std::string("x")}, {"b", std::string("y")}}));
}

TEST(SmallestRefutation, MovesAllTogetherWhereOneIsNotEnough) {
  ClaimCheck check = check_of(CheckSubject::ratio, {{"a", "b"}, {"c", "d"}, {"e", "f"}});
  check.low = 1.0;
  check.required = 2;
  const Measurements all_hold = {{"a", 2.0}, {"b", 1.0}, {"c", 2.0},
                                 {"d", 1.0}, {"e", 2.0}, {"f", 1.0}};
  const auto found = refutation_of(check, all_hold);
  ASSERT_TRUE(found);
  EXPECT_THAT(found->measurements, ElementsAre("a", "c", "e"));
  EXPECT_NEAR(found->relative_change, 0.5, 0.01);
}

TEST(SmallestRefutation, IsOnlyOfAClaimThatHolds) {
  const ClaimCheck check = between(8.0, 11.0, check_of(CheckSubject::value, {{"m"}}));
  EXPECT_THROW(refutation_of(check, {{"m", 7.0}}), ContractViolation);
}

TEST(SmallestRefutation, OfMatchesIsAnotherText) {
  ClaimCheck check = check_of(CheckSubject::matches, {{"seeds/"}});
  check.equals_text = "wanted";
  check.low = 1.0;
  const Measurements two_of_three = {{"seeds/1", std::string("wanted")},
                                     {"seeds/2", std::string("other")},
                                     {"seeds/3", std::string("wanted")}};
  const auto found = refutation_of(check, two_of_three);
  ASSERT_TRUE(found);
  EXPECT_THAT(found->measurements, ElementsAre("seeds/1", "seeds/3"));
}

}  // namespace
}  // namespace phytobench
