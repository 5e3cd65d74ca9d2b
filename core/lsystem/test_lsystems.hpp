// SPDX-License-Identifier: MIT
// Texts for tests of L-systems.
#pragma once

#include <string>

#include "core/lsystem/read_lsystem.hpp"

namespace phytobench {

inline LSystem parsed(const std::string& text) {
  return parse_lsystem(text, "test.lsys");
}

/// [Alsweis] sec. 3.2, L-System1.
inline constexpr const char* stochastic_system =
    "w : A(1)B(3)A(5)\n"
    "p1 : A(x) -> A(x + 1) : 0.4\n"
    "p2 : A(x) -> B(x - 1) : 0.6\n"
    "p3 : A(x) < B(y) > A(z) : y < 4 -> B(x + z)[A(y)]\n";

/// [Alsweis] sec. 3.4, L-System2.
inline constexpr const char* query_system =
    "w : A\n"
    "p1 : A -> F(1)?P(x, y) - A\n"
    "p2 : F(k) -> F(k + 1)\n";

/// [Lintermann1997] sec. 2.1 with settings of every kind.
inline constexpr const char* bush_system =
    "# bush\n"
    "steps: 5   angle: 22.5   width_factor: 0.7   colours: #6b4a2b #457d29 # two\n"
    "turtle: words   start: upwards   draw: F   move: f   seed: 1\n"
    "\xcf\x89 : A\n"
    "p_1 : A ::= [&FL!A]/////'[&FL!A]\n"
    "            ///////'[&FL!A]\n"
    "p_2 : F ::= S/////F\n"
    "p_3 : S ::= FL\n"
    "p_4 : L ::= ['''^^{-f+f+f-|-f+f+f}]\n";

/// Constants, alphabet, random numbers and every operator.
inline constexpr const char* expression_system =
    "alphabet: ar al\n"
    "n = 3\n"
    "half = (1 + 2 ^ 2 * n) / 26\n"
    "ignore: + -\n"
    "axiom: ar al(half, n) A(1, 2)\n"
    "A(x, y) : (x < 4 && y >= 2) || !(x == y % 5) -> al(min(x, random(0, y)), -floor(y)) ar : "
    "half\n"
    "A(x, y) : (x < 4 && y >= 2) || !(x == y % 5) -> [A(x + 1, sin(y))]{.f.} : 1 - half\n"
    "ar < al(u, v) > A(x, y)[ar] : u != 0 -> ?H(p, q, r)\n";

}  // namespace phytobench
