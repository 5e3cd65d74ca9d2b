// SPDX-License-Identifier: MIT
// Maps of stands side by side: where plants stand, and how far their zones reach.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/point2.hpp"
#include "core/population/population.hpp"

namespace phytobench::experiments::alsweis {

enum class StandMark {
  disc,  ///< filled, for stems: at least a visible dot
  ring,  ///< an outline, for zones
  dashed_ring,
  cross,  ///< where a plant has been; in the legend as a line: better explained in a caption
};

/// Plants that look alike.
struct StandLayer {
  std::string name;  ///< in the legend; layers of one name share a colour. Empty: not in the legend
  std::vector<Point2> places;
  std::vector<double> radii;  ///< m, as many as places
  StandMark mark = StandMark::disc;
  /// Number of the colour, below curve_colours. Unset: names take colours in the order they come.
  std::optional<std::size_t> colour = std::nullopt;
};

/// One map of a row or table of maps; later layers lie on earlier ones.
struct StandPanel {
  std::vector<StandLayer> layers;
  std::string caption;
};

/// The ground that all panels of a picture show.
struct StandMap {
  Rectangle ground;       ///< what lies beyond is cut off
  bool is_torus = false;  ///< rings that leave the ground come in on the other side
  std::size_t columns = 3;
  double panel_width = 240.0;  ///< pixels
};

/// The maps with one legend below, as an SVG that follows the page's text colour; the same bytes
/// for the same plants in any order. Places keep half a pixel: a dot takes six to eight bytes, a
/// ring some forty.
std::string stand_panels_svg(const StandMap& map, const std::vector<StandPanel>& panels,
                             const std::string& title);

/// Stems of the plants of one species, their radii times `magnification`.
StandLayer stems_of(const Population& population, SpeciesIndex species, double magnification = 1.0);
/// Their root and crown zones.
StandLayer root_zones_of(const Population& population, SpeciesIndex species);
StandLayer crown_zones_of(const Population& population, SpeciesIndex species);

}  // namespace phytobench::experiments::alsweis
