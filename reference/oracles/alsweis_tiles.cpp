// SPDX-License-Identifier: MIT
#include "reference/oracles/alsweis_tiles.hpp"

#include <cmath>

#include "reference/oracles/alsweis_overlap.hpp"

namespace phytobench::oracles::alsweis::tiles {

namespace {

double binomial(int n, int m) {
  double value = 1.0;
  for (int i = 1; i <= m; ++i) value = value * (n - m + i) / i;
  return value;
}

// Subsets of the four pairs of a south and an east colour, as bits, of one size.
std::vector<int> choices(int size) {
  std::vector<int> found;
  for (int bits = 0; bits < 16; ++bits) {
    int count = 0;
    for (int pair = 0; pair < 4; ++pair) count += (bits >> pair) & 1;
    if (count == size) found.push_back(bits);
  }
  return found;
}

bool are_stacked(const Tile& above, const Tile& below) {
  return above.south == below.north;
}

bool are_beside(const Tile& left, const Tile& right) {
  return left.east == right.west;
}

}  // namespace

std::vector<std::vector<Tile>> sets_of_tiles(int per_pair) {
  std::vector<std::vector<Tile>> sets{{}};
  for (int north = 0; north < 2; ++north)
    for (int west = 0; west < 2; ++west) {
      std::vector<std::vector<Tile>> longer;
      for (const std::vector<Tile>& begun : sets)
        for (const int bits : choices(per_pair)) {
          std::vector<Tile> set = begun;
          for (int pair = 0; pair < 4; ++pair)
            if ((bits >> pair) & 1) set.push_back({north, pair & 1, pair >> 1, west});
          longer.push_back(set);
        }
      sets = longer;
    }
  return sets;
}

int tiles_of_smallest_period(const std::vector<Tile>& set) {
  for (const Tile& tile : set)
    if (are_stacked(tile, tile) && are_beside(tile, tile)) return 1;
  for (const Tile& a : set)
    for (const Tile& b : set) {
      const bool column =
          are_stacked(a, b) && are_stacked(b, a) && are_beside(a, a) && are_beside(b, b);
      const bool row =
          are_beside(a, b) && are_beside(b, a) && are_stacked(a, a) && are_stacked(b, b);
      if (column || row) return 2;
    }
  return 0;
}

int tiles_of_largest_smallest_period(int per_pair) {
  int largest = 1;
  for (const std::vector<Tile>& set : sets_of_tiles(per_pair)) {
    const int tiles = tiles_of_smallest_period(set);
    if (tiles == 0) return 0;
    if (tiles > largest) largest = tiles;
  }
  return largest;
}

double kernel(int k, int p, int q) {
  if (std::abs(p) > k || std::abs(q) > k) return 0.0;
  return binomial(2 * k, k + p) * binomial(2 * k, k + q);
}

double equation_6_2_as_printed(int k) {
  double M = 0.0;
  for (int p = 0; p <= 2 * k; ++p)
    for (int q = 0; q <= 2 * k; ++q) M += kernel(k, p, q);
  return M;
}

double equation_6_2_corrected(int k) {
  double M = 0.0;
  for (int p = -k; p <= k; ++p)
    for (int q = -k; q <= k; ++q) M += kernel(k, p, q);
  return M;
}

double equation_6_1(const std::function<double(int, int)>& I, int S_i, int S_j, int k, double M) {
  double sum = 0.0;
  for (int p = S_i - k; p <= S_i + k; ++p)
    for (int q = S_j - k; q <= S_j + k; ++q) sum += I(p, q) * kernel(k, S_i - p, S_j - q);
  return sum / M;
}

int deleted_as_printed(double R_1, double R_2) {
  if (R_1 < R_2) return 1;
  return R_2 < R_1 ? 2 : 0;
}

int deleted_corrected(double R_1, double R_2) {
  return R_1 < R_2 ? 1 : 2;
}

int conflicts_left(double R_1, double R_2, double d, double threshold,
                   int (*rule)(double R_1, double R_2)) {
  if (equation_a4_corrected(R_1, R_2, d) < threshold) return 0;
  return rule(R_1, R_2) == 0 ? 1 : 0;
}

double radius_left_of_figure_6_5_as_told(double /*R_2*/, double R_neighbour) {
  return R_neighbour;
}

double radius_left_of_figure_6_5_by_rule(double R_2, double R_neighbour) {
  return deleted_corrected(R_2, R_neighbour) == 1 ? R_neighbour : R_2;
}

}  // namespace phytobench::oracles::alsweis::tiles
