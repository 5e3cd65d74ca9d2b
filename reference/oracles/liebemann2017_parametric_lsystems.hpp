// SPDX-License-Identifier: MIT
// Parametric L-systems by [Liebemann2017] sec. 2.2.1, with functions as successors. Shares no code
// with core/, so that agreement means something.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "reference/oracles/parametric_word.hpp"

namespace phytobench::oracles::liebemann2017 {

// Applies to modules of that letter with that number of parameters.
struct ParametricRule {
  std::string letter;
  std::size_t parameters = 0;
  std::function<ParametricWord(const std::vector<double>&)> successor;
};

struct ParametricLSystem {
  ParametricWord omega;
  std::vector<ParametricRule> P;
};

// All modules at once; one that no production fits stays.
inline ParametricWord derive(const ParametricLSystem& G, int n) {
  ParametricWord word = G.omega;
  for (int i = 0; i < n; ++i) {
    ParametricWord next;
    for (const Module& module : word) {
      ParametricWord successor{module};
      for (const ParametricRule& rule : G.P)
        if (rule.letter == module.letter && rule.parameters == module.parameters.size())
          successor = rule.successor(module.parameters);
      next.insert(next.end(), successor.begin(), successor.end());
    }
    word = next;
  }
  return word;
}

inline ParametricLSystem equation_2_2() {
  using Values = std::vector<double>;
  ParametricLSystem G;
  G.omega = {{"A", {1, 1}}};
  G.P.push_back({"A", 2, [](const Values& v) {
                   const double x = v[0], y = v[1];
                   return ParametricWord{{"A", {x + 1, y * 2}}, {"B", {y}}};
                 }});
  G.P.push_back({"B", 1, [](const Values& v) {
                   const double x = v[0];
                   return ParametricWord{{"B", {x + 1}}, {"C", {}}};
                 }});
  return G;
}

// The tree of figure 2.6: angles a and d in degrees, and the factor l_r of lengths.
inline ParametricLSystem equation_2_17(double a, double d, double l_r) {
  ParametricLSystem G;
  G.omega = {{"/", {45}}, {"A", {}}};
  G.P.push_back(
      {"A", 0, [a, d](const std::vector<double>&) {
         const ParametricWord branch{{"[", {}}, {"&", {a}}, {"F", {50}}, {"A", {}}, {"]", {}}};
         ParametricWord successor{{"F", {50}}};
         for (int i = 0; i < 3; ++i) {
           if (i > 0) successor.push_back({"/", {d}});
           successor.insert(successor.end(), branch.begin(), branch.end());
         }
         return successor;
       }});
  G.P.push_back({"F", 1, [l_r](const std::vector<double>& v) {
                   const double l = v[0];
                   return ParametricWord{{"F", {l * l_r}}};
                 }});
  return G;
}

}  // namespace phytobench::oracles::liebemann2017
