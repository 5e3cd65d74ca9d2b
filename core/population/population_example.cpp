// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "core/population/population_file.hpp"
#include "core/population/population_keys.hpp"

namespace phytobench {

namespace {

/// The line that begins a section; that of a list which may be empty is commented out.
std::string heading(std::string_view section, bool is_commented_out) {
  const char* form = is_list_of_population(section) ? "\n{}[[{}]]\n" : "\n{}[{}]\n";
  return fmt::format(fmt::runtime(form), is_commented_out ? "# " : "", section);
}

}  // namespace

std::string example_population_file() {
  std::string text =
      "# A stand for `phytobench compete`. Keys that are left out have the values here, but that "
      "no plant is sown\n# without count. Lines that begin with \"# \" and a key are other ways to "
      "say it, or lists that may be empty.\n"
      "# [Alsweis] is described by `phytobench list papers`.\n";
  std::string_view section;
  for (const PopulationKey& key : population_keys()) {
    if (section_of(key.name) != section) {
      section = section_of(key.name);
      text += heading(section, key.shown_as_comment);
    }
    text += example_lines({.name = key.name,
                           .unit = key.unit,
                           .meaning = key.meaning,
                           .source = key.source,
                           .allowed = allowed_values(key),
                           .value = key.example_text.empty() ? key.default_text : key.example_text,
                           .is_commented_out = key.shown_as_comment});
  }
  return text;
}

}  // namespace phytobench
