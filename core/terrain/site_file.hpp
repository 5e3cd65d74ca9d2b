// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "core/terrain/site_description.hpp"

namespace phytobench {

/// Where a file of entries that comes with the program lies. Throws InputError for a name of none.
using EntryFileFinder = std::function<std::filesystem::path(const std::string& name)>;

/// Reads a site file: [heights], [ground], [climate], [sun], [model] and lists [[biome]], [[soil]],
/// [[species]], and the files of entries that it names. Missing keys have their defaults. Throws
/// InputError with file, line, key and what is allowed.
SiteDescription read_site_file(const std::filesystem::path& file, const EntryFileFinder& find);

/// The same from text; `name` stands for the file in messages.
SiteDescription parse_site(std::string_view text, const std::filesystem::path& name,
                           const EntryFileFinder& find);

/// A site with every key at its default, each with meaning, unit, range and source. It can be read.
std::string example_site_file();

}  // namespace phytobench
