// SPDX-License-Identifier: MIT
// What crowding does to numbers, seeds and weight of plants, after [Alsweis] 2.2, 2.3 and 2.5.
// Densities are plants per area in any unit, kept throughout.
#pragma once

#include <optional>

namespace phytobench {

/// Plants that are left of `density` plants where some die because of the others: density /
/// (1 + m_d density), [Alsweis] (2.2). The inverse density grows by m_d each time: no more than
/// 1 / m_d are ever left. For density and m_d >= 0.
double surviving_density(double density, double crowding_mortality);

/// The same after a part has died for other reasons: `survival` from 0 to 1 is the share that lives
/// on, [Alsweis] (2.3), where it is an unnamed constant m_i. Deaths for other reasons come first;
/// in the other order fewer plants are left.
double surviving_density(double density, double crowding_mortality, double survival);

/// Seeds of a plant of a given weight, at_no_weight + per_weight * weight, [Alsweis] (2.4).
double linear_fecundity(double weight, double at_no_weight, double per_weight);

/// Mean seeds of a plant among others, (alpha + beta x^phi)^(-1/theta), [Alsweis] (2.5).
struct CrowdedFecundity {
  double isolation =
      1.0;  ///< alpha > 0: alpha^(-1/theta) are the seeds of a plant that stands alone
  double crowding = 1.0;          ///< beta >= 0: strength of competition
  double density_exponent = 1.0;  ///< phi > 0
  double root = 1.0;              ///< theta > 0, not named in the source
};

/// Seeds per plant at a density >= 0.
double seeds_per_plant(const CrowdedFecundity& law, double density);

/// Seeds per area: density times seeds per plant.
double seeds_per_area(const CrowdedFecundity& law, double density);

/// What seeds per area near at high density: their limit if phi = theta, 0 if phi is larger, and
/// nothing (no bound) if it is smaller or nothing crowds.
std::optional<double> limit_of_seeds_per_area(const CrowdedFecundity& law);

/// The density at which seeds per area are highest: at x^phi = alpha / (beta (phi / theta - 1)).
/// Nothing unless phi > theta and beta > 0.
std::optional<double> density_of_most_seeds(const CrowdedFecundity& law);

/// Self-thinning, weight = b density^(-k), [Alsweis] (2.15), after Yoda et al. 1963 with k = 3/2.
struct SelfThinning {
  double factor = 1.0;    ///< b > 0, the mean weight at density 1
  double exponent = 1.5;  ///< k > 0
};

/// Mean weight of a plant at the highest density that such plants reach, [Alsweis] (2.15).
double thinned_weight(const SelfThinning& law, double density);

/// The highest density of plants of a mean weight: the inverse of the above.
double thinned_density(const SelfThinning& law, double weight);

/// Weight of all plants per area; for k > 1 it grows while plants die.
double thinned_yield(const SelfThinning& law, double density);

/// log10(weight) + k log10(density), [Alsweis] (2.17): log10(b) for all stands of a law, not "the
/// logarithm of density". For weight and density > 0.
double thinning_constant(double exponent, double weight, double density);

}  // namespace phytobench
