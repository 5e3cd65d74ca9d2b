// SPDX-License-Identifier: MIT
// How often each letter of a D0L-system occurs after n steps, by its matrix: entry (b, a) says how
// many b the successor of a has. No word is derived, no number is too large. For systems with
// parameters letters stand for letter and number of parameters. Shares no code with core/.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reference/oracles/natural.hpp"

namespace phytobench::oracles {

struct D0LStructure {
  std::vector<std::string> axiom;
  std::map<std::string, std::vector<std::string>> successors;  // a letter that lacks one stays
};

using LetterCounts = std::map<std::string, Natural>;

// Letters that do not occur have no entry.
LetterCounts letter_counts(const D0LStructure& system, int n);

// The same, or nothing where it takes more than so much work: a unit for each digit that is added,
// and twenty for each addition.
std::optional<LetterCounts> letter_counts_within(const D0LStructure& system, int n,
                                                 double most_work);

// The same by squaring the matrix: another way to the same numbers, and for many steps.
LetterCounts letter_counts_by_powers(const D0LStructure& system, int n);

Natural count_of(const LetterCounts& counts, const std::string& letter);
Natural word_length(const LetterCounts& counts);

// Segments that a turtle draws: of every letter in `draws`, each of which is one character.
Natural drawn_segments(const LetterCounts& counts, std::string_view draws);

}  // namespace phytobench::oracles
