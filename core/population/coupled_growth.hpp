// SPDX-License-Identifier: MIT
// Plants that grow against each other without places in a plane: the growth law of [Alsweis] 4.3,
// corrected.
#pragma once

#include <span>
#include <utility>
#include <vector>

namespace phytobench {

/// dv_i/dt = k / (1 - delta) v_i^a ((1/w sum_j phi_ij v_j)^(delta - 1) - 1), and its limit
/// k v_i^a (log w - log sum_j phi_ij v_j) for delta = 1. Other than printed, each neighbour has a
/// share phi_ij of its own, a pure number, and the plant itself belongs to the sum with phi_ii = 1:
/// without neighbours and with a = 1 it grows by Richards' law.
struct CoupledGrowth {
  double rate = 0.1;        ///< k > 0, in size^(1-a) per time
  double final_size = 1.0;  ///< w > 0, at which a plant alone and a stand of phi = 1 in sum stop
  double shape = 2.0;       ///< delta, any finite number
  double asymmetry =
      1.0;  ///< a >= 0: 0 equal growth, 1 growth in proportion to size, the neutral one
};

/// How much of plant i's area plant j covers, from 0 to 1, and 1 for i = j.
class OverlapShares {
 public:
  /// Row by row, n * n entries. Throws ContractViolation unless they are as said above.
  OverlapShares(std::size_t plants, std::vector<double> shares);

  /// All plants in one place: every share 1.
  static OverlapShares complete(std::size_t plants);
  /// No neighbours.
  static OverlapShares none(std::size_t plants);

  std::size_t plants() const { return plants_; }
  std::span<const double> of(std::size_t plant) const {
    return std::span(shares_).subspan(plant * plants_, plants_);
  }

 private:
  std::size_t plants_;
  std::vector<double> shares_;
};

/// v^a, the weight that (4.5) of [Alsweis] gives to size. For sizes > 0.
double size_factor(double size, double asymmetry);

/// Size per time of every plant. Throws ContractViolation unless there are as many sizes as plants,
/// all > 0.
std::vector<double> coupled_growth_rates(const CoupledGrowth& growth, const OverlapShares& shares,
                                         std::span<const double> sizes);

/// (v^(1-a) - 1) / (1 - a), log v for a = 1: plants that share everything keep the differences of
/// this for ever, because all of them divide their growth by v^a. For sizes > 0.
double conserved_scale(double size, double asymmetry);

/// Where two plants end that share everything, w in sum: the smaller first, like `sizes`. Follows
/// from what is conserved, without integration, for any shape. Sizes > 0 with a sum of at most w;
/// throws ContractViolation for others.
std::pair<double, double> end_sizes_of_two(double final_size, double asymmetry,
                                           std::pair<double, double> sizes);

}  // namespace phytobench
