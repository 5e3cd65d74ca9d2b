// SPDX-License-Identifier: MIT
#include "core/population/size_growth.hpp"

#include <cmath>

#include "core/population/richards_growth.hpp"

namespace phytobench {

double growth_rate(const Species& species, double stem_radius) {
  const double size = stem_radius / species.largest_radius;
  if (species.growth == GrowthLaw::basal) return species.growth_rate * size * (1.0 - size);
  return richards_rate({.rate = species.growth_rate / species.largest_radius,
                        .final_size = species.largest_radius,
                        .shape = species.growth_shape},
                       stem_radius);
}

double zone_radius(const ZoneLaw& zone, double stem_radius, double resource) {
  const double factor = std::lerp(zone.poor_factor, zone.rich_factor, resource);
  if (zone.exponent == 0.5) return factor * std::sqrt(stem_radius);  // the usual one, and fast
  if (zone.exponent == 1.0) return factor * stem_radius;
  return factor * std::pow(stem_radius, zone.exponent);
}

}  // namespace phytobench
