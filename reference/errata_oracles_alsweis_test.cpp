// SPDX-License-Identifier: MIT
#include "reference/errata_oracles.hpp"
#include "reference/oracles/alsweis_hopkins.hpp"
#include "reference/oracles/alsweis_overlap.hpp"

namespace phytobench {

namespace {

std::vector<oracles::alsweis::Plant> plants_of(const Arguments& a) {
  std::vector<oracles::alsweis::Plant> plants;
  for (std::size_t i = 0; i + 1 < a.size(); i += 2) plants.push_back({a[i], a[i + 1]});
  return plants;
}

}  // namespace

OracleTable alsweis_pattern_oracles() {
  return {
      {"alsweis/equation-a4",
       {3,
        [](const Arguments& a) {
          return oracles::alsweis::equation_a4_as_printed(a[0], a[1], a[2]);
        },
        [](const Arguments& a) {
          return oracles::alsweis::equation_a4_corrected(a[0], a[1], a[2]);
        }}},
      // Plants, x and y in turn; mean distance to the nearest.
      {"alsweis/equation-2.8-denominator",
       {6,
        [](const Arguments& a) {
          return oracles::alsweis::equation_2_8_denominator(plants_of(a), true);
        },
        [](const Arguments& a) {
          return oracles::alsweis::equation_2_8_denominator(plants_of(a), false);
        }}},

  };
}

}  // namespace phytobench
