// SPDX-License-Identifier: MIT
#include <algorithm>

#include "reference/errata_oracles.hpp"
#include "reference/oracles/alsweis_edges_and_noise.hpp"
#include "reference/oracles/alsweis_tiles.hpp"
#include "reference/oracles/brzoska2019_l_systems.hpp"

namespace phytobench {

namespace {

namespace alsweis = oracles::alsweis;
namespace tiles = oracles::alsweis::tiles;

/// (6.1) of a map that is 1 everywhere.
double supersampled_one(int k, double M) {
  return tiles::equation_6_1([](int, int) { return 1.0; }, 0, 0, k, M);
}

double conflicts(const Arguments& a, int (*rule)(double, double)) {
  return tiles::conflicts_left(a[0], a[1], a[2], a[3], rule);
}

alsweis::Neighbourhood neighbourhood(const Arguments& a) {
  return {a[0], a[1], a[2], a[3], a[4], a[5], a[6], a[7], a[8]};
}

OracleTable tile_oracles() {
  return {
      // Tiles for each pair of colours; tiles of the smallest period, an aperiodic set has none.
      {"alsweis/tiles-of-smallest-period",
       {1, [](const Arguments&) { return undefined; },
        [](const Arguments& a) {
          return double(tiles::tiles_of_largest_smallest_period(static_cast<int>(a[0])));
        }}},
      // k.
      {"alsweis/equation-6.2",
       {1,
        [](const Arguments& a) {
          const int k = static_cast<int>(a[0]);
          return supersampled_one(k, tiles::equation_6_2_as_printed(k));
        },
        [](const Arguments& a) {
          const int k = static_cast<int>(a[0]);
          return supersampled_one(k, tiles::equation_6_2_corrected(k));
        }}},
      // Two radii, distance, threshold.
      {"alsweis/conflicts-left-at-an-edge",
       {4, [](const Arguments& a) { return conflicts(a, tiles::deleted_as_printed); },
        [](const Arguments& a) { return conflicts(a, tiles::deleted_corrected); }}},
      // Radius of plant 2 and of its neighbour.
      {"alsweis/figure-6.5",
       {2, [](const Arguments& a) { return tiles::radius_left_of_figure_6_5_as_told(a[0], a[1]); },
        [](const Arguments& a) { return tiles::radius_left_of_figure_6_5_by_rule(a[0], a[1]); }}},
  };
}

OracleTable appendix_oracles() {
  return {
      // z_1 to z_9.
      {"alsweis/equation-b.1",
       {9, [](const Arguments& a) { return alsweis::equation_b1_second_line(neighbourhood(a)); },
        [](const Arguments& a) { return alsweis::equation_b1_first_line(neighbourhood(a)); }}},
      // Values at three neighbouring knots.
      {"alsweis/slope-jump-of-noise",
       {3, [](const Arguments&) { return alsweis::slope_jump_as_told(); },
        [](const Arguments& a) { return alsweis::slope_jump_of_linear(a[0], a[1], a[2]); }}},
      // Values at a knot and at the next.
      {"alsweis/noise-at-a-knot",
       {2, [](const Arguments& a) { return alsweis::perlin_noise_at_knot(a[0]); },
        [](const Arguments& a) { return alsweis::noise_at_knot(a[0], a[1]); }}},
      // Year printed, latest year of what it names, year of publication: years in between.
      {"alsweis/years-after-what-it-names",
       {3, [](const Arguments& a) { return a[0] - a[1]; },
        [](const Arguments& a) { return a[2] - a[1]; }}},
  };
}

/// Letters of a word of eq. 6 that its alphabet lacks.
double letters_outside(const oracles::brzoska2019::LSystem& system, const Arguments& a) {
  return oracles::brzoska2019::letters_outside(
      system.V, oracles::brzoska2019::derive(system, static_cast<int>(a[0])));
}

/// How far a page is from those of a work; zero within it.
double pages_beside(double page, double first, double last) {
  return std::max({first - page, page - last, 0.0});
}

}  // namespace

OracleTable tiles_and_noise_oracles() {
  OracleTable all = tile_oracles();
  all.merge(appendix_oracles());
  // Steps.
  all["brzoska2019/equation-6-alphabet"] = {
      1,
      [](const Arguments& a) {
        return letters_outside(oracles::brzoska2019::equation_6_as_printed(), a);
      },
      [](const Arguments& a) {
        return letters_outside(oracles::brzoska2019::equation_6_corrected(), a);
      }};
  // Page printed, page cited elsewhere, first and last page of the work.
  all["brzoska2019/pages-beside-the-work"] = {
      4, [](const Arguments& a) { return pages_beside(a[0], a[2], a[3]); },
      [](const Arguments& a) { return pages_beside(a[1], a[2], a[3]); }};
  return all;
}

}  // namespace phytobench
