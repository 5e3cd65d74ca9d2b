// SPDX-License-Identifier: MIT
// The bush of [Lintermann1997] sec. 2.1 as an L-system of the suite, in both prints.
#pragma once

#include <string>
#include <string_view>

#include <fmt/format.h>

#include "core/lsystem/read_lsystem.hpp"
#include "experiments/l_system_words.hpp"
#include "reference/oracles/lintermann1997_bush.hpp"

namespace phytobench::experiments::lintermann1997 {

using oracles::lintermann1997::BushPrint;

/// Five, seven and five slashes, as the book has them that figure 1 is taken from.
inline BushPrint bush_of_the_book() {
  return {};
}

/// Eight slashes each, as the article's text has them.
inline BushPrint bush_as_printed() {
  BushPrint print;
  print.slashes_first = print.slashes_second = print.slashes_stem = 8;
  return print;
}

/// `settings` is added as a line of the L-system's text.
inline LSystem bush_system(const BushPrint& print, std::string_view settings = "turtle: words") {
  const auto slashes = [](int count) { return std::string(static_cast<std::size_t>(count), '/'); };
  const std::string primes(static_cast<std::size_t>(print.leaf_primes), '\'');
  const std::string text = fmt::format(
      "axiom: A\nangle: 22.5\n{}\n"
      "p1 : A ::= [&FL!A]{}'[&FL!A]{}'[&FL!A]\n"
      "p2 : F ::= S{}F\n"
      "p3 : S ::= FL\n"
      "p4 : L ::= [{}^^{{-f+f+f-|-f+f+f}}]\n",
      settings, slashes(print.slashes_first), slashes(print.slashes_second),
      slashes(print.slashes_stem), primes);
  return parse_lsystem(text, "bush");
}

}  // namespace phytobench::experiments::lintermann1997
