// SPDX-License-Identifier: MIT
// The two L-systems of [Alsweis] chapter 3 as the suite reads them.
#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <string_view>

#include "core/lsystem/read_lsystem.hpp"
#include "experiments/l_system_words.hpp"
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
