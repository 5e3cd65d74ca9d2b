// SPDX-License-Identifier: MIT
#include <algorithm>

#include "benchmarks/lsystem/derivation_race.hpp"

namespace phytobench {

namespace {

/// From `first` steps on all that keep the word within so many modules, up to `last`; if not even
/// the first does, as many as do, but at least `least`.
template <class Make>
void add_each(std::vector<DerivationCase>& cases, const Make& make, int least, int first, int last,
              std::uint64_t most_modules) {
  const LSystem system = make(least).system;
  int most = least;
  while (most <= last && modules_by_matrix(system, most) <= most_modules) ++most;
  for (int n = std::min(first, most - 1); n < most; ++n)
    if (n >= least) cases.push_back(make(n));
}

}  // namespace

std::vector<DerivationCase> derivation_cases(std::uint64_t most_modules) {
  std::vector<DerivationCase> cases;
  add_each(cases, tree_derivation, 8, 8, 13, most_modules);
  for (const bool every_word : {true, false})
    add_each(
        cases, [&](int n) { return bush_derivation(n, every_word); }, 5, 7, 12, most_modules);
  for (const bool every_word : {true, false})
    add_each(
        cases, [&](int n) { return plant_derivation(n, every_word); }, 5, 7, 11, most_modules);
  constexpr std::uint64_t longest_row = 1'000'000;
  constexpr int row_steps = 10;
  cases.push_back(row_derivation(
      static_cast<std::size_t>(std::clamp<std::uint64_t>(most_modules, 3, longest_row)),
      row_steps));
  return cases;
}

}  // namespace phytobench
