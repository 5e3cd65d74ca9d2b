// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/accepted_instructions.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmarks/comparison/text_fixture.hpp"
#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const std::string entry =
    "[[accepted]]\nbenchmark = \"overlap/*\"\npercent = 12.0\nbase = \"0123456789ab\"\n"
    "reason = \"areas are summed in a fixed order\"\n";

void expect_refused(const std::string& text, const std::string& place, const std::string& problem) {
  try {
    accepted_increases_from(text, "accepted.toml");
    ADD_FAILURE() << "accepted: " << text;
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), StartsWith("accepted.toml:" + place));
    EXPECT_THAT(error.what(), HasSubstr(problem));
  }
}

TEST(AcceptedInstructions, AreReadFromTheirTables) {
  const auto increases = accepted_increases_from(entry + entry, "f");
  ASSERT_EQ(increases.size(), 2u);
  EXPECT_EQ(increases[0].benchmark, "overlap/*");
  EXPECT_EQ(increases[0].percent, 12.0);
  EXPECT_EQ(increases[0].base, "0123456789ab");
  EXPECT_EQ(increases[1].reason, "areas are summed in a fixed order");
  EXPECT_TRUE(accepted_increases_from("# nothing is\n", "f").empty());
}

TEST(AcceptedInstructions, HoldForTheirBenchmarksAndTheirCommitOnly) {
  const AcceptedIncrease increase = accepted_increases_from(entry, "f").front();
  EXPECT_TRUE(increase.applies_to("overlap/sweep/equal", "0123456789ab"));
  EXPECT_TRUE(increase.applies_to("overlap/sweep/equal", "0123456789abcdef"));
  EXPECT_FALSE(increase.applies_to("overlap/sweep/equal", "0123456789ac"));
  EXPECT_FALSE(increase.applies_to("overlap/sweep/equal", "0123"));
  EXPECT_FALSE(increase.applies_to("overlap/sweep/equal", ""));
  EXPECT_FALSE(increase.applies_to("nearest-node/voxel_grid/dn", "0123456789ab"));
}

TEST(AcceptedInstructions, DamageIsNamedWithItsLine) {
  expect_refused("x", "1:", "not valid TOML");
  expect_refused("percent = 1\n", "1: ", "only [[accepted]]");
  expect_refused("accepted = 3\n", "1: ", "only [[accepted]]");
  expect_refused("accepted = [3]\n", "1: ", "must be tables");
  expect_refused(replaced(entry, "percent = 12.0\n", ""), "1: ", "has no percent");
  expect_refused(replaced(entry, "12.0", "0"), "3: ", "percent");
  expect_refused(replaced(entry, "12.0", "nan"), "3: ", "percent");
  expect_refused(replaced(entry, "12.0", "\"12\""), "3: ", "number");
  expect_refused(replaced(entry, "0123456789ab", "HEAD"), "4: ", "12 of its digits");
  expect_refused(replaced(entry, "areas are summed in a fixed order", " "), "5: ", "reason");
  expect_refused(replaced(entry, "reason", "why = \"x\"\nreason"), "5: ", "unknown key 'why'");
}

TEST(AcceptedInstructions, WithoutAFileThereAreNone) {
  EXPECT_TRUE(read_accepted_increases("no/such/file.toml").empty());
}

}  // namespace
}  // namespace phytobench
