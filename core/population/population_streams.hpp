// SPDX-License-Identifier: MIT
// Which random numbers of a population's seed belong to what: no two uses share one.
#pragma once

#include <cstdint>

#include "core/random/counter_stream.hpp"

namespace phytobench {

enum class PopulationDraw : std::uint64_t {
  sowing = 1,   ///< by species
  fruiting,     ///< by plant
  germination,  ///< of resting seeds
  season,
  event,  ///< by event and plant
};

/// The numbers for one plant, species or event (below 2^56) in one step; 2^24 of them.
inline CounterStream draws_of(std::uint64_t seed, PopulationDraw draw, std::uint64_t number,
                              std::int32_t step) {
  return {seed, static_cast<std::uint64_t>(draw) << 56 | number,
          static_cast<std::uint64_t>(step) << 24};
}

}  // namespace phytobench
