// SPDX-License-Identifier: MIT
// The L-systems of [Brzoska2019] eq. 4 to 7, letter by letter. Shares no code with core/, so that
// agreement means something.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace phytobench::oracles::brzoska2019 {

// p: predecessor -> successor.
struct Production {
  char a;
  std::string chi;
};

// G = <V, omega, P>.
struct LSystem {
  std::string V;
  std::string omega;
  std::vector<Production> P;
};

// Eq. 4 to 7. The production p4 of eq. 7 has two primes, as printed.
LSystem equation_4();
LSystem equation_5();
LSystem equation_6_as_printed();
LSystem equation_6_corrected();  // X joins the alphabet
LSystem equation_7();

// Sec. 3.4.2: in each step every letter is replaced at once; one without a production stays.
std::string derive(const LSystem& G, int steps);

// Letters of a word that are not in V.
int letters_outside(std::string_view V, std::string_view word);

// The same of the axiom and of both sides of all productions. Sec. 3.4.2 demands zero.
int letters_outside_alphabet(const LSystem& G);

}  // namespace phytobench::oracles::brzoska2019
