// SPDX-License-Identifier: MIT
#include "benchmarks/lsystem/derivation_race.hpp"

#include <utility>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/lsystem/derive.hpp"
#include "reference/oracles/lsystem_closed_forms.hpp"

namespace phytobench {
namespace {

TEST(DerivationRace, TimesWhatIsRight) {
  DerivationRaceRequest request;
  request.cases = derivation_cases(60'000);
  ASSERT_EQ(request.cases.size(), 6u);
  request.threads = {1, 2};
  request.rounds = 2;
  const std::vector<DerivationEntry> entries = race_derivations(request);
  ASSERT_EQ(entries.size(), 12u);
  for (const DerivationEntry& entry : entries) {
    EXPECT_EQ(entry.objection, "") << entry.name;
    EXPECT_EQ(entry.seconds.size(), 2u) << entry.name;
    EXPECT_GE(entry.modules_made, entry.modules) << entry.name;
    EXPECT_GE(entry.bytes_per_module, 1.0) << entry.name;
  }
  EXPECT_EQ(entries[0].modules, 55'762u);  // [Liebemann2017] fig. 2.6
  EXPECT_GT(entries[2].modules_made, entries[2].modules);
  EXPECT_EQ(entries[4].modules_made, entries[4].modules);  // the words before are passed over
  EXPECT_EQ(entries[6].name, "plant, every word");
  EXPECT_EQ(entries[10].modules_made, 600'000u);
}

/// The numbers of the works, or their closed forms: eq. 2.17 from figure 2.6 on, eq. 7 with seven
/// steps, eq. 6 with figure 14's seven.
TEST(DerivationRace, HasEveryNumberOfSteps) {
  std::vector<std::pair<std::string, int>> found;
  for (const DerivationCase& one : derivation_cases(60'000'000))
    found.emplace_back(one.name, one.steps);
  std::vector<std::pair<std::string, int>> expected;
  for (int n = 8; n <= 13; ++n) expected.emplace_back("tree, parametric", n);
  for (const char* words : {"every word", "last word alone"})
    for (int n = 7; n <= 12; ++n) expected.emplace_back(std::string("bush, ") + words, n);
  for (const char* words : {"every word", "last word alone"})
    for (int n = 7; n <= 11; ++n) expected.emplace_back(std::string("plant, ") + words, n);
  expected.emplace_back("row, parametric, contexts", 10);
  EXPECT_EQ(found, expected);
  EXPECT_EQ(modules_by_matrix(tree_derivation(8).system, 8), 55'762u);
  EXPECT_EQ(modules_by_matrix(bush_derivation(7, true).system, 7), 77'399u);
  EXPECT_EQ(modules_by_matrix(plant_derivation(7, true).system, 7), 187'834u);
  EXPECT_EQ(modules_by_matrix(plant_derivation(7, true).system, 11),
            oracles::equation_6_letters(11));
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
