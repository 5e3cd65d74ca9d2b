// SPDX-License-Identifier: MIT
// A stand seen from above, in the manner of [Alsweis] fig. 4.7.
#pragma once

#include <span>
#include <string>

#include "core/population/population_parameters.hpp"
#include "core/population/stand.hpp"

namespace phytobench {

/// A stand at one moment. Numbers of plants lie in the stand's order.
struct StandView {
  const PopulationParameters& parameters;  ///< ground, names of species, resource maps
  const Stand& stand;
  std::span<const double> loss;
  std::span<const double> root_radius;   ///< m
  std::span<const double> crown_radius;  ///< m; empty: crowns are not drawn
};

/// So many plants stay legible, and within a few megabytes.
inline constexpr std::size_t most_plants_in_svg = 20'000;

/// Root zones as circles, crowns as discs, stems as dots: a colour for each species, lighter with
/// age, red zones where a plant loses more than half of its growth space, broken circles around the
/// stems of ill plants. A map of nutrients, or else of light, lies below, hazy where it is poor.
/// With a title, a legend that counts plants and a bar of length, all in the page's text colour.
/// Ends of zones that reach across a torus are drawn on the other side. ContractViolation beyond
/// most_plants_in_svg.
std::string stand_svg(const StandView& view, const std::string& title);

/// The same without letters, for any number of plants, on white, as the bytes of a PNG file; `side`
/// is the longer one, in pixels. Plants are drawn in the order of their ids: the same bytes for any
/// order in memory.
std::string stand_png(const StandView& view, int side);

}  // namespace phytobench
