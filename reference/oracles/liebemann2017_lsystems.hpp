// SPDX-License-Identifier: MIT
// The D0L-systems of [Liebemann2017] ch. 2 and the ways in which their productions may be applied,
// letter by letter. Shares no code with core/, so that agreement means something.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace phytobench::oracles::liebemann2017 {

// Letters may have more than one character: a_l is "al".
using Letters = std::vector<std::string>;

// P : a -> b.
struct Rule {
  std::string a;
  Letters b;
};

// G = (V, P, omega); V is what occurs.
struct D0LSystem {
  Letters omega;
  std::vector<Rule> P;  // in the order in which they are printed
};

Letters one_by_one(std::string_view text);      // every character but blanks is a letter
Letters between_blanks(std::string_view text);  // every run without a blank is a letter
std::string joined(const Letters& word, std::string_view separator = "");

D0LSystem equation_2_1();
D0LSystem equation_2_6();
D0LSystem figure_2_5a();
D0LSystem figure_2_5b();

// Definition 2.1: all letters at once; a letter without a production stays.
Letters derive_in_parallel(const D0LSystem& G, int n);

// Sec. 4.2.2 at its word: always the same string, and in each derivation every production in turn
// replaces what it finds, so that later productions see what earlier ones wrote.
Letters derive_rule_after_rule(const D0LSystem& G, int n);

// The end of sec. 2.1: one string is gone through from left to right, and each replacement changes
// it at once. The text leaves open where to go on: behind the successor, or at the next letter,
// which may be one that has just been written.
enum class GoOn { behind_the_successor, at_the_next_letter };

// Nothing if a derivation needs more than `most` replacements.
std::optional<Letters> derive_left_to_right(const D0LSystem& G, int n, GoOn go_on,
                                            std::size_t most);

}  // namespace phytobench::oracles::liebemann2017
