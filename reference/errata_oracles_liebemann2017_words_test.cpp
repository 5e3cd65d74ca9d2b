// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "reference/errata_oracles.hpp"
#include "reference/oracles/liebemann2017_lsystems.hpp"
#include "reference/oracles/lsystem_closed_forms.hpp"

namespace phytobench {

namespace {

double size_of(const oracles::liebemann2017::Letters& word) {
  return static_cast<double>(word.size());
}

}  // namespace

OracleTable liebemann2017_words_oracles() {
  namespace literal = oracles::liebemann2017;
  return {
      // Terminals, variables, productions; symbols that must have a production and have none.
      {"liebemann2017/symbols-without-production",
       {3, [](const Arguments& a) { return std::max(0.0, a[0] + a[1] - a[2]); },
        [](const Arguments& a) { return std::max(0.0, a[1] - a[2]); }}},
      // Letters of w; ways to write it as a_1 ... a_m with words that are not empty, and with
      // letters.
      {"liebemann2017/factorisations-of-a-word",
       {1, [](const Arguments& a) { return std::pow(2.0, a[0] - 1.0); },
        [](const Arguments&) { return 1.0; }}},
      // Numbers of parameters of the four modules that the productions of eq. 2.2 write; how many
      // of these are in V x E, and in V x E*.
      {"liebemann2017/modules-of-the-successors",
       {4,
        [](const Arguments& a) {
          double allowed = 0.0;
          for (const double parameters : a) allowed += parameters == 1.0;
          return allowed;
        },
        [](const Arguments& a) { return static_cast<double>(a.size()); }}},
      // Least number of derivations by sec. 4.2.1, and of figure 2.4; lines of the first island.
      {"liebemann2017/lines-of-the-first-island",
       {2,
        [](const Arguments& a) {
          return static_cast<double>(oracles::equation_2_6_F(static_cast<int>(a[0])));
        },
        [](const Arguments& a) {
          return static_cast<double>(oracles::equation_2_6_F(static_cast<int>(a[1])));
        }}},
      // Derivations of eq. 2.1; cells if each production sees what the ones before it wrote, and
      // if all are applied at once.
      {"liebemann2017/cells-in-one-string",
       {1,
        [](const Arguments& a) {
          return size_of(
              literal::derive_rule_after_rule(literal::equation_2_1(), static_cast<int>(a[0])));
        },
        [](const Arguments& a) {
          return size_of(
              literal::derive_in_parallel(literal::equation_2_1(), static_cast<int>(a[0])));
        }}},
  };
}

}  // namespace phytobench
