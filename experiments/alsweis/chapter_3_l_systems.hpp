// SPDX-License-Identifier: MIT
// The two L-systems of [Alsweis] chapter 3 as the suite reads them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "core/contract/errors.hpp"
#include "core/lsystem/derive.hpp"
#include "core/lsystem/drawing.hpp"
#include "core/lsystem/read_lsystem.hpp"
#include "core/random/counter_stream.hpp"
#include "reference/oracles/alsweis_lsystems.hpp"

namespace phytobench::experiments::alsweis {

/// The productions of L-system 1 with other probabilities of p1 and p2.
inline std::string l_system_1_text(const std::string& p1 = "0.4", const std::string& p2 = "0.6",
                                   const std::string& axiom = "A(1)B(3)A(5)") {
  return "axiom: " + axiom + "\np1: A(x) -> A(x + 1) : " + p1 + "\np2: A(x) -> B(x - 1) : " + p2 +
         "\np3: A(x) < B(y) > A(z) : y < 4 -> B(x + z)[A(y)]\n";
}

/// The angle is our reading (R7), as are place and direction of the start.
inline constexpr std::string_view l_system_2_text =
    "axiom: A\np1: A -> F(1)?P(x, y)-A\np2: F(k) -> F(k + 1)\nangle: 90\n";

inline LSystem l_system(std::string_view text) {
  return parse_lsystem(text, "chapter 3");
}

inline bool is_refused(std::string_view text) {
  try {
    l_system(text);
  } catch (const InputError&) {
    return true;
  }
  return false;
}

inline Word derived(const LSystem& system, int steps, std::uint64_t seed = 0) {
  DeriveOptions options;
  options.steps = steps;
  options.seed = seed;
  return derive(system, options);
}

inline std::string word_after(const LSystem& system, int steps, std::uint64_t seed = 0) {
  return text_of(system, derived(system, steps, seed));
}

/// What the turtle draws along a word that nothing replaces.
inline Drawing drawn_word(const std::string& letters, double angle_deg) {
  LSystem system = l_system("axiom: " + letters + "\n");
  system.turtle.angle_deg = angle_deg;
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

/// Words of L-system 1 and their probabilities.
using WordLaw = std::map<std::string, oracles::alsweis::FifthsProbability>;
inline constexpr int most_steps_of_l_system_1 = 4;

/// A word in the name of a measurement: "a2b6_a3_b4".
inline std::string name_of_word(std::string word) {
  std::erase_if(word, [](char c) { return c == '(' || c == ')'; });
  std::replace(word.begin(), word.end(), 'A', 'a');
  std::replace(word.begin(), word.end(), 'B', 'b');
  std::replace_if(
      word.begin(), word.end(), [](char c) { return c == '[' || c == ']'; }, '_');
  return word;
}

inline double value_of(oracles::alsweis::FifthsProbability p) {
  return static_cast<double>(p.numerator) / static_cast<double>(p.denominator);
}

}  // namespace phytobench::experiments::alsweis
