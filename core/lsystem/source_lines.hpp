// SPDX-License-Identifier: MIT
// The text of an L-system cut into statements, each of which knows where its characters came from.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/lsystem/lsystem.hpp"

namespace phytobench {

/// Throws the InputError "name:line:column: problem".
[[noreturn]] void fail_in_text(std::string_view name, const TextPlace& place,
                               const std::string& problem);

/// A statement: a line of the text and those that begin with a blank after it, without comments.
struct SourceLine {
  struct Piece {
    std::size_t offset = 0;  ///< in `text`, where the line's first column is
    int line = 0;
  };
  std::string_view name;  ///< of the file, for messages
  std::string text;       ///< not empty
  std::vector<Piece> pieces;

  /// Columns count characters, not bytes.
  TextPlace place(std::size_t offset) const;
  [[noreturn]] void fail(std::size_t offset, const std::string& problem) const;
};

/// In their order; empty lines and comments are left out. Lines end with \n, \r\n or \r. `name`
/// must outlive the result. Throws InputError for text that is not UTF-8, and for control
/// characters.
std::vector<SourceLine> source_lines(std::string_view text, std::string_view name);

inline bool is_blank(char c) {
  return c == ' ' || c == '\t';
}

/// Bytes of the UTF-8 character at the beginning of `text`; 0 if there is none.
std::size_t utf8_length(std::string_view text);

/// '#' and six hexadecimal digits.
bool is_colour(std::string_view text);

}  // namespace phytobench
