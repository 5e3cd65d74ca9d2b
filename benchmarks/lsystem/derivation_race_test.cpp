// SPDX-License-Identifier: MIT
#include "benchmarks/lsystem/derivation_race.hpp"

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/lsystem/derive.hpp"

namespace phytobench {
namespace {

TEST(DerivationRace, TimesWhatIsRight) {
  DerivationRaceRequest request;
  request.cases = derivation_cases(60'000);
  ASSERT_EQ(request.cases.size(), 4u);
  request.threads = {1, 2};
  request.rounds = 2;
  const std::vector<DerivationEntry> entries = race_derivations(request);
  ASSERT_EQ(entries.size(), 8u);
  for (const DerivationEntry& entry : entries) {
    EXPECT_EQ(entry.objection, "") << entry.name;
    EXPECT_EQ(entry.seconds.size(), 2u) << entry.name;
    EXPECT_GE(entry.modules_made, entry.modules) << entry.name;
    EXPECT_GE(entry.bytes_per_module, 1.0) << entry.name;
  }
  EXPECT_EQ(entries[0].modules, 55'762u);  // [Liebemann2017] fig. 2.6
  EXPECT_GT(entries[2].modules_made, entries[2].modules);
  EXPECT_EQ(entries[4].modules_made, entries[4].modules);  // the words before are passed over
  EXPECT_EQ(entries[6].modules_made, 600'000u);
}

/// Every check of a word sees a word that is a step short, and one with another number.
TEST(DerivationRace, GivesNoTimeForAWrongWord) {
  DerivationRaceRequest request;
  request.cases = derivation_cases(60'000);
  for (DerivationCase& one : request.cases) --one.steps;
  for (const DerivationEntry& entry : race_derivations(request)) {
    EXPECT_NE(entry.objection, "") << entry.name;
    EXPECT_TRUE(entry.seconds.empty()) << entry.name;
  }
  for (const DerivationCase& one : derivation_cases(60'000)) {
    DeriveOptions options;
    options.steps = one.steps;
    Word word = derive(one.system, options);
    EXPECT_EQ(one.objection(word), "") << one.name;
    if (word.parameters.size() > 0)
      word.parameters[word.parameters.size() / 2 + 1] += 1.0;
    else
      word.symbols[word.size() / 2] = word.symbols[word.size() / 2] == 0 ? 1 : 0;
    EXPECT_NE(one.objection(word), "") << one.name;
  }
}

TEST(DerivationRace, StopsWhenAsked) {
  DerivationRaceRequest request;
  request.cases = derivation_cases(20'000);
  request.is_interrupted = [] { return true; };
  EXPECT_THROW(race_derivations(request), Interrupted);
}

}  // namespace
}  // namespace phytobench
