// SPDX-License-Identifier: MIT
// Options whose value is a list.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace phytobench::cli {

/// Comma-separated in one word. The library would take the words that follow for more of the list,
/// and with them what the command works on.
inline CLI::Option* as_one_list(CLI::Option* option) {
  return option->delimiter(',')->allow_extra_args(false);
}

inline std::string without_spaces_around(const std::string& text) {
  const std::size_t first = text.find_first_not_of(' ');
  return first == std::string::npos ? ""
                                    : text.substr(first, text.find_last_not_of(' ') + 1 - first);
}

/// The same of names and numbers, which people write with a space behind each comma.
inline CLI::Option* as_one_list_of_names(CLI::Option* option) {
  return as_one_list(option)->transform(without_spaces_around);
}

}  // namespace phytobench::cli
