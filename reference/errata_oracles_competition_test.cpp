// SPDX-License-Identifier: MIT
#include <cmath>
#include <vector>

#include "reference/errata_oracles.hpp"
#include "reference/oracles/alsweis_competition_extended.hpp"
#include "reference/oracles/alsweis_competition_shares.hpp"
#include "reference/oracles/alsweis_competition_zones.hpp"
#include "reference/oracles/alsweis_overlap.hpp"
#include "reference/oracles/alsweis_stand.hpp"

namespace phytobench {

namespace {

namespace overlap = oracles::alsweis;
namespace print = oracles::alsweis::competition;

/// What is left of growth to plant i of two where the larger wins all: zones of i and j, distance.
double growth_by_4_3(const Arguments& a, bool as_printed) {
  const double A_i = print::disc_area_of(a[0]), A_j = print::disc_area_of(a[1]);
  const double gamma = overlap::equation_a4_corrected(a[0], a[1], a[2]);
  const double alpha = as_printed ? print::equation_4_3_as_printed(A_i, A_j, gamma)
                                  : print::equation_4_3_corrected(A_i, A_j, gamma);
  return print::equation_5_7(print::equation_4_4(1.0, alpha, 0.0) / A_i);
}

/// 1 if a plant without neighbours is dead after five steps, else 0.
double is_dead_after_five_steps(double radius, print::Death death, double threshold) {
  print::LiteralStand stand({.death = death, .n = 5, .threshold = threshold}, {{0, 0, radius}});
  for (int t = 0; t < 5; ++t) stand.step();
  return stand.plants()[0].is_dead ? 1.0 : 0.0;
}

/// The part of both losses that the smaller of two crowns bears: zones, the smaller first,
/// distance.
double share_of_the_smaller(const Arguments& a) {
  const double A = print::disc_area_of(a[0]), B = print::disc_area_of(a[1]);
  const double gamma = overlap::equation_a4_corrected(a[0], a[1], a[2]);
  const int F = print::zone_index_F(a[2], a[0], a[1]);
  const double smaller = A * print::equations_5_3_and_5_4(print::equation_5_2(A, B, gamma), F, A);
  const double larger = B * print::equations_5_3_and_5_4(print::equation_5_2(B, A, gamma), F, B);
  return smaller / (smaller + larger);
}

/// By how much deep roots outgrow flat ones beside them: distance, steps.
double deep_less_flat(const Arguments& a, bool one_factor_per_pair) {
  print::LiteralStand stand({.species = {{.rank = 0.0}, {.rank = 1.0}},
                             .zones = print::Zones::two,
                             .p = 0.0,
                             .has_roots = true,
                             .as_printed = {.roots_of_pair = one_factor_per_pair}},
                            {{0, 0, 0.05, 0}, {a[0], 0, 0.05, 1}});
  for (int t = 0; t < static_cast<int>(a[1]); ++t) stand.step();
  return stand.plants()[1].R - stand.plants()[0].R;
}

/// Chapter 4: shares and death.
OracleTable share_oracles() {
  return {
      // p; the weight of the asymmetric part.
      {"alsweis/sentence-4.4",
       {1, [](const Arguments& a) { return print::sentence_4_4_as_printed(a[0]); },
        [](const Arguments& a) { return print::sentence_4_4_corrected(a[0]); }}},
      // p; by how much the asymmetric part exceeds the symmetric one.
      {"alsweis/balance-4.4",
       {1, [](const Arguments& a) { return print::balance_4_4_as_printed(a[0]); },
        [](const Arguments& a) { return print::balance_4_4_corrected(a[0]); }}},
      {"alsweis/growth-by-4.3",
       {3, [](const Arguments& a) { return growth_by_4_3(a, true); },
        [](const Arguments& a) { return growth_by_4_3(a, false); }}},
      // Radius, threshold of size, threshold of growth.
      {"alsweis/death-of-a-lone-seedling",
       {3,
        [](const Arguments& a) {
          return is_dead_after_five_steps(a[0], print::Death::mean_size, a[1]);
        },
        [](const Arguments& a) {
          return is_dead_after_five_steps(a[0], print::Death::mean_growth, a[2]);
        }}},
  };
}

/// Chapter 5: zones.
OracleTable zone_oracles() {
  return {
      // Factor, stem, exponent and a larger one; whether the zone widens.
      {"alsweis/zone-of-larger-exponent",
       {4, [](const Arguments& a) { return std::copysign(1.0, a[3] - a[2]); },
        [](const Arguments& a) {
          return std::copysign(
              1.0, print::equation_4_1(a[0], a[1], a[3]) - print::equation_4_1(a[0], a[1], a[2]));
        }}},
      {"alsweis/share-of-the-smaller",
       {3, [](const Arguments&) { return 0.5; },  // what symmetric means below (4.2)
        share_of_the_smaller}},
  };
}

/// Chapter 7: light, roots, illness, nurses.
OracleTable extended_oracles() {
  return {
      // q, L, overlap; what both plants lose.
      {"alsweis/equation-7.2-pair",
       {3,
        [](const Arguments& a) { return 2.0 * print::equation_7_2_as_printed(a[0], a[1], a[2]); },
        [](const Arguments& a) {
          return print::equation_7_2_corrected(a[0], a[1], a[2], 1.0, 2.0) +
                 print::equation_7_2_corrected(a[0], a[1], a[2], 2.0, 1.0);
        }}},
      // q, transparency from 0 to 1; the smaller plant's loss, in overlaps.
      {"alsweis/loss-below-a-transparent-crown",
       {2,
        [](const Arguments& a) { return print::equation_7_2_as_printed(a[0], a[0] * a[1], 1.0); },
        [](const Arguments& a) {
          return print::equation_7_2_corrected(a[0], a[0] * (1.0 - a[1]), 1.0, 1.0, 2.0);
        }}},
      // Overlap, area, steps since it fell ill, steps that illness lasts.
      {"alsweis/equation-7.4",
       {4,
        [](const Arguments& a) {
          return print::equation_7_4(a[0], a[1], print::T_k_as_printed(1.0, a[2], a[3]), 1.0);
        },
        [](const Arguments& a) {
          return print::equation_7_4(a[0], a[1], print::T_k_corrected(1.0, a[2], a[3]), 1.0);
        }}},
      // p.
      {"alsweis/nutrient-share-7.5",
       {1, [](const Arguments& a) { return print::nutrient_share_7_5_as_printed(a[0]); },
        [](const Arguments& a) { return print::nutrient_share_7_5_corrected(a[0]); }}},
      {"alsweis/deep-less-flat-roots",
       {2, [](const Arguments& a) { return deep_less_flat(a, true); },
        [](const Arguments& a) { return deep_less_flat(a, false); }}},
      // p, alpha, sigma.
      {"alsweis/equation-7.6",
       {3, [](const Arguments& a) { return print::equation_7_6_as_printed(a[0], a[1], a[2]); },
        [](const Arguments& a) { return print::equation_7_6_as_told(a[0], a[1], a[2]); }}},
  };
}

}  // namespace

OracleTable alsweis_competition_oracles() {
  OracleTable all = share_oracles();
  all.merge(zone_oracles());
  all.merge(extended_oracles());
  return all;
}

}  // namespace phytobench
