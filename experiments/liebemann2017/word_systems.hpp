// SPDX-License-Identifier: MIT
// The L-systems of [Liebemann2017] sec. 2.2 as the suite reads them, and words of theirs.
#pragma once

#include <string>
#include <utility>

#include "experiments/liebemann2017/drawn_systems.hpp"

namespace phytobench::experiments::liebemann2017 {

/// Eq. 2.1.
inline LSystem anabaena_system(const std::string& axiom = "ar") {
  return parse_lsystem("alphabet: ar al br bl\naxiom: " + axiom +
                           "\np1 : ar -> al br\np2 : al -> bl ar\np3 : br -> ar\np4 : bl -> al\n",
                       "equation 2.1");
}

/// Eq. 2.2.
inline LSystem parametric_system(const std::string& axiom = "A(1, 1)") {
  return parse_lsystem(
      "axiom: " + axiom + "\np1 : A(x, y) -> A(x + 1, y * 2) B(y)\np2 : B(x) -> B(x + 1) C\n",
      "equation 2.2");
}

/// The system with the word as its axiom.
inline LSystem with_axiom(LSystem system, const Word& word) {
  system.axiom.clear();
  std::size_t parameter = 0;
  for (std::size_t i = 0; i < word.size(); ++i) {
    AxiomModule module;
    module.symbol = word.symbols[i];
    for (int k = 0; k < system.symbols[module.symbol].arity; ++k)
      module.parameters.push_back(word.parameters[parameter++]);
    system.axiom.push_back(std::move(module));
  }
  return system;
}

}  // namespace phytobench::experiments::liebemann2017
