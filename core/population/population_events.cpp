// SPDX-License-Identifier: MIT
#include "core/population/population_events.hpp"

#include <algorithm>

#include "core/population/population_streams.hpp"

namespace phytobench {

namespace {

/// All plants of the event's species, or of all.
std::vector<std::size_t> candidates_of(const Stand& stand, const PopulationEvent& event) {
  std::vector<std::size_t> candidates;
  for (std::size_t i = 0; i < stand.size(); ++i)
    if (!event.species || stand.species[i] == *event.species) candidates.push_back(i);
  return candidates;
}

/// The largest ones; of equals, those with lower ids.
void keep_largest(const Stand& stand, std::int64_t count, std::vector<std::size_t>& plants) {
  const auto kept = std::min(static_cast<std::size_t>(count), plants.size());
  std::partial_sort(plants.begin(), plants.begin() + static_cast<std::ptrdiff_t>(kept),
                    plants.end(), [&](std::size_t a, std::size_t b) {
                      if (stand.stem_radius[a] != stand.stem_radius[b])
                        return stand.stem_radius[a] > stand.stem_radius[b];
                      return stand.id[a] < stand.id[b];
                    });
  plants.resize(kept);
  std::sort(plants.begin(), plants.end());
}

}  // namespace

std::vector<std::size_t> plants_selected(const PopulationState& state,
                                         const PopulationParameters& parameters,
                                         std::size_t number) {
  const PopulationEvent& event = parameters.events[number];
  const Stand& stand = state.stand;
  std::vector<std::size_t> plants = candidates_of(stand, event);
  if (!event.plants.empty()) {
    std::vector<PlantId> named = event.plants;
    std::sort(named.begin(), named.end());
    std::erase_if(plants, [&](std::size_t i) {
      return !std::binary_search(named.begin(), named.end(), stand.id[i]);
    });
  } else if (event.largest > 0) {
    keep_largest(stand, event.largest, plants);
  } else {
    std::erase_if(plants, [&](std::size_t i) {
      // By event and plant: which plants are struck does not depend on their order.
      return draws_of(parameters.seed, PopulationDraw::event, stand.id[i], event.step, number)
                 .next_unit() >= event.share;
    });
  }
  return plants;
}

bool apply_events(PopulationState& state, const PopulationParameters& parameters) {
  bool is_any = false;
  for (std::size_t number = 0; number < parameters.events.size(); ++number) {
    if (parameters.events[number].step != state.step) continue;
    is_any = true;
    const std::vector<std::size_t> plants = plants_selected(state, parameters, number);
    if (parameters.events[number].kind == EventKind::disease) {
      for (const std::size_t i : plants)
        if (state.stand.ill_since[i] == healthy) state.stand.ill_since[i] = state.step;
    } else {
      std::vector<std::uint8_t> is_out(state.stand.size(), 0);
      for (const std::size_t i : plants) is_out[i] = 1;
      remove_plants(state, is_out);
    }
  }
  return is_any;
}

}  // namespace phytobench
