// SPDX-License-Identifier: MIT
// Every key of a site file in one table: reading, the commented example and messages all come from
// it.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/contract/parameter_keys.hpp"
#include "core/terrain/site_description.hpp"

namespace phytobench {

/// What stands in a file. Of the lists it holds the entry that is being read.
struct SiteFileValues {
  SiteDescription site;
  Biome biome;
  Soil soil;
  SitePlant species;
  std::string source;  ///< of the entry
};

struct SiteNumber {
  NumberRange range;
  void (*assign)(SiteFileValues&, double) = nullptr;
};

/// One of a few words, by its position.
struct SiteChoice {
  std::vector<std::string_view> words;
  void (*choose)(SiteFileValues&, std::size_t) = nullptr;
};

struct SiteSwitch {
  void (*assign)(SiteFileValues&, bool) = nullptr;
};

struct SiteText {
  std::string_view allowed;  ///< in words
  std::string& (*place)(SiteFileValues&) = nullptr;
};

/// A file, seen from the folder of the site file.
struct SiteFileName {
  std::string& (*place)(SiteFileValues&) = nullptr;
};

struct SiteNames {
  std::string_view allowed;
  std::vector<std::string>& (*place)(SiteFileValues&) = nullptr;
};

struct SiteDate {};  ///< of sun.date

using SiteKeyKind =
    std::variant<SiteNumber, SiteChoice, SiteSwitch, SiteText, SiteFileName, SiteNames, SiteDate>;

/// What a key is for. A file that gives it for something else is wrong.
struct SiteKeyCondition {
  std::string_view text;  ///< "sun.kind = \"solar\""
  bool (*holds)(const SiteDescription&) = nullptr;
};

struct SiteKey {
  std::string_view name;  ///< "section.key", or "key" at the top
  std::string_view unit;
  std::string_view default_text;  ///< as written in a file; of a required key an example
  std::string_view meaning;
  std::string_view source;  ///< paper key and place, or "phytobench"
  SiteKeyKind kind;
  bool is_required = false;       ///< in every entry of its list
  bool shown_as_comment = false;  ///< alternative to other keys, or without a default
  SiteKeyCondition condition = {};
};

/// All keys, grouped by section, those of lists last.
std::span<const SiteKey> site_keys();

/// The parts that it is made of.
std::vector<SiteKey> site_height_keys();
std::vector<SiteKey> site_choice_keys();
std::vector<SiteKey> site_entry_keys();

/// Sections that are written as [[biome]], once for each entry.
bool is_list_of_site(std::string_view section);

/// "a number >= 0 and <= 1", for messages and the example.
std::string allowed_values(const SiteKey& key);

}  // namespace phytobench
