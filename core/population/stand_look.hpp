// SPDX-License-Identifier: MIT
// What pictures of stands have in common: which colour a plant has, and where it appears.
#pragma once

#include <cstddef>

#include "core/picture/image.hpp"
#include "core/population/population_parameters.hpp"

namespace phytobench {

inline constexpr std::size_t age_classes = 4;

/// 0 (young) to age_classes - 1. Old is what has had time to grow up: ten times largest radius over
/// growth rate, in which a plant without neighbours goes from less than a hundredth to more than 99
/// hundredths of its size ([Alsweis] (5.8)), or the largest age if it is less.
std::size_t age_class(const Species& species, std::int32_t age);

/// Okabe and Ito's colours, which colour-blind eyes tell apart, then purple and yellow; lighter by
/// age.
Colour plant_colour(std::size_t species, std::size_t age);
/// Number of the colour, of curve_colours, whose hue is that of the species: the same for lines,
/// which need more contrast than discs.
std::size_t curve_colour(std::size_t species);
/// So many species have hues of their own.
inline constexpr std::size_t species_hues = 7;
/// Their red, kept for plants under strong competition.
Colour oppressed_colour();

/// Radius of the broken circle around the stem of an ill plant: outside the stem and wide enough to
/// be seen, but no nuisance where plants stand densely. `spacing` is that of equally many plants in
/// a square lattice. All in pixels.
double illness_ring(double stem_radius, double spacing);

/// The map that lies below the plants, or none.
const ResourceMap* background_of(const PopulationParameters& parameters);

/// Calls draw(place) for every place where a disc, or a part of it, lies on the ground: on a torus
/// there may be several, each a turn round it from the others.
template <class Draw>
void for_each_appearance(const PopulationParameters& parameters, const Point2& center,
                         double radius, const Draw& draw) {
  const Rectangle& ground = parameters.ground;
  const int reach = parameters.is_torus ? 1 : 0;
  for (int row = -reach; row <= reach; ++row)
    for (int column = -reach; column <= reach; ++column) {
      const Point2 at = center + Point2{column * ground.width(), row * ground.height()};
      if (at.x + radius > ground.low.x && at.x - radius < ground.high.x &&
          at.y + radius > ground.low.y && at.y - radius < ground.high.y)
        draw(at);
    }
}

}  // namespace phytobench
