// SPDX-License-Identifier: MIT
#include "benchmarks/lsystem/watched_derivations.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/lsystem/derive.hpp"

namespace phytobench {
namespace {

Word derived(const DerivationCase& one, int steps) {
  DeriveOptions options;
  options.steps = steps;
  options.seed = one.system.seed;
  return derive(one.system, options);
}

TEST(WatchedDerivations, AcceptTheRightWordAlone) {
  for (const WatchedDerivation& watched : watched_derivations()) {
    const DerivationCase one = watched.make();
    Word word = derived(one, one.steps);
    EXPECT_EQ(one.objection(word), "") << watched.name;
    EXPECT_NE(one.objection(derived(one, one.steps - 1)), "") << watched.name;
    EXPECT_NE(one.objection(Word{}), "") << watched.name;
    if (word.parameters.size() > 0) {
      word.parameters[word.parameters.size() / 2] += 1.0;
    } else {
      std::size_t at = word.size() / 2;
      while (word.symbols[at] == word.symbols[at + 1]) ++at;
      std::swap(word.symbols[at], word.symbols[at + 1]);
    }
    EXPECT_NE(one.objection(word), "") << watched.name;
  }
}

/// A signal that has gone everywhere, or nowhere, would try little.
TEST(WatchedDerivations, TheSignalIsOnItsWay) {
  for (const WatchedDerivation& watched : watched_derivations()) {
    if (watched.name != "derive-signal") continue;
    const DerivationCase one = watched.make();
    const Word word = derived(one, one.steps);
    const double* const first = word.parameters.data();
    const auto without = std::count(first, first + word.parameters.size(), 0.0);
    EXPECT_GT(without, static_cast<std::ptrdiff_t>(word.parameters.size() / 10));
    EXPECT_LT(without, static_cast<std::ptrdiff_t>(word.parameters.size() / 2));
  }
}

}  // namespace
}  // namespace phytobench
