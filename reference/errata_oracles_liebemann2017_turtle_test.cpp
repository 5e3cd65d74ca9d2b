// SPDX-License-Identifier: MIT
#include <cmath>

#include "reference/errata_oracles.hpp"
#include "reference/oracles/liebemann2017_tree_graph.hpp"
#include "reference/oracles/lsystem_closed_forms.hpp"

namespace phytobench {

OracleTable liebemann2017_turtle_oracles() {
  return {
      // Steps, l_r; way from the root to a tip of eq. 2.17, and with the trunk F(200) of its
      // source,
      // which every step makes longer, too.
      {"liebemann2017/way-to-a-tip-with-trunk",
       {2,
        [](const Arguments& a) {
          return oracles::equation_2_17_path_length(static_cast<int>(a[0]), a[1]);
        },
        [](const Arguments& a) {
          return oracles::equation_2_17_path_length(static_cast<int>(a[0]), a[1]) +
                 200.0 * std::pow(a[1], a[0]);
        }}},
      // Tips, g; root radius by eq. 3.4, and by the cubes of Murray's law.
      {"liebemann2017/radius-by-murray",
       {2,
        [](const Arguments& a) {
          return oracles::liebemann2017::radius_above_tips(static_cast<std::size_t>(a[0]), 1.0,
                                                           a[1]);
        },
        [](const Arguments& a) {
          return oracles::liebemann2017::radius_above_tips(static_cast<std::size_t>(a[0]), 1.0,
                                                           3.0);
        }}},
  };
}

}  // namespace phytobench
