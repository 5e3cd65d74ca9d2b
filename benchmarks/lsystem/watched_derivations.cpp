// SPDX-License-Identifier: MIT
#include "benchmarks/lsystem/watched_derivations.hpp"

#include <fmt/format.h>

#include "benchmarks/lsystem/signal_derivation.hpp"
#include "core/lsystem/read_lsystem.hpp"
#include "core/random/counter_stream.hpp"
#include "reference/oracles/liebemann2017_parametric_lsystems.hpp"

namespace phytobench {

namespace {

constexpr const char* twigs_text =
    "axiom: F\n"
    "F -> F[+F]F : 0.3\n"
    "F -> F[-F] : 0.3\n"
    "F -> FF : 0.4\n"
    "seed: 8\n";

/// Module by module, with equal bits: both multiply the same numbers in the same order.
std::string objection_to_modules(const LSystem& system, const Word& word,
                                 const oracles::ParametricWord& expected) {
  if (word.size() != expected.size())
    return fmt::format("{} modules instead of {}", word.size(), expected.size());
  const double* parameter = word.parameters.data();
  for (std::size_t i = 0; i < word.size(); ++i) {
    const Symbol& symbol = system.symbols[word.symbols[i]];
    const oracles::Module found{symbol.letter, {parameter, parameter + symbol.arity}};
    if (!(found == expected[i]))
      return fmt::format("module {} is {} instead of {}", i, oracles::text_of({found}),
                         oracles::text_of({expected[i]}));
    parameter += symbol.arity;
  }
  return "";
}

DerivationCase literal_tree() {
  constexpr int steps = 8;  // of figure 2.6
  DerivationCase tree = tree_derivation(steps);
  const LSystem system = tree.system;
  tree.objection = [system](const Word& word) {
    const auto G = oracles::liebemann2017::equation_2_17(18.95, 137.5, 1.3);
    return objection_to_modules(system, word, oracles::liebemann2017::derive(G, steps));
  };
  return tree;
}

/// As a string, letter by letter.
std::string literal_twigs(std::uint64_t seed, int steps) {
  std::string string = "F";
  for (int step = 1; step <= steps; ++step) {
    std::string next;
    for (std::size_t i = 0; i < string.size(); ++i) {
      const double unit = random_unit(seed, 2 * static_cast<std::uint64_t>(step), i);
      if (string[i] != 'F')
        next += string[i];
      else
        next += unit < 0.3 ? "F[+F]F" : unit < 0.3 + 0.3 ? "F[-F]" : "FF";
    }
    string = next;
  }
  return string;
}

DerivationCase twigs_derivation(int steps) {
  const LSystem system = parse_lsystem(twigs_text, "twigs");
  return {"twigs, by chance", twigs_text, system, steps, true, [system, steps](const Word& word) {
            const std::string expected = literal_twigs(system.seed, steps);
            const std::string found = text_of(system, word);
            return found == expected ? "" : "another word than string by string";
          }};
}

}  // namespace

std::vector<WatchedDerivation> watched_derivations() {
  return {
      {"derive-bush", "Derives the bush of [Brzoska2019] eq. 7, every word.",
       [] { return bush_derivation(9, true); }},
      {"derive-bush-last", "The same bush, but only its last word is asked for.",
       [] { return bush_derivation(9, false); }},
      {"derive-tree", "Derives the parametric tree of [Liebemann2017] eq. 2.17.", literal_tree},
      {"derive-row", "Derives a row in which each module takes the mean of three.",
       [] { return row_derivation(20'000, 5); }},
      {"derive-signal", "Hands a signal on from the root through a branching word.",
       [] { return signal_derivation(20'000, 12); }},
      {"derive-twigs", "Derives twigs whose productions are drawn by chance.",
       [] { return twigs_derivation(12); }},
  };
}

}  // namespace phytobench
