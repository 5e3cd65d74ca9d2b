// SPDX-License-Identifier: MIT
#include "core/population/stand_look.hpp"

#include <algorithm>
#include <array>

namespace phytobench {

namespace {

constexpr Colour white{1.0, 1.0, 1.0}, black{0.0, 0.0, 0.0};

Colour mixed(const Colour& a, const Colour& b, double share_of_b) {
  const auto mix = [&](double x, double y) { return x + share_of_b * (y - x); };
  return {mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue)};
}

constexpr Colour rgb(int red, int green, int blue) {
  return {red / 255.0, green / 255.0, blue / 255.0};
}

struct SpeciesColour {
  Colour of_discs;
  std::size_t of_curves;
};

constexpr std::array<SpeciesColour, species_hues> species_colours{{{rgb(0, 158, 115), 2},
                                                                   {rgb(0, 114, 178), 0},
                                                                   {rgb(204, 121, 167), 6},
                                                                   {rgb(230, 159, 0), 1},
                                                                   {rgb(86, 180, 233), 5},
                                                                   {rgb(150, 110, 190), 3},
                                                                   {rgb(200, 190, 40), 7}}};

}  // namespace

std::size_t age_class(const Species& species, std::int32_t age) {
  double grown_up = static_cast<double>(species.largest_age);
  if (species.growth_rate > 0.0)
    grown_up = std::min(grown_up, 10.0 * species.largest_radius / species.growth_rate);
  const double share = std::clamp(age / grown_up, 0.0, 1.0);
  return std::min(age_classes - 1, static_cast<std::size_t>(share * age_classes));
}

Colour plant_colour(std::size_t species, std::size_t age) {
  constexpr double lighter = 0.12, darker = 0.35;
  const Colour& own = species_colours[species % species_hues].of_discs;
  // Beyond the list its colours come again, darker.
  const Colour base = species < species_hues ? own : mixed(own, black, darker);
  return mixed(base, white, lighter * static_cast<double>(age));
}

std::size_t curve_colour(std::size_t species) {
  return species_colours[species % species_hues].of_curves;
}

double illness_ring(double stem_radius, double spacing) {
  constexpr double gap = 2.5, smallest = 5.0;
  return std::max(stem_radius + std::min(gap, 0.3 * spacing), std::min(smallest, 0.6 * spacing));
}

Colour oppressed_colour() {
  return rgb(213, 94, 0);
}

const ResourceMap* background_of(const PopulationParameters& parameters) {
  if (!parameters.nutrients.is_uniform()) return &parameters.nutrients;
  if (!parameters.light.is_uniform()) return &parameters.light;
  return nullptr;
}

}  // namespace phytobench
