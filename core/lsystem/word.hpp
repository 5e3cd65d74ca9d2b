// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/lsystem/lsystem.hpp"
#include "core/memory/large_array.hpp"

namespace phytobench {

/// A word: one byte for each module, and the parameters of all modules one after the other.
struct Word {
  LargeArray<SymbolIndex> symbols;
  LargeArray<double> parameters;  ///< as many as the symbols' arities add up to

  std::size_t size() const { return symbols.size(); }
  std::size_t bytes() const { return symbols.size() + parameters.size() * sizeof(double); }
};

Word axiom_word(const LSystem& system);
Word copy_of(const Word& word);

/// The word as it is written, with the shortest digits that give the same numbers back:
/// "A(2,2)B(1)". A blank parts letters of more than one character from their neighbours: "al br".
std::string text_of(const LSystem& system, const Word& word);

/// How often each symbol of the system occurs.
std::vector<std::uint64_t> symbol_counts(const LSystem& system, const Word& word);

/// FNV-1a over letters, arities and the bits of parameters, as 16 hexadecimal digits: the same for
/// any numbering of the symbols.
std::string word_hash(const LSystem& system, const Word& word);

}  // namespace phytobench
