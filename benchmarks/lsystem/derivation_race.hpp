// SPDX-License-Identifier: MIT
// How fast derive() makes words with parameters, in space and with contexts: proven, then timed.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "benchmarks/lsystem/derivation_case.hpp"

namespace phytobench {

/// The tree of [Liebemann2017] eq. 2.17 with 8 to 13 derivations, the bush of [Brzoska2019] eq. 7
/// with 7 to 12 and the plant of its eq. 6 with 7 to 11 (every word, and the last alone), each as
/// far as the word keeps within `most_modules` (bush and plant go down to 5 for that); and a row of
/// so many modules, at most a million, with contexts on both sides, ten times.
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
