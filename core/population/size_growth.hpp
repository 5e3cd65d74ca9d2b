// SPDX-License-Identifier: MIT
// How fast one plant grows, and how far its zones reach.
#pragma once

#include "core/population/population_parameters.hpp"

namespace phytobench {

/// Growth without competition at this stem radius, m per step ([Alsweis] (5.8), (2.1)).
double growth_rate(const Species& species, double stem_radius);

/// Radius of a zone at a place that offers this part of the resource, 0 to 1 ([Alsweis] (4.1)).
double zone_radius(const ZoneLaw& zone, double stem_radius, double resource);

}  // namespace phytobench
