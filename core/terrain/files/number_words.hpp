// SPDX-License-Identifier: MIT
// Words of text files of numbers.
#pragma once

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>

namespace phytobench {

/// The next word, taken off `text`; empty at its end.
inline std::string_view next_word(std::string_view& text) {
  constexpr std::string_view blanks = " \t\r\f\v";
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  const std::string_view word = text.substr(0, text.find_first_of(blanks));
  text.remove_prefix(word.size());
  return word;
}

inline bool is_nan_word(std::string_view word) {
  return word.size() == 3 && (word[0] | 0x20) == 'n' && (word[1] | 0x20) == 'a' &&
         (word[2] | 0x20) == 'n';
}

/// Nothing for what is no number, or none that a double can hold.
inline std::optional<double> number_of(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

/// As the user sees it, however long or odd.
inline std::string shown_word(std::string_view word) {
  constexpr std::size_t most = 40;
  std::string shown(word.substr(0, most));
  for (char& c : shown)
    if (c < ' ' || c > '~') c = '?';
  return word.size() <= most ? shown : shown + "...";
}

}  // namespace phytobench
