// SPDX-License-Identifier: MIT
// What derive() says when it refuses. Each function throws InputError.
#pragma once

#include <cstdint>
#include <string>

#include "core/lsystem/lsystem.hpp"

namespace phytobench {

/// "tree.lsys:4:1: p2", or without the numbers where the production stands in no text.
std::string name_of(const LSystem& system, const Production& production);

/// The old word's module that was being replaced.
struct DerivationPlace {
  int step = 0;
  std::size_t position = 0;  ///< in the word before the step, from 0
  std::string module;        ///< as it is written
};

/// `made` is the module of the successor with the bad parameter, as it is written.
[[noreturn]] void refuse_parameter(const LSystem& system, const Production& production,
                                   const DerivationPlace& place, const std::string& made);

[[noreturn]] void refuse_condition(const LSystem& system, const Production& production,
                                   const DerivationPlace& place);

/// How long a word would be and how long it may be.
struct WordLength {
  std::uint64_t modules = 0;
  std::uint64_t parameters = 0;
};
/// Throws if the word of that step is longer than allowed; says that `fitting_step` is the last
/// that is not. A fitting_step below 0: not even the axiom.
void refuse_if_longer(const LSystem& system, const WordLength& length, const WordLength& most,
                      int step, int fitting_step);

}  // namespace phytobench
