// SPDX-License-Identifier: MIT
// The L-systems whose drawings [Liebemann2017] ch. 2 shows, and words written out for one
// measurement.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/lsystem/read_lsystem.hpp"
#include "experiments/l_system_words.hpp"
#include "reference/oracles/parametric_word.hpp"

namespace phytobench::experiments::liebemann2017 {

/// Eq. 2.6 with the line length of figure 2.4 after n steps, 400 / 4^n.
inline double koch_step(int n) {
  return 400.0 / std::pow(4.0, n);
}
inline LSystem koch_system(double step) {
  return parse_lsystem(
      fmt::format("axiom: F-F-F-F\np1 : F -> F+F-F-FF+F+F-F\nangle: 90 step: {}\n", step),
      "equation 2.6");
}

inline constexpr int plant_a_steps = 4, plant_b_steps = 5;  // figure 2.5
inline LSystem plant_a_system() {
  return parse_lsystem("axiom: F\np1 : F -> FF-[-F+F+F]+[+F-F-F]\nangle: 25 step: 18\n",
                       "figure 2.5a");
}
inline LSystem plant_b_system() {
  return parse_lsystem("axiom: F\np1 : F -> F[-F]F[+F][F]\nangle: 25 step: 15\n", "figure 2.5b");
}

/// Figure 2.6: d = 137.5 degrees, l_r = 1.3.
inline constexpr int space_tree_steps = 8;
inline constexpr double pitch_a_deg = 18.95, pitch_b_deg = 36.0, space_tree_growth = 1.3;

/// Eq. 2.17; `settings` are lines of the text format, as "start: local".
inline LSystem space_tree_system(double pitch_deg, const std::string& settings = "start: local",
                                 double divergence_deg = 137.5, double growth = space_tree_growth) {
  return parse_lsystem(fmt::format("a = {}\nd = {}\nlr = {}\naxiom: /(45)A\n"
                                   "p1 : A -> F(50)[&(a)F(50)A]/(d)[&(a)F(50)A]/(d)[&(a)F(50)A]\n"
                                   "p2 : F(l) -> F(l * lr)\n{}\n",
                                   pitch_deg, divergence_deg, growth, settings),
                       "equation 2.17");
}

/// How many modules have that letter, whatever their parameters.
inline std::int64_t letter_count(const LSystem& system, const Word& word,
                                 const std::string& letter) {
  const std::vector<std::uint64_t> counts = symbol_counts(system, word);
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < counts.size(); ++i)
    if (system.symbols[i].letter == letter) sum += counts[i];
  return static_cast<std::int64_t>(sum);
}

/// A word that no production made.
struct WrittenWord {
  LSystem system;
  Word word;
};
inline WrittenWord written(const std::string& text,
                           const std::string& settings = "start: upwards") {
  WrittenWord made;
  made.system = parse_lsystem("axiom: " + text + "\n" + settings + "\n", "written word");
  made.word = axiom_word(made.system);
  return made;
}
inline Drawing drawing_of(const std::string& text, const std::string& settings = "start: upwards") {
  const WrittenWord made = written(text, settings);
  return draw(made.system, made.word);
}

/// The same word for the literal turtles.
inline oracles::ParametricWord literal_word(const LSystem& system, const Word& word) {
  oracles::ParametricWord literal;
  std::size_t parameter = 0;
  for (std::size_t i = 0; i < word.size(); ++i) {
    const Symbol& module = system.symbols[word.symbols[i]];
    literal.push_back({module.letter, {}});
    for (int k = 0; k < module.arity; ++k)
      literal.back().parameters.push_back(word.parameters[parameter++]);
  }
  return literal;
}

inline double largest_entry(const Vector3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// Greatest difference of a coordinate between drawn segments and those of a literal turtle, or
/// largest() if their numbers differ.
template <class Segments, class LiteralSegments>
double segments_off(const Segments& found, const LiteralSegments& literal) {
  if (found.size() != literal.size()) return std::numeric_limits<double>::max();
  const auto in_space = [](const auto& p) {
    if constexpr (requires { p.z; })
      return Vector3{p.x, p.y, p.z};
    else
      return Vector3{p.x, p.y, 0.0};
  };
  double off = 0.0;
  for (std::size_t i = 0; i < found.size(); ++i)
    off = std::max({off, largest_entry(in_space(found[i].from) - in_space(literal[i].from)),
                    largest_entry(in_space(found[i].to) - in_space(literal[i].to))});
  return off;
}

}  // namespace phytobench::experiments::liebemann2017
