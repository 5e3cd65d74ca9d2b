// SPDX-License-Identifier: MIT
#pragma once

#include "core/picture/image.hpp"

namespace phytobench {

/// Bark in one colour, with fine streaks along the branch ([Brzoska2019] sec. 5.4 generates its
/// textures for a choice of colours). Repeats without a seam in both directions.
Image bark_texture(const Colour& colour);

/// Many small ellipses in shades of one colour on nothing: seen from afar, a bunch of leaves
/// ([Brzoska2019] sec. 4.1 and fig. 38, after Reeves and Blau 1985). `seed` places them.
Image leaf_particle_texture(const Colour& colour, std::uint64_t seed);

}  // namespace phytobench
