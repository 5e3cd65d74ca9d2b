// SPDX-License-Identifier: MIT
// Every parameter of a population file in one table: reading, checking, the commented example and
// the list of known keys all come from it.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/population/population_key_kinds.hpp"

namespace phytobench {

struct PopulationKey {
  std::string_view name;  ///< "section.key", or "key" at the top
  std::string_view unit;
  std::string_view default_text;  ///< as written in a file; of a required key an example
  std::string_view meaning;
  std::string_view source;  ///< paper key and place, or "phytobench"
  PopulationKeyKind kind;
  bool is_required = false;       ///< in every entry of its list
  bool shown_as_comment = false;  ///< alternative to other keys, or of a list that may be empty
  /// Only a file is held to the range: a program sets it otherwise, or leaves it at what means
  /// "not given".
  bool is_of_file_alone = false;
  std::string_view example_text = {};  ///< what the example shows, if not the default
};

/// All keys, grouped by section, those of lists last.
std::span<const PopulationKey> population_keys();

/// The parts that it ends with.
std::vector<PopulationKey> species_keys();
std::vector<PopulationKey> influence_and_event_keys();

/// Sections that are written as [[species]], once for each entry.
bool is_list_of_population(std::string_view section);

/// "a number >= 0 and <= 1", for messages and the example.
std::string allowed_values(const PopulationKey& key);

/// What a file with these parameters would hold: ground and factors as its keys have them. Entries
/// of lists are for the caller to set.
PopulationFileValues file_values_of(const PopulationParameters& parameters);

/// Something wrong in parameters, and the keys that have to do with it: "species[0].count" is that
/// of the first species. The message names keys as a file has them.
struct PopulationProblem {
  std::vector<std::string> keys;
  std::string text;
  std::string whose;  ///< "species 'oak': ", or "" where the keys alone tell
};

/// The first that check_parameters() would complain of.
std::optional<PopulationProblem> find_problem(const PopulationParameters& parameters);

}  // namespace phytobench
