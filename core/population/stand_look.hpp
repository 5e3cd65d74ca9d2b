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

/// Okabe and Ito's colours, which colour-blind eyes tell apart; lighter by age.
Colour plant_colour(std::size_t species, std::size_t age);
/// Their red, kept for plants under strong competition.
Colour oppressed_colour();

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
