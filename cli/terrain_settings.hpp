// SPDX-License-Identifier: MIT
// All that a run of `terrain` has used, under the names of keys of a site file, so that it can be
// made again without the files that it was put together from.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "cli/commands.hpp"
#include "core/terrain/site.hpp"
#include "core/terrain/site_description.hpp"

namespace phytobench::cli {

/// Sections, and lists of the biome, the soils and the species with all their values.
nlohmann::ordered_json terrain_settings(const SiteDescription& description, const Site& site,
                                        const TerrainOptions& options);

/// The same as a site file that names no file of entries. Heights and maps of soils are named by
/// where they lie on this machine.
std::string terrain_settings_file(const SiteDescription& description, const Site& site,
                                  const TerrainOptions& options);

}  // namespace phytobench::cli
