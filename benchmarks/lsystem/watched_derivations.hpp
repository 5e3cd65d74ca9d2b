// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "benchmarks/lsystem/derivation_case.hpp"

namespace phytobench {

/// A derivation that takes milliseconds, and whose word is known module by module.
struct WatchedDerivation {
  std::string name;     ///< "derive-tree"
  std::string summary;  ///< one sentence
  std::function<DerivationCase()> make;
};

/// One for each way in which a production may be chosen: by the letter alone (with and without the
/// words on the way), with parameters, by neighbours on both sides, by the neighbour towards the
/// root of a branching word with a condition, and by chance. Their objections share no code with
/// derive() but the text's reader and, for chance, random_unit().
std::vector<WatchedDerivation> watched_derivations();

}  // namespace phytobench
