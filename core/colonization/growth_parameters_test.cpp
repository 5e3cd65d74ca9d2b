// SPDX-License-Identifier: MIT
#include "core/colonization/growth_parameters.hpp"

#include <set>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

using enum KillTiming;
using enum PointFilter;

void expect_options(std::string_view name, KillTiming timing, PointFilter filter) {
  const LoopOptions options = loop_options_named(name);
  EXPECT_EQ(options.kill_timing, timing) << name;
  EXPECT_EQ(options.point_filter, filter) << name;
}

TEST(LoopOptions, HaveTheLettersOfTableOne) {
  for (const char* name : {"s", "S"}) expect_options(name, immediate, none);
  for (const char* name : {"d", "D"}) expect_options(name, deferred, none);
  for (const char* name : {"n", "N"}) expect_options(name, immediate, bounding_box);
  for (const char* name : {"dn", "DN", "d&n", "D&N"}) expect_options(name, deferred, bounding_box);
}

TEST(LoopOptions, DefaultIsPlain) {
  EXPECT_EQ(LoopOptions{}.kill_timing, immediate);
  EXPECT_EQ(LoopOptions{}.point_filter, none);
}

TEST(LoopOptions, ListedNamesAreFourDifferentOptions) {
  std::set<std::pair<KillTiming, PointFilter>> different;
  for (const std::string_view name : loop_option_names) {
    const LoopOptions options = loop_options_named(name);
    different.insert({options.kill_timing, options.point_filter});
  }
  EXPECT_EQ(different.size(), 4u);
}

TEST(LoopOptions, UnknownIsAnInputErrorThatNamesTheFour) {
  for (const char* name : {"", "x", "nd", "s ", "dnx"}) {
    try {
      loop_options_named(name);
      ADD_FAILURE() << "'" << name << "' was taken";
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr("'" + std::string(name) + "'"));
      for (const char* known : {"s (", "d (", "n (", "dn ("})
        EXPECT_THAT(error.what(), testing::HasSubstr(known));
    }
  }
}

}  // namespace
}  // namespace phytobench
