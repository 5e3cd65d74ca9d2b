// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>

#include "core/lsystem/segment_stream.hpp"

namespace phytobench {

namespace {

bool occurs(const LSystem& system, std::string_view letter) {
  return std::any_of(system.symbols.begin(), system.symbols.end(),
                     [&](const Symbol& symbol) { return symbol.letter == letter; });
}

bool rewrites_brackets(const LSystem& system) {
  return std::any_of(
      system.productions.begin(), system.productions.end(), [&](const Production& production) {
        const std::string& letter = system.symbols[production.predecessor.symbol].letter;
        return letter == "[" || letter == "]";
      });
}

}  // namespace

std::string objection_to_streaming(const LSystem& system) {
  const LSystemKind kind = kind_of(system);
  if (kind.queries) return "asks the turtle (?P, ?H, ?L, ?U), which only a word can be told";
  if (kind.parametric) return "has parameters; only systems without can be drawn without the word";
  if (kind.contextual) return "has contexts; only systems without can be drawn without the word";
  if (kind.conditional) return "has conditions; only systems without can be drawn without the word";
  if (kind.stochastic) return "draws lots; only systems that do not can be drawn without the word";
  if (occurs(system, "%")) return "cuts branches off (%), which depends on what stands before";
  if (occurs(system, "$")) return "levels the turtle ($), which depends on how it stands";
  if (rewrites_brackets(system)) return "has a production for a bracket";
  return "";
}

}  // namespace phytobench
