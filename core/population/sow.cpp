// SPDX-License-Identifier: MIT
#include <cmath>

#include <fmt/format.h>

#include "core/contract/errors.hpp"
#include "core/population/population.hpp"
#include "core/population/population_streams.hpp"

namespace phytobench {

namespace {

void check_plant(const PopulationParameters& parameters, const StartPlant& plant,
                 std::size_t number) {
  if (plant.species >= parameters.species.size())
    throw InputError(fmt::format("plant {} has species {}, but there are only {}", number,
                                 plant.species, parameters.species.size()));
  if (!parameters.ground.contains(plant.place))
    throw InputError(
        fmt::format("plant {} at {}, {} stands outside the ground; move it or enlarge "
                    "ground.size",
                    number, plant.place.x, plant.place.y));
  const double largest = parameters.species[plant.species].largest_radius;
  if (!(plant.stem_radius >= smallest_stem_radius && plant.stem_radius <= largest))
    throw InputError(
        fmt::format("plant {} has radius {}; give a radius > 0 and at most the {} of "
                    "its species",
                    number, plant.stem_radius, largest));
}

void sow_species(const PopulationParameters& parameters, SpeciesIndex index,
                 PopulationState& state) {
  const Species& species = parameters.species[index];
  const Rectangle& ground = parameters.ground;
  CounterStream stream = draws_of(parameters.seed, PopulationDraw::sowing, index, 0);
  for (std::int64_t i = 0; i < species.count; ++i) {
    const double u = stream.next_unit(), v = stream.next_unit(), w = stream.next_unit();
    add_plant(state, {ground.low.x + u * ground.width(), ground.low.y + v * ground.height()},
              species.start_radius_low + w * (species.start_radius_high - species.start_radius_low),
              index);
  }
}

}  // namespace

PopulationState sow(const PopulationParameters& parameters, std::span<const StartPlant> plants) {
  check_parameters(parameters);
  PopulationState state;
  state.recent_growth.resize(static_cast<std::size_t>(parameters.mortality.window));
  state.born.assign(parameters.species.size(), 0);
  state.died.assign(parameters.species.size(), 0);
  std::size_t count = plants.size();
  for (const Species& species : parameters.species)
    count += static_cast<std::size_t>(species.count);
  if (count > parameters.most_plants)
    throw InputError(
        fmt::format("{} plants of a file and of species.count together are too many; "
                    "give at most {}",
                    count, parameters.most_plants));
  reserve_plants(state, count);
  for (std::size_t i = 0; i < plants.size(); ++i) {
    check_plant(parameters, plants[i], i);
    add_plant(state, plants[i].place, plants[i].stem_radius, plants[i].species);
  }
  for (std::size_t species = 0; species < parameters.species.size(); ++species)
    sow_species(parameters, static_cast<SpeciesIndex>(species), state);
  return state;
}

}  // namespace phytobench
