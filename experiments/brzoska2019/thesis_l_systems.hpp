// SPDX-License-Identifier: MIT
// The L-systems of [Brzoska2019] sec. 3.4.2 as the suite reads them, and words of theirs.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "core/lsystem/derive.hpp"
#include "core/lsystem/drawing.hpp"
#include "core/lsystem/read_lsystem.hpp"
#include "core/random/counter_stream.hpp"

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

inline Word derived(const LSystem& system, int steps, int threads = 1) {
  DeriveOptions options;
  options.steps = steps;
  options.threads = threads;
  return derive(system, options);
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

inline std::string word_after(const LSystem& system, int steps) {
  return text_of(system, derived(system, steps));
}

/// What the turtle draws along a word that nothing replaces.
inline Drawing drawn_word(std::string_view letters, double angle_deg) {
  const LSystem system =
      parse_lsystem(fmt::format("axiom: {}\nangle: {}\n", letters, angle_deg), "word");
  return draw(system, axiom_word(system));
}

inline std::string random_letters(UnitStream& stream, std::string_view from, std::size_t count) {
  std::string letters;
  for (std::size_t i = 0; i < count; ++i)
    letters +=
        from[static_cast<std::size_t>(stream.next_unit() * static_cast<double>(from.size()))];
  return letters;
}

inline std::int64_t whole(std::size_t number) {
  return static_cast<std::int64_t>(number);
}

}  // namespace phytobench::experiments::brzoska2019
