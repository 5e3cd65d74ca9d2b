// SPDX-License-Identifier: MIT
// How far from its mother plant a seed falls.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "core/geometry/point2.hpp"
#include "core/random/unit_stream.hpp"

namespace phytobench {

/// Readings of [Alsweis] (4.6), "exp(-r / lambda)", which its text calls a two-dimensional Gaussian
/// with mean lambda: three laws, of which the first alone has that mean. All directions are alike.
enum class DispersalLaw {
  radial_exponential,  ///< distances have the density exp(-r / lambda) / lambda: mean lambda
  planar_exponential,  ///< seeds per area have the density exp(-r / lambda) / (2 pi lambda^2)
  gaussian,            ///< seeds per area fall as exp(-r^2 / (2 lambda^2))
};
inline constexpr std::array all_dispersal_laws = {
    DispersalLaw::radial_exponential, DispersalLaw::planar_exponential, DispersalLaw::gaussian};

/// "radial-exponential", "planar-exponential", "gaussian".
std::string_view name_of(DispersalLaw law);
/// Throws InputError that lists the names, and the nearest one if there is one.
DispersalLaw dispersal_law_named(const std::string& name);

/// A law with its scale. Distances in the unit of the scale, from 0 on.
struct SeedDispersal {
  DispersalLaw law = DispersalLaw::radial_exponential;
  double scale = 1.0;  ///< lambda, above 0

  /// Probability that a seed falls no further than this; 0 below 0.
  double distance_distribution(double distance) const;
  /// Its derivative: seeds per distance.
  double distance_density(double distance) const;
  /// Seeds per area at this distance: distance_density() / (2 pi distance). Of the radial
  /// exponential law infinite at 0.
  double plane_density(double distance) const;
  /// The distance that a share of all seeds, in [0, 1), does not exceed.
  double distance_quantile(double share) const;

  double mean_distance() const;  ///< lambda, 2 lambda, 1.2533 lambda
  double median_distance() const { return distance_quantile(0.5); }

  /// Where one seed falls, seen from its mother. Two numbers of the stream, three for the planar
  /// exponential law. Never further than 37, 74 and 8.6 times the scale: 53 bits reach no further.
  Point2 draw(UnitStream& stream) const;
};

}  // namespace phytobench
