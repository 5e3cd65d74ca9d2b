// SPDX-License-Identifier: MIT
// The L-systems of [Brzoska2019] sec. 3.4.2 as the suite reads them, and words of theirs.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/lsystem/read_lsystem.hpp"
#include "experiments/l_system_words.hpp"

namespace phytobench::experiments::brzoska2019 {

/// As printed, but for the X that the alphabet of eq. 6 lacks (E7).
inline constexpr const char* equation_4_text =
    "V : {a, b}\nomega: b\np1: b -> a\np2: a -> ab\nangle: 90\n";
inline constexpr const char* equation_5_text =
    "V : {F, -, +}\nomega: F\np: F -> F+F--F+F\nangle: 60\n";
inline constexpr const char* equation_6_text =
    "V : {F, X, -, +, [, ]}\nomega: X\np1: F -> FF\n"
    "p2: X -> F[+++FX]F[---FX]F[++F-FX][F-FX]\nangle: 10\n";

/// Without its alphabet, which has a comma of its own. Our transcription of p4 has two primes; the
/// book that the section cites has three (A13).
inline std::string equation_7_text(int leaf_primes = 2) {
  return "omega: A\np1: A -> [&FL!A]/////'[&FL!A]///////'[&FL!A]\np2: F -> S/////F\np3: S -> FL\n"
         "p4: L -> [" +
         std::string(static_cast<std::size_t>(leaf_primes), '\'') +
         "^^{-f+f+f-|-f+f+f}]\nangle: 22.5\n";
}

inline LSystem thesis_l_system(const std::string& text) {
  return parse_lsystem(text, "thesis");
}

/// The system with another axiom, all of whose letters have one character and no parameters.
inline LSystem with_axiom(LSystem system, std::string_view letters) {
  system.axiom.clear();
  for (const char c : letters) {
    const std::string letter(1, c);
    if (!find_symbol(system, letter, 0)) {
      system.symbols.push_back({letter, 0});
      system.ignored.push_back(false);
    }
    system.axiom.push_back({*find_symbol(system, letter, 0), {}});
  }
  return system;
}

}  // namespace phytobench::experiments::brzoska2019
