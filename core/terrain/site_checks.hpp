// SPDX-License-Identifier: MIT
// What is wrong in a site though each of its keys is allowed.
#pragma once

#include <string_view>

#include "core/terrain/height_field.hpp"
#include "core/terrain/site_description.hpp"

namespace phytobench {

/// Throws InputError for heights of both kinds: before keys are judged that belong to one of them.
void refuse_two_kinds_of_heights(const SiteDescription& site);

/// Throws InputError, with file and line, for sources that are missing or given twice, names
/// without an entry, losses of the air above 100 percent or written as shares, an unknown engine.
void check_description(const SiteDescription& site);

/// The entry of that name, the first one. Throws InputError at the place of `key`, with the closest
/// name.
const SiteEntry<Biome>& biome_named(const SiteDescription& site, std::string_view name);
const SiteEntry<Soil>& soil_named(const SiteDescription& site, std::string_view name,
                                  std::string_view key);
const SiteEntry<SitePlant>& species_named(const SiteDescription& site, std::string_view name,
                                          std::string_view key);

/// Throws InputError for heights and cells that can hardly have the same unit.
void check_units(const SiteDescription& site, const HeightField& heights);

}  // namespace phytobench
