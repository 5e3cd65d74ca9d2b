// SPDX-License-Identifier: MIT
#include "reference/errata_oracles.hpp"
#include "reference/oracles/lsystem_closed_forms.hpp"

namespace phytobench {

OracleTable liebemann2017_axioms_oracles() {
  return {
      // Derivations of eq. 2.6; lines if the axiom is one symbol, and the word of four F.
      {"liebemann2017/lines-from-the-axiom",
       {1,
        [](const Arguments& a) {
          return static_cast<double>(oracles::whole_power(8, static_cast<int>(a[0])));
        },
        [](const Arguments& a) {
          return static_cast<double>(oracles::equation_2_6_F(static_cast<int>(a[0])));
        }}},
  };
}

}  // namespace phytobench
