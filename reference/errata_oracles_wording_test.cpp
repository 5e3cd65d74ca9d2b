// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "reference/errata_oracles.hpp"
#include "reference/oracles/alsweis_growth.hpp"
#include "reference/oracles/brzoska2019_missing_cases.hpp"

namespace phytobench {

namespace {

namespace brzoska = oracles::brzoska2019;
namespace growth = oracles::alsweis::growth;

/// Share of its seeds that a plant loses to the others: alpha, beta, phi, theta, density.
double share_lost(double alpha, const Arguments& a) {
  return 1.0 - growth::equation_2_5(a[5], alpha, a[2], a[3], a[4]) /
                   growth::equation_2_5(0.0, alpha, a[2], a[3], a[4]);
}

/// Seeds of a plant that grows by (2.1): size at first, k, w, delta, b_0, b_1, and a time.
double seeds_at(const Arguments& a, double time) {
  return growth::equation_2_4(growth::solution_of_2_1(a[0], a[1], a[2], a[3], time), a[4], a[5]);
}

}  // namespace

OracleTable brzoska2019_wording_oracles() {
  return {
      // Direction of a branch and lambda; its upward component after bending.
      {"brzoska2019/bent-branch",
       {4,
        [](const Arguments& a) {
          return brzoska::bent_as_printed({a[0], a[1], a[2]}, a[3]).y;
        },
        [](const Arguments& a) {
          return brzoska::bent_corrected({a[0], a[1], a[2]}, a[3]).y;
        }}},
      // Corners of a ring and rings of a branch; sides that belong to one triangle only.
      {"brzoska2019/open-sides-of-a-tube",
       {2, [](const Arguments&) { return 0.0; },  // what "closed" means
        [](const Arguments& a) {
          return static_cast<double>(brzoska::open_sides(
              brzoska::triangles_of_tube(static_cast<int>(a[0]), static_cast<int>(a[1]))));
        }}},
      // Triangles of the left and of the right plant, their edges, corners of a ring; leaves of the
      // plant that the sentence means.
      {"brzoska2019/leaves-of-figure-43",
       {4, [](const Arguments& a) { return brzoska::leaves_of_plant(a[0], a[2], a[3]); },
        [](const Arguments& a) { return brzoska::leaves_of_plant(a[1], a[2], a[3]); }}},
      // Radii, density, share cut off as told and as published; points.
      {"brzoska2019/points-above-the-cut",
       {6,
        [](const Arguments& a) {
          return brzoska::points_of_cloud({a[0], a[1], a[2]}, a[3], a[4]);
        },
        [](const Arguments& a) {
          return brzoska::points_of_cloud({a[0], a[1], a[2]}, a[3], a[5]);
        }}},
      // Seconds without and with late removal; 1 if that saves time, -1 if it costs time.
      {"brzoska2019/gain-of-late-removal",
       {2, [](const Arguments&) { return 1.0; },  // "the fastest way"
        [](const Arguments& a) { return std::copysign(1.0, a[0] - a[1]); }}},
  };
}

OracleTable alsweis_wording_oracles() {
  return {
      // alpha, a larger alpha, beta, phi, theta, density; 1 if plants lose a larger share then.
      {"alsweis/loss-with-alpha",
       {6, [](const Arguments& a) { return std::copysign(1.0, a[1] - a[0]); },
        [](const Arguments& a) {
          return std::copysign(1.0, share_lost(a[1], a) - share_lost(a[0], a));
        }}},
      // Size at first, k, w, delta, b_0, b_1, time; seeds at half of that time.
      {"alsweis/seeds-at-half-time",
       {7, [](const Arguments& a) { return (seeds_at(a, 0.0) + seeds_at(a, a[6])) / 2.0; },
        [](const Arguments& a) { return seeds_at(a, a[6] / 2.0); }}},
  };
}

}  // namespace phytobench
