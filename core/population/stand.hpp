// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/competition/competition_parameters.hpp"
#include "core/geometry/point2.hpp"

namespace phytobench {

using PlantId = std::uint64_t;

/// Never ill.
inline constexpr std::int32_t healthy = -1;

/// Plants that live on a ground, one array for each property ([Alsweis] sec. 4.7, 5.1), all of one
/// length. Not in the order of their ids: neighbours on the ground are neighbours in memory.
struct Stand {
  std::vector<double> x, y;             ///< of the stem, m
  std::vector<double> stem_radius;      ///< R_basal, m, > 0
  std::vector<PlantId> id;              ///< unique for ever
  std::vector<std::int32_t> age;        ///< steps it has lived
  std::vector<std::int32_t> ill_since;  ///< step of infection, or `healthy`
  std::vector<SpeciesIndex> species;

  std::size_t size() const { return x.size(); }
  Point2 place(std::size_t i) const { return {x[i], y[i]}; }
};

/// A seed at rest in the soil ([Alsweis] sec. 4.6).
struct DormantSeed {
  Point2 place;
  SpeciesIndex species = 0;

  friend bool operator==(const DormantSeed&, const DormantSeed&) = default;
};

/// All that changes while a population lives: random numbers have no state, they are a function of
/// seed, step and plant.
struct PopulationState {
  std::int32_t step = 0;  ///< steps done
  PlantId next_id = 0;
  Stand stand;
  /// Growth of every plant in step s at recent_growth[s % size], m; as many as the window of
  /// mortality is long.
  std::vector<std::vector<float>> recent_growth;
  std::vector<DormantSeed> seeds;
  /// Since the start, by species.
  std::vector<std::uint64_t> born, died;
};

/// Room for that many plants: growing step by step leaves holes as large as the stand in memory.
void reserve_plants(PopulationState& state, std::size_t count);

/// One plant more, of age 0, healthy, with the next id. `species` must be known to `born`.
void add_plant(PopulationState& state, const Point2& place, double stem_radius,
               SpeciesIndex species);

/// Takes out the plants whose entry is not 0 and counts them as died; the others keep their order.
void remove_plants(PopulationState& state, const std::vector<std::uint8_t>& is_out);

/// Puts plants that are near on the ground near in memory: overlaps are then found several times as
/// fast. Depends on places and ids only. False if they were in that order.
bool order_by_place(PopulationState& state, const Rectangle& ground);

/// Positions in the stand in the order of ids.
std::vector<std::size_t> order_of_ids(const Stand& stand);

}  // namespace phytobench
