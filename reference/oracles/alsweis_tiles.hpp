// SPDX-License-Identifier: MIT
// Sections 3.6, 6.1, 6.2 and 6.4 of [Alsweis], literally, and beside each misprint the corrected
// form. Shares no code with core/, so that agreement means something.
#pragma once

#include <functional>
#include <vector>

namespace phytobench::oracles::alsweis::tiles {

// A Wang tile: the colours of its four edges.
struct Tile {
  int north, east, south, west;
};

// Section 6.1: eight tiles of two colours, two for every pair of a north and a west colour, so that
// laying them row by row never gets stuck. All such sets, with `per_pair` tiles for each pair.
std::vector<std::vector<Tile>> sets_of_tiles(int per_pair);

// Fewest tiles, one or two, that can be repeated over the whole plane; 0: more are needed.
int tiles_of_smallest_period(const std::vector<Tile>& set);

// The largest of these numbers over all sets; 0 if one of them has no period of one or two tiles.
// Section 3.6 calls the tiling aperiodic: by that there would be no period at all.
int tiles_of_largest_smallest_period(int per_pair);

// (6.1) and (6.2) for h(p, q) = C(2k, k + p) C(2k, k + q), which is zero outside of -k .. k.
double kernel(int k, int p, int q);

// (6.2): over 0 .. 2k, where a centred kernel has a quarter and its middle lines only.
double equation_6_2_as_printed(int k);
double equation_6_2_corrected(int k);

// (6.1) at S_i, S_j, with M by (6.2).
double equation_6_1(const std::function<double(int, int)>& I, int S_i, int S_j, int k, double M);

// Section 6.4 for plants 1 and 2 on both sides of an edge, overlapping by at least the threshold:
// the number of the one to delete, or 0.
int deleted_as_printed(double R_1, double R_2);
int deleted_corrected(double R_1, double R_2);  // of two equal ones the second

// Whether two plants overlap by at least the threshold after one step of that rule: 0 or 1.
int conflicts_left(double R_1, double R_2, double d, double threshold,
                   int (*rule)(double R_1, double R_2));

// Figure 6.5 a as told: plant 2 is larger than its neighbour, "so this one" is deleted; and by the
// rule above. The radius of the one that stays.
double radius_left_of_figure_6_5_as_told(double R_2, double R_neighbour);
double radius_left_of_figure_6_5_by_rule(double R_2, double R_neighbour);

}  // namespace phytobench::oracles::alsweis::tiles
