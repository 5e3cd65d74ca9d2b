// SPDX-License-Identifier: MIT
#include "core/lsystem/word.hpp"

#include <algorithm>
#include <bit>

#include <fmt/format.h>

#include "core/lsystem/module_text.hpp"
#include "core/lsystem/symbol_histogram.hpp"

namespace phytobench {

namespace {

/// More than one character, in UTF-8, and no query: such letters are declared.
bool is_declared(const std::string& letter) {
  const auto begins_character = [](char c) {
    return (static_cast<unsigned char>(c) & 0xc0) != 0x80;
  };
  return !letter.starts_with('?') &&
         std::count_if(letter.begin(), letter.end(), begins_character) > 1;
}

bool is_bracket(const Symbol& symbol) {
  return symbol.letter == "[" || symbol.letter == "]";
}

/// Where a blank keeps letters apart that a reader, who takes the longest that fits, would join.
class Blanks {
 public:
  explicit Blanks(const LSystem& system) {
    const std::vector<Symbol>& symbols = system.symbols;
    for (const Symbol& symbol : symbols) {
      const bool begins_declared =
          std::any_of(symbols.begin(), symbols.end(), [&](const Symbol& s) {
            return is_declared(s.letter) && s.letter.starts_with(symbol.letter);
          });
      const bool ends_itself = symbol.arity > 0 || is_bracket(symbol);
      sides_.push_back({ends_itself, begins_declared, is_declared(symbol.letter)});
    }
  }

  bool between(SymbolIndex left, SymbolIndex right, const Symbol& right_symbol) const {
    if (sides_[left].ends_itself || is_bracket(right_symbol)) return false;
    return sides_[left].begins_declared || sides_[right].declared;
  }

 private:
  struct Sides {
    bool ends_itself, begins_declared, declared;
  };
  std::vector<Sides> sides_;  // per symbol
};

class Fnv1a {
 public:
  void add(unsigned char byte) { hash_ = (hash_ ^ byte) * 0x100000001b3u; }
  void add(const std::string& text) {
    for (const char c : text) add(static_cast<unsigned char>(c));
  }
  void add(double number) {
    const auto bits = std::bit_cast<std::uint64_t>(number);
    for (int shift = 0; shift < 64; shift += 8)
      add(static_cast<unsigned char>(bits >> shift & 0xff));
  }
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325u;
};

}  // namespace

Word axiom_word(const LSystem& system) {
  std::size_t parameter_count = 0;
  for (const AxiomModule& module : system.axiom) parameter_count += module.parameters.size();
  Word word;
  word.symbols.resize_for_overwrite(system.axiom.size());
  word.parameters.resize_for_overwrite(parameter_count);
  double* parameter = word.parameters.data();
  for (std::size_t i = 0; i < system.axiom.size(); ++i) {
    word.symbols[i] = system.axiom[i].symbol;
    parameter =
        std::copy(system.axiom[i].parameters.begin(), system.axiom[i].parameters.end(), parameter);
  }
  return word;
}

Word copy_of(const Word& word) {
  Word copy;
  copy.symbols.resize_for_overwrite(word.size());
  copy.parameters.resize_for_overwrite(word.parameters.size());
  std::copy_n(word.symbols.data(), word.size(), copy.symbols.data());
  std::copy_n(word.parameters.data(), word.parameters.size(), copy.parameters.data());
  return copy;
}

std::string text_of(const LSystem& system, const Word& word) {
  std::string text;
  const double* parameter = word.parameters.data();
  const Blanks blanks(system);
  for (std::size_t i = 0; i < word.size(); ++i) {
    const Symbol& symbol = system.symbols[word.symbols[i]];
    if (i > 0 && blanks.between(word.symbols[i - 1], word.symbols[i], symbol)) text += ' ';
    append_module(text, symbol, parameter);
    parameter += symbol.arity;
  }
  return text;
}

std::vector<std::uint64_t> symbol_counts(const LSystem& system, const Word& word) {
  const SymbolHistogram counts = histogram_of({word.symbols.data(), word.size()});
  return {counts.begin(), counts.begin() + static_cast<std::ptrdiff_t>(system.symbols.size())};
}

std::string word_hash(const LSystem& system, const Word& word) {
  Fnv1a hash;
  const double* parameter = word.parameters.data();
  for (std::size_t i = 0; i < word.size(); ++i) {
    const Symbol& symbol = system.symbols[word.symbols[i]];
    hash.add(symbol.letter);
    hash.add(symbol.arity);
    for (std::size_t p = 0; p < symbol.arity; ++p) hash.add(*parameter++);
  }
  return fmt::format("{:016x}", hash.value());
}

}  // namespace phytobench
