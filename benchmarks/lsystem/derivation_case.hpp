// SPDX-License-Identifier: MIT
// Derivations that are raced or watched, each with an objection that was found without derive().
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "core/lsystem/word.hpp"

namespace phytobench {

/// A derivation, and what its word must be.
struct DerivationCase {
  std::string name;
  std::string text;  ///< what the system was read from; its axiom may have been replaced since
  LSystem system;
  int steps = 0;
  /// The words on the way are made, too. derive() passes over them where it can: without
  /// parameters, if nobody asks for them.
  bool every_word = true;
  std::function<std::string(const Word&)> objection;  ///< to the last word; empty if it is right
};

/// The tree of [Liebemann2017] eq. 2.17 with the angles of figure 2.6a: parametric. Letters are
/// counted by matrix and closed form, parameters are added up.
DerivationCase tree_derivation(int steps);

/// The bush of [Brzoska2019] eq. 7 in space, and the plant of its eq. 6: without parameters. Every
/// letter is followed down its productions, and closed forms give the length.
DerivationCase bush_derivation(int steps, bool every_word);
DerivationCase plant_derivation(int steps, bool every_word);

/// A row of at least three modules in which each takes the mean of itself and its neighbours:
/// parametric, with a context on both sides. The same means in an array, to the bit.
DerivationCase row_derivation(std::size_t modules, int steps);

/// Letters after so many steps, by the matrix of the system's letters; 2^64 - 1 for more.
std::uint64_t modules_by_matrix(const LSystem& system, int steps);

}  // namespace phytobench
