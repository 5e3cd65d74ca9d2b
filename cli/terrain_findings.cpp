// SPDX-License-Identifier: MIT
#include "cli/terrain_findings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/terrain/site_checks.hpp"

namespace phytobench::cli {

MapRange range_of(const TerrainMap& map) {
  MapRange range{.least = HUGE_VAL, .most = -HUGE_VAL};
  double sum = 0.0;
  for (const double value : map.values) {
    if (std::isnan(value)) continue;
    sum += value;
    range.least = std::min(range.least, value);
    range.most = std::max(range.most, value);
    ++range.cells;
  }
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (range.cells == 0) return {none, none, none, 0};
  range.mean = sum / static_cast<double>(range.cells);
  return range;
}

std::vector<SoilFindings> soil_findings(const SiteDescription& description, const Site& site) {
  const HeightField& heights = site.input.heights;
  std::vector<std::size_t> cells(site.input.soils.size());
  for (std::size_t i = 0; i < heights.size(); ++i)
    if (const int soil = site.input.soil_of[i]; soil >= 0 && !std::isnan(heights.heights()[i]))
      ++cells[static_cast<std::size_t>(soil)];
  std::vector<SoilFindings> soils;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (cells[i] == 0) continue;
    const std::string& name = site.input.soils[i].name;
    soils.push_back({name, soil_named(description, name, "ground").source,
                     static_cast<double>(cells[i]) * heights.cell_width() * heights.cell_depth()});
  }
  return soils;
}

std::uint64_t placed_plants_of(const TerrainFindings& findings) {
  std::uint64_t placed = 0;
  for (const SpeciesFindings& species : findings.species) placed += species.plants;
  return placed;
}

SpeciesFindings species_findings(const HeightField& heights, const SiteEntry<SitePlant>& species,
                                 const ChanceMaps& maps) {
  SpeciesFindings findings{.name = species.entry.name, .source = species.source};
  findings.chance = range_of(maps.chance);
  for (std::size_t i = 0; i < suitable_from.size(); ++i) {
    const SuitableArea area = suitable_area(heights, maps.chance, suitable_from[i]);
    findings.suitable_m2[i] = area.suitable;
    findings.with_data_m2 = area.with_data;
  }
  const double cell = heights.cell_width() * heights.cell_depth();
  const std::array<const TerrainMap*, factor_names.size()> factors{&maps.soil, &maps.light,
                                                                   &maps.water, &maps.depth};
  for (std::size_t i = 0; i < maps.chance.values.size(); ++i) {
    const double least = maps.chance.values[i];
    if (!(least < 1.0)) continue;
    const auto decides = [&](const TerrainMap* factor) { return factor->values[i] == least; };
    const auto found = std::find_if(factors.begin(), factors.end(), decides);
    if (found != factors.end())
      findings.limited_m2[static_cast<std::size_t>(found - factors.begin())] += cell;
  }
  return findings;
}

}  // namespace phytobench::cli
