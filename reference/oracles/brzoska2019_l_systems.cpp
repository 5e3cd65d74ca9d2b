// SPDX-License-Identifier: MIT
#include "reference/oracles/brzoska2019_l_systems.hpp"

namespace phytobench::oracles::brzoska2019 {

LSystem equation_4() {
  return {"ab", "b", {{'b', "a"}, {'a', "ab"}}};
}

LSystem equation_5() {
  return {"F-+", "F", {{'F', "F+F--F+F"}}};
}

LSystem equation_6_as_printed() {
  return {"F-+[]", "X", {{'F', "FF"}, {'X', "F[+++FX]F[---FX]F[++F-FX][F-FX]"}}};
}

LSystem equation_6_corrected() {
  LSystem G = equation_6_as_printed();
  G.V += 'X';
  return G;
}

LSystem equation_7() {
  return {R"(FfASL-+|&^\/[]'!{})",
          "A",
          {{'A', "[&FL!A]/////'[&FL!A]///////'[&FL!A]"},
           {'F', "S/////F"},
           {'S', "FL"},
           {'L', "[''^^{-f+f+f-|-f+f+f}]"}}};
}

std::string derive(const LSystem& G, int steps) {
  std::string word = G.omega;
  for (int step = 0; step < steps; ++step) {
    std::string next;
    for (const char letter : word) {
      std::string successor(1, letter);
      for (const Production& p : G.P)
        if (p.a == letter) successor = p.chi;
      next += successor;
    }
    word = next;
  }
  return word;
}

int letters_outside(std::string_view V, std::string_view word) {
  int outside = 0;
  for (const char letter : word) outside += V.find(letter) == std::string_view::npos ? 1 : 0;
  return outside;
}

int letters_outside_alphabet(const LSystem& G) {
  int outside = letters_outside(G.V, G.omega);
  for (const Production& p : G.P)
    outside += letters_outside(G.V, std::string(1, p.a)) + letters_outside(G.V, p.chi);
  return outside;
}

}  // namespace phytobench::oracles::brzoska2019
