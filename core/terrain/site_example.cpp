// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "core/terrain/site_file.hpp"
#include "core/terrain/site_keys.hpp"

namespace phytobench {

std::string example_site_file() {
  std::string text =
      "# A site for `phytobench terrain`. Keys that are left out have the values here; heights, "
      "soil and biome must be given.\n# Lines that begin with \"# \" and a key are other ways to "
      "say it. [Lesser2019] is described by `phytobench list papers`.\n";
  std::string_view section;
  for (const SiteKey& key : site_keys()) {
    if (section_of(key.name) != section) {
      section = section_of(key.name);
      text +=
          fmt::format(fmt::runtime(is_list_of_site(section) ? "\n[[{}]]\n" : "\n[{}]\n"), section);
    }
    text += example_lines({.name = key.name,
                           .unit = key.unit,
                           .meaning = key.meaning,
                           .source = key.source,
                           .allowed = allowed_values(key),
                           .value = key.default_text,
                           .is_commented_out = key.shown_as_comment});
  }
  return text;
}

}  // namespace phytobench
