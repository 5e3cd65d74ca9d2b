// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace phytobench {

using SpeciesIndex = std::uint16_t;

/// What a neighbour's zone does to a plant ([Alsweis] table 5.1: N, T, P). The values are the signs
/// s1, s2 of (5.6).
enum class Influence : std::int8_t { helps = -1, none = 0, harms = 1 };

/// Who wins where two zones are equally large ([Alsweis] (4.3), (5.2) leave it open).
enum class TieRule {
  share,          ///< each loses half of the overlap
  lower_id_wins,  ///< the plant of the higher id loses all of it
};

/// Traits of a species that competition depends on.
struct CompetitionTraits {
  double crown_opacity =
      1.0;                 ///< L / q of [Alsweis] (7.2): 0 lets half of the light through, 1 none
  double root_rank = 1.0;  ///< T_f / m of (7.3): 0 flat, 0.5 medium, 1 deep roots
  double open_ground_stress = 0.0;  ///< loss that only helpers can make up for, >= 0 (sec. 7.4)
};

/// Parameters of all rules; each rule reads those it knows.
struct CompetitionParameters {
  /// p: share of asymmetric (4.4) or above-ground (5.5) competition, 0 to 1.
  double above_share = 0.5;
  /// a: a plant's share of common ground is its area^a over the sum of both areas^a. 0 shares
  /// equally, 1 by size, infinity leaves all to the larger.
  double asymmetry_exponent = 1.0;
  TieRule ties = TieRule::share;
  /// k of (7.1), > 0: weight of light competition in the innermost zone.
  double light_constant = 1.0;
  /// F_min of Berger and Hildenbrandt 2000: what is left of a plant's field at the rim of its
  /// zone, in (0, 1).
  double field_at_rim = 0.1;
  std::vector<CompetitionTraits> species = std::vector<CompetitionTraits>(1);
  /// Influence of species j on species i at [i * species.size() + j]; empty: all harm.
  std::vector<Influence> influence_above = {};
  std::vector<Influence> influence_below = {};
};

/// Throws InputError, naming the parameter, for values out of the ranges above or tables of another
/// size.
void check_parameters(const CompetitionParameters& parameters);

/// C of [Alsweis] (5.7): what is left of a plant's growth, 1 without loss, 0 from a loss of one
/// half on, above 1 where neighbours help.
constexpr double growth_factor(double loss) {
  return loss <= 0.5 ? 1.0 - 2.0 * loss : 0.0;
}

}  // namespace phytobench
