// SPDX-License-Identifier: MIT
// How fast derive() makes words with parameters, in space and with contexts: proven, then timed.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/lsystem/word.hpp"

namespace phytobench {

/// A derivation, and what its word must be.
struct DerivationCase {
  std::string name;
  LSystem system;
  int steps = 0;
  /// The words on the way are made, too. derive() passes over them where it can: without
  /// parameters, if nobody asks for them.
  bool every_word = true;
  std::function<std::string(const Word&)> objection;  ///< to the last word; empty if it is right
};

/// The tree of [Liebemann2017] eq. 2.17 (parametric), the bush of [Brzoska2019] eq. 7 (without
/// parameters, in space; every word, and the last alone), each with as many steps as keep the word
/// within `most_modules`, up to 13 and 12; and a row of so many modules, at most a million, in
/// which each takes the mean of itself and its neighbours (parametric, context on both sides) ten
/// times.
std::vector<DerivationCase> derivation_cases(std::uint64_t most_modules);

struct DerivationEntry {
  std::string name;
  int steps = 0;
  int threads = 1;
  std::string objection;      ///< why it got no time; empty if it did
  std::uint64_t modules = 0;  ///< of the last word
  bool every_word = true;
  std::uint64_t modules_made = 0;  ///< of all words but the axiom, or of the last word alone
  double bytes_per_module = 0.0;   ///< of the last word, parameters included
  std::vector<double> seconds;     ///< of all steps
};

struct DerivationRaceRequest {
  std::vector<DerivationCase> cases;
  std::vector<int> threads{1};
  int rounds = 7;
  std::uint64_t order_seed = 0;
  std::function<void(const std::string&)> show_progress = {};
  std::function<bool()> is_interrupted = {};
};

/// Throws Interrupted when asked to stop. Several threads must make the word of one, to the bit.
std::vector<DerivationEntry> race_derivations(const DerivationRaceRequest& request);

}  // namespace phytobench
