// SPDX-License-Identifier: MIT
// What a derived word must be, found without deriving one.
#pragma once

#include <string>

#include "core/lsystem/word.hpp"

namespace phytobench {

/// What is wrong with a word of a system without parameters, choices and contexts; empty if
/// nothing. Each letter of the axiom is followed down its productions, one successor after the
/// other, and what it ends in compared with what stands in the word: no word is rewritten, and none
/// is held. Time of the order of the word's length.
std::string objection_to_letters(const LSystem& system, int steps, const Word& word);

}  // namespace phytobench
