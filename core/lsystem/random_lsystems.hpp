// SPDX-License-Identifier: MIT
// For tests: texts of L-systems that nobody would write.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/random/counter_stream.hpp"

namespace phytobench {

struct RandomSystemOptions {
  bool parametric = false;
  bool conditional = false;  ///< only with parameters
  bool probabilities = false;
  bool contexts = false;      ///< and ignored symbols
  bool random_calls = false;  ///< random() in parameters; only with parameters
};

class RandomSystem {
 public:
  RandomSystem(std::uint64_t seed, const RandomSystemOptions& options)
      : stream_(seed, 77), options_(options) {}

  std::string text() {
    std::string text =
        "axiom: " + word(3, 6, {"1", "2.5"}) + "A" + (arity('A') ? "(0.5)" : "") + "\n";
    in_axiom_ = false;
    if (options_.contexts) text += "ignore: +\n";
    for (const char letter : letters) text += productions_of(letter);
    return text;
  }
  /// Without the axiom; productions and settings only.
  static std::string productions_in(const std::string& text) {
    return text.substr(text.find('\n') + 1);
  }
  std::string word() {
    in_axiom_ = true;
    return word(1, 5, {"1", "2.5"});
  }

 private:
  using Names = std::vector<std::string>;
  static constexpr const char letters[] = {'A', 'B', 'C', 'D'};

  std::size_t below(std::size_t count) {
    return static_cast<std::size_t>(stream_.next_unit() * static_cast<double>(count));
  }
  bool chance(double probability) { return stream_.next_unit() < probability; }
  std::size_t arity(char letter) const {
    if (!options_.parametric || letter == 'C' || letter == '+') return 0;
    return letter == 'B' ? 2 : 1;
  }

  /// Between `least` and `most` modules, some in brackets.
  std::string word(std::size_t least, std::size_t most, const Names& names) {
    std::string text;
    const std::size_t length = least + below(most - least + 1);
    for (std::size_t i = 0; i < length; ++i) {
      const bool is_branch = chance(0.2);
      if (is_branch) text += "[";
      text += module(names);
      if (is_branch && chance(0.5)) text += module(names);
      if (is_branch) text += "]";
    }
    return text;
  }

  char letter() { return chance(0.15) ? '+' : letters[below(std::size(letters))]; }

  std::string module(const Names& names) {
    const char made = letter();
    std::string text(1, made);
    for (std::size_t p = 0; p < arity(made); ++p) text += (p == 0 ? "(" : ",") + expression(names);
    return arity(made) > 0 ? text + ")" : text;
  }

  /// Of values that stay small.
  std::string expression(const Names& names) {
    if (names.empty()) return "0.75";
    const std::string& a = names[below(names.size())];
    const std::string& b = names[below(names.size())];
    if (options_.random_calls && !in_axiom_ && chance(0.3)) return "random(" + a + ", 3)";
    switch (below(7)) {
      case 0:
        return "1.25";
      case 1:
        return a;
      case 2:
        return a + " + 0.5";
      case 3:
        return a + " * 0.7";
      case 4:
        return "(" + a + " + " + b + ") / 2";
      case 5:
        return a + " - " + b;
      default:
        return "sin(" + a + ")";
    }
  }

  /// A module with new names, for predecessors and contexts.
  std::string pattern_module(char of, Names& names) {
    std::string text(1, of);
    for (std::size_t p = 0; p < arity(of); ++p) {
      names.push_back(fmt::format("v{}", names.size()));
      text += (p == 0 ? "(" : ",") + names.back();
    }
    return arity(of) > 0 ? text + ")" : text;
  }
  char pattern_letter() { return letters[below(std::size(letters))]; }

  std::string productions_of(char letter) {
    std::string text;
    if (options_.contexts) text += contextual_production(letter);
    if (options_.conditional && arity(letter) > 0) {
      Names names;
      text += pattern_module(letter, names);
      text +=
          " : " + names[0] + (chance(0.5) ? " < 1" : " - 1") + " -> " + word(0, 3, names) + "\n";
    }
    if (chance(0.25)) return text;
    Names names;
    const std::string predecessor = pattern_module(letter, names);
    if (options_.probabilities && chance(0.7)) {
      text += predecessor + " -> " + word(0, 3, names) + " : 0.25\n";
      return text + predecessor + " -> " + word(1, 3, names) + " : 0.75\n";
    }
    return text + predecessor + " -> " + word(0, 4, names) + "\n";
  }

  std::string contextual_production(char letter) {
    Names names;
    std::string text;
    const std::size_t kind = below(3);
    if (kind != 0) {
      text += pattern_module(pattern_letter(), names);
      if (chance(0.3)) text += pattern_module(pattern_letter(), names);
      text += " < ";
    }
    text += pattern_module(letter, names);
    if (kind != 1) {
      text += " > ";
      if (chance(0.5)) text += "[" + pattern_module(pattern_letter(), names) + "]";
      if (chance(0.2)) text += "[" + pattern_module(pattern_letter(), names) + "]";
      text += pattern_module(pattern_letter(), names);
    }
    if (options_.conditional && !names.empty() && chance(0.5))
      text += " : " + names.front() + " < 2";
    return text + " -> " + word(0, 4, names) + "\n";
  }

  CounterStream stream_;
  RandomSystemOptions options_;
  bool in_axiom_ = true;  // where random() has no place
};

}  // namespace phytobench
