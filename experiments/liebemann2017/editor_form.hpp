// SPDX-License-Identifier: MIT
// The form of [Liebemann2017] sec. 4.2.1, into which an L-system is typed.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/lsystem/read_lsystem.hpp"

namespace phytobench::experiments::liebemann2017 {

struct FormProduction {
  std::string predecessor;
  std::string parameters;  ///< between commas
  std::string successor;
};
/// Its fields.
struct Form {
  std::string axiom;
  std::vector<std::pair<std::string, std::string>> constants;
  std::vector<FormProduction> productions;
};

inline std::string text_of(const Form& form) {
  std::string text;
  for (const auto& [name, value] : form.constants) text += name + " = " + value + "\n";
  text += "axiom: " + form.axiom + "\n";
  for (const FormProduction& p : form.productions)
    text += p.predecessor + (p.parameters.empty() ? "" : "(" + p.parameters + ")") + " -> " +
            p.successor + "\n";
  return text;
}
inline LSystem entered(const Form& form) {
  return parse_lsystem(text_of(form), "form");
}

inline Form equation_2_17_form(const std::string& a, const std::string& d,
                               const std::string& factor) {
  const std::string branch = "[&(" + a + ")F(50)A]", roll = "/(" + d + ")";
  return {"/(45)A",
          {{a, "18.95"}, {d, "137.5"}, {factor, "1.3"}},
          {{"A", "", "F(50)" + branch + roll + branch + roll + branch},
           {"F", "l", "F(l * " + factor + ")"}}};
}

}  // namespace phytobench::experiments::liebemann2017
