// SPDX-License-Identifier: MIT
#include "core/population/mortality.hpp"

#include <algorithm>

namespace phytobench {

namespace {

std::size_t window_of(const PopulationState& state) {
  return state.recent_growth.size();
}

/// The mean over the window lies below the threshold ([Alsweis] sec. 4.5).
bool starves(const PopulationState& state, const PopulationParameters& parameters, std::size_t i) {
  const MortalityParameters& mortality = parameters.mortality;
  const Stand& stand = state.stand;
  if (static_cast<std::size_t>(stand.age[i]) < window_of(state)) return false;
  const double radius = stand.stem_radius[i];
  const double full_size = parameters.species[stand.species[i]].largest_radius;
  const bool is_grown_up = radius >= mortality.grown_up * full_size;
  switch (mortality.rule) {
    case MortalityRule::none:
      return false;
    case MortalityRule::mean_growth:
      return !is_grown_up && mean_recent_growth(state, i) < mortality.threshold;
    case MortalityRule::mean_relative_growth:
      return !is_grown_up && mean_recent_growth(state, i) < mortality.threshold * radius;
    case MortalityRule::mean_size:
      return mean_recent_radius(state, i) < mortality.threshold;
  }
  return false;
}

}  // namespace

double mean_recent_growth(const PopulationState& state, std::size_t i) {
  double sum = 0.0;
  for (const std::vector<float>& growth : state.recent_growth)
    sum += static_cast<double>(growth[i]);
  const auto lived = static_cast<std::size_t>(state.stand.age[i]);
  return sum / static_cast<double>(std::min(lived, window_of(state)));
}

double mean_recent_radius(const PopulationState& state, std::size_t i) {
  // Back from the radius it has now: the growth of step s lies at s % window.
  const std::size_t window = window_of(state);
  double radius = state.stand.stem_radius[i], sum = 0.0;
  for (std::size_t back = 0; back < window; ++back) {
    sum += radius;
    const std::size_t step = static_cast<std::size_t>(state.step) + window - back;
    radius -= static_cast<double>(state.recent_growth[step % window][i]);
  }
  return sum / static_cast<double>(window);
}

bool dies(const PopulationState& state, const PopulationParameters& parameters, std::size_t i) {
  const Stand& stand = state.stand;
  if (stand.age[i] >= parameters.species[stand.species[i]].largest_age) return true;
  const IllnessParameters& illness = parameters.illness;
  if (illness.is_deadly && stand.ill_since[i] != healthy &&
      state.step + 1 - stand.ill_since[i] >= illness.duration)
    return true;
  return starves(state, parameters, i);
}

}  // namespace phytobench
