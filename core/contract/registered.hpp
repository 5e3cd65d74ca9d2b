// SPDX-License-Identifier: MIT
// What all tables that are made from a .def list have in common.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/contract/errors.hpp"
#include "core/contract/suggestion.hpp"

namespace phytobench {

/// "all_pairs, sweep, ..." for messages.
template <class Descriptor>
std::string registered_names(std::span<const Descriptor* const> table) {
  std::string names;
  for (const Descriptor* entry : table) {
    if (!names.empty()) names += ", ";
    names += entry->name;
  }
  return names;
}

/// The built entry of that name; `kind` is what messages call an entry. Throws InputError naming
/// the known ones, or the missing package.
template <class Descriptor>
const Descriptor& registered_as(std::string_view name, std::string_view kind,
                                std::span<const Descriptor* const> table) {
  std::vector<std::string> known;
  for (const Descriptor* entry : table) {
    known.emplace_back(entry->name);
    if (entry->name != name) continue;
    if (entry->built()) return *entry;
    throw InputError(std::string(kind) + " '" + std::string(name) +
                     "' is not built: " + std::string(entry->missing_package) +
                     " was not found, or left out, when phytobench was configured; install it and "
                     "build again");
  }
  throw InputError("unknown " + std::string(kind) + " '" + std::string(name) + "'" +
                   did_you_mean(name, known) + "; known: " + registered_names(table));
}

}  // namespace phytobench
