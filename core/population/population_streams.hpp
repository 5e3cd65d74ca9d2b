// SPDX-License-Identifier: MIT
// Which random numbers of a population's seed belong to what: no two uses share one.
#pragma once

#include <cstdint>

#include "core/contract/check.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {

enum class PopulationDraw : std::uint64_t {
  sowing = 1,   ///< by species
  fruiting,     ///< by plant
  germination,  ///< by place among the resting seeds
  season,
  event,  ///< by plant; the event is the place in its numbers
};

/// The numbers for one plant, species or seed (below 2^56) in one step; 2^24 of them, from `first`
/// on.
inline CounterStream draws_of(std::uint64_t seed, PopulationDraw draw, std::uint64_t number,
                              std::int32_t step, std::uint64_t first = 0) {
  PHYTOBENCH_EXPECT(number >> 56 == 0 && first >> 24 == 0 && step >= 0);
  return {seed, static_cast<std::uint64_t>(draw) << 56 | number,
          (static_cast<std::uint64_t>(step) << 24) + first};
}

}  // namespace phytobench
