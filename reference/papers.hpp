// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace phytobench {

/// A work under validation (reference/papers/<key>/paper.toml).
struct Paper {
  std::string key;  ///< as cited in the code: [Brzoska2019] has the key brzoska2019
  std::string title;
  std::string author;
  std::string year;
  std::string kind;      ///< "bachelor thesis", "article"
  std::string summary;   ///< one sentence in our own words
  std::string pictures;  ///< what its experiments' pictures show, or nothing
};

/// Keys of papers.def, in that order.
std::vector<std::string> paper_keys();

/// Throws InputError for an unknown key or a broken file.
Paper load_paper(const std::string& key);

}  // namespace phytobench
