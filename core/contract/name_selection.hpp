// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace phytobench {

/// How messages speak of the things that are chosen from.
struct SelectionWords {
  std::string_view kind;     ///< what one of them is called: "experiment"
  std::string_view listing;  ///< what shows them all: "phytobench list experiments"
};

/// Places of the names that match one of the patterns ('*' any text, '?' any character), ascending;
/// all without patterns. A pattern without wildcard that is no name is an InputError with the
/// nearest name, one with wildcards that matches nothing NothingSelected.
std::vector<std::size_t> selected_names(std::span<const std::string> names,
                                        std::span<const std::string> patterns,
                                        const SelectionWords& words);

}  // namespace phytobench
