// SPDX-License-Identifier: MIT
// The places that a work has, whether a claim is about them or not: a reader must be able to tell
// a place without a claim from one that does not exist.
#pragma once

#include <string>
#include <vector>

#include "reports/document_locators.hpp"

namespace phytobench {

/// A numbered place and where it stands.
struct KnownPlace {
  Place place;
  int first_page = 0, last_page = 0;  ///< as printed; where it may be if no page is known exactly
  std::string section;  ///< the number of the section or chapter that it is in; empty: none
};

/// Of reference/papers/<key>/places.toml, in the order of the works; empty without that file.
/// Throws InputError for an unknown key, an unknown kind or pages that are none.
std::vector<KnownPlace> known_places(const std::string& paper);

/// The same from a file.
std::vector<KnownPlace> known_places_of(const std::string& file);

/// "p. 45", "p. 43-45".
std::string shown_pages(const KnownPlace& known);

}  // namespace phytobench
