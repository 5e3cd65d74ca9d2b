// SPDX-License-Identifier: MIT
// Systems and words for tests, without parser and derivation: what is tested with them does not
// depend on those.
#pragma once

#include <algorithm>
#include <charconv>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "core/lsystem/drawing.hpp"
#include "core/lsystem/lsystem.hpp"
#include "core/lsystem/word.hpp"

namespace phytobench {

/// `axiom` with all letters replaced at once, so many times.
inline std::string rewritten(std::string axiom, const std::map<char, std::string>& rules,
                             int steps) {
  for (int step = 0; step < steps; ++step) {
    std::string next;
    for (const char c : axiom) {
      const auto rule = rules.find(c);
      if (rule == rules.end())
        next += c;
      else
        next += rule->second;
    }
    axiom = std::move(next);
  }
  return axiom;
}

/// A system without productions, to which words add their symbols, and the words.
class TestWords {
 public:
  explicit TestWords(TurtleSettings turtle = {}) {
    system.source = "test";
    system.turtle = std::move(turtle);
  }

  /// The modules of "F(1,2)[+(30)A]?P(0,0)".
  Word word(std::string_view text) {
    std::vector<SymbolIndex> symbols;
    std::vector<double> parameters;
    while (!text.empty()) {
      const std::size_t letter_size = text[0] == '?' ? 2 : 1;
      const std::string letter(text.substr(0, letter_size));
      text.remove_prefix(letter_size);
      const std::size_t before = parameters.size();
      if (!text.empty() && text[0] == '(') read_parameters(text, parameters);
      symbols.push_back(symbol(letter, static_cast<std::uint8_t>(parameters.size() - before)));
    }
    Word result;
    result.symbols.resize_for_overwrite(symbols.size());
    std::copy(symbols.begin(), symbols.end(), result.symbols.begin());
    result.parameters.resize_for_overwrite(parameters.size());
    std::copy(parameters.begin(), parameters.end(), result.parameters.begin());
    return result;
  }

  /// word() first, which may add symbols.
  Drawing drawn(std::string_view text) {
    const Word made = word(text);
    return draw(system, made);
  }
  TurtleTree tree(std::string_view text) {
    const Word made = word(text);
    return turtle_tree(system, made);
  }

  LSystem system;

 private:
  static void read_parameters(std::string_view& text, std::vector<double>& parameters) {
    while (text[0] != ')') {
      text.remove_prefix(1);
      double value = 0.0;
      const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
      text.remove_prefix(static_cast<std::size_t>(end - text.data()));
      parameters.push_back(value);
    }
    text.remove_prefix(1);
  }

  SymbolIndex symbol(const std::string& letter, std::uint8_t arity) {
    const auto found = std::find_if(
        system.symbols.begin(), system.symbols.end(),
        [&](const Symbol& known) { return known.letter == letter && known.arity == arity; });
    const auto index = static_cast<SymbolIndex>(found - system.symbols.begin());
    if (found == system.symbols.end()) system.symbols.push_back({letter, arity});
    return index;
  }
};

/// Settings that differ from the defaults in these.
inline TurtleSettings test_turtle(double angle_deg, double step = 1.0,
                                  TurtleStart start = TurtleStart::upwards,
                                  TurtleConvention convention = TurtleConvention::words) {
  TurtleSettings turtle;
  turtle.angle_deg = angle_deg;
  turtle.step = step;
  turtle.start = start;
  turtle.convention = convention;
  return turtle;
}

/// [Liebemann2017] eq. 2.17 after n steps with d = 137.5 and lr = 1.3.
inline std::string ternary_word(int steps, double pitch_deg) {
  std::string word = "A";
  std::string length = "50";
  std::vector<std::string> lengths;  // of what step n, n - 1, ... made
  double grown = 50.0;
  for (int step = 0; step < steps; ++step, grown *= 1.3)
    lengths.push_back(fmt::format("{}", grown));
  const std::string pitch = fmt::format("&({})", pitch_deg);
  for (int age = 0; age < steps; ++age) {  // from the tips down
    const std::string piece = "F(" + lengths[static_cast<std::size_t>(age)] + ")";
    const std::string branch = "[" + pitch + piece + word + "]";
    word = piece + branch + "/(137.5)" + branch + "/(137.5)" + branch;
  }
  return "/(45)" + word;
}

/// The bush of [Lintermann1997] sec. 2.1 with so many slashes in its three runs.
inline std::string bush_word(int steps, std::size_t first, std::size_t second,
                             std::size_t in_shoot) {
  const std::string branch = "[&FL!A]";
  return rewritten("A",
                   {{'A', branch + std::string(first, '/') + "'" + branch +
                              std::string(second, '/') + "'" + branch},
                    {'F', "S" + std::string(in_shoot, '/') + "F"},
                    {'S', "FL"},
                    {'L', "['''^^{-f+f+f-|-f+f+f}]"}},
                   steps);
}

}  // namespace phytobench
