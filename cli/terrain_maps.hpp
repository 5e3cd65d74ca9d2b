// SPDX-License-Identifier: MIT
// The files of maps that `terrain` writes.
#pragma once

#include <string>
#include <vector>

#include "core/contract/text_file.hpp"
#include "core/terrain/pictures/map_svg.hpp"
#include "core/terrain/site.hpp"

namespace phytobench::cli {

/// One map, in every format that fits it.
struct MapSheet {
  std::string name;  ///< of its files, without ending
  MapLegend legend;
  TerrainMap numbers;  ///< of tables, and of pictures with a colour bar
};

/// Those of the site itself, in the order of its stages; lit hours, energy, depth (in cm), water.
std::vector<MapSheet> site_sheets(const Site& site, const SiteMaps& maps);

/// That of a species. Says where its numbers are from, and those of the biome.
MapSheet chance_sheet(const Site& site, const SiteEntry<SitePlant>& species, TerrainMap chance,
                      const std::string& biome_source);

/// Of an entry; those that come with the program all name theirs.
std::string source_or_yours(const std::string& source);

/// Hours in the light; NaN without data.
TerrainMap lit_hours_map(const Site& site, const LitMaps& lit);
TerrainMap in_centimetres(const TerrainMap& metres);

/// Throws InputError for a format that there is not, or one that this build cannot write.
void check_map_formats(const std::vector<std::string>& formats);

/// The sheet in these formats, under names without a folder.
std::vector<FileContent> sheet_files(const Site& site, const MapSheet& sheet,
                                     const std::vector<std::string>& formats);

}  // namespace phytobench::cli
