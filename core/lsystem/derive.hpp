// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "core/lsystem/word.hpp"

namespace phytobench {

/// Work of a derivation, independent of the machine, of threads and of blocks.
struct DerivationWork {
  std::uint64_t modules_read = 0;        ///< of all words that were replaced
  std::uint64_t modules_written = 0;     ///< of all words that were made
  std::uint64_t parameters_written = 0;  ///< the same
  /// Productions looked at where more than the letter decides; only with counts_inner_loop.
  std::uint64_t productions_tried = 0;
};

struct DeriveOptions {
  int steps = 0;                                ///< derivations, >= 0
  int threads = 1;                              ///< the word is the same for any number
  std::uint64_t seed = 0;                       ///< of random choices
  std::uint64_t most_modules = 100'000'000;     ///< longer words are refused before they are made
  std::uint64_t most_parameters = 400'000'000;  ///< words with more, of all modules, are, too
  /// Called now and then with the step (from 1); returning false throws Interrupted.
  std::function<bool(int step)> go_on = {};
  /// Called after each step, and with step 0 for the axiom; may be empty.
  std::function<void(int step, const Word& word)> each_word = {};
  DerivationWork* work = nullptr;  ///< is told what was done; may be null
};

/// The axiom derived so many times. All modules are replaced at once; a module that no production
/// fits stays as it is. Productions with contexts come before those without, then the first in the
/// text that fits is taken; a condition fits if its value is not 0. A group with probabilities
/// stands where its first member does, and one of it is drawn by
/// random_unit(seed, 2 * step, position of the module in the word before the step), steps from 1.
/// Query symbols hold what the turtle says after each step, and in the axiom.
///
/// Left context: the modules between here and the root, branches beside the path left out. Right
/// context: the modules that follow in this branch; branches that the pattern does not name are
/// left out, and a branch of the pattern must fit the beginning of some branch at its place here:
/// before the next module, and behind the branch that the pattern's last one fitted. The first
/// branch that fits is taken. Symbols that are ignored are seen by no context; a pattern that names
/// one fits nowhere.
///
/// Throws InputError, with the place of the production and the step, if a parameter or a condition
/// is not finite, if contexts meet brackets that do not match, and if a word would have more than
/// most_modules modules or more than most_parameters parameters (it says how many, and the last
/// step that fits). Where successors are fixed, that is known before anything is derived.
Word derive(const LSystem& system, const DeriveOptions& options);

/// Where random() of a production takes its numbers: stream 2 * step + 1, index 256 * position of
/// the module in the word before the step.
ExpressionRandom random_place_of(std::uint64_t seed, int step, std::uint64_t position);

/// Modules, parameters and symbols after each number of steps, without deriving; only for systems
/// with fixed successors. Counts are exact up to 2^64 - 1 and stay there (`saturated`).
struct GrowthForecast {
  struct Step {
    std::uint64_t modules = 0;
    std::uint64_t parameters = 0;
    std::vector<std::uint64_t> symbols;  ///< per symbol
    bool saturated = false;
  };
  std::vector<Step> steps;  ///< [0] is the axiom
};
/// Empty for other systems.
std::optional<GrowthForecast> growth_forecast(const LSystem& system, int steps);

}  // namespace phytobench
