// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/terrain/files/height_file.hpp"
#include "core/terrain/site_description.hpp"
#include "core/terrain/site_maps.hpp"

namespace phytobench {

/// A site with its heights and soils, ready for site_maps() but for where the sun stands.
struct Site {
  SiteInput input;
  SiteOptions options;
  std::vector<SiteEntry<SitePlant>> species;  ///< to be mapped
  std::optional<GeoReference> place;
  std::string heights;        ///< "ESRI ASCII grid" or "fractal"
  double soilless_share = 0;  ///< of vertices with data
};

/// Reads and makes what the description names; `grow`, if not empty, instead of its species. Throws
/// InputError with the place in the site file.
Site load_site(const SiteDescription& description, const std::vector<std::string>& grow = {});

/// Sets where the sun stands: in every hour of the thesis' path, or at the middle of equal parts of
/// a true day, each of which counts as long as it is. Throws InputError if it does not rise on that
/// day.
void set_sun(SiteOptions& options, const SiteDescription& description, const SiteModel& model);

/// The heights alone.
HeightFile heights_of(const SiteDescription& description);

}  // namespace phytobench
